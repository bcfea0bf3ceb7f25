#pragma once

#include "scene/ReadLayers.h"

#include <functional>
#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/ShaderSource.h>
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

    void Field(const FieldInfo& field, FieldValue value) override;
    void BeginGroup(std::string_view name) override;
    void EndGroup() override;

    /// Every setting and every group the feature named, in its order; not the groups' members.
    const std::vector<std::string>& fieldNames() const { return m_FieldNames; }

private:
    const YamlNode* Find(std::string_view name);

    template <typename T>
    void Read(const FieldInfo& field, const YamlNode& node, T* value);
    void Read(const FieldInfo& field, const YamlNode& node, LayerMask* value);
    void Read(const FieldInfo& field, const YamlNode& node, RenderPassEvent* value);
    void Read(const FieldInfo& field, const YamlNode& node, std::shared_ptr<const Shader>* value);
    void Read(const FieldInfo& field, const YamlNode& node, std::shared_ptr<const Material>* value);
    void Read(const FieldInfo& field, const YamlNode& node, std::vector<std::string>* value);
    void Read(const FieldInfo& field, const YamlNode& node, EnumValue value);
    void Read(const FieldInfo& field, const YamlNode& node, RenderingLayerValue value);

    YamlMapReader& Map() { return m_Group ? *m_Group : m_Map; }

    YamlMapReader& m_Map;
    std::optional<YamlMapReader> m_Group; ///< that the fields are in now
    const SettingsContext& m_Context;
    AssetDiagnostics& m_Diagnostics;
    std::vector<std::string> m_FieldNames;
};

/// Sets a feature's `active` and its settings to what a map of a file of limn's own says. The
/// caller calls map.Finish().
void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SettingsContext& context, AssetDiagnostics& diagnostics);

/// Settings that are good one by one may not fit each other: better said where they stand than when
/// the feature is used. An error at `location` if it cannot be created.
/// @param shaders  where its Create finds shaders by name
/// @param subject  stands before what the feature says, which begins with its name
void TryCreate(ScriptableRendererFeature& feature, const std::shared_ptr<ShaderSource>& shaders,
               SourceLocation location, std::string_view subject, AssetDiagnostics& diagnostics);

} // namespace limn
