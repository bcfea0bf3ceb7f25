#include <limn/volume/YamlNode.h>

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

/// yaml-cpp's words for a syntax error, put so that a person finds the spot.
void ReportSyntaxError(const YAML::Exception& e, const YamlTreeBuilder& builder,
                       AssetDiagnostics& diagnostics)
{
    SourceLocation location = builder.ToLocation(e.mark);
    const YamlContent* innermost = builder.innermost();
    std::string message = e.msg;
    if (e.msg == YAML::ErrorMsg::END_OF_MAP || e.msg == YAML::ErrorMsg::END_OF_SEQ)
    {
        message = "this line does not belong to what is above it; check its indentation";
    }
    else if (e.msg == YAML::ErrorMsg::MAP_VALUE)
    {
        message = "a ':' is out of place; check the indentation and the line above, or put the "
                  "text in quotes";
    }
    else if ((e.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW ||
              e.msg == YAML::ErrorMsg::END_OF_MAP_FLOW) &&
             innermost)
    {
        location = innermost->location;
        message = innermost->kind == YamlKind::Map ? "the '{' here is not closed by a '}'"
                                                   : "the '[' here is not closed by a ']'";
    }
    diagnostics.Error(location, "not valid YAML: " + message);
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
        throw AssetError(file, LocationOf(text, *offset, firstLine),
                         "a NUL byte: this is a binary file or UTF-16; UTF-8 text is expected");
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
        ReportSyntaxError(e, builder, diagnostics);
    }
    diagnostics.ThrowIfErrors();
    const bool isEmpty = std::all_of(builder.documents.begin(), builder.documents.end(),
                                     [](const YamlNode& document) { return document.isNull(); });
    if (isEmpty)
    {
        throw AssetError(file, {}, "is empty; it begins with a name and a colon, 'name:'");
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
