#pragma once

#include "ReadLayers.h"

#include <functional>
#include <limn/core/Inspector.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

/// A shader from what stands for it in a file; null, with an error, if there is none.
using ShaderReader =
    std::function<std::shared_ptr<const Shader>(const YamlNode& node, const std::string& subject)>;

/// Sets a feature's settings to what a map says; settings it does not name stay. Everything must
/// outlive the reader.
class SettingsReader final : public Inspector
{
public:
    SettingsReader(YamlMapReader& map, const LayerNames& layers, const LayerNames& renderingLayers,
                   ShaderReader readShader, AssetDiagnostics& diagnostics);

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
    void RenderingLayerIndex(std::string_view name, int& value, std::string_view tooltip) override;
    void EnumField(std::string_view name, int& value, std::span<const EnumEntry> entries,
                   std::string_view tooltip) override;

    /// Every setting the feature named, in its order.
    const std::vector<std::string>& fieldNames() const { return m_FieldNames; }

private:
    const YamlNode* Find(std::string_view name);

    YamlMapReader& m_Map;
    const LayerNames& m_Layers;
    const LayerNames& m_RenderingLayers;
    ShaderReader m_ReadShader;
    AssetDiagnostics& m_Diagnostics;
    std::vector<std::string> m_FieldNames;
};

} // namespace limn
