#pragma once

#include <limn/volume/ValueParameter.h>

namespace limn
{

/// On or off; blending switches as soon as t > 0. Unity: BoolParameter (URP 14).
class BoolParameter : public detail::ValueParameter<bool>
{
public:
    /// What an editor shows; blending and files do not look at it.
    /// Unity: BoolParameter.DisplayType (URP 14).
    enum class DisplayType
    {
        Checkbox = 0,
        EnumPopup = 1
    };

    using ValueParameter::ValueParameter;

    BoolParameter(VolumeComponent* owner, std::string_view name, bool value, DisplayType type,
                  bool overrideState = false, ParameterInfo info = {})
        : ValueParameter(owner, name, value, overrideState, std::move(info)), displayType(type)
    {
    }

    const DisplayType displayType = DisplayType::Checkbox;

    std::string_view typeName() const override { return "Bool"; }
};

} // namespace limn
