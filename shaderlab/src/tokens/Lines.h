#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limn
{

/// Reads HLSL line by line as a preprocessor sees it: comments are blanks, a line that ends in `\`
/// continues in the next, and so does a directive that ends in the middle of a comment.
class HlslLines
{
public:
    /// @param text  must outlive the reader
    HlslLines(std::string_view text, int firstLine) : m_Text(text), m_Line(firstLine) {}

    /// Reads the next line; returns false behind the last one. `number` receives the number of the
    /// line in the file at which it starts.
    bool Next(std::string& line, int& number);

    /// Returns whether the text read so far ends in a comment.
    bool endsInComment() const { return m_InComment; }

private:
    void TakeCode(std::string& line);
    void SkipComment();
    bool GoesOn(std::string& line) const;

    std::string_view m_Text;
    std::size_t m_Position = 0;
    int m_Line;
    bool m_InComment = false; ///< a `/*`
    bool m_InLineComment = false;
    bool m_InString = false; ///< `//` in the name of an include is no comment
};

/// Converts a file's name to one that a #line directive can hold, and back: swaps quotes and line
/// breaks with letters that no name has.
std::string SwapMarks(std::string name);

} // namespace limn
