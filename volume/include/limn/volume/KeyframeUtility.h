#pragma once

#include <limn/volume/AnimationCurve.h>

namespace limn
{

/// Blending of curves. Unity: UnityEngine.Rendering.KeyframeUtility (URP 14).
struct KeyframeUtility
{
    /// Makes the first curve the blend of both, with a key at every time that either has one.
    /// t <= 0, NaN, or a second curve without keys: unchanged. t >= 1, or a first curve without
    /// keys: the keys of the second. The wrap modes of the first stay and play no part. A tangent
    /// that is not finite in one of the two stays so; the first curve's wins. Allocates only where
    /// the curve grows.
    static void InterpAnimationCurve(AnimationCurve& lhsAndResult, const AnimationCurve& rhs,
                                     float t);
};

} // namespace limn
