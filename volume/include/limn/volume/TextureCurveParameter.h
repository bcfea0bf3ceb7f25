#pragma once

#include <limn/volume/TextureCurve.h>
#include <limn/volume/ValueParameter.h>

namespace limn
{

/// A curve for a shader; blending switches as soon as t > 0. In YAML
/// {keys: [...], zeroValue: 0, loop: false, range: 1}, the keys as for an AnimationCurveParameter,
/// or Unity's {m_Curve: {m_Curve: [...]}, m_Loop: 0, ...}. Unity: TextureCurveParameter (URP 14).
class TextureCurveParameter : public detail::ValueParameter<TextureCurve>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "TextureCurve"; }
};

} // namespace limn
