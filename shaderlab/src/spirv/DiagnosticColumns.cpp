#include "spirv/DiagnosticColumns.h"

#include "hlsl/Tokens.h"
#include "text/Text.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace limn
{

namespace
{

/// The line of a text that starts at line `first`; nothing where it is not in it.
std::optional<std::string_view> LineOf(std::string_view text, int first, int line)
{
    for (; first < line; ++first)
    {
        const std::size_t end = text.find('\n');
        if (end == text.npos)
        {
            return std::nullopt;
        }
        text.remove_prefix(end + 1);
    }
    return first == line ? std::optional(text.substr(0, text.find('\n'))) : std::nullopt;
}

/// 'word' at the start of a message or behind "function: ".
std::string_view NamedWord(std::string_view message)
{
    if (message.find("' expected") != message.npos)
    {
        return {}; // the word is missing, not there
    }
    const std::size_t open = message.find('\'');
    const std::size_t close = open == message.npos ? open : message.find('\'', open + 1);
    const bool isStart =
        open == 0 || (open != message.npos && open >= 2 && message.substr(open - 2, 2) == ": ");
    return isStart && close != message.npos ? message.substr(open + 1, close - open - 1)
                                            : std::string_view();
}

class ColumnFinder
{
public:
    ColumnFinder(const PassProgram& program, IncludeResolver& resolver)
        : m_Program(program), m_Resolver(resolver)
    {
    }

    int Find(const Diagnostic& diagnostic)
    {
        const std::string_view word = NamedWord(diagnostic.message);
        const auto line = word.empty() ? std::nullopt : Line(diagnostic);
        if (!line)
        {
            return 0;
        }
        // Behind its mark a directive has words like any other line.
        const std::size_t start = std::min(line->find_first_not_of(" \t#"), line->size());
        for (const HlslToken& token : TokenizeHlsl(line->substr(start)))
        {
            if (token.text == word)
            {
                return static_cast<int>(token.Begin(*line)) + 1;
            }
        }
        return 0;
    }

private:
    std::optional<std::string_view> Line(const Diagnostic& diagnostic)
    {
        if (diagnostic.file != m_Program.file)
        {
            auto& text = m_Files[diagnostic.file];
            if (!text)
            {
                const auto file = m_Resolver.Reread(diagnostic.file);
                text = file ? file->text : "";
            }
            return LineOf(*text, 1, diagnostic.location.line);
        }
        // Chunks share a line where one ends and the next begins.
        std::optional<std::string_view> result;
        for (const SourceChunk& chunk : m_Program.chunks)
        {
            const auto line = LineOf(chunk.text, chunk.firstLine, diagnostic.location.line);
            const bool isWhole = line && diagnostic.location.line > chunk.firstLine;
            result = isWhole ? line : result;
        }
        return result;
    }

    const PassProgram& m_Program;
    IncludeResolver& m_Resolver;
    std::map<std::string, std::optional<std::string>> m_Files;
};

} // namespace

void AddColumns(std::vector<Diagnostic>& diagnostics, const PassProgram& program,
                IncludeResolver& resolver)
{
    ColumnFinder finder(program, resolver);
    for (Diagnostic& diagnostic : diagnostics)
    {
        if (diagnostic.location.line > 0 && diagnostic.location.column == 0)
        {
            diagnostic.location.column = finder.Find(diagnostic);
        }
    }
}

} // namespace limn
