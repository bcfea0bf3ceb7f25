#pragma once

#include <span>
#include <vector>

namespace limn
{

/// The behaviour of a curve outside its keys. Unity: UnityEngine.WrapMode (2022.3).
enum class WrapMode
{
    Default = 0, ///< the same as ClampForever for a curve
    Once = 1,    ///< the same as ClampForever for a curve
    Clamp = 1,
    Loop = 2,        ///< begins again
    PingPong = 4,    ///< runs back and forth
    ClampForever = 8 ///< stays at the value of the key at the end
};

/// The tangents of a key that have a weight. Unity: UnityEngine.WeightedMode (2022.3).
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
    float inWeight = 0.0f;   ///< 0...1, the part of the way to the key before that a handle takes
    float outWeight = 0.0f;  ///< the same for the key behind; a tangent without weight takes 1/3
    WeightedMode weightedMode = WeightedMode::None;

    bool operator==(const Keyframe&) const = default;
};

/// A function of time through keys, cubic between them. Copies share nothing.
/// Unity: UnityEngine.AnimationCurve (2022.3).
class AnimationCurve
{
public:
    AnimationCurve() = default;
    explicit AnimationCurve(std::vector<Keyframe> keys) { SetKeys(std::move(keys)); }

    /// Replaces all keys and sorts them by time; keys of equal time stay in the order given.
    void SetKeys(std::vector<Keyframe> keys);

    /// Adds a key and returns its index. Returns -1 and adds nothing if there is a key at its time.
    int AddKey(const Keyframe& key);
    /// Adds a key like the other AddKey. SmoothTangents makes its tangents; those of its neighbours
    /// stay.
    int AddKey(float time, float value);

    /// Gives both tangents of a key one slope: the slope of the line to its only neighbour, or the
    /// weighted mean of the slopes to both neighbours. Weight 1 takes only the slope to the key
    /// before, -1 only the slope to the key behind. A curve with one key stays as it is.
    /// @throws ContractError without such an index
    void SmoothTangents(int index, float weight);

    /// @throws ContractError without such an index
    void RemoveKey(int index);

    /// Returns the value at a time: 0 without keys, the first key's value for NaN. The wrap modes
    /// decide outside the keys; an infinite time is clamped. Where several keys have the same time,
    /// the last of them counts. Where a tangent has a weight (clamped to 0...1), the curve is the
    /// Bezier whose handles have the tangents' slopes and the weights times the distance of the
    /// keys as lengths along time.
    float Evaluate(float time) const;

    /// Sets what counts before the first key and behind the last. The initial mode is ClampForever;
    /// every mode but Loop and PingPong becomes ClampForever.
    void SetPreWrapMode(WrapMode mode) { m_PreWrapMode = Known(mode); }
    void SetPostWrapMode(WrapMode mode) { m_PostWrapMode = Known(mode); }
    WrapMode preWrapMode() const { return m_PreWrapMode; }
    WrapMode postWrapMode() const { return m_PostWrapMode; }

    /// Evaluates the cubic Hermite curve through both keys, which blending uses; weights do not
    /// bend it. Time is not normalised; a distance of the keys below 1e-4 counts as 1e-4. Where a
    /// tangent between the two is not finite, the result is the left key's value with slope 0.
    /// @return the time, the value, and the slope as both tangents
    static Keyframe EvaluateBetween(const Keyframe& left, const Keyframe& right, float time);

    std::span<const Keyframe> keys() const { return m_Keys; } ///< by ascending time
    int length() const { return static_cast<int>(m_Keys.size()); }

    bool operator==(const AnimationCurve&) const = default;

private:
    friend struct KeyframeUtility;

    static WrapMode Known(WrapMode mode)
    {
        const bool repeats = mode == WrapMode::Loop || mode == WrapMode::PingPong;
        return repeats ? mode : WrapMode::ClampForever;
    }
    /// @throws ContractError without such an index
    void RequireKey(int index) const;

    std::vector<Keyframe> m_Keys;
    WrapMode m_PreWrapMode = WrapMode::ClampForever;
    WrapMode m_PostWrapMode = WrapMode::ClampForever;
};

/// Blends curves. Unity: UnityEngine.Rendering.KeyframeUtility (URP 14).
struct KeyframeUtility
{
    /// Makes the first curve the blend of both, with a key at every time that either has one. The
    /// first curve is unchanged if t <= 0, t is NaN, or the second has no keys. It takes the keys
    /// of the second if t >= 1 or it has no keys itself. The wrap modes of the first stay and play
    /// no part. A tangent that is not finite in one of the curves is not finite in the result; the
    /// first curve's wins. Allocates only where the curve grows.
    static void InterpAnimationCurve(AnimationCurve& lhsAndResult, const AnimationCurve& rhs,
                                     float t);
};

} // namespace limn
