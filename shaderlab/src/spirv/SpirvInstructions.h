#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace limn
{

using Id = std::uint32_t;
using SpirvWords = std::vector<std::uint32_t>;

inline constexpr std::size_t k_SpirvHeaderSize = 5; ///< words
inline constexpr std::size_t k_SpirvBoundWord = 3;
inline constexpr std::uint32_t k_SpirvFunction = 54; ///< spv::OpFunction

struct SpirvInstruction
{
    std::uint32_t op = 0;
    Id type = 0;
    Id result = 0;
    SpirvWords words; ///< the first holds size and op
    /// Indices of the words that are ids, except type and result.
    std::vector<std::size_t> operands;
};

/// @throws ContractError if the words are no SPIR-V
std::vector<SpirvInstruction> ParseSpirv(const SpirvWords& spirv);

/// Calls `each` with opcode and words of the instructions before the first one of the opcode `end`,
/// or of all.
template <typename Words, typename Each>
void ForEachInstruction(Words& spirv, const Each& each, std::uint32_t end = 0xffff)
{
    for (std::size_t i = k_SpirvHeaderSize; i < spirv.size();)
    {
        const std::uint32_t op = spirv[i] & 0xffffu;
        const std::size_t size = std::clamp<std::size_t>(spirv[i] >> 16, 1, spirv.size() - i);
        if (op == end)
        {
            return;
        }
        each(op, std::span(spirv).subspan(i, size));
        i += size;
    }
}

/// Calls `each` with opcode and words of the instructions before the first function.
template <typename Words, typename Each>
void ForEachDeclaration(Words& spirv, const Each& each)
{
    ForEachInstruction(spirv, each, k_SpirvFunction);
}

} // namespace limn
