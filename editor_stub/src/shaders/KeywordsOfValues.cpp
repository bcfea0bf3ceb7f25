#include "shaders/KeywordsOfValues.h"

#include <algorithm>
#include <limn/core/BuiltinShaders.h>
#include <limn/shaderlab/InitialKeywords.h>

namespace limn
{

namespace
{

const ShaderPropertyId _SpecColor("_SpecColor");
const ShaderPropertyId _EmissionColor("_EmissionColor");
const ShaderPropertyId _Smoothness("_Smoothness");
const ShaderPropertyId _DetailAlbedoMapScale("_DetailAlbedoMapScale");

void SetKeyword(Material& material, const std::string& keyword, bool isOn)
{
    if (material.IsKeywordEnabled(keyword) != isOn)
    {
        isOn ? material.EnableKeyword(keyword) : material.DisableKeyword(keyword);
    }
}

void SetKeywordsOfAttributes(Material& material)
{
    const Shader& shader = *material.shader();
    std::vector<ShaderProperty> properties = shader.document().properties;
    for (ShaderProperty& property : properties)
    {
        const ShaderPropertyId id(property.name);
        if (material.HasFloat(id))
        {
            property.defaultValue[0] = material.GetFloat(id);
        }
    }
    const std::vector<std::string> wanted = InitialKeywords(properties);
    for (const std::string& keyword : shader.initialKeywords())
    {
        SetKeyword(material, keyword, std::ranges::find(wanted, keyword) != wanted.end());
    }
    for (const std::string& keyword : wanted)
    {
        SetKeyword(material, keyword, true);
    }
}

/// Returns whether the material has a texture of its own there.
bool HasMap(const Material& material, const char* name)
{
    const ShaderPropertyId id{std::string(name)};
    const std::shared_ptr<const Texture> texture = material.GetTexture(id);
    const auto& properties = material.shader()->document().properties;
    const auto property = std::ranges::find(properties, name, &ShaderProperty::name);
    return texture && property != properties.end() &&
           texture != DefaultTexture(property->defaultTexture, texture->dimension());
}

/// The shaders without _MetallicGlossMap are Simple Lit's kind, whose _Smoothness is an alpha.
void SetKeywordsOfHighlights(Material& material)
{
    const bool hasSpecularMap = HasMap(material, "_SpecGlossMap");
    if (material.HasTexture(ShaderPropertyId("_MetallicGlossMap")))
    {
        SetKeyword(material, "_METALLICSPECGLOSSMAP",
                   material.IsKeywordEnabled("_SPECULAR_SETUP")
                       ? hasSpecularMap
                       : HasMap(material, "_MetallicGlossMap"));
    }
    else if (material.HasColor(_SpecColor) && material.HasFloat(_Smoothness))
    {
        const bool isOn = material.IsKeywordEnabled("_SPECULAR_COLOR");
        SetKeyword(material, "_SPECULAR_COLOR", isOn && !hasSpecularMap);
        SetKeyword(material, "_SPECGLOSSMAP", isOn && hasSpecularMap);
        Color color = material.GetColor(_SpecColor);
        color.a = material.GetFloat(_Smoothness);
        material.SetColor(_SpecColor, color);
    }
}

void SetKeywordsOfMaps(Material& material)
{
    SetKeyword(material, "_NORMALMAP", HasMap(material, "_BumpMap"));
    SetKeyword(material, "_OCCLUSIONMAP", HasMap(material, "_OcclusionMap"));
    SetKeyword(material, "_PARALLAXMAP", HasMap(material, "_ParallaxMap"));
    SetKeywordsOfHighlights(material);
    if (HasMap(material, "_DetailAlbedoMap") || HasMap(material, "_DetailNormalMap"))
    {
        const bool isWhole = material.GetFloat(_DetailAlbedoMapScale) == 1.0f;
        SetKeyword(material, "_DETAIL_MULX2", isWhole);
        SetKeyword(material, "_DETAIL_SCALED", !isWhole);
    }
    if (material.HasColor(_EmissionColor))
    {
        const Color color = material.GetColor(_EmissionColor);
        SetKeyword(material, "_EMISSION", std::max({color.r, color.g, color.b}) > 0.0f);
    }
}

} // namespace

void SetKeywordsOfValues(Material& material)
{
    SetKeywordsOfAttributes(material);
    if (material.shader()->name().starts_with("Universal Render Pipeline/"))
    {
        SetKeywordsOfMaps(material);
    }
}

} // namespace limn
