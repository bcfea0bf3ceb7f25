#pragma once

#include <limn/shaderlab/PassProgram.h>

#include <cstdint>
#include <string>
#include <vector>

namespace limn
{

/// A number of shader variants. It is a whole number without an upper bound, because real shaders
/// have more variants than 64 bits can count.
class VariantCount
{
public:
    VariantCount(std::uint32_t value = 0);

    VariantCount& operator+=(const VariantCount& other);
    VariantCount& operator*=(std::uint32_t factor);
    std::string ToString() const; ///< decimal digits

    bool operator==(const VariantCount&) const = default;

private:
    /// Parts of nine digits each, lowest first; the highest is not zero.
    std::vector<std::uint32_t> m_Parts;
};

/// Returns the number of variants of the program: the product of the sizes of its keyword sets
/// without the keywords that `#pragma skip_variants` drops. Equal sets count once, the keywords of
/// dynamic_branch sets not at all. Nothing is compiled.
VariantCount CountVariants(const PassProgram& program);

} // namespace limn
