#pragma once

#include "console/Texts.h"

#include <algorithm>
#include <iterator>
#include <limn/base/TerminalText.h>
#include <span>
#include <string>
#include <vector>

namespace limn
{

/// The lines of a text for people, without their ends.
using TextLines = std::vector<std::string>;

/// Returns the text of each item.
template <typename Items, typename TextOf>
TextLines LinesOf(const Items& items, const TextOf& textOf)
{
    TextLines lines;
    std::ranges::transform(items, std::back_inserter(lines), textOf);
    return lines;
}

/// Returns "title:" and the lines below it; "" without lines.
/// @param most  the number of lines that are shown; a last one says how many there are beside them
inline std::string Section(const std::string& title, const TextLines& lines,
                           std::size_t most = static_cast<std::size_t>(-1))
{
    std::string text = lines.empty() ? "" : title + ":\n";
    for (const std::string& line : std::span(lines).first(std::min(most, lines.size())))
    {
        text += "  " + OneLine(line) + "\n";
    }
    return text + (lines.size() > most
                       ? "  … and " + std::to_string(lines.size() - most) + " more; -v lists them\n"
                       : "");
}

/// Returns the text as HTML and XML have it between tags and in attributes.
inline std::string MarkupText(const std::string& text)
{
    return Replaced(Replaced(Replaced(Replaced(text, "&", "&amp;"), "<", "&lt;"), ">", "&gt;"),
                    "\"", "&quot;");
}

} // namespace limn
