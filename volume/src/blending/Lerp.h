#pragma once

namespace limn
{

/// Blends two numbers linearly. The result is exact at t = 0 and t = 1, never outside [from, to]
/// between them, and monotonic in t. Its error is half an ulp, and 2^-51 of the larger number where
/// the two nearly cancel. Unity's from + (to - from) t in floats blends 1e8 to 0.1 at t = 1 into 0,
/// and overflows between large numbers of both signs.
inline float Lerp(float from, float to, float t)
{
    if (t == 0.0f || t == 1.0f)
    {
        return t == 0.0f ? from : to; // infinities and the sign of zero too
    }
    const auto share = static_cast<double>(t);
    return static_cast<float>(static_cast<double>(from) * (1.0 - share) +
                              static_cast<double>(to) * share);
}

} // namespace limn
