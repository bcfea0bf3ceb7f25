#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limn
{

/// Reads HLSL line by line as a preprocessor sees it: comments are blanks, and a line that ends in
/// `\` goes on in the next.
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
    void Take(std::string_view rest, std::string& line);

    std::string_view m_Text;
    std::size_t m_Position = 0;
    int m_Line;
    bool m_InComment = false;
    bool m_InString = false; ///< `//` in the name of an include is no comment
};

} // namespace limn
