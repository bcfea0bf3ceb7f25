#include "hlsl/Types.h"

#include <limn/base/WordList.h>

#include <algorithm>
#include <map>
#include <utility>

namespace limn
{

namespace
{

constexpr std::pair<std::string_view, HlslScalar> k_Scalars[] = {
    {"float", HlslScalar::Float},     {"half", HlslScalar::Half},
    {"int", HlslScalar::Int},         {"uint", HlslScalar::Uint},
    {"bool", HlslScalar::Bool},       {"min16float", HlslScalar::Half},
    {"min10float", HlslScalar::Half}, {"min16int", HlslScalar::Int},
    {"min12int", HlslScalar::Int},    {"min16uint", HlslScalar::Uint},
    {"double", HlslScalar::Double},   {"dword", HlslScalar::Uint},
    {"float16_t", HlslScalar::Half},  {"float32_t", HlslScalar::Float},
};

bool isSize(char c)
{
    return c >= '1' && c <= '4';
}

// Functions of the language by what they give. Those that are not here give what is not known.
const WordList k_LikeArguments(
    "abs acos asin atan atan2 ceil clamp cos cosh ddx ddx_coarse ddx_fine ddy ddy_coarse "
    "ddy_fine degrees exp exp2 fma floor fmod frac frexp fwidth ldexp lerp log log10 log2 mad "
    "max min modf normalize pow radians rcp round rsqrt saturate sin sinh smoothstep sqrt step "
    "tan tanh trunc faceforward reflect refract countbits reversebits firstbithigh firstbitlow "
    "QuadReadAcrossX QuadReadAcrossY QuadReadAcrossDiagonal WaveReadLaneFirst WaveActiveSum "
    "WaveActiveMax");

const WordList
    k_IntegerLikeArguments("abs clamp countbits mad max min reversebits firstbithigh firstbitlow");

const WordList k_FloatScalars("length distance dot determinant");
const WordList k_Truth("any all");

// Functions that give numbers of a kind for as many of any kind.
const std::map<std::string_view, HlslScalar> k_Converting = {
    {"asfloat", HlslScalar::Float},  {"asint", HlslScalar::Int},
    {"asuint", HlslScalar::Uint},    {"sign", HlslScalar::Int},
    {"f16tof32", HlslScalar::Float}, {"f32tof16", HlslScalar::Uint},
    {"isnan", HlslScalar::Bool},     {"isinf", HlslScalar::Bool},
    {"isfinite", HlslScalar::Bool}};

HlslType PromoteAll(std::span<const HlslType> arguments)
{
    HlslType result = arguments.front();
    for (const HlslType& argument : arguments.subspan(1))
    {
        result = Promote(result, argument);
    }
    return result;
}

HlslScalar FloatOf(HlslScalar scalar)
{
    return scalar >= HlslScalar::Literal ? scalar : HlslScalar::Float;
}

/// Returns the type of `mul(left, right)`: the rows of the left matrix and the columns of the right
/// one; a vector has none.
HlslType ProductType(const HlslType& left, const HlslType& right)
{
    const HlslScalar scalar = FloatOf(std::max(left.scalar, right.scalar));
    if (left.isScalar() || right.isScalar())
    {
        return (left.isScalar() ? right : left).Of(scalar);
    }
    const int rows = left.rows;
    const int columns = right.isVector() ? 0 : right.columns;
    return rows > 0 && columns > 0 ? HlslType::Number(scalar, columns, rows)
                                   : HlslType::Number(scalar, std::max({rows, columns, 1}));
}

/// "_m03_m13" or "_14_24": how many elements; 0 of another word.
int CountElements(std::string_view word)
{
    const std::size_t size = word.starts_with("_m") ? 4 : 3;
    const bool isWhole = !word.empty() && word.size() % size == 0;
    for (std::size_t i = 0; isWhole && i < word.size(); i += size)
    {
        if (word[i] != '_' || !isDigit(word[i + size - 1]) || !isDigit(word[i + size - 2]))
        {
            return 0;
        }
    }
    return isWhole ? static_cast<int>(word.size() / size) : 0;
}

} // namespace

HlslType HlslType::Number(HlslScalar scalar, int columns, int rows)
{
    HlslType type;
    type.kind = Kind::Number;
    type.scalar = scalar;
    type.rows = static_cast<std::uint8_t>(rows);
    type.columns = static_cast<std::uint8_t>(columns);
    return type;
}

HlslType HlslType::Innermost() const
{
    HlslType type = *this;
    type.dimensions = 0;
    return type;
}

std::string HlslType::Spelling() const
{
    constexpr std::string_view k_Names[] = {"",      "bool",  "int",   "uint",
                                            "float", "float", "float", "double"};
    std::string text(k_Names[static_cast<std::size_t>(scalar)]);
    if (rows > 0)
    {
        return text + std::to_string(rows) + "x" + std::to_string(columns);
    }
    return columns > 1 ? text + std::to_string(columns) : text;
}

std::optional<HlslType> NumberType(std::string_view word)
{
    if (word == "vector" || word == "matrix")
    {
        return HlslType::Number(HlslScalar::Float, 4, word == "matrix" ? 4 : 0);
    }
    for (const auto& [name, scalar] : k_Scalars)
    {
        if (!word.starts_with(name))
        {
            continue;
        }
        const std::string_view size = word.substr(name.size());
        if (size.empty())
        {
            return HlslType::Number(scalar);
        }
        if (size.size() == 1 && isSize(size[0]))
        {
            return HlslType::Number(scalar, size[0] - '0');
        }
        if (size.size() == 3 && isSize(size[0]) && size[1] == 'x' && isSize(size[2]))
        {
            return HlslType::Number(scalar, size[2] - '0', size[0] - '0');
        }
    }
    return std::nullopt;
}

bool isSameType(std::string_view a, std::string_view b)
{
    const auto first = NumberType(a);
    const auto second = NumberType(b);
    return a == b || (first && second && first->Spelling() == second->Spelling());
}

bool isObjectType(std::string_view word)
{
    static const WordList s_Types(
        "Texture1D Texture1DArray Texture2D Texture2DArray Texture2DMS Texture2DMSArray Texture3D "
        "TextureCube TextureCubeArray Buffer StructuredBuffer ByteAddressBuffer "
        "AppendStructuredBuffer ConsumeStructuredBuffer SamplerState SamplerComparisonState "
        "PointStream LineStream TriangleStream sampler sampler1D sampler2D sampler3D samplerCUBE "
        "samplerRECT sampler_state texture texture1D texture2D texture3D textureCUBE textureRECT");
    for (const std::string_view writable : {"RW", "RasterizerOrdered"})
    {
        if (word.starts_with(writable))
        {
            word.remove_prefix(writable.size());
            return s_Types.Has(word);
        }
    }
    return s_Types.Has(word);
}

bool isTypeModifier(std::string_view word)
{
    static const WordList s_Modifiers(
        "static const uniform extern volatile precise shared inline row_major column_major "
        "nointerpolation linear centroid noperspective sample in out inout snorm unorm "
        "groupshared point line triangle lineadj triangleadj");
    return s_Modifiers.Has(word);
}

HlslType Promote(const HlslType& left, const HlslType& right)
{
    if (!left.isNumber() || !right.isNumber())
    {
        return {};
    }
    const HlslScalar scalar = std::max(left.scalar, right.scalar);
    if (left.isScalar() || right.isScalar())
    {
        return (left.isScalar() ? right : left).Of(scalar);
    }
    if (left.isMatrix() != right.isMatrix())
    {
        return {}; // equal numbers of elements are possible; who needs them writes a cast
    }
    return HlslType::Number(scalar, std::min(left.columns, right.columns),
                            std::min(left.rows, right.rows));
}

HlslType IntrinsicType(std::string_view name, std::span<const HlslType> arguments)
{
    if (name.starts_with("tex"))
    {
        static const WordList s_Starts("tex1D tex2D tex3D texCUBE");
        const bool isSample = s_Starts.HasStartOf(name);
        return isSample ? HlslType::Number(HlslScalar::Float, 4) : HlslType();
    }
    if (arguments.empty() || !std::ranges::all_of(arguments, &HlslType::isNumber))
    {
        return {};
    }
    const HlslType& first = arguments.front();
    if (k_Truth.Has(name))
    {
        return HlslType::Number(HlslScalar::Bool);
    }
    if (name == "sign" && first.isMatrix())
    {
        return first.Of(FloatOf(first.scalar)); // SPIR-V has no matrices of integers
    }
    if (const auto converted = k_Converting.find(name); converted != k_Converting.end())
    {
        return first.Of(converted->second);
    }
    if (name == "transpose")
    {
        return first.isMatrix() ? first.As(first.rows, first.columns) : HlslType();
    }
    if (name == "mul" && arguments.size() == 2)
    {
        return ProductType(first, arguments[1]);
    }
    if (name == "refract")
    {
        return PromoteAll(arguments.first(std::min<std::size_t>(arguments.size(), 2)));
    }
    const HlslType all = PromoteAll(arguments);
    if (name == "cross")
    {
        return all.isNumber() ? HlslType::Number(FloatOf(all.scalar), 3) : HlslType();
    }
    if (k_FloatScalars.Has(name))
    {
        const bool isInteger = name == "dot" && !all.isFloating();
        return all.isNumber() ? HlslType::Number(isInteger ? all.scalar : FloatOf(all.scalar))
                              : HlslType();
    }
    if (k_LikeArguments.Has(name) && all.isNumber())
    {
        return k_IntegerLikeArguments.Has(name) ? all : all.Of(FloatOf(all.scalar));
    }
    return {};
}

bool isIntrinsic(std::string_view name)
{
    static const WordList s_Others(
        "abort asdouble asfloat asint asuint clip cross dst errorf f16tof32 f32tof16 isfinite "
        "isinf isnan lit msad4 mul noise printf sign sincos transpose D3DCOLORtoUBYTE4 "
        "CheckAccessFullyMapped NonUniformResourceIndex GetRenderTargetSampleCount "
        "GetRenderTargetSamplePosition limn_Lacks");
    static const WordList s_Starts(
        "tex1D tex2D tex3D texCUBE Interlocked EvaluateAttribute Wave Quad Process");
    return k_LikeArguments.Has(name) || k_FloatScalars.Has(name) || k_Truth.Has(name) ||
           s_Others.Has(name) || name.ends_with("MemoryBarrier") ||
           name.ends_with("MemoryBarrierWithGroupSync") || s_Starts.HasStartOf(name);
}

bool isComponentwise(std::string_view intrinsic)
{
    static const WordList s_OfVectors("normalize faceforward reflect refract");
    return intrinsic == "sign" || (k_LikeArguments.Has(intrinsic) && !s_OfVectors.Has(intrinsic));
}

HlslType MethodType(const HlslType& object, std::string_view method)
{
    if (object.kind != HlslType::Kind::Object)
    {
        return {};
    }
    if (method.starts_with("SampleCmp"))
    {
        return HlslType::Number(HlslScalar::Float);
    }
    if (object.name == "ByteAddressBuffer" || object.name == "RWByteAddressBuffer")
    {
        const bool isLoad = method.starts_with("Load") && method.size() <= 5;
        const int size = method.size() == 5 && isSize(method[4]) ? method[4] - '0' : 1;
        return isLoad ? HlslType::Number(HlslScalar::Uint, size) : HlslType();
    }
    const bool isTexel = method == "Load" || method.starts_with("Sample");
    if (object.element.empty() && (isTexel || method.starts_with("Gather")))
    {
        return HlslType::Number(HlslScalar::Float, 4);
    }
    return isTexel ? NumberType(object.element).value_or(HlslType()) : HlslType();
}

HlslType SwizzleType(const HlslType& type, std::string_view letters)
{
    if (!type.isNumber())
    {
        return {};
    }
    if (type.isMatrix())
    {
        const int count = CountElements(letters);
        return count > 0 && count <= 4 ? type.As(count) : HlslType();
    }
    const bool isKnown =
        letters.size() <= 4 && (letters.find_first_not_of("xyzw") == letters.npos ||
                                letters.find_first_not_of("rgba") == letters.npos);
    return isKnown ? type.As(static_cast<int>(letters.size())) : HlslType();
}

} // namespace limn
