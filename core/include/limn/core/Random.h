#pragma once

#include <algorithm>
#include <random>

namespace limn
{

/// Random numbers from one generator for all callers, like Unity's: each call moves it on. It
/// begins in the same state in every process, so that pictures can be repeated, where Unity begins
/// anew each time; the numbers are others than Unity's. Use it from one thread.
/// Unity: UnityEngine.Random (2022.3).
class Random
{
public:
    /// Starts the sequence that belongs to the seed.
    static void InitState(int seed) { s_Engine.seed(static_cast<std::mt19937::result_type>(seed)); }
    /// Returns a number from 0 to 1.
    static float value()
    {
        return static_cast<float>(s_Engine()) / static_cast<float>(std::mt19937::max());
    }
    /// Returns a number between the limits, which may come out themselves, in either order.
    static float Range(float minInclusive, float maxInclusive)
    {
        const float share = value();
        return std::clamp(minInclusive + (maxInclusive - minInclusive) * share,
                          std::min(minInclusive, maxInclusive),
                          std::max(minInclusive, maxInclusive));
    }
    /// Returns a whole number from the first limit on, below the second one; the first limit where
    /// both are equal. With the limits the other way round, it is above the second one.
    static int Range(int minInclusive, int maxExclusive)
    {
        if (minInclusive == maxExclusive)
        {
            return minInclusive;
        }
        const bool isUp = minInclusive < maxExclusive;
        std::uniform_int_distribution<int> distribution(isUp ? minInclusive : maxExclusive + 1,
                                                        isUp ? maxExclusive - 1 : minInclusive);
        return distribution(s_Engine);
    }

private:
    inline static std::mt19937 s_Engine;
};

} // namespace limn
