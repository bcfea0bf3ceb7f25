#include "scale/PlainLoops.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace limn::benchmarks
{

std::array<float, 3> PlaceOf(std::size_t index)
{
    // A sequence that fills the box evenly.
    const auto part = [&](double step)
    {
        const double x = static_cast<double>(index + 1) * step;
        return static_cast<float>((x - std::floor(x)) * 200.0 - 100.0);
    };
    return {part(0.8191725133961645), part(0.6710436067037893), part(0.5497004779019703) + 150.0f};
}

PlainLoops::PlainLoops(std::size_t count) : m_Count(count)
{
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::array<float, 3> place = PlaceOf(i);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            m_Center[axis].push_back(place[axis]);
            m_Extent[axis].push_back(0.5f);
        }
        m_Queue.push_back(2000);
        m_Layer.push_back(static_cast<std::uint8_t>(i % 8));
        m_RenderingLayers.push_back(1u | (i % 100 == 0 ? 256u : 0u));
        m_Material.push_back(static_cast<std::uint16_t>(i / k_MeshCount % k_MaterialCount));
        m_Mesh.push_back(static_cast<std::uint16_t>(i % k_MeshCount));
    }
}

void PlainLoops::Cull()
{
    // 60 degrees, 16:9, 0.3 to 1000 m.
    const float f = 1.0f / std::tan(30.0f * 3.14159265f / 180.0f);
    const float a = f * 9.0f / 16.0f;
    const float planes[6][4] = {{a, 0, 1, 0},  {-a, 0, 1, 0},    {0, f, 1, 0},
                                {0, -f, 1, 0}, {0, 0, 1, -0.3f}, {0, 0, -1, 1000}};
    m_Visible.resize(m_Count);
    std::size_t visible = 0;
    for (std::size_t i = 0; i < m_Count; ++i)
    {
        bool inside = true;
        for (const auto& plane : planes)
        {
            float depth = plane[3];
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                depth +=
                    plane[axis] * m_Center[axis][i] + std::abs(plane[axis]) * m_Extent[axis][i];
            }
            inside &= depth >= 0.0f;
        }
        m_Visible[visible] = static_cast<std::uint32_t>(i);
        visible += inside;
    }
    m_Visible.resize(visible);
}

void PlainLoops::Judge()
{
    m_Drawn.resize(m_Visible.size());
    std::size_t drawn = 0;
    for (const std::uint32_t i : m_Visible)
    {
        m_Drawn[drawn] = i;
        drawn += (m_Queue[i] <= 2500) & ((0xFFFFFFFFu >> m_Layer[i]) & 1u) &
                 ((m_RenderingLayers[i] & 256u) != 0);
    }
    m_Drawn.resize(drawn);
}

void PlainLoops::MakeKeys()
{
    m_Entries.resize(m_Visible.size());
    for (std::size_t j = 0; j < m_Visible.size(); ++j)
    {
        const std::uint32_t i = m_Visible[j];
        float squared = 0.0f;
        for (const std::vector<float>& center : m_Center)
        {
            squared += center[i] * center[i];
        }
        m_Entries[j] = {std::uint64_t{m_Queue[i]} << 48 | std::uint64_t{m_Material[i]} << 36 |
                            std::uint64_t{m_Mesh[i]} << 24 |
                            std::bit_cast<std::uint32_t>(squared) >> 20,
                        i};
    }
}

void PlainLoops::Sort()
{
    m_Spare.resize(m_Entries.size());
    std::vector<std::uint32_t> places(2048);
    for (int shift = 0; shift < 64; shift += 11)
    {
        const auto digit = [&](const Entry& entry)
        {
            return (entry.key >> shift) & 2047;
        };
        std::ranges::fill(places, 0u);
        for (const Entry& entry : m_Entries)
        {
            ++places[digit(entry)];
        }
        if (places[digit(m_Entries.front())] == m_Entries.size())
        {
            continue;
        }
        std::uint32_t next = 0;
        for (std::uint32_t& place : places)
        {
            const std::uint32_t count = place;
            place = next;
            next += count;
        }
        for (const Entry& entry : m_Entries)
        {
            m_Spare[places[digit(entry)]++] = entry;
        }
        m_Entries.swap(m_Spare);
    }
}

void PlainLoops::WriteIndices()
{
    m_Indices.resize(m_Entries.size());
    m_Batches = 0;
    for (std::size_t j = 0; j < m_Entries.size(); ++j)
    {
        m_Batches += j == 0 || ((m_Entries[j].key ^ m_Entries[j - 1].key) >> 24) != 0;
        m_Indices[j] = m_Entries[j].index;
    }
}

void PlainLoops::Frame()
{
    Cull();
    Judge();
    MakeKeys();
    Sort();
    WriteIndices();
}

} // namespace limn::benchmarks
