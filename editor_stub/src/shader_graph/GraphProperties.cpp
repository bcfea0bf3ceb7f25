#include "shader_graph/GraphProperties.h"

#include "console/Texts.h"

#include <limn/base/NumberText.h>

namespace limn
{

namespace
{

/// The types of properties in HLSL.
const std::map<std::string, std::string, std::less<>> k_Types{
    {"Vector1", "float"},    {"Boolean", "float"},    {"Vector2", "float2"},
    {"Vector3", "float3"},   {"Vector4", "float4"},   {"Color", "float4"},
    {"Matrix2", "float2x2"}, {"Matrix3", "float3x3"}, {"Matrix4", "float4x4"}};

bool IsOfMaterials(const Json& property)
{
    return NumberIn(property, "m_GeneratePropertyBlock") != 0.0;
}

std::string LabelOf(const Json& property)
{
    return Replaced(TextIn(property, "m_Name"), "\"", "'");
}

std::string DeclaredProperty(const std::string& name, const std::string& label,
                             const std::string& type, const std::string& value)
{
    return name + "(\"" + label + "\", " + type + ") = " + value + "\n";
}

std::string NumbersOf(const Json& value, const char* const (&keys)[4])
{
    std::string text;
    for (const char* key : keys)
    {
        text += (text.empty() ? "(" : ", ") + NumberText(NumberIn(value, key));
    }
    return text + ")";
}

std::string TextureText(const Json& property, const std::string& dimension)
{
    const bool hasTransform = NumberIn(property, "useTilingAndOffset") != 0.0;
    const bool isMain = NumberIn(property, "isMainTexture") != 0.0;
    const std::string value = dimension == "2D" ? GraphDefaultTexture(property) : "";
    return std::string(hasTransform ? "" : "[NoScaleOffset] ") + (isMain ? "[MainTexture] " : "") +
           DeclaredProperty(GraphReferenceName(property), LabelOf(property), dimension,
                            "\"" + value + "\" {}");
}

std::string NumberType(const Json& property)
{
    const Json& range = PartOf(property, "m_RangeValues");
    const double low = NumberIn(range, "x");
    const double high = NumberIn(range, "y");
    const bool isSlider = NumberIn(property, "m_FloatType") == 1.0 && low < high;
    return isSlider ? "Range(" + NumberText(low) + ", " + NumberText(high) + ")" : "Float";
}

/// Returns a property of materials, or "" for one that only the graph has.
std::string PropertyText(const Json& property)
{
    const std::string kind = GraphTypeOf(property);
    const std::string name = GraphReferenceName(property);
    const Json& value = PartOf(property, "m_Value");
    if (kind == "Vector1" || kind == "Boolean")
    {
        return (kind == "Boolean" ? "[ToggleUI] " : "") +
               DeclaredProperty(name, LabelOf(property), NumberType(property),
                                NumberText(NumberIn(property, "m_Value")));
    }
    if (kind == "Color")
    {
        return std::string(NumberIn(property, "m_ColorMode") == 1.0 ? "[HDR] " : "") +
               (NumberIn(property, "isMainColor") != 0.0 ? "[MainColor] " : "") +
               DeclaredProperty(name, LabelOf(property), "Color",
                                NumbersOf(value, {"r", "g", "b", "a"}));
    }
    if (kind.starts_with("Vector"))
    {
        return DeclaredProperty(name, LabelOf(property), "Vector",
                                NumbersOf(value, {"x", "y", "z", "w"}));
    }
    const std::string dimension = GraphTextureDimension(kind);
    return dimension.empty() ? "" : TextureText(property, dimension);
}

std::string ToggleText(const std::string& name, const Json& keyword)
{
    const bool isToggle = NumberIn(keyword, "m_KeywordDefinition") == 0.0 &&
                          NumberIn(keyword, "m_KeywordType") == 0.0;
    return isToggle ? "[Toggle(" + name + ")] " +
                          DeclaredProperty(name, LabelOf(keyword), "Float",
                                           NumberText(NumberIn(keyword, "m_Value")))
                    : "";
}

/// The uniforms of materials, and all other declarations.
struct Uniforms
{
    std::string material;
    std::string others;

