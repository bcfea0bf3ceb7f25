#pragma once

#include "scene/ReadLayers.h"

#include <functional>
#include <limn/core/Inspector.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

/// A shader from what stands for it in a file; null, with an error, if there is none.
using ShaderReader =
    std::function<std::shared_ptr<const Shader>(const YamlNode& node, const std::string& subject)>;

/// The same for a material.
using MaterialReader = std::function<std::shared_ptr<const Material>(const YamlNode& node,
                                                                     const std::string& subject)>;

/// What the settings of a file may refer to.
struct SettingsContext
{
    const LayerNames& layers;
    const LayerNames& renderingLayers;
    ShaderReader readShader;
    MaterialReader readMaterial;
    bool refusesUnknownKeys = true; ///< in groups; the file's own map is the caller's business
};

/// Sets a feature's settings to what a map says; settings it does not name stay. Everything must
/// outlive the reader.
class SettingsReader final : public Inspector
{
public:
    SettingsReader(YamlMapReader& map, const SettingsContext& context,
                   AssetDiagnostics& diagnostics);

    void Header(std::string_view text) override;
    void Field(std::string_view name, bool& value, std::string_view tooltip) override;
    void Field(std::string_view name, int& value, FieldRange range,
               std::string_view tooltip) override;
    void Field(std::string_view name, float& value, FieldRange range,
               std::string_view tooltip) override;
    void Field(std::string_view name, Color& value, std::string_view tooltip) override;
    void Field(std::string_view name, LayerMask& value, std::string_view tooltip) override;
    void Field(std::string_view name, RenderPassEvent& value, std::string_view tooltip) override;
    void Field(std::string_view name, std::shared_ptr<const Shader>& value,
               std::string_view tooltip) override;
    void Field(std::string_view name, std::shared_ptr<const Material>& value,
               std::string_view tooltip) override;
    void Field(std::string_view name, glm::vec4& value, std::string_view tooltip) override;
    void Field(std::string_view name, std::string& value, std::string_view tooltip) override;
    void Field(std::string_view name, std::vector<std::string>& value,
               std::string_view tooltip) override;
    void RenderingLayerIndex(std::string_view name, int& value, std::string_view tooltip) override;
    void EnumField(std::string_view name, int& value, std::span<const EnumEntry> entries,
                   std::string_view tooltip) override;
    void BeginGroup(std::string_view name) override;
    void EndGroup() override;

    /// Every setting and every group the feature named, in its order; not the groups' members.
    const std::vector<std::string>& fieldNames() const { return m_FieldNames; }

private:
    const YamlNode* Find(std::string_view name);

    YamlMapReader& Map() { return m_Group ? *m_Group : m_Map; }

    YamlMapReader& m_Map;
    std::optional<YamlMapReader> m_Group; ///< that the fields are in now
    const SettingsContext& m_Context;
    AssetDiagnostics& m_Diagnostics;
    std::vector<std::string> m_FieldNames;
};

} // namespace limn
