#pragma once

#include <limn/core/LayerMask.h>
#include <limn/volume/ValueParameter.h>

namespace limn
{

/// A set of layers; blending switches as soon as t > 0. In YAML: the bits as one number, "Nothing",
/// "Everything", a list of indices or of Unity's built-in layers' names ("Default", "UI"), or
/// {m_Bits: 5}. A profile does not know the names that a scene gives its layers.
/// Unity: LayerMaskParameter (URP 14).
class LayerMaskParameter : public detail::ValueParameter<LayerMask>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "LayerMask"; }
};

/// A set of rendering layers; blending switches as soon as t > 0. In YAML as a LayerMask, without
/// names in the list. Unity: RenderingLayerMaskParameter (URP 17).
class RenderingLayerMaskParameter : public detail::ValueParameter<RenderingLayerMask>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "RenderingLayerMask"; }
};

} // namespace limn
