#include "BlueNoise.h"

#include <cmath>
#include <random>
#include <vector>

namespace limn
{

namespace
{

constexpr int k_CellCount = k_BlueNoiseSize * k_BlueNoiseSize;
constexpr int k_Reach = 7;          ///< texels; farther away the bell is below 1e-4
constexpr double k_Deviation = 1.5; ///< texels, Ulichney's
constexpr int k_FirstCount = k_CellCount / 10;

/// Some cells of a square that goes on at its other side, and how crowded each place is.
class Pattern
{
public:
    Pattern()
    {
        for (int i = -k_Reach; i <= k_Reach; ++i)
        {
            m_Bell.push_back(std::exp(-i * i / (2.0 * k_Deviation * k_Deviation)));
        }
    }

    bool isSet(int cell) const { return m_IsSet[static_cast<std::size_t>(cell)] != 0; }
    void Set(int cell, bool isSet)
    {
        m_IsSet[static_cast<std::size_t>(cell)] = isSet ? 1 : 0;
        const double sign = isSet ? 1.0 : -1.0;
        for (int y = -k_Reach; y <= k_Reach; ++y)
        {
            for (int x = -k_Reach; x <= k_Reach; ++x)
            {
                const int row = (cell / k_BlueNoiseSize + y + k_BlueNoiseSize) % k_BlueNoiseSize;
                const int column = (cell + x + k_BlueNoiseSize) % k_BlueNoiseSize;
                m_Crowd[static_cast<std::size_t>(row * k_BlueNoiseSize + column)] +=
                    sign * m_Bell[static_cast<std::size_t>(x + k_Reach)] *
                    m_Bell[static_cast<std::size_t>(y + k_Reach)];
            }
        }
    }
    int TightestCluster() const { return Extreme(true); }
    int LargestVoid() const { return Extreme(false); }

private:
    /// The most crowded of the set cells, or the least crowded of the others.
    int Extreme(bool ofSet) const
    {
        const double sign = ofSet ? 1.0 : -1.0;
        double best = -1e30;
        std::size_t found = 0;
        for (std::size_t i = 0; i < m_Crowd.size(); ++i)
        {
            if ((m_IsSet[i] != 0) == ofSet && sign * m_Crowd[i] > best)
            {
                best = sign * m_Crowd[i];
                found = i;
            }
        }
        return static_cast<int>(found);
    }

    std::vector<char> m_IsSet = std::vector<char>(k_CellCount);
    std::vector<double> m_Crowd = std::vector<double>(k_CellCount);
    std::vector<double> m_Bell;
};

/// Cells at random, then moved from clusters into voids until that changes nothing.
Pattern FirstPattern()
{
    std::mt19937 random(1993);
    Pattern pattern;
    for (int count = 0; count < k_FirstCount;)
    {
        const int cell = static_cast<int>(random() % k_CellCount);
        if (!pattern.isSet(cell))
        {
            pattern.Set(cell, true);
            ++count;
        }
    }
    for (int moves = 0; moves < k_CellCount; ++moves)
    {
        const int from = pattern.TightestCluster();
        pattern.Set(from, false);
        const int to = pattern.LargestVoid();
        pattern.Set(to, true);
        if (from == to)
        {
            break;
        }
    }
    return pattern;
}

/// The place of each cell in the order of 0 ... k_CellCount - 1.
std::vector<int> Ranks()
{
    const Pattern first = FirstPattern();
    std::vector<int> ranks(k_CellCount);
    Pattern pattern = first;
    for (int rank = k_FirstCount - 1; rank >= 0; --rank)
    {
        const int cell = pattern.TightestCluster();
        pattern.Set(cell, false);
        ranks[static_cast<std::size_t>(cell)] = rank;
    }
    pattern = first;
    for (int rank = k_FirstCount; rank < k_CellCount; ++rank)
    {
        // Beyond the half: the largest void of some is the tightest cluster of the others.
        const int cell = pattern.LargestVoid();
        pattern.Set(cell, true);
        ranks[static_cast<std::size_t>(cell)] = rank;
    }
    return ranks;
}

std::shared_ptr<const Texture2D> MakeBlueNoise()
{
    std::vector<std::byte> texels;
    texels.reserve(4 * k_CellCount);
    for (const int rank : Ranks())
    {
        texels.insert(texels.end(), 4, static_cast<std::byte>(rank * 256 / k_CellCount));
    }
    SamplerState sampler;
    sampler.filterMode = FilterMode::Point;
    return std::make_shared<const Texture2D>("limn_BlueNoise", k_BlueNoiseSize, k_BlueNoiseSize,
                                             GraphicsFormat::R8G8B8A8_UNorm, std::move(texels),
                                             sampler);
}

} // namespace

const std::shared_ptr<const Texture2D>& BlueNoise()
{
    static const std::shared_ptr<const Texture2D> texture = MakeBlueNoise();
    return texture;
}

} // namespace limn
