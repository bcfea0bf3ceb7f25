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

/// What C# makes a float of by itself.
template <typename T>
concept WholeNumber = std::integral<T> && !std::same_as<T, bool>;
template <typename T>
concept FloatArgument = std::same_as<T, float> || WholeNumber<T>;

/// The number of a name, the same for equal names over the whole process; any thread.
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
    /// A property may be called by its name wherever its number is taken, as in Unity, and a
    /// resource's name is a text there.
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

/// A shader property's name as a number. Whatever takes one takes a string, too, which is looked up
/// in a table of the process each time: keep the number in a static where that is each frame. Each
/// name is kept to the end of the process. Unity: Shader.PropertyToID, and the overloads of
/// Material.SetFloat and the like that take a string (2022.3).
using ShaderPropertyId = detail::NameId<detail::PropertyTag>;

/// The name of a ShaderLab tag's value, above all of LightMode. Unity:
/// UnityEngine.Rendering.ShaderTagId.
using ShaderTagId = detail::NameId<detail::ShaderTag>;

/// The name of a group of GPU work. Each that a process uses is kept to its end.
using SampleName = detail::NameId<detail::SampleTag>;

/// What a render graph calls a texture or buffer: the same text each frame costs no memory. Each
/// that a process uses is kept to its end.
using ResourceName = detail::NameId<detail::ResourceTag>;

} // namespace limn

template <typename Tag>
struct std::hash<limn::detail::NameId<Tag>>
{
    std::size_t operator()(limn::detail::NameId<Tag> id) const noexcept { return id.value; }
};
