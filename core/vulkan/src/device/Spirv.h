#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <spirv_cross/spirv.hpp>
#include <vector>

namespace limn::vulkan
{

using Words = std::vector<std::uint32_t>;

// The header of a module.
inline constexpr std::size_t k_HeaderSize = 5; // words
inline constexpr std::size_t k_BoundWord = 3;

/// Calls `function` with the opcode and the words of each instruction, in order.
template <typename Function>
void EachInstruction(const Words& spirv, const Function& function)
{
    for (std::size_t i = k_HeaderSize; i < spirv.size();)
    {
        const std::size_t size = std::clamp<std::size_t>(spirv[i] >> 16, 1, spirv.size() - i);
        function(spirv[i] & 0xffffu, std::span(spirv).subspan(i, size));
        i += size;
    }
}

/// Returns whether the instruction declares something as this built-in value.
inline bool isBuiltIn(std::uint32_t op, std::span<const std::uint32_t> words, spv::BuiltIn builtIn)
{
    const std::size_t at = op == spv::OpMemberDecorate ? 3 : 2;
    return (op == spv::OpDecorate || op == spv::OpMemberDecorate) && words.size() > at + 1 &&
           words[at] == spv::DecorationBuiltIn && words[at + 1] == builtIn;
}

/// Returns whether the module reads or writes the built-in value.
inline bool HasBuiltIn(const Words& spirv, spv::BuiltIn builtIn)
{
    bool has = false;
    EachInstruction(spirv, [&](std::uint32_t op, std::span<const std::uint32_t> words)
                    { has = has || isBuiltIn(op, words, builtIn); });
    return has;
}

} // namespace limn::vulkan
