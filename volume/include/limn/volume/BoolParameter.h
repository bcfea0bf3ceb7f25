#pragma once

#include <limn/volume/VolumeParameter.h>

namespace limn
{

/// On or off; blending switches as soon as t > 0. Unity: BoolParameter (URP 14).
class BoolParameter : public VolumeParameterT<bool>
{
public:
    BoolParameter(VolumeComponent* owner, std::string_view name, bool value,
                  bool overrideState = false)
        : VolumeParameterT(owner, name, value, overrideState)
    {
    }

    bool ReadYaml(const YamlNode& node, std::string_view subject,
                  AssetDiagnostics& diagnostics) override;
    std::string ValueText() const override;
    std::string_view typeName() const override { return "Bool"; }
};

} // namespace limn
