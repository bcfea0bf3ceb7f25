#include "report/pages/ReportText.h"

#include "explain/TextLines.h"

#include <algorithm>
#include <limn/base/EmbeddedFile.h>
#include <limn/base/ReadFile.h>
#include <limn/base/TerminalText.h>

namespace limn::embedded
{
std::span<const EmbeddedFile> ReportPage();
}

namespace limn::study
{

namespace
{

std::string HtmlText(const std::string& text)
{
    return Replaced(MarkupText(OneLine(text)), "'", "&#39;");
}

std::string Base64(const std::string& bytes)
{
    constexpr const char* k_Letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        const auto at = [&bytes](std::size_t place)
        {
            return place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0u;
        };
        const unsigned bits = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
        for (unsigned letter = 0; letter < 4; ++letter)
        {
            const bool isThere = i + letter < bytes.size() + 1;
            result += isThere ? k_Letters[bits >> (18 - 6 * letter) & 63] : '=';
        }
    }
    return result;
}

std::string Paragraph(const std::string& text)
{
    return "<p>" + HtmlText(text) + "</p>\n";
}

std::string HtmlTable(const Table& table)
{
    constexpr std::size_t k_Few = 16; // rows that need no scrolling down
    const bool isLong = table.rows.size() > k_Few;
    std::string text = table.title.empty() ? "" : "<h3>" + HtmlText(table.title) + "</h3>\n";
    text +=
        isLong ? Paragraph(std::to_string(table.rows.size()) + " rows; the table scrolls.") : "";
    text += std::string("<div class=\"scroll") + (isLong ? " long" : "") +
            "\" tabindex=\"0\" role=\"region\" aria-label=\"" +
            HtmlText(table.title.empty() ? table.id : table.title) + "\"><table id=\"" + table.id +
            "\">\n<thead><tr>";
    for (const TableColumn& column : table.columns)
    {
        text += std::string("<th scope=\"col\"") + (column.isNumber ? " class=\"number\">" : ">") +
                HtmlText(column.title) +
                (column.unit.empty() ? "" : " <span>" + HtmlText(column.unit) + "</span>") +
                "</th>";
    }
    text += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i)
    {
        const bool isMarked = std::ranges::find(table.marked, i) != table.marked.end();
        text += isMarked ? "<tr class=\"marked\">" : "<tr>";
        for (std::size_t j = 0; j < table.rows[i].size(); ++j)
        {
            const std::string cell = HtmlText(table.rows[i][j]);
            text += j == 0                      ? "<th scope=\"row\">" + cell + "</th>"
                    : table.columns[j].isNumber ? "<td class=\"number\">" + cell + "</td>"
                                                : "<td>" + cell + "</td>";
        }
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

/// Without the elements of that name.
std::string Without(std::string text, const std::string& element)
{
    const std::string end = "</" + element + ">";
    for (std::size_t from = 0; (from = text.find("<" + element + ">", from)) != std::string::npos;)
    {
        const std::size_t to = text.find(end, from);
        text.erase(from, to == std::string::npos ? to : to + end.size() - from);
    }
    return text;
}

/// From <svg to </svg>, without the names that gnuplot gives its parts: browsers show them as tips.
std::string InlineSvg(const std::string& svg, const std::string& kind, const std::string& title)
{
    const std::size_t begin = svg.find("<svg");
    if (begin == std::string::npos)
    {
        return "";
    }
    return "<svg class=\"" + kind + "\" role=\"img\" aria-label=\"" + HtmlText(title) + "\"" +
           Without(Without(svg.substr(begin + 4), "title"), "desc");
}

std::string HtmlPlot(const Plot& plot, const DrawnPlots& drawn)
{
    const auto found = drawn.find(plot.file);
    if (found == drawn.end())
    {
        return "";
    }
    return "<figure class=\"plot\" id=\"" + plot.file + "\">\n" +
           InlineSvg(found->second.svg, "wide", plot.title) +
           InlineSvg(found->second.narrowSvg, "narrow", plot.title) + "<figcaption>" +
           HtmlText(plot.caption) + "</figcaption>\n</figure>\n";
}

/// @param caption  HTML
std::string HtmlFigure(const std::string& what, const std::string& file, const std::string& caption,
                       const std::filesystem::path& folder)
{
    const FileContent content = TryReadFile(folder / file, k_MaxDataBytes);
    return content.isRead()
               ? "<figure><img alt=\"" + HtmlText(what) + "\" src=\"data:image/png;base64," +
                     Base64(content.bytes) + "\"><figcaption>" + caption + "</figcaption></figure>"
               : "<p>" + HtmlText(file + ": " + content.problem) + "</p>";
}

std::string HtmlTiles(const ReportText& report, const std::filesystem::path& folder)
{
    if (report.tiles.empty())
    {
        return "";
    }
    std::string text = "<ul class=\"tiles\">\n";
    for (const Tile& tile : report.tiles)
    {
        const std::string caption = "<strong>" + HtmlText(tile.technique) + "</strong>" +
                                    (tile.isRecommended ? " <em>recommended</em>" : "") +
                                    (tile.isArticle ? " <em class=\"article\">article</em>" : "") +
                                    "<span>" + HtmlText(tile.error) + "</span><span>" +
                                    HtmlText(tile.time) + "</span>";
        text += std::string(tile.isRecommended ? "<li class=\"marked\">" : "<li>") +
                HtmlFigure(tile.technique, tile.picture, caption, folder) + "</li>\n";
    }
    return text + "</ul>\n" + Paragraph(report.tilesCaption);
}

std::string HtmlSection(const Section& section, const ReportText& report,
                        const std::filesystem::path& folder, const DrawnPlots& drawn)
{
    std::string text =
        "<section id=\"" + section.id + "\">\n<h2>" + HtmlText(section.title) + "</h2>\n";
    text += Joined(section.paragraphs, "", Paragraph);
    for (const Plot& plot : report.plots)
    {
        const bool isHere = std::ranges::find(section.plots, plot.file) != section.plots.end();
        text += isHere ? HtmlPlot(plot, drawn) : "";
    }
    text += Joined(section.tables, "", HtmlTable);
    for (const Strip& strip : section.strips)
    {
        text += "<h3>" + HtmlText(strip.title) + "</h3>\n<div class=\"strip\">";
        for (const auto& [what, file] : strip.pictures)
        {
            text += HtmlFigure(what, file, HtmlText(what), folder);
        }
        text += "</div>\n";
    }
    return text + "</section>\n";
}

} // namespace

std::string HtmlPage(const ReportText& report, const std::filesystem::path& folder,
                     const DrawnPlots& drawn)
{
    std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                       "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
                       HtmlText(report.title) + "</title>\n<style>\n" +
                       std::string(embedded::ReportPage().front().text) +
                       "</style>\n</head>\n<body>\n<header><h1>" + HtmlText(report.title) +
                       "</h1>\n" + Paragraph(report.subtitle) + HtmlTiles(report, folder) +
                       "<div class=\"recommendation\">" + Paragraph(report.recommendation) +
                       (report.more.empty() ? "" : Paragraph(report.more)) + "</div>\n";
    text += report.remarks.empty()
                ? "<nav>"
                : "<ul class=\"remarks\">\n<li>" + Joined(report.remarks, "</li>\n<li>", HtmlText) +
                      "</li>\n</ul>\n<nav>";
    const auto link = [](const Section& section)
    {
        return "<a href=\"#" + section.id + "\">" + HtmlText(section.title) + "</a> ";
    };
    const auto sectionText = [&](const Section& section)
    {
        return HtmlSection(section, report, folder, drawn);
    };
    return text + Joined(report.sections, "", link) + "</nav></header>\n<main>\n" +
           Joined(report.sections, "", sectionText) + "</main>\n</body>\n</html>\n";
}

} // namespace limn::study
