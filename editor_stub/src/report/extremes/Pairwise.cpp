#include "report/extremes/Pairwise.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <random>

namespace limn::study
{

namespace
{

constexpr int k_TriesEach = 8; ///< combinations of which the one with the most new pairs is taken

void ExpectFactors(std::span<const int> levelCounts, std::size_t atLeast)
{
    if (levelCounts.size() < atLeast ||
        std::ranges::any_of(levelCounts, [](int n) { return n < 1; }))
    {
        throw ContractError("combinations need " + std::to_string(atLeast) +
                            " factors or more, of one level or more each");
    }
}

/// Counts the occurrences of each pair of levels.
class PairCounts
{
public:
    explicit PairCounts(std::span<const int> levelCounts)
    {
        for (const int count : levelCounts)
        {
            m_First.push_back(m_Levels);
            m_Levels += static_cast<std::size_t>(count);
        }
        m_Counts.resize(m_Levels * m_Levels);
    }

    int& Of(std::size_t factor, int level, std::size_t other, int otherLevel)
    {
        const std::size_t a = m_First[factor] + static_cast<std::size_t>(level);
        const std::size_t b = m_First[other] + static_cast<std::size_t>(otherLevel);
        return m_Counts[std::min(a, b) * m_Levels + std::max(a, b)];
    }
    /// @param change  1 to add the combination, -1 to take it out
    void Count(const Combination& combination, int change)
    {
        for (std::size_t i = 0; i < combination.size(); ++i)
        {
            for (std::size_t k = i + 1; k < combination.size(); ++k)
            {
                Of(i, combination[i], k, combination[k]) += change;
            }
        }
    }
    /// Returns the number of pairs of a level with those of other factors that occur so many times.
    int PairsThatOccur(int times, const Combination& others, std::size_t factor, int level)
    {
        int count = 0;
        for (std::size_t k = 0; k < others.size(); ++k)
        {
            count += k != factor && others[k] >= 0 && Of(factor, level, k, others[k]) == times;
        }
        return count;
    }

private:
    std::vector<std::size_t> m_First;
    std::size_t m_Levels = 0;
    std::vector<int> m_Counts;
};

/// Fills factors in a random order, each with the level that makes the most new pairs.
Combination Fill(std::span<const int> levelCounts, PairCounts& pairs, std::mt19937& random,
                 Combination combination)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < levelCounts.size(); ++i)
    {
        order.insert(order.begin() + static_cast<std::ptrdiff_t>(random() % (i + 1)), i);
    }
    for (const std::size_t factor : order)
    {
        if (combination[factor] >= 0)
        {
            continue;
        }
        int best = -1;
        const int shift = static_cast<int>(random() % 1024u);
        for (int i = 0; i < levelCounts[factor]; ++i)
        {
            const int level = (i + shift) % levelCounts[factor];
            const int count = pairs.PairsThatOccur(0, combination, factor, level);
            if (count > best)
            {
                best = count;
                combination[factor] = level;
            }
        }
    }
    return combination;
}

int NewPairsOf(const Combination& combination, PairCounts& pairs)
{
    int twice = 0;
    for (std::size_t i = 0; i < combination.size(); ++i)
    {
        twice += pairs.PairsThatOccur(0, combination, i, combination[i]);
    }
    return twice / 2;
}

/// The first pair that does not occur yet, all else open; empty if all occur.
Combination Missing(std::span<const int> levelCounts, PairCounts& pairs)
{
    for (std::size_t i = 0; i < levelCounts.size(); ++i)
    {
        for (std::size_t k = i + 1; k < levelCounts.size(); ++k)
        {
            for (int a = 0; a < levelCounts[i]; ++a)
            {
                for (int b = 0; b < levelCounts[k]; ++b)
                {
                    if (pairs.Of(i, a, k, b) == 0)
                    {
                        Combination open(levelCounts.size(), -1);
                        open[i] = a;
                        open[k] = b;
                        return open;
                    }
                }
            }
        }
    }
    return {};
}

} // namespace

std::vector<Combination> CoverPairs(std::span<const int> levelCounts, std::uint32_t seed)
{
    ExpectFactors(levelCounts, 2);
    std::mt19937 random(seed);
    PairCounts pairs(levelCounts);
    std::vector<Combination> rows;
    for (Combination open = Missing(levelCounts, pairs); !open.empty();
         open = Missing(levelCounts, pairs))
    {
        Combination best;
        for (int attempt = 0; attempt < k_TriesEach; ++attempt)
        {
            Combination candidate = Fill(levelCounts, pairs, random, open);
            if (best.empty() || NewPairsOf(candidate, pairs) > NewPairsOf(best, pairs))
            {
                best = std::move(candidate);
            }
        }
        pairs.Count(best, 1);
        rows.push_back(std::move(best));
    }
    for (Combination& row : rows)
    {
        for (std::size_t factor = 0; factor < row.size(); ++factor)
        {
            if (pairs.PairsThatOccur(1, row, factor, row[factor]) == 0) // others have all of them
            {
                pairs.Count(row, -1);
                row[factor] = 0;
                pairs.Count(row, 1);
            }
        }
    }
    return rows;
}

std::vector<Combination> AllCombinations(std::span<const int> levelCounts,
                                         const std::function<bool(const Combination&)>& isAllowed)
{
    ExpectFactors(levelCounts, 1);
    std::vector<Combination> all;
    Combination next(levelCounts.size(), 0);
    while (true)
    {
        if (!isAllowed || isAllowed(next))
        {
            all.push_back(next);
        }
        std::size_t factor = next.size();
        while (factor > 0 && ++next[factor - 1] == levelCounts[factor - 1])
        {
            next[--factor] = 0;
        }
        if (factor == 0)
        {
            return all;
        }
    }
}

} // namespace limn::study
