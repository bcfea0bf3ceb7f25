#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn
{

using Id = std::uint32_t;
using SpirvWords = std::vector<std::uint32_t>;

inline constexpr std::size_t k_SpirvHeaderSize = 5; ///< words
inline constexpr std::size_t k_SpirvBoundWord = 3;

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

} // namespace limn
