#include "report/pages/ReportText.h"

#include "console/Texts.h"

#include <algorithm>
#include <limn/base/TerminalText.h>

namespace limn::study
{

namespace
{

/// Returns the text on one line without markup.
std::string MarkdownText(const std::string& text)
{
    std::string result;
    for (const char c : OneLine(text))
    {
        const bool isMarkup = std::string_view("\\`*_{}[]#|~!").find(c) != std::string_view::npos;
        result += c == '<'   ? "&lt;"
                  : c == '&' ? "&amp;"
                  : isMarkup ? std::string("\\") + c
                             : std::string(1, c);
    }
    return result;
}

/// A file below the report's folder as an address.
std::string Address(const std::string& path)
{
    constexpr const char* k_Digits = "0123456789ABCDEF";
    std::string result;
    for (const char c : path)
    {
        const auto byte = static_cast<unsigned char>(c);
        const bool isPlain =
            std::isalnum(byte) != 0 || std::string_view("/._-").find(c) != std::string_view::npos;
        result += isPlain ? std::string(1, c)
                          : std::string("%") + k_Digits[byte >> 4] + k_Digits[byte & 15];
    }
    return result;
}

std::string MarkdownTable(const Table& table)
{
    std::string text = table.title.empty() ? "" : "**" + MarkdownText(table.title) + "**\n\n";
    std::string head = "|";
    std::string line = "|";
    for (const TableColumn& column : table.columns)
    {
        head += " " + MarkdownText(column.title) +
                (column.unit.empty() ? "" : ", " + MarkdownText(column.unit)) + " |";
        line += column.isNumber ? " ---: |" : " --- |";
    }
    text += head + "\n" + line + "\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i)
    {
        const bool isMarked = std::ranges::find(table.marked, i) != table.marked.end();
        text += "|";
        for (std::size_t j = 0; j < table.rows[i].size(); ++j)
        {
            const std::string cell = MarkdownText(table.rows[i][j]);
            text += isMarked && j == 0 ? " **" + cell + "** |" : " " + cell + " |";
        }
        text += "\n";
    }
    return text + "\n";
}

std::string MarkdownTiles(const ReportText& report)
{
    if (report.tiles.empty())
    {
        return "";
    }
    std::string text = "| picture | technique | error | time added |\n| --- | --- | --- | --- |\n";
    for (const Tile& tile : report.tiles)
    {
        const std::string name = MarkdownText(tile.technique);
        text += "| ![" + name + "](" + Address(tile.picture) + ") | " +
                (tile.isRecommended ? "**" + name + "**, recommended" : name) +
                (tile.isArticle ? ", an article's" : "") + " | " + MarkdownText(tile.error) +
                " | " + MarkdownText(tile.time) + " |\n";
    }
    return text + "\n" + MarkdownText(report.tilesCaption) + "\n\n";
}

std::string MarkdownStrip(const Strip& strip)
{
    std::string text = MarkdownText(strip.title) + ":\n\n";
    for (const auto& [what, file] : strip.pictures)
    {
        text += "![" + MarkdownText(what) + "](" + Address(file) + ") ";
    }
    return text + "\n\n";
}

} // namespace

std::string MarkdownPage(const ReportText& report, const DrawnPlots& drawn)
{
    std::string text = "# " + MarkdownText(report.title) + "\n\n" + MarkdownText(report.subtitle) +
                       "\n\n" + MarkdownTiles(report) + "**" + MarkdownText(report.recommendation) +
                       "**\n\n" + (report.more.empty() ? "" : MarkdownText(report.more) + "\n\n");
    for (const std::string& remark : report.remarks)
    {
        text += "> " + MarkdownText(remark) + "\n\n";
    }
    for (const Section& section : report.sections)
    {
        text += "## " + MarkdownText(section.title) + "\n\n";
        for (const std::string& paragraph : section.paragraphs)
        {
            text += MarkdownText(paragraph) + "\n\n";
        }
        for (const Plot& plot : report.plots)
        {
            if (std::ranges::find(section.plots, plot.file) != section.plots.end())
            {
                text += drawn.contains(plot.file)
                            ? "![" + MarkdownText(plot.title) + "](plots/" + plot.file + ".svg)\n\n"
                            : "";
                text += MarkdownText(plot.caption) + "\n\n";
            }
        }
        text +=
            Joined(section.tables, "", MarkdownTable) + Joined(section.strips, "", MarkdownStrip);
    }
    return text;
}

} // namespace limn::study
