#pragma once

#include <limn/volume/ValueParameter.h>

namespace limn
{

/// On or off; blending switches as soon as t > 0. Unity: BoolParameter (URP 14).
class BoolParameter : public detail::ValueParameter<bool>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "Bool"; }
};

} // namespace limn
