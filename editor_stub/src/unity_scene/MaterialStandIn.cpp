#include "unity_scene/MaterialStandIn.h"

#include "unity/UnityDatabase.h"
#include "unity/UnityReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limn/base/Case.h>
#include <vector>

namespace limn
{

namespace
{

constexpr const char* k_SimpleLit = "Universal Render Pipeline/Simple Lit";
constexpr const char* k_Unlit = "Universal Render Pipeline/Unlit";

/// The values of a surface that is blended by alpha.
const std::map<std::string, float, std::less<>> k_Blended = {
    {"_Surface", 1.0f}, {"_SrcBlend", 5.0f}, {"_DstBlend", 10.0f}, {"_ZWrite", 0.0f}};

/// Returns a saved number; 0 if there is none, or one that is not finite.
float SavedNumber(const UnityNode& saved, std::string_view name)
{
    float number = 0.0f;
    for (const auto& [property, value] : PropertiesIn(saved["m_Floats"]))
    {
        number = property == name ? NumberOf(value, number) : number;
    }
    return std::isfinite(number) ? number : 0.0f;
}

std::vector<std::string> SavedTextures(const UnityNode& saved)
{
    std::vector<std::string> names;
    for (const auto& [name, value] : PropertiesIn(saved["m_TexEnvs"]))
    {
        if (!ReadUnityReference(value["m_Texture"]).isNull())
        {
            names.emplace_back(name);
        }
    }
    return names;
}

bool Has(const std::vector<std::string>& names, std::string_view name)
{
    return std::ranges::find(names, name) != names.end();
}

/// Standard's _Mode: opaque, cut out, fading, transparent with full highlights.
void SetMode(float mode, MaterialStandIn& standIn)
{
    standIn.values["_AlphaClip"] = mode == 1.0f ? 1.0f : 0.0f;
    standIn.values["_Surface"] = mode >= 2.0f ? 1.0f : 0.0f;
    standIn.isPremultiplied = mode == 3.0f;
}

bool TakePrefix(std::string_view& text, std::string_view prefix)
{
    const bool isThere = text.starts_with(prefix);
    text.remove_prefix(isThere ? prefix.size() : 0);
    return isThere;
}

/// Returns Simple Lit for the built-in pipeline's oldest shaders; nothing for those that mirror,
/// glow or have light maps, and for other shaders.
/// @source Unity: URP's upgrader of materials (URP 14)
std::optional<MaterialStandIn> StandInForLegacy(std::string_view shader)
{
    if (!TakePrefix(shader, "Legacy Shaders/") && !TakePrefix(shader, "Mobile/"))
    {
        return std::nullopt;
    }
    const bool isCutout = TakePrefix(shader, "Transparent/Cutout/");
    const bool isTransparent = TakePrefix(shader, "Transparent/");
    static constexpr std::string_view k_Names[] = {
        "VertexLit",      "Diffuse",         "Diffuse Fast",     "Diffuse Detail",   "Specular",
        "Bumped Diffuse", "Bumped Specular", "Parallax Diffuse", "Parallax Specular"};
    if (std::ranges::find(k_Names, shader) == std::end(k_Names))
    {
        return std::nullopt;
    }
    MaterialStandIn standIn{
        k_SimpleLit,
        {{"_MainTex", "_BaseMap"}, {"_Color", "_BaseColor"}, {"_Shininess", "_Smoothness"}}};
    standIn.values["_SpecularHighlights"] = shader.ends_with("Specular") ? 1.0f : 0.0f;
    standIn.values["_AlphaClip"] = isCutout ? 1.0f : 0.0f;
    if (isTransparent)
    {
        standIn.values.insert(k_Blended.begin(), k_Blended.end());
    }
    return standIn;
}

/// Returns the first of `usual` that is among `names`, or else of those among `names` that the
/// graph mentions the one that it mentions first; "" without any.
std::string MainOf(const std::vector<std::string>& names,
                   std::initializer_list<std::string_view> usual, std::string_view graph)
{
    const auto known =
        std::ranges::find_if(usual, [&](std::string_view name) { return Has(names, name); });
    if (known != usual.end())
    {
        return std::string(*known);
    }
    std::string first;
    std::size_t place = graph.npos;
    for (const std::string& name : names)
    {
        // A graph of before 2020 holds JSON in strings, with \" for ".
        const std::size_t found =
            std::min(graph.find('"' + name + '"'), graph.find('"' + name + "\\\""));
        if (found < place)
        {
            place = found;
            first = name;
        }
    }
    return first;
}

/// Returns whether a texture's name promises other values than the colours of a surface.
bool IsNoColorByName(const std::string& texture)
{
    const std::string lower = ToLower(texture);
    return std::ranges::any_of(std::array{"normal", "bump", "metallic", "rough", "smooth",
                                          "occlusion", "mask", "noise", "height", "emission",
                                          "reflection", "cube"},
                               [&](const char* word) { return lower.find(word) != lower.npos; });
}

/// Returns the saved colours that are colours by their names; vectors are saved among them.
std::vector<std::string> SavedColors(const UnityNode& saved)
{
    std::vector<std::string> names;
    for (const auto& [name, value] : PropertiesIn(saved["m_Colors"]))
    {
        const std::string lower = ToLower(name);
        if (lower.find("color") != lower.npos || lower.find("tint") != lower.npos)
        {
            names.emplace_back(name);
        }
    }
    return names;
}

} // namespace

std::vector<std::pair<std::string_view, UnityNode>> PropertiesIn(const UnityNode& list)
{
    std::vector<std::pair<std::string_view, UnityNode>> properties;
    for (const UnityNode item : list)
    {
        if (item["first"])
        {
            properties.emplace_back(item["first"]["name"].text(), item["second"]);
            continue;
        }
        for (const UnityNode property : item)
        {
            properties.emplace_back(property.key(), property);
        }
    }
    return properties;
}

std::string MaterialStandIn::NameOf(std::string_view saved) const
{
    const auto renamed = names.find(saved);
    if (renamed != names.end())
    {
        return renamed->second;
    }
    const bool isTaken =
        std::ranges::any_of(names, [&](const auto& pair) { return pair.second == saved; });
    return isTaken ? std::string() : std::string(saved);
}

std::optional<MaterialStandIn> StandInFor(std::string_view shader, const UnityNode& saved)
{
    struct BuiltInShader
    {
        std::string_view name;
        const char* standIn;
        std::map<std::string, float, std::less<>> values;
    };
    if (std::optional<MaterialStandIn> legacy = StandInForLegacy(shader))
    {
        return legacy;
    }
    static const BuiltInShader k_BuiltInShaders[] = {
        {"Standard", k_Lit, {}},
        {"Standard (Specular setup)", k_Lit, {{"_WorkflowMode", 0}}},
        {"Unlit/Texture", k_Unlit, {}},
        {"Unlit/Color", k_Unlit, {}},
        {"Unlit/Transparent", k_Unlit, k_Blended},
        {"Unlit/Transparent Cutout", k_Unlit, {{"_AlphaClip", 1}}},
        {"Autodesk Interactive", k_Lit, {{"_Surface", 0}, {"_AlphaClip", 0}}},
        {"Autodesk Interactive Transparent", k_Lit, k_Blended},
        {"Autodesk Interactive Masked", k_Lit, {{"_Surface", 0}, {"_AlphaClip", 1}}},
    };
    const auto* const found = std::ranges::find(k_BuiltInShaders, shader, &BuiltInShader::name);
    if (found == std::end(k_BuiltInShaders))
    {
        return std::nullopt;
    }
    MaterialStandIn standIn{
        found->standIn, {{"_MainTex", "_BaseMap"}, {"_Color", "_BaseColor"}}, found->values};
    if (shader.starts_with("Autodesk"))
    {
        // Its _Glossiness is a roughness, and a map counts only where it is switched on.
        standIn.values["_Smoothness"] = 1.0f - SavedNumber(saved, "_Glossiness");
        if (SavedNumber(saved, "_UseColorMap") == 0.0f)
        {
            standIn.names["_MainTex"] = "";
        }
    }
    else if (found->standIn == std::string_view(k_Lit))
    {
        const std::vector<std::string> textures = SavedTextures(saved);
        const bool isSpecular = found->values.contains("_WorkflowMode");
        // The inspector shows one of the two numbers: the map's scale where there is a map.
        const bool isScaled = Has(textures, isSpecular ? "_SpecGlossMap" : "_MetallicGlossMap") ||
                              SavedNumber(saved, "_SmoothnessTextureChannel") == 1.0f;
        standIn.names[isScaled ? "_GlossMapScale" : "_Glossiness"] = "_Smoothness";
        SetMode(SavedNumber(saved, "_Mode"), standIn);
    }
    return standIn;
}

MaterialStandIn StandInForGraph(std::string_view graph, const UnityNode& saved)
{
    MaterialStandIn standIn{k_Lit, {}};
    std::vector<std::string> textures = SavedTextures(saved);
    std::erase_if(textures, IsNoColorByName);
    const std::string texture = MainOf(
        textures,
        {"_BaseMap", "_MainTex", "_BaseColorMap", "_Albedo", "_AlbedoMap", "_BaseTexture"}, graph);
    const std::string color =
        MainOf(SavedColors(saved), {"_BaseColor", "_Color", "_MainColor", "_Tint"}, graph);
    if (!texture.empty())
    {
        standIn.names[texture] = "_BaseMap";
    }
    if (!color.empty())
    {
        standIn.names[color] = "_BaseColor";
    }
    return standIn;
}

} // namespace limn
