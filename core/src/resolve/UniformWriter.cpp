#include "resolve/DrawResolver.h"

#include "material/PropertyValues.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <limn/core/CoreUtils.h>
#include <limn/core/DrawError.h>
#include <limn/core/ShaderKeyword.h>

namespace limn
{

namespace
{

using Bytes = std::span<std::byte>;

/// The bits of the integer that HLSL's cast makes of a number: without its fraction, and the
/// nearest that there is of one too large. To an unsigned one negative numbers are bits, as -1 for
/// all.
std::uint32_t Truncate(float number, UniformType type)
{
    constexpr double k_Least = std::numeric_limits<std::int32_t>::min();
    constexpr double k_Most = std::numeric_limits<std::int32_t>::max();
    constexpr double k_MostUnsigned = std::numeric_limits<std::uint32_t>::max();
    const double most = type == UniformType::UInt ? k_MostUnsigned : k_Most;
    const double kept = std::clamp(std::trunc(static_cast<double>(number)), k_Least, most);
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(kept));
}

void WriteComponents(const UniformPlace& member, const float* values, int count, Bytes bytes)
{
    const int used = std::min<int>(count, member.components);
    for (int i = 0; i < used; ++i)
    {
        std::byte* target = bytes.data() + static_cast<std::size_t>(i) * 4;
        if (member.type == UniformType::Float)
        {
            std::memcpy(target, &values[i], 4);
        }
        else
        {
            const std::uint32_t number = Truncate(values[i], member.type);
            std::memcpy(target, &number, 4);
        }
    }
}

void Write(const UniformPlace& member, float value, Bytes bytes)
{
    WriteComponents(member, &value, 1, bytes);
}

void Write(const UniformPlace& member, const glm::vec4& value, Bytes bytes)
{
    WriteComponents(member, glm::value_ptr(value), 4, bytes);
}

void Write(const UniformPlace& member, const Color& value, Bytes bytes)
{
    Write(member, CoreUtils::ConvertSRGBToActiveColorSpace(value).vector(), bytes);
}

void Write(const UniformPlace&, const glm::mat4& value, Bytes bytes)
{
    std::memcpy(bytes.data(), glm::value_ptr(value), sizeof(glm::mat4));
}

void Write(const UniformPlace& member, int value, Bytes bytes)
{
    if (member.type == UniformType::Float)
    {
        const auto number = static_cast<float>(value);
        std::memcpy(bytes.data(), &number, 4);
    }
    else
    {
        std::memcpy(bytes.data(), &value, 4);
    }
}

template <typename Element>
void Write(const UniformPlace& member, const PropertyArray<Element>& values, Bytes bytes)
{
    const std::size_t count =
        std::min(values.size(), static_cast<std::size_t>(std::max(member.arraySize, 1)));
    for (std::size_t i = 0; i < count; ++i)
    {
        Write(member, values[i], bytes.subspan(i * member.arrayStride));
    }
}

/// Writes consecutive numbers as ComputeShader::SetFloats does. Nothing is written behind the end
/// of the uniform.
template <typename Number>
void WriteConsecutive(const UniformPlace& member, const std::vector<Number>& values, Bytes bytes)
{
    UniformPlace component = member;
    component.components = 1;
    for (std::size_t i = 0; i < std::min(values.size(), bytes.size() / 4); ++i)
    {
        Write(component, values[i], bytes.subspan(i * 4));
    }
}

void Write(const UniformPlace& member, const ConsecutiveParams& params, Bytes bytes)
{
    std::visit([&](const auto& values) { WriteConsecutive(member, values, bytes); }, params.values);
}

const char* KindOf(const ShaderPropertyValue& value)
{
    static constexpr const char* k_Kinds[] = {"a number",
                                              "an integer",
                                              "a vector",
                                              "a color",
                                              "a matrix",
                                              "an array of floats",
                                              "an array of vectors",
                                              "an array of matrices",
                                              "a texture",
                                              "a buffer",
                                              "consecutive numbers"};
    return k_Kinds[value.index()];
}

[[noreturn]] void FailKind(const UniformPlace& member, const ShaderPropertyValue& value,
                           const PropertySources& sources)
{
    throw DrawError(sources.Subject(member.id.name()) + " is set to " + KindOf(value) +
                    ", but the shader declares " +
                    (member.type == UniformType::Matrix4x4 ? "a matrix" : "a number or vector"));
}

bool WriteValue(const UniformPlace& member, const ShaderPropertyValue& value, Bytes bytes)
{
    const bool isMatrix = std::holds_alternative<glm::mat4>(value) ||
                          std::holds_alternative<PropertyArray<glm::mat4>>(value);
    if (isMatrix != (member.type == UniformType::Matrix4x4))
    {
        return false;
    }
    return std::visit(
        [&](const auto& v)
        {
            using Value = std::decay_t<decltype(v)>;
            if constexpr (std::is_same_v<Value, std::shared_ptr<const Texture>> ||
                          std::is_same_v<Value, BufferRange>)
            {
                return false;
            }
            else
            {
                Write(member, v, bytes);
                return true;
            }
        },
        value);
}

/// A texture that was never set is the 1x1 default.
void WriteTexelSize(const UniformPlace& member, const ShaderPropertyValue* value, Bytes bytes)
{
    const auto* texture = std::get_if<std::shared_ptr<const Texture>>(value);
    const bool isSet = texture != nullptr && *texture != nullptr;
    const float w = isSet ? static_cast<float>((*texture)->width()) : 1.0f;
    const float h = isSet ? static_cast<float>((*texture)->height()) : 1.0f;
    const float values[] = {1.0f / w, 1.0f / h, w, h};
    WriteComponents(member, values, 4, bytes);
}

} // namespace