    void AddTexture(const std::string& name, const std::string& dimension, bool hasTransform)
    {
        if (dimension == "2D")
        {
            material += "            float4 " + name + "_TexelSize;\n";
            material += hasTransform ? "            float4 " + name + "_ST;\n" : "";
        }
        const std::string type = dimension == "Cube"      ? "CUBE"
                                 : dimension == "2DArray" ? "2D_ARRAY"
                                                          : dimension;
        others += "            TEXTURE" + type + "(" + name + ");\n            SAMPLER(sampler" +
                  name + ");\n";
    }
};

} // namespace

std::string GraphPropertiesText(const GraphFile& file, const GraphSurroundings& around)
{
    std::string text;
    const auto add = [&text](const std::string& line)
    {
        text += line.empty() ? "" : "        " + line;
    };
    for (const Json* property : file.FindAll(PartOf(file.graph(), "m_Properties")))
    {
        add(IsOfMaterials(*property) ? PropertyText(*property) : "");
    }
    for (const auto& [name, texture] : around.textures)
    {
        add("[HideInInspector] [NoScaleOffset] " +
            DeclaredProperty(name, name, texture.dimension, "\"" + texture.defaultName + "\" {}"));
    }
    for (const auto& [name, keyword] : around.keywords)
    {
        add(ToggleText(name, *keyword));
    }
    return text;
}

std::string GraphUniformsText(const GraphFile& file, const GraphSurroundings& around)
{
    Uniforms uniforms;
    std::set<std::string> samplers = around.samplers;
    for (const Json* property : file.FindAll(PartOf(file.graph(), "m_Properties")))
    {
        const std::string kind = GraphTypeOf(*property);
        const std::string name = GraphReferenceName(*property);
        const std::string dimension = GraphTextureDimension(kind);
        const auto type = k_Types.find(kind);
        if (!dimension.empty())
        {
            uniforms.AddTexture(name, dimension, NumberIn(*property, "useTilingAndOffset") != 0.0);
        }
        else if (type != k_Types.end())
        {
            (IsOfMaterials(*property) ? uniforms.material : uniforms.others) +=
                "            " + type->second + " " + name + ";\n";
        }
        else if (kind == "SamplerState") // a custom function may name it
        {
            samplers.insert(GraphSamplerName(PartOf(*property, "m_Value")));
        }
    }
    for (const auto& [name, texture] : around.textures)
    {
        uniforms.AddTexture(name, texture.dimension, false);
    }
    for (const std::string& sampler : samplers)
    {
        uniforms.others += "            SAMPLER(" + sampler + ");\n";
    }
    return "            CBUFFER_START(UnityPerMaterial)\n" + uniforms.material +
           "            CBUFFER_END\n" + uniforms.others;
}

std::string GraphKeywordsText(const GraphSurroundings& around)
{
    std::string text;
    for (const auto& [name, keyword] : around.keywords)
    {
        const double definition = NumberIn(*keyword, "m_KeywordDefinition");
        if (definition > 1.0)
        {
            continue; // the pipeline declares it
        }
        const bool isGlobal = NumberIn(*keyword, "m_KeywordScope") == 1.0;
        std::string names = " _ " + name;
        if (NumberIn(*keyword, "m_KeywordType") == 1.0)
        {
            names.clear();
            for (const Json& entry : PartOf(*keyword, "m_Entries"))
            {
                names += " " + name + "_" + TextIn(entry, "referenceName");
            }
        }
        text += std::string("            #pragma ") +
                (definition == 0.0 ? "shader_feature" : "multi_compile") +
                (isGlobal ? "" : "_local") + names + "\n";
    }
    return text;
}

} // namespace limn
