#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/ShaderLabDocument.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace limn
{

/// A value and its name in ShaderLab. If several names mean the same, the first is the one to
/// write.
template <typename T>
struct EnumName
{
    std::string_view name;
    T value;
};

/// Returns a value as ShaderLab writes it, or "[_Property]".
/// @throws ContractError if none of the names is its
template <typename T>
std::string NameOf(std::type_identity_t<std::span<const EnumName<T>>> names,
                   const StateValue<T>& value)
{
    if (!value.property.empty())
    {
        return "[" + value.property + "]";
    }
    const auto found = std::ranges::find(names, value.value, &EnumName<T>::value);
    if (found == names.end())
    {
        throw ContractError("PrintShaderLab: a state has a value that ShaderLab has no name for");
    }
    return std::string(found->name);
}

inline constexpr EnumName<CullMode> k_CullModes[] = {
    {"Back", CullMode::Back},
    {"Front", CullMode::Front},
    {"Off", CullMode::Off},
    {"False", CullMode::Off},
};

// `Off` means no depth test at all, which is not the same as `Always`: it writes no depth either.
inline constexpr EnumName<CompareFunction> k_DepthTests[] = {
    {"Never", CompareFunction::Never},         {"Less", CompareFunction::Less},
    {"Equal", CompareFunction::Equal},         {"LEqual", CompareFunction::LessEqual},
    {"Greater", CompareFunction::Greater},     {"NotEqual", CompareFunction::NotEqual},
    {"GEqual", CompareFunction::GreaterEqual}, {"Always", CompareFunction::Always},
    {"NEqual", CompareFunction::NotEqual},     {"Disabled", CompareFunction::Disabled},
    {"Off", CompareFunction::Disabled},        {"False", CompareFunction::Disabled},
    {"On", CompareFunction::LessEqual},        {"True", CompareFunction::LessEqual},
};

/// The real comparisons, which Stencil and AlphaTest also have.
inline constexpr std::span<const EnumName<CompareFunction>> k_CompareFunctions =
    std::span<const EnumName<CompareFunction>>(k_DepthTests).first(9);

inline constexpr EnumName<bool> k_Bools[] = {
    {"On", true},
    {"Off", false},
    {"True", true},
    {"False", false},
};

inline constexpr EnumName<BlendMode> k_BlendModes[] = {
    {"One", BlendMode::One},
    {"Zero", BlendMode::Zero},
    {"SrcColor", BlendMode::SrcColor},
    {"SrcAlpha", BlendMode::SrcAlpha},
    {"SrcAlphaSaturate", BlendMode::SrcAlphaSaturate},
    {"DstColor", BlendMode::DstColor},
    {"DstAlpha", BlendMode::DstAlpha},
    {"OneMinusSrcColor", BlendMode::OneMinusSrcColor},
    {"OneMinusSrcAlpha", BlendMode::OneMinusSrcAlpha},
    {"OneMinusDstColor", BlendMode::OneMinusDstColor},
    {"OneMinusDstAlpha", BlendMode::OneMinusDstAlpha},
};

inline constexpr EnumName<BlendOp> k_BlendOps[] = {
    {"Add", BlendOp::Add},
    {"Sub", BlendOp::Subtract},
    {"RevSub", BlendOp::ReverseSubtract},
    {"Min", BlendOp::Min},
    {"Max", BlendOp::Max},
    {"LogicalClear", BlendOp::LogicalClear},
    {"LogicalSet", BlendOp::LogicalSet},
    {"LogicalCopy", BlendOp::LogicalCopy},
    {"LogicalCopyInverted", BlendOp::LogicalCopyInverted},
    {"LogicalNoop", BlendOp::LogicalNoop},
    {"LogicalInvert", BlendOp::LogicalInvert},
    {"LogicalAnd", BlendOp::LogicalAnd},
    {"LogicalNand", BlendOp::LogicalNand},
    {"LogicalOr", BlendOp::LogicalOr},
    {"LogicalNor", BlendOp::LogicalNor},
    {"LogicalXor", BlendOp::LogicalXor},
    {"LogicalEquiv", BlendOp::LogicalEquivalence},
    {"LogicalAndReverse", BlendOp::LogicalAndReverse},
    {"LogicalAndInverted", BlendOp::LogicalAndInverted},
    {"LogicalOrReverse", BlendOp::LogicalOrReverse},
    {"LogicalOrInverted", BlendOp::LogicalOrInverted},
    {"Multiply", BlendOp::Multiply},
    {"Screen", BlendOp::Screen},
    {"Overlay", BlendOp::Overlay},
    {"Darken", BlendOp::Darken},
    {"Lighten", BlendOp::Lighten},
    {"ColorDodge", BlendOp::ColorDodge},
    {"ColorBurn", BlendOp::ColorBurn},
    {"HardLight", BlendOp::HardLight},
    {"SoftLight", BlendOp::SoftLight},
    {"Difference", BlendOp::Difference},
    {"Exclusion", BlendOp::Exclusion},
    {"HSLHue", BlendOp::HSLHue},
    {"HSLSaturation", BlendOp::HSLSaturation},
    {"HSLColor", BlendOp::HSLColor},
    {"HSLLuminosity", BlendOp::HSLLuminosity},
};

struct PropertyTypeName
{
    std::string_view name;
    ShaderPropertyType type;
    TextureDimension dimension = TextureDimension::Tex2D;
};

inline constexpr PropertyTypeName k_PropertyTypes[] = {
    {"Float", ShaderPropertyType::Float},
    {"Range", ShaderPropertyType::Range},
    {"Int", ShaderPropertyType::Int},
    {"Integer", ShaderPropertyType::Integer},
    {"Color", ShaderPropertyType::Color},
    {"Vector", ShaderPropertyType::Vector},
    {"2D", ShaderPropertyType::Texture, TextureDimension::Tex2D},
    {"2DArray", ShaderPropertyType::Texture, TextureDimension::Tex2DArray},
    {"3D", ShaderPropertyType::Texture, TextureDimension::Tex3D},
    {"Cube", ShaderPropertyType::Texture, TextureDimension::Cube},
    {"CubeArray", ShaderPropertyType::Texture, TextureDimension::CubeArray},
    {"Rect", ShaderPropertyType::Texture, TextureDimension::Tex2D},
    {"Any", ShaderPropertyType::Texture, TextureDimension::Tex2D},
};

inline constexpr EnumName<StencilOp> k_StencilOps[] = {
    {"Keep", StencilOp::Keep},
    {"Zero", StencilOp::Zero},
    {"Replace", StencilOp::Replace},
    {"IncrSat", StencilOp::IncrementSaturate},
    {"DecrSat", StencilOp::DecrementSaturate},
    {"Invert", StencilOp::Invert},
    {"IncrWrap", StencilOp::IncrementWrap},
    {"DecrWrap", StencilOp::DecrementWrap},
};

} // namespace limn
