#include <limn/volume/AnimationCurve.h>

#include "blending/Lerp.h"

#include <cmath>

namespace limn
{

namespace
{

/// Nothing bends before the first key and behind the last.
Keyframe KeyAt(std::span<const Keyframe> keys, std::size_t index)
{
    Keyframe key = keys[index];
    key.inTangent = index == 0 ? 0.0f : key.inTangent;
    key.outTangent = index + 1 == keys.size() ? 0.0f : key.outTangent;
    return key;
}

/// The curve at a time in front of the key `next` and not in front of the one before that.
Keyframe EvaluatedKey(std::span<const Keyframe> keys, std::size_t next, float time)
{
    if (next == 0 || next == keys.size())
    {
        return {time, keys[next == 0 ? 0 : next - 1].value};
    }
    return AnimationCurve::EvaluateBetween(keys[next - 1], keys[next], time);
}

float LerpTangents(float from, float to, float t)
{
    if (!std::isfinite(from) || !std::isfinite(to))
    {
        return std::isfinite(from) ? to : from;
    }
    return Lerp(from, to, t);
}

Keyframe LerpKeys(const Keyframe& from, const Keyframe& to, float t)
{
    return {Lerp(from.time, to.time, t),
            Lerp(from.value, to.value, t),
            LerpTangents(from.inTangent, to.inTangent, t),
            LerpTangents(from.outTangent, to.outTangent, t),
            Lerp(from.inWeight, to.inWeight, t),
            Lerp(from.outWeight, to.outWeight, t),
            from.weightedMode};
}

/// `lhs` and `rhs` have keys.
void MergeKeys(std::span<const Keyframe> lhs, std::span<const Keyframe> rhs, float t,
               std::vector<Keyframe>& result)
{
    std::size_t left = 0;
    std::size_t right = 0;
    while (left < lhs.size() || right < rhs.size())
    {
        const bool isLeft =
            right == rhs.size() || (left < lhs.size() && lhs[left].time <= rhs[right].time);
        const bool isRight =
            left == lhs.size() || (right < rhs.size() && rhs[right].time <= lhs[left].time);
        const float time = isLeft ? lhs[left].time : rhs[right].time;
        const Keyframe from = isLeft ? KeyAt(lhs, left) : EvaluatedKey(lhs, left, time);
        const Keyframe to = isRight ? KeyAt(rhs, right) : EvaluatedKey(rhs, right, time);
        result.push_back(LerpKeys(from, to, t));
        left += isLeft ? 1 : 0;
        right += isRight ? 1 : 0;
    }
}

} // namespace

void KeyframeUtility::InterpAnimationCurve(AnimationCurve& lhsAndResult, const AnimationCurve& rhs,
                                           float t)
{
    if (!(t > 0.0f) || rhs.m_Keys.empty())
    {
        return;
    }
    if (t >= 1.0f || lhsAndResult.m_Keys.empty())
    {
        lhsAndResult.m_Keys = rhs.m_Keys;
        return;
    }
    // Kept from call to call, so that a frame that blends what the last one did allocates nothing.
    thread_local std::vector<Keyframe> merged;
    merged.clear();
    MergeKeys(lhsAndResult.m_Keys, rhs.m_Keys, t, merged);
    lhsAndResult.m_Keys = merged;
}

} // namespace limn
