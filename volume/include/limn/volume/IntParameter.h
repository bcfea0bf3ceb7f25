#pragma once

#include <limn/volume/VolumeParameter.h>

namespace limn
{

/// A whole number; a blend is rounded toward zero. Unity: IntParameter (URP 14).
class IntParameter : public VolumeParameterT<int>
{
public:
    using VolumeParameterT::Interp;

    IntParameter(VolumeComponent* owner, std::string_view name, int value,
                 bool overrideState = false)
        : VolumeParameterT(owner, name, value, overrideState)
    {
    }

    void Interp(const int& from, const int& to, float t) final;
    bool ReadYaml(const YamlNode& node, std::string_view subject,
                  AssetDiagnostics& diagnostics) override;
    std::string ValueText() const override;
    std::string_view typeName() const override { return "Int"; }
};

} // namespace limn
