#include "shader_graph/GraphValue.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limn/base/NumberText.h>

namespace limn
{

namespace
{

bool IsWordByte(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string SrgbToLinear(double channel)
{
    const double linear = channel <= 0.04045 ? channel / 12.92
                          : channel < 1.0    ? std::pow((channel + 0.055) / 1.055, 2.4)
                                             : std::pow(channel, 2.2);
    return NumberText(static_cast<float>(linear));
}

struct GradientKeys
{
    std::vector<std::string> colors; ///< r, g, b and place
    std::vector<std::string> alphas; ///< alpha and place
    int mode = 0;
};

void AddColor(const Json& color, const char* const (&keys)[3], double place, GradientKeys& to)
{
    to.colors.push_back("float4(" + SrgbToLinear(NumberIn(color, keys[0])) + ", " +
                        SrgbToLinear(NumberIn(color, keys[1])) + ", " +
                        SrgbToLinear(NumberIn(color, keys[2])) + ", " + NumberText(place) + ")");
}

void AddAlpha(double alpha, double place, GradientKeys& to)
{
    to.alphas.push_back("float2(" + NumberText(alpha) + ", " + NumberText(place) + ")");
}

/// Reads a gradient as Unity saves it: eight keys, of which as many count as it says.
GradientKeys ReadGradient(const Json& value)
{
    GradientKeys keys;
    keys.mode = IntIn(value, "m_Mode");
    for (int i = 0; i < 8; ++i)
    {
        const std::string number = std::to_string(i);
        const Json& key = PartOf(value, ("key" + number).c_str());
        if (i < NumberIn(value, "m_NumColorKeys"))
        {
            AddColor(key, {"r", "g", "b"}, NumberIn(value, ("ctime" + number).c_str()) / 65535.0,
                     keys);
        }
        if (i < NumberIn(value, "m_NumAlphaKeys"))
        {
            AddAlpha(NumberIn(key, "a"), NumberIn(value, ("atime" + number).c_str()) / 65535.0,
                     keys);
        }
    }
    return keys;
}

/// Reads the gradient of a node that has one.
GradientKeys ReadGradientNode(const Json& node)
{
    GradientKeys keys;
    keys.mode = IntIn(node, "m_SerializableMode");
    for (const Json& key : PartOf(node, "m_SerializableColorKeys"))
    {
        AddColor(key, {"x", "y", "z"}, NumberIn(key, "w"), keys);
    }
    for (const Json& key : PartOf(node, "m_SerializableAlphaKeys"))
    {
        AddAlpha(NumberIn(key, "x"), NumberIn(key, "y"), keys);
    }
    return keys;
}

std::string GradientText(GradientKeys keys)
{
    std::string text = "NewGradient(" + std::to_string(keys.mode) + ", " +
                       std::to_string(keys.colors.size()) + ", " +
                       std::to_string(keys.alphas.size());
    keys.colors.resize(8, "float4(0, 0, 0, 0)");
    keys.alphas.resize(8, "float2(0, 0)");
    for (const std::vector<std::string>* list : {&keys.colors, &keys.alphas})
    {
        for (const std::string& key : *list)
        {
            text += ", " + key;
        }
    }
    return text + ")";
}

/// The keys of what a graph saves of textures, by their kinds.
struct TextureKeys
{
    const char* kind;      ///< the slot's
    const char* dimension; ///< in ShaderLab
    const char* field;
    const char* serialized;
};
constexpr TextureKeys k_TextureKeys[] = {
    {"Texture2D", "2D", "m_Texture", "m_SerializedTexture"},
    {"Texture2DArray", "2DArray", "m_TextureArray", "m_SerializedTexture"},
    {"Texture3D", "3D", "m_Texture", "m_SerializedTexture"},
    {"Cubemap", "Cube", "m_Cubemap", "m_SerializedCubemap"}};

} // namespace

int GraphWidth(const std::string& type)
{
    return type == "float" || type == "bool"                 ? 1
           : type.size() == 6 && type.starts_with("float")   ? type.back() - '0'
           : type.size() == 8 && type.find('x') != type.npos ? type.back() - '0'
                                                             : 0;
}

bool IsGraphMatrix(const std::string& type)
{
    return type.size() == 8 && type.starts_with("float");
}

std::string GraphVectorType(int width)
{
    return width <= 1 ? "float" : "float" + std::to_string(width);
}

std::string GraphTypeOfKind(const std::string& kind)
{
    static const std::map<std::string, std::string, std::less<>> types{
        {"Vector1", "float"},
        {"Vector2", "float2"},
        {"Vector3", "float3"},
        {"Vector4", "float4"},
        {"ColorRGB", "float3"},
        {"ColorRGBA", "float4"},
        {"Position", "float3"},
        {"Normal", "float3"},
        {"Tangent", "float3"},
        {"Bitangent", "float3"},
        {"ViewDirection", "float3"},
        {"UV", "float2"},
        {"ScreenPosition", "float4"},
        {"VertexColor", "float4"},
        {"Boolean", "bool"},
        {"PropertyConnectionState", "bool"},
        {"Matrix2", "float2x2"},
        {"Matrix3", "float3x3"},
        {"Matrix4", "float4x4"},
        {"Texture2D", "UnityTexture2D"},
        {"Texture2DArray", "UnityTexture2DArray"},
        {"Texture3D", "UnityTexture3D"},
        {"Cubemap", "UnityTextureCube"},
        {"SamplerState", "UnitySamplerState"},
        {"Gradient", "Gradient"}};
    const auto found = types.find(kind);
    return found == types.end() ? "" : found->second;
}

std::string GraphConstant(const std::string& type, const Json& fields)
{
    const auto value = fields.find("m_Value");
    const int width = GraphWidth(type);
    if (IsGraphMatrix(type))
    {
        std::string numbers;
        for (int row = 0; row < width; ++row)
        {
            for (int column = 0; column < width; ++column)
            {
                const std::string key = "e" + std::to_string(row) + std::to_string(column);
                numbers += (numbers.empty() ? "" : ", ") +
                           NumberText(NumberIn(PartOf(fields, "m_Value"), key.c_str()));
            }
        }
        return type + "(" + numbers + ")";
    }
    if (type == "bool")
    {
        return NumberIn(fields, "m_Value") != 0.0 ? "true" : "false";
    }
    if (value == fields.end() || !value->is_object())
    {
        return type + "(" + NumberText(NumberIn(fields, "m_Value")) + ")";
    }
    std::string numbers;
    const bool isMatrix = value->contains("e00"); // of a slot that also takes matrices
    for (int i = 0; i < width; ++i)
    {
        const char* const keys[] = {"x", "y", "z", "w"};
        const char* const first[] = {"e00", "e01", "e02", "e03"};
        numbers += (i > 0 ? ", " : "") + NumberText(NumberIn(*value, (isMatrix ? first : keys)[i]));
    }
    return type + "(" + numbers + ")";
}

std::string GraphGradient(const Json& value)
{
    return GradientText(ReadGradient(value));
}

std::string GraphGradientOfNode(const Json& node)
{
    return GradientText(ReadGradientNode(node));
}

std::string ConvertGraphValue(const GraphValue& value, const std::string& type)
{
    const int from = GraphWidth(value.type);
    const int to = GraphWidth(type);
    if (value.type == type || from == 0 || to == 0)
    {
        return value.text;
    }
    if (value.type == "bool")
    {
        return type + "(" + value.text + ")";
    }
    if (type == "bool")
    {
        return "(" + (from > 1 ? value.text + ".x" : value.text) + " != 0)";
    }
    if (IsGraphMatrix(value.type) || IsGraphMatrix(type))
    {
        return "((" + type + ")" + value.text + ")";
    }
    if (from == 1)
    {
        return type + "(" + value.text + std::string(to > 1 ? ", " + value.text : "") +
               std::string(to > 2 ? ", " + value.text : "") +
               std::string(to > 3 ? ", " + value.text : "") + ")";
    }
    if (from > to)
    {
        return value.text + "." + std::string("xyzw").substr(0, static_cast<std::size_t>(to));
    }
    std::string filled = type + "(" + value.text;
    for (int i = from; i < to; ++i)
    {
        filled += i == 3 ? ", 1" : ", 0";
    }
    return filled + ")";
}

std::string GraphSamplerName(const Json& fields)
{
    static const char* const filters[] = {"Linear", "Point", "Trilinear"};
    static const char* const wraps[] = {"Repeat", "Clamp", "Mirror", "MirrorOnce"};
    const auto choose = [&](const char* key, const auto& names)
    {
        const double last = static_cast<double>(std::size(names)) - 1.0;
        return std::string(
            names[static_cast<std::size_t>(std::clamp(NumberIn(fields, key), 0.0, last))]);
    };
    return "SamplerState_" + choose("m_filter", filters) + "_" + choose("m_wrap", wraps);
}

std::string GraphReferenceName(const Json& property)
{
    std::string name = TextIn(property, "m_OverrideReferenceName");
    name = name.empty() ? TextIn(property, "m_DefaultReferenceName") : name;
    return name.empty() ? GraphTypeOf(property) + "_" +
                              TextIn(PartOf(property, "m_Guid"), "m_GuidSerialized").substr(0, 8)
                        : name;
}

std::string GraphTextureDimension(std::string_view kind)
{
    const auto* keys = std::ranges::find(k_TextureKeys, kind, &TextureKeys::kind);
    return keys == std::end(k_TextureKeys) ? "" : keys->dimension;
}

std::string GraphDefaultTexture(const Json& fields)
{
    static const char* const names[] = {"white", "black", "grey", "bump", "linearGrey", "red"};
    return names[static_cast<std::size_t>(std::clamp(NumberIn(fields, "m_DefaultType"), 0.0, 5.0))];
}

std::string GraphWordAt(const std::string& text, std::size_t at)
{
    const auto end =
        std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), IsWordByte);
    return {text.begin() + static_cast<std::ptrdiff_t>(at), end};
}

GraphAsset ReadGraphAsset(const std::string& serialized)
{
    const Json asset = Json::parse(serialized, nullptr, false);
    if (!asset.is_object() || asset.empty() || !asset.begin().value().is_object())
    {
        return {};
    }
    const Json& reference = asset.begin().value();
    const auto id = reference.find("fileID");
    const bool hasId = id != reference.end() && id->is_number_integer();
    return {TextIn(reference, "guid"), hasId ? id->get<std::int64_t>() : 0};
}

GraphAsset ReadGraphTexture(std::string_view kind, const Json& fields)
{
    const auto* keys = std::ranges::find(k_TextureKeys, kind, &TextureKeys::kind);
    return keys == std::end(k_TextureKeys)
               ? GraphAsset()
               : ReadGraphAsset(TextIn(PartOf(fields, keys->field), keys->serialized));
}

std::string GraphLine(const std::string& text)
{
    return "            " + text + "\n";
}

} // namespace limn