UniformPlace::UniformPlace(const UniformMember& member)
    : id(member.name),
      offset(member.offset),
      size(member.size),
      arrayStride(member.arrayStride),
      arraySize(member.arraySize),
      type(member.type),
      components(static_cast<std::uint8_t>(member.components))
{
    const std::string_view name = member.name;
    constexpr std::string_view k_TexelSize = "_TexelSize";
    if (name.ends_with(k_TexelSize))
    {
        unset = Unset::TexelSize;
        texture = ShaderPropertyId(name.substr(0, name.size() - k_TexelSize.size()));
    }
    // No texture of limn's is encoded: value = x * (w * (alpha - 1) + 1)^y * rgb gives rgb.
    else if (name.ends_with("_ST") || name.ends_with("_HDR"))
    {
        unset = Unset::OneOneZeroZero;
    }
}

bool WriteUniform(const UniformPlace& member, const ShaderPropertyValue* value,
                  const ShaderPropertyValue* texture, std::span<std::byte> buffer)
{
    const Bytes bytes = buffer.subspan(member.offset, member.size);
    std::ranges::fill(bytes, std::byte{0});
    if (value != nullptr)
    {
        return WriteValue(member, *value, bytes);
    }
    if (member.unset == UniformPlace::Unset::TexelSize)
    {
        WriteTexelSize(member, texture, bytes);
    }
    else if (member.unset == UniformPlace::Unset::OneOneZeroZero)
    {
        const float values[] = {1.0f, 1.0f, 0.0f, 0.0f};
        WriteComponents(member, values, 4, bytes);
    }
    return true;
}

void WriteUniform(const UniformPlace& member, const PropertySources& sources,
                  std::span<std::byte> buffer)
{
    const ShaderPropertyValue* value = sources.Find(member.id);
    const bool needsTexture = value == nullptr && member.unset == UniformPlace::Unset::TexelSize;
    if (!WriteUniform(member, value, needsTexture ? sources.Find(member.texture) : nullptr, buffer))
    {
        FailKind(member, *value, sources);
    }
}

void WriteDynamicKeywords(const UniformBuffer& buffer, const PropertySources& sources,
                          std::span<std::byte> bytes)
{
    for (const UniformMember& member : buffer.members)
    {
        const ShaderPropertyValue* forAll = sources.globals->Find(GlobalKeyword(member.name).id());
        const bool isOnForAll = forAll != nullptr && *forAll == ShaderPropertyValue(1);
        const std::int32_t isOn = isOnForAll || sources.IsKeywordEnabled(member.name) ? 1 : 0;
        std::memcpy(bytes.data() + member.offset, &isOn, sizeof(isOn));
    }
}

} // namespace limn
