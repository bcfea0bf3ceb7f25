#pragma once

#include <limn/volume/AssetReference.h>
#include <limn/volume/ValueParameter.h>

namespace limn
{

class Material;

using MaterialReference = AssetReference<Material>;

/// A material; blending switches as soon as t > 0. In YAML, and loaded, as a TextureParameter.
/// Unity: MaterialParameter (URP 14.0.12).
class MaterialParameter : public detail::ValueParameter<MaterialReference>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "Material"; }

private:
    bool ReadNode(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext& context) override;
};

} // namespace limn
