#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

namespace limn
{

namespace detail
{

/// A type that C# converts to float implicitly.
template <typename T>
concept WholeNumber = std::integral<T> && !std::same_as<T, bool>;
template <typename T>
concept FloatArgument = std::same_as<T, float> || WholeNumber<T>;

/// Returns the number of a name, which is the same for equal names in the whole process. Any thread
/// may call it.
std::uint32_t InternName(std::string_view name);
const std::string& InternedName(std::uint32_t id);

struct PropertyTag;
struct ShaderTag;
struct SampleTag;
struct ResourceTag;

template <typename Tag>
struct NameId
{
    std::uint32_t value = 0; ///< 0 = the empty name

    constexpr NameId() = default;
    /// Makes the number of a name. The conversion is implicit for properties and resources, since
    /// in Unity a property may be given by its name wherever its number is taken, and the name of a
    /// resource is a string.
    template <std::convertible_to<std::string_view> Text>
    explicit(!std::is_same_v<Tag, PropertyTag> && !std::is_same_v<Tag, ResourceTag>)
        NameId(const Text& name)
        : value(InternName(name))
    {
    }

    const std::string& name() const { return InternedName(value); }
    bool operator==(const NameId&) const = default;
    template <std::convertible_to<std::string_view> Text>
    bool operator==(const Text& text) const
    {
        return name() == text;
    }
    auto operator<=>(const NameId&) const = default;
};

} // namespace detail

/// The name of a shader property as a number. Functions that take one take a string, too, which is
/// looked up in a table of the process each time: if that happens each frame, keep the number in a
/// static. Each name is kept until the process ends. Unity: Shader.PropertyToID, and the overloads
/// of Material.SetFloat and the like that take a string (2022.3).
using ShaderPropertyId = detail::NameId<detail::PropertyTag>;

/// The name of a ShaderLab tag's value, above all of LightMode. Unity:
/// UnityEngine.Rendering.ShaderTagId.
using ShaderTagId = detail::NameId<detail::ShaderTag>;

/// The name of a group of GPU work. Each name that a process uses is kept until it ends.
using SampleName = detail::NameId<detail::SampleTag>;

/// The name of a texture or buffer in a render graph: the same text each frame costs no memory.
/// Each name that a process uses is kept until it ends.
using ResourceName = detail::NameId<detail::ResourceTag>;

} // namespace limn

template <typename Tag>
struct std::hash<limn::detail::NameId<Tag>>
{
    std::size_t operator()(limn::detail::NameId<Tag> id) const noexcept { return id.value; }
};
