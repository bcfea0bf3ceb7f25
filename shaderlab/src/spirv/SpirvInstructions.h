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
    SpirvWords words;                  ///< the first holds size and op
    std::vector<std::size_t> operands; ///< words that are ids, type and result apart
};

/// @throws ContractError if it is no SPIR-V
std::vector<SpirvInstruction> ParseSpirv(const SpirvWords& spirv);

} // namespace limn
