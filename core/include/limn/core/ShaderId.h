#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace limn
{

namespace detail
{

/// The number of a name, the same for equal names over the whole process; any thread.
std::uint32_t InternName(std::string_view name);
const std::string& InternedName(std::uint32_t id);

template <typename Tag>
struct NameId
{
    std::uint32_t value = 0; ///< 0 = the empty name

    constexpr NameId() = default;
    explicit NameId(std::string_view name) : value(InternName(name)) {}

    const std::string& name() const { return InternedName(value); }
    bool operator==(const NameId&) const = default;
    bool operator==(std::string_view text) const { return name() == text; }
    auto operator<=>(const NameId&) const = default;
};

struct PropertyTag;
struct ShaderTag;
struct SampleTag;

} // namespace detail

/// A shader property's name as a number, for keeping in a static. Unity: Shader.PropertyToID.
using ShaderPropertyId = detail::NameId<detail::PropertyTag>;

/// The name of a ShaderLab tag's value, above all of LightMode. Unity:
/// UnityEngine.Rendering.ShaderTagId.
using ShaderTagId = detail::NameId<detail::ShaderTag>;

/// The name of a group of GPU work. Each that a process uses is kept to its end.
using SampleName = detail::NameId<detail::SampleTag>;

} // namespace limn

template <typename Tag>
struct std::hash<limn::detail::NameId<Tag>>
{
    std::size_t operator()(limn::detail::NameId<Tag> id) const noexcept { return id.value; }
};
