#pragma once

#include <span>
#include <vector>

namespace limn
{

/// Which tangents of a key have a weight. Unity: UnityEngine.WeightedMode (2022.3).
enum class WeightedMode
{
    None = 0,
    In = 1,
    Out = 2,
    Both = 3
};

/// A point that a curve goes through. Unity: UnityEngine.Keyframe (2022.3).
struct Keyframe
{
    float time = 0.0f;
    float value = 0.0f;
    float inTangent = 0.0f;  ///< slope before the key; infinite: the value jumps at the key
    float outTangent = 0.0f; ///< slope behind it; infinite: the value waits until the next key
    float inWeight = 0.0f;
    float outWeight = 0.0f;
    WeightedMode weightedMode = WeightedMode::None;

    bool operator==(const Keyframe&) const = default;
};

/// A function of time through keys, cubic between them. Copies share nothing. Weights are kept and
/// blended, but do not bend the curve. Unity: UnityEngine.AnimationCurve (2022.3).
class AnimationCurve
{
public:
    AnimationCurve() = default;
    explicit AnimationCurve(std::vector<Keyframe> keys) { SetKeys(std::move(keys)); }

    /// Sorts by time; keys of equal time stay in the order given.
    void SetKeys(std::vector<Keyframe> keys);

    /// @return the index of the new key, or -1, with nothing added, if there is one at its time
    int AddKey(const Keyframe& key);

    /// @throws ContractError without such an index
    void RemoveKey(int index);

    /// The first key's value before it (and for NaN), the last one's behind it, 0 without keys. At
    /// a time that several keys have, the last of them counts.
    float Evaluate(float time) const;

    /// The cubic Hermite through both keys, time not normalised; a distance below 1e-4 counts as
    /// 1e-4. Where a tangent between the two is not finite, it is the left key's value with slope
    /// 0. @return time, value and the slope as both tangents
    static Keyframe EvaluateBetween(const Keyframe& left, const Keyframe& right, float time);

    std::span<const Keyframe> keys() const { return m_Keys; } ///< by ascending time
    int length() const { return static_cast<int>(m_Keys.size()); }

    bool operator==(const AnimationCurve&) const = default;

private:
    friend struct KeyframeUtility;

    std::vector<Keyframe> m_Keys;
};

} // namespace limn
