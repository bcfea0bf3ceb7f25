#pragma once

#include <span>
#include <string_view>

namespace limn
{

/// A text file compiled into the program. Both views live as long as the program.
struct EmbeddedFile
{
    std::string_view path; ///< relative to the embedded folder, with '/' as separator
    std::string_view text;
};

} // namespace limn
