#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limn
{

/// Reads HLSL line by line as a preprocessor sees it: comments are blanks, a line that ends in `\`
/// goes on in the next, and so does a directive that ends in the middle of a comment.
class HlslLines
{
public:
    /// @param text  must outlive the reader
    HlslLines(std::string_view text, int firstLine) : m_Text(text), m_Line(firstLine) {}

    /// False behind the last line. `number` is where the line starts in the file.
    bool Next(std::string& line, int& number);

    /// Of what was read so far.
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

/// A file's name as a #line directive can hold it, and back: quotes and line breaks change places
/// with letters that no name has.
std::string SwapMarks(std::string name);

} // namespace limn
