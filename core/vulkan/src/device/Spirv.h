#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace limn::vulkan
{

using Words = std::vector<std::uint32_t>;

// The header of a module.
inline constexpr std::size_t k_HeaderSize = 5; // words
inline constexpr std::size_t k_BoundWord = 3;

enum Opcode : std::uint32_t
{
    OpLine = 8,
    OpEntryPoint = 15,
    OpCapability = 17,
    OpTypeVoid = 19, ///< the first type
    OpTypeFloat = 22,
    OpTypeImage = 25,
    OpTypePointer = 32,
    OpTypeForwardPointer = 39, ///< the last type
    OpConstant = 43,
    OpFunction = 54,
    OpVariable = 59,
    OpLoad = 61,
    OpStore = 62,
    OpDecorate = 71,
    OpMemberDecorate = 72,
    OpLabel = 248,
    OpNoLine = 317
};

inline constexpr std::uint32_t k_BuiltIn = 11; // a decoration

enum BuiltIn : std::uint32_t
{
    BuiltInPointSize = 1,
    BuiltInVertexIndex = 42
};

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
inline bool isBuiltIn(std::uint32_t op, std::span<const std::uint32_t> words, BuiltIn builtIn)
{
    const std::size_t at = op == OpMemberDecorate ? 3 : 2;
    return (op == OpDecorate || op == OpMemberDecorate) && words.size() > at + 1 &&
           words[at] == k_BuiltIn && words[at + 1] == builtIn;
}

/// Returns whether the module reads or writes the built-in value.
inline bool HasBuiltIn(const Words& spirv, BuiltIn builtIn)
{
    bool has = false;
    EachInstruction(spirv, [&](std::uint32_t op, std::span<const std::uint32_t> words)
                    { has = has || isBuiltIn(op, words, builtIn); });
    return has;
}

} // namespace limn::vulkan
