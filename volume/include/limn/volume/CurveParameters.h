#pragma once

#include <limn/volume/TextureCurve.h>
#include <limn/volume/ValueParameters.h>

namespace limn
{

/// A curve, blended key by key (KeyframeUtility::InterpAnimationCurve). YAML has a list of keys,
/// [{time: 0, value: 1, inTangent: 0, outTangent: 0}], of which only time and value are needed,
/// with wrap modes {keys: [...], preWrapMode: Loop, postWrapMode: PingPong}, or Unity's {m_Curve:
/// [...], m_PreInfinity: 1, m_PostInfinity: 0}. Unity: AnimationCurveParameter (URP 14).
class AnimationCurveParameter : public detail::ValueParameter<AnimationCurve>
{
public:
    using ValueParameter::Interp;
    using ValueParameter::ValueParameter;

    void Interp(const AnimationCurve& from, const AnimationCurve& to, float t) override;
    std::string_view typeName() const override { return "AnimationCurve"; }
};

/// A curve for a shader; blending switches as soon as t > 0. In YAML
/// {keys: [...], zeroValue: 0, loop: false, range: 1}, the keys as for an AnimationCurveParameter,
/// or Unity's {m_Curve: {m_Curve: [...]}, m_Loop: 0, ...}. Unity: TextureCurveParameter (URP 14).
using TextureCurveParameter =
    detail::NamedParameter<detail::ValueParameter<TextureCurve>, "TextureCurve">;

} // namespace limn
