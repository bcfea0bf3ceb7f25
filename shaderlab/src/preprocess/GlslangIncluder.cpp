#include "preprocess/GlslangIncluder.h"

#include "lowering/GlslangGuards.h"
#include "tokens/Lines.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <utility>

namespace limn
{

namespace
{

constexpr std::size_t k_MaximumIncludeDepth = 64;
constexpr std::size_t k_MaximumCount = 10'000;
constexpr std::size_t k_MaximumTotal = std::size_t{256} << 20;

/// Returns the text behind the name if the line is the directive `name`. Blanks may stand around
/// the `#`.
std::optional<std::string_view> BehindDirective(std::string_view line, std::string_view name)
{
    line = Trim(line);
    if (!line.starts_with("#"))
    {
        return std::nullopt;
    }
    line = Trim(line.substr(1));
    const bool isName =
        line.starts_with(name) && (line.size() == name.size() || !isLetter(line[name.size()]));
    return isName ? std::optional(line.substr(name.size())) : std::nullopt;
}

std::string_view WithoutByteOrderMark(std::string_view text)
{
    constexpr std::string_view k_Utf8Mark = "\xEF\xBB\xBF";
    while (text.starts_with(k_Utf8Mark))
    {
        text.remove_prefix(k_Utf8Mark.size());
    }
    return text;
}

bool HasPragmaOnce(std::string_view text)
{
    text = WithoutByteOrderMark(text);
    for (std::size_t at = text.find("once"); at != text.npos; at = text.find("once", at + 1))
    {
        const std::size_t start = text.rfind('\n', at);
        const std::string_view line = text.substr(start == text.npos ? 0 : start + 1);
        const auto pragma = BehindDirective(line.substr(0, line.find('\n')), "pragma");
        if (pragma && Trim(*pragma).starts_with("once"))
        {
            return true;
        }
    }
    return false;
}

// The preprocessor takes the blanks out of a pragma, so that the message is one word: two letters a
// byte.
constexpr std::string_view k_WarningPragma = "#pragma limn_warning_";

std::string WriteWarningPragma(std::string_view message)
{
    constexpr std::size_t k_LongestMessage = 400; // glslang's words have up to 1024 letters
    std::string line(k_WarningPragma);
    for (const char c : message.substr(0, k_LongestMessage))
    {
        const int byte = static_cast<unsigned char>(c);
        line += static_cast<char>('a' + byte / 16);
        line += static_cast<char>('a' + byte % 16);
    }
    return line;
}

/// Gives a line as glslang is to see it.
std::string TranslateLine(std::string_view line)
{
    if (const auto file = BehindDirective(line, "include_with_pragmas"))
    {
        return "#include" + std::string(*file);
    }
    if (const auto warning = BehindDirective(line, "warning"))
    {
        return WriteWarningPragma(Trim(*warning));
    }
    if (const auto pragma = BehindDirective(line, "pragma"))
    {
        // The pragmas are Unity's; matrix packing alone is the compiler's business. Real files
        // contain `#pragma x#define y`, a line break forgotten.
        const std::size_t glued = pragma->find('#');
        const bool isPacking = Trim(*pragma).starts_with("pack_matrix");
        return isPacking               ? std::string(line)
               : glued != pragma->npos ? std::string(pragma->substr(glued))
                                       : "";
    }
    return std::string(line);
}

/// `o. ## name` as `o. name`: a dot and a name are no one token, and glslang says so, where Unity's
/// compilers leave both as they are.
std::string PasteNoDots(std::string line)
{
    for (std::size_t at = line.find("##"); at != line.npos; at = line.find("##", at))
    {
        const std::size_t before = line.find_last_not_of(" \t", at - 1);
        const std::size_t behind = line.find_first_not_of(" \t", at + 2);
        const bool isBehindDot = at > 0 && before != line.npos && line[before] == '.';
        const bool isBeforeDot = behind != line.npos && line[behind] == '.';
        if (isBehindDot || isBeforeDot)
        {
            line.replace(at, 2, "  ");
        }
        at += 2;
    }
    return line;
}

/// `1.#INF`, `1.#IND` and `1.#QNAN` are numbers of the C runtime that Unity's compilers read; here
/// by their bits.
std::string SpellNonFinite(std::string line)
{
    constexpr std::pair<std::string_view, std::string_view> k_Numbers[] = {
        {".#INF", "asfloat(0x7F800000)"},
        {".#IND", "asfloat(0x7FC00000)"},
        {".#QNAN", "asfloat(0x7FC00000)"},
        {".#SNAN", "asfloat(0x7F800001)"}};
    for (const auto& [mark, bits] : k_Numbers)
    {
        for (std::size_t at = line.find(mark); at != line.npos; at = line.find(mark, at))
        {
            std::size_t first = at;
            while (first > 0 && isDigit(line[first - 1]))
            {
                --first;
            }
            std::size_t end = at + mark.size();
            end += end < line.size() && (ToLower(line[end]) == 'f' || ToLower(line[end]) == 'h');
            line.replace(first, end - first, bits);
            at = first + bits.size();
        }
    }
    return line;
}

/// `'A'` by its number: glslang reads over the quotes.
std::string SpellCharacters(std::string line)
{
    constexpr std::size_t k_Size = 3;
    for (std::size_t at = line.find('\''); at != line.npos; at = line.find('\'', at + 1))
    {
        const bool isCharacter = at + k_Size <= line.size() && line[at + 2] == '\'' &&
                                 line[at + 1] != '\\' && line[at + 1] != '\'' &&
                                 (at == 0 || !isNameCharacter(line[at - 1]));
        if (isCharacter)
        {
            line.replace(at, k_Size, std::to_string(static_cast<unsigned char>(line[at + 1])));
        }
    }
    return line;
}

} // namespace

std::string TranslateDirectives(std::string_view text)
{
    text = WithoutByteOrderMark(text);
    std::string result;
    result.reserve(text.size() + 1);
    HlslLines lines(text, 1);
    std::string line;
    int written = 1;
    for (int number = 0; lines.Next(line, number);)
    {
        // Lines that go on are one, and those behind them keep their number.
        result.append(static_cast<std::size_t>(number - written), '\n');
        written = number;
        const bool isDirective = line.find('#') != line.npos;
        std::string translated = isDirective ? PasteNoDots(SpellNonFinite(TranslateLine(line)))
                                             : std::string(Trim(line));
        if (!isDirective || BehindDirective(line, "define"))
        {
            translated = SpellCharacters(std::move(translated));
        }
        result.append(translated);
    }
    if (lines.endsInComment())
    {
        result += "/*"; // glslang says so
    }
    const auto missing =
        std::ranges::count(text, '\n') - (written - 1); // by a last line that goes on
    result.append(static_cast<std::size_t>(std::max<std::ptrdiff_t>(missing, 1)), '\n');
    return result;
}

std::optional<std::string> ReadWarningPragma(std::string_view line)
{
    line = Trim(line);
    if (!line.starts_with(k_WarningPragma))
    {
        return std::nullopt;
    }
    std::string message;
    line.remove_prefix(k_WarningPragma.size());
    for (; line.size() > 1; line.remove_prefix(2))
    {
        message += static_cast<char>((line[0] - 'a') * 16 + (line[1] - 'a'));
    }
    return message;
}

bool NamesStages(std::string_view text)
{
    return text.find("SHADER_STAGE_") != text.npos;
}

glslang::TShader::Includer::IncludeResult*
GlslangIncluder::includeLocal(const char* header, const char* includer, std::size_t depth)
{
    m_FailedHeader.clear();
    IncludeResult* const result = Include(header, includer, depth);
    if (!result || result->headerName.empty())
    {
        m_FailedHeader = header;
        m_FailedDepth = depth;
        m_FailedResult = result;
    }
    return result;
}

glslang::TShader::Includer::IncludeResult*
GlslangIncluder::includeSystem(const char* header, const char* includer, std::size_t depth)
{
    const bool isSecondTry = depth == m_FailedDepth && header == m_FailedHeader;
    return isSecondTry ? m_FailedResult : Include(header, includer, depth);
}

glslang::TShader::Includer::IncludeResult*
GlslangIncluder::Include(const std::string& header, const char* includer, std::size_t depth)
{
    if (m_HasStopped)
    {
        return Keep(header, "\n"); // why it stopped is said already
    }
    m_Chain.resize(std::min(depth - 1, m_Chain.size()));
    std::string problem = ReasonToStop(depth);
    auto file = problem.empty() ? m_Resolver.Find(header, SwapMarks(includer)) : std::nullopt;
    if (const auto line = file && !file->isEmbedded ? FindDeepMacros(file->text, 1) : std::nullopt)
    {
        return Keep("", DescribeDeepMacros() + " in its line " + std::to_string(*line) +
                            "; take it apart");
    }
    if (!file)
    {
        problem = problem.empty() ? m_Resolver.refusal() : problem;
        m_NeedsHighDefinition =
            m_NeedsHighDefinition ||
            header.find("com.unity.render-pipelines.high-definition") != header.npos;
        m_HasMissing = m_HasMissing || problem.empty();
        return problem.empty() ? nullptr : Keep("", problem);
    }
    m_Chain.push_back(file->name);
    m_TotalSize += file->text.size();
    m_NamesStages = m_NamesStages || NamesStages(file->text);
    if (HasPragmaOnce(file->text) && !m_Once.insert(file->name).second)
    {
        file->text.clear();
    }
    // glslang reads the last character of a header unasked.
    return Keep(SwapMarks(file->name), TranslateDirectives(file->text.empty() ? "\n" : file->text));
}

glslang::TShader::Includer::IncludeResult* GlslangIncluder::Keep(const std::string& name,
                                                                 std::string text)
{
    Loaded& loaded = m_Loaded.emplace_back();
    loaded.text = std::move(text);
    loaded.result =
        std::make_unique<IncludeResult>(name, loaded.text.c_str(), loaded.text.size(), nullptr);
    return loaded.result.get();
}

std::string GlslangIncluder::Circle() const
{
    for (auto first = m_Chain.begin(); first != m_Chain.end(); ++first)
    {
        const auto again = std::find(first + 1, m_Chain.end(), *first);
        if (again != m_Chain.end())
        {
            std::string circle = *first;
            for (auto file = first + 1; file <= again; ++file)
            {
                circle += " -> " + *file;
            }
            return circle;
        }
    }
    return {};
}

std::string GlslangIncluder::ReasonToStop(std::size_t depth)
{
    if (depth > k_MaximumIncludeDepth)
    {
        m_HasStopped = true;
        const std::string circle = Circle();
        return circle.empty() ? "nested more than " + std::to_string(k_MaximumIncludeDepth) +
                                    " files deep; include less"
                              : "part of a circle of includes, " + circle +
                                    "; write '#pragma once' at the top of these files";
    }
    m_HasStopped = m_Loaded.size() >= k_MaximumCount || m_TotalSize > k_MaximumTotal;
    return m_HasStopped ? "one of more than " + std::to_string(k_MaximumCount) + " files or " +
                              std::to_string(k_MaximumTotal >> 20) +
                              " MB that the shader includes; write '#pragma once' at the top of "
                              "included files"
                        : "";
}

} // namespace limn
