#pragma once

#include <limn/volume/VolumeParameter.h>

namespace limn
{

/// A colour, blended linearly per channel, alpha too, in whatever space its values are in.
/// Unity: ColorParameter (URP 14).
class ColorParameter : public VolumeParameterT<Color>
{
public:
    using VolumeParameterT::Interp;

    ColorParameter(VolumeComponent* owner, std::string_view name, const Color& value,
                   bool overrideState = false)
        : VolumeParameterT(owner, name, value, overrideState)
    {
    }

    void Interp(const Color& from, const Color& to, float t) override;
    bool ReadYaml(const YamlNode& node, std::string_view subject,
                  AssetDiagnostics& diagnostics) override;
    std::string ValueText() const override;
    std::string_view typeName() const override { return "Color"; }
};

} // namespace limn
