#include "console/FitLines.h"

#include <algorithm>
#include <limn/base/Text.h>
#include <vector>

namespace limn
{

namespace
{

constexpr std::string_view k_Gap = "  "; ///< the least that stands between two columns

/// A line in its parts: `indent` blanks, and cells with the blanks in front of each.
struct TableRow
{
    struct Cell
    {
        std::size_t blanks; ///< between it and the cell before it
        std::string_view text;
    };

    std::size_t indent = 0;
    std::vector<Cell> cells;

    bool hasColumns() const { return cells.size() > 1; }
    /// Returns the column at which the second cell begins.
    std::size_t secondColumn() const { return indent + ColumnsOf(cells[0].text) + cells[1].blanks; }
};

TableRow SplitTableRow(std::string_view line)
{
    TableRow row;
    row.indent = std::min(line.find_first_not_of(' '), line.size());
    line.remove_prefix(row.indent);
    std::size_t blanks = 0;
    while (!line.empty())
    {
        const std::string_view text = line.substr(0, line.find(k_Gap));
        row.cells.push_back({blanks, text});
        line.remove_prefix(text.size());
        blanks = std::min(line.find_first_not_of(' '), line.size());
        line.remove_prefix(blanks);
    }
    return row;
}

/// Writes words into lines of a width, all but the first of which begin at `hang`.
class Filler
{
public:
    Filler(std::size_t indent, std::size_t hang, std::size_t width)
        : m_Line(indent, ' '), m_Columns(indent), m_Hang(hang), m_Width(width)
    {
    }

    /// Adds a cell. One that fits into a line of its own is not broken.
    void Add(const TableRow::Cell& cell)
    {
        const std::size_t columns = ColumnsOf(cell.text);
        if (Fits(cell.blanks + columns) || (!m_IsEmpty && m_Hang + columns <= m_Width))
        {
            AddWord(cell.text, cell.blanks);
            return;
        }
        std::size_t blanks = cell.blanks;
        std::string_view rest = cell.text;
        while (!rest.empty())
        {
            const std::string_view word = TakeWord(rest);
            AddWord(word, blanks);
            blanks = 1;
        }
    }

    std::string Text() const { return m_Text + m_Line; }

private:
    bool Fits(std::size_t columns) const { return m_Columns + columns <= m_Width; }

    void AddWord(std::string_view word, std::size_t blanks)
    {
        const std::size_t columns = ColumnsOf(word);
        if (!m_IsEmpty && !Fits(blanks + columns))
        {
            m_Text += m_Line + "\n";
            m_Line = std::string(m_Hang, ' ');
            m_Columns = m_Hang;
            m_IsEmpty = true;
        }
        blanks = m_IsEmpty ? 0 : blanks;
        m_Line += std::string(blanks, ' ') + std::string(word);
        m_Columns += blanks + columns;
        m_IsEmpty = false;
    }

    std::string m_Text; ///< the lines that are full
    std::string m_Line;
    std::size_t m_Columns;
    std::size_t m_Hang;
    std::size_t m_Width;
    bool m_IsEmpty = true; ///< true until the line has a word
};

std::string FitTableRow(TableRow row, std::size_t width, bool isTight)
{
    for (std::size_t i = 2; isTight && i < row.cells.size(); ++i)
    {
        row.cells[i].blanks = k_Gap.size();
    }
    const bool isBelowColumn = row.hasColumns() && row.secondColumn() <= width / 2;
    const std::size_t hang =
        isBelowColumn ? row.secondColumn() : std::min(row.indent + 2, width / 2);
    Filler filler(row.indent, hang, width);
    for (const TableRow::Cell& cell : row.cells)
    {
        filler.Add(cell);
    }
    return filler.Text();
}

} // namespace

std::size_t ColumnsOf(std::string_view line)
{
    std::size_t columns = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
        if (line[i] == '\033')
        {
            i = std::min(line.find('m', i), line.size());
            continue;
        }
        columns += isInsideCharacter(line[i]) ? 0 : 1;
    }
    return columns;
}

std::string FitLines(std::string_view text, std::size_t width)
{
    std::vector<std::string_view> lines;
    const bool isEnded = text.ends_with('\n');
    for (std::string_view rest = text; !rest.empty();)
    {
        lines.push_back(rest.substr(0, rest.find('\n')));
        rest.remove_prefix(std::min(lines.back().size() + 1, rest.size()));
    }
    std::string fitted;
    for (std::size_t begin = 0, end = 0; begin < lines.size(); begin = end)
    {
        // Rows of one table are those of one indent that follow each other.
        const TableRow first = SplitTableRow(lines[begin]);
        bool fits = true;
        do
        {
            fits = fits && ColumnsOf(lines[end]) <= width;
            ++end;
        } while (end < lines.size() && first.hasColumns() &&
                 SplitTableRow(lines[end]).hasColumns() &&
                 SplitTableRow(lines[end]).indent == first.indent);
        for (std::size_t i = begin; i < end; ++i)
        {
            fitted +=
                fits ? std::string(lines[i]) : FitTableRow(SplitTableRow(lines[i]), width, !fits);
            fitted += i + 1 < lines.size() || isEnded ? "\n" : "";
        }
    }
    return fitted;
}

std::string Wrapped(std::string_view words, std::size_t column, std::size_t hang, std::size_t width)
{
    Filler filler(column, hang, width);
    filler.Add({0, words});
    return filler.Text().substr(column) + "\n";
}

std::string CutLine(std::string_view line, std::size_t width)
{
    if (ColumnsOf(line) <= width || width == 0)
    {
        return std::string(line);
    }
    std::size_t end = 0;
    for (std::size_t columns = 0; end < line.size(); ++end)
    {
        columns += isInsideCharacter(line[end]) ? 0 : 1;
        if (columns == width)
        {
            break;
        }
    }
    return std::string(line.substr(0, end)) + "…";
}

} // namespace limn
