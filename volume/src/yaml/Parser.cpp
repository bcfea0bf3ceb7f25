#include "yaml/Text.h"
#include "yaml/TreeBuilder.h"

#include <algorithm>
#include <limn/base/ReadFile.h>
#include <optional>
#include <sstream>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

namespace limn
{

namespace
{

using SyntaxLines = std::vector<std::pair<int, std::string_view>>; ///< with their numbers

struct SyntaxProblem
{
    SourceLocation location;
    std::string message;
};

/// Returns the place of a tab that indents one of the lines, and the line with it.
std::optional<SyntaxProblem> FindTab(const SyntaxLines& lines)
{
    for (const auto& [number, line] : lines)
    {
        const std::size_t blank = line.find_first_not_of(' ');
        if (blank != std::string_view::npos && line[blank] == '\t')
        {
            return SyntaxProblem{{number, static_cast<int>(blank) + 1},
                                 "a tab indents this line; YAML takes spaces only"};
        }
    }
    return std::nullopt;
}

/// Returns the place of "key:value", which YAML takes for a text without a key.
std::optional<SyntaxProblem> FindKeyWithoutSpace(const SyntaxLines& lines)
{
    constexpr std::string_view k_Letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    for (const auto& [number, line] : lines)
    {
        const std::size_t first = line.find_first_not_of(" -");
        const std::size_t colon = line.find_first_not_of(k_Letters, std::min(first, line.size()));
        if (colon != std::string_view::npos && first < colon && colon + 1 < line.size() &&
            line[colon] == ':' &&
            std::string_view(" \r/:").find(line[colon + 1]) == std::string_view::npos)
        {
            return SyntaxProblem{{number, static_cast<int>(colon) + 1},
                                 "a space is missing behind the ':'"};
        }
    }
    return std::nullopt;
}

/// Returns the place of "r: 1 g: 0" within braces, where a comma is missing.
std::optional<SyntaxProblem> FindMissingComma(const SyntaxLines& lines)
{
    for (const auto& [number, line] : lines)
    {
        const std::size_t open = line.find('{');
        for (std::size_t colon = line.find(": ", std::min(open, line.size()));
             colon != std::string_view::npos; colon = line.find(": ", colon + 1))
        {
            const std::size_t next = line.find_first_of(",:{}[]", colon + 1);
            const std::size_t blank =
                next == std::string_view::npos ? next : line.find_last_of(' ', next);
            if (blank != std::string_view::npos && line[next] == ':' && blank > colon + 1)
            {
                return SyntaxProblem{{number, static_cast<int>(blank) + 1},
                                     "a ',' is missing between two values here"};
            }
        }
    }
    return std::nullopt;
}

/// Returns the lines from one to another, with their numbers.
SyntaxLines LinesFrom(std::string_view text, int firstLine, int from, int to)
{
    SyntaxLines lines;
    for (int number = firstLine; number <= to && !text.empty(); ++number)
    {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (number >= from)
        {
            lines.emplace_back(number, text.substr(0, end));
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// Returns yaml-cpp's words for a syntax error, put so that a person finds the spot.
SyntaxProblem InWords(const YAML::Exception& e, const YamlTreeBuilder& builder)
{
    const SourceLocation location = builder.ToLocation(e.mark);
    const YamlContent* innermost = builder.innermost();
    if (e.msg == YAML::ErrorMsg::END_OF_MAP || e.msg == YAML::ErrorMsg::END_OF_SEQ)
    {
        return {location, "this line does not belong to what is above it; check its indentation"};
    }
    if (e.msg == YAML::ErrorMsg::MAP_VALUE)
    {
        return {location, "a ':' is out of place; check the indentation and the line above, or put "
                          "the text in quotes"};
    }
    if ((e.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW || e.msg == YAML::ErrorMsg::END_OF_MAP_FLOW) &&
        innermost)
    {
        return {innermost->location, innermost->kind == YamlKind::Map
                                         ? "the '{' here is not closed by a '}'"
                                         : "the '[' here is not closed by a ']'"};
    }
    return {location, e.msg};
}

/// Adds a syntax error, with its cause where it is one of those that people meet often.
void ReportSyntaxError(const YAML::Exception& e, const YamlTreeBuilder& builder,
                       std::string_view text, int firstLine, AssetDiagnostics& diagnostics)
{
    const SyntaxProblem problem = InWords(e, builder);
    const int line = problem.location.line;
    const SyntaxLines lines = LinesFrom(text, firstLine, line - 1, line);
    std::optional<SyntaxProblem> cause = FindTab(lines);
    if (!cause && (e.msg == YAML::ErrorMsg::MAP_VALUE || e.msg == YAML::ErrorMsg::END_OF_MAP))
    {
        cause = FindKeyWithoutSpace(lines);
    }
    if (!cause && e.msg == YAML::ErrorMsg::END_OF_MAP_FLOW)
    {
        cause = FindMissingComma(LinesFrom(text, firstLine, line, line));
    }
    const SyntaxProblem& found = cause ? *cause : problem;
    diagnostics.Error(found.location, "this is not valid YAML: " + found.message);
}

/// A key that is longer than YAML allows ends a map, as yaml-cpp sees it.
void CheckKeyLength(const YAML::Exception& e, std::string_view text, const std::string& file,
                    int firstLine)
{
    constexpr std::size_t maxLength = 1024;
    const auto begin = static_cast<std::size_t>(std::max(e.mark.pos, 0));
    const char first = begin < text.size() ? text[begin] : '\n';
    const bool isQuoted = first == '"' || first == '\'';
    const std::size_t end =
        isQuoted ? text.find(first, begin + 1) : text.find_first_of(":,[]{}\n", begin);
    if (e.msg == YAML::ErrorMsg::END_OF_MAP_FLOW && end != text.npos && end - begin > maxLength)
    {
        throw AssetError(file, LocationOf(text, begin, firstLine),
                         "the key here is longer than " + std::to_string(maxLength) +
                             " characters, which is the most that YAML allows");
    }
}

void CheckIsText(std::string_view text, const std::string& file, int firstLine)
{
    const std::optional<std::size_t> offset = FindNonText(text);
    if (offset && text[*offset] == '\0')
    {
        throw AssetError(
            file, LocationOf(text, *offset, firstLine),
            "here is a NUL byte, so this is a binary file or UTF-16; UTF-8 text is expected");
    }
    if (offset)
    {
        throw AssetError(file, LocationOf(text, *offset, firstLine),
                         "the bytes here are not UTF-8; save the file as UTF-8 text");
    }
}

void CheckFlow(std::string_view text, const std::string& file, std::size_t maxBytes, int firstLine)
{
    if (const std::optional<std::size_t> offset = FindLongFlow(text, maxBytes))
    {
        throw AssetError(file, LocationOf(text, *offset, firstLine),
                         "the list or map in brackets here is longer than " +
                             std::to_string(maxBytes) +
                             " bytes; put its items on lines of their own, behind '- '");
    }
}

} // namespace

std::vector<YamlNode> ParseYaml(std::string_view text, const std::string& file,
                                const YamlLimits& limits, int firstLine)
{
    CheckIsText(text, file, firstLine);
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark))
    {
        text.remove_prefix(byteOrderMark.size());
    }
    CheckFlow(text, file, limits.flowBytes, firstLine);
    AssetDiagnostics diagnostics(file);
    YamlTreeBuilder builder(text, limits, diagnostics, firstLine);
    try
    {
        std::istringstream stream{std::string(text)};
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder))
        {
        }
        builder.CheckEnd();
    }
    catch (const StopReading&)
    {
        diagnostics.ThrowIfErrors();
    }
    catch (const YAML::Exception& e)
    {
        CheckKeyLength(e, text, file, firstLine);
        ReportSyntaxError(e, builder, text, firstLine, diagnostics);
    }
    diagnostics.ThrowIfErrors();
    if (std::ranges::all_of(builder.documents, &YamlNode::isNull))
    {
        throw AssetError(file, {}, "the file is empty; write a name and a colon first, 'name:'");
    }
    return std::move(builder.documents);
}

std::string ReadYamlText(const std::filesystem::path& path)
{
    return ReadFile(path, k_MaxTextBytes);
}

std::vector<YamlNode> LoadYamlFile(const std::filesystem::path& path)
{
    return ParseYaml(ReadYamlText(path), path.generic_string());
}

} // namespace limn
