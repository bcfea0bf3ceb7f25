#pragma once

#include <limn/shaderlab/Diagnostic.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A token of preprocessed HLSL. Directives and blanks lie between tokens.
struct HlslToken
{
    std::string_view text;
    bool isWord = false; ///< identifier or keyword

    std::size_t Begin(std::string_view source) const
    {
        return static_cast<std::size_t>(text.data() - source.data());
    }
};

/// Views into `source`, which must outlive them.
std::vector<HlslToken> TokenizeHlsl(std::string_view source);

/// Where the character at `offset` of preprocessed text came from, by the #line directives before
/// it.
struct HlslPlace
{
    std::string file;
    SourceLocation location;
};
HlslPlace PlaceOf(std::string_view source, std::size_t offset);

} // namespace limn
