#include "tokens/ColumnFinder.h"

#include <algorithm>

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
    const std::size_t open = message.find('\'');
    const std::size_t close = open == message.npos ? open : message.find('\'', open + 1);
    const bool isStart =
        open == 0 || (open != message.npos && open >= 2 && message.substr(open - 2, 2) == ": ");
    return isStart && close != message.npos ? message.substr(open + 1, close - open - 1)
                                            : std::string_view();
}

/// Blanks in their place.
std::string WithoutComments(std::string_view line)
{
    std::string code(line);
    const std::size_t end = code.find("*/");
    if (end != code.npos && end < code.find("/*"))
    {
        code.replace(0, end + 2, end + 2, ' '); // of a comment that begins in another line
    }
    for (std::size_t open = code.find("/*"); open != code.npos; open = code.find("/*", open))
    {
        const std::size_t close = std::min(code.find("*/", open + 2), code.size() - 2) + 2;
        code.replace(open, close - open, close - open, ' ');
    }
    return code.substr(0, code.find("//"));
}

constexpr std::size_t k_None = std::string_view::npos;

/// Returns for each token of one line the matching token of the other, or k_None: a longest common
/// subsequence. Tokens from macros are in one line only.
std::vector<std::size_t> Match(std::span<const HlslToken> made, std::span<const HlslToken> written)
{
    const std::size_t width = written.size() + 1;
    std::vector<std::uint32_t> longest((made.size() + 1) * width);
    for (std::size_t i = made.size(); i-- > 0;)
    {
        for (std::size_t j = written.size(); j-- > 0;)
        {
            longest[i * width + j] =
                made[i].text == written[j].text
                    ? longest[(i + 1) * width + j + 1] + 1
                    : std::max(longest[(i + 1) * width + j], longest[i * width + j + 1]);
        }
    }
    std::vector<std::size_t> matches(made.size(), k_None);
    for (std::size_t i = 0, j = 0; i < made.size() && j < written.size();)
    {
        if (made[i].text == written[j].text)
        {
            matches[i++] = j++;
        }
        else
        {
            const bool skipsMade = longest[(i + 1) * width + j] >= longest[i * width + j + 1];
            ++(skipsMade ? i : j);
        }
    }
    return matches;
}

} // namespace

std::optional<std::string_view> ColumnFinder::Find(const std::string& file, int line)
{
    if (file != m_Program.file)
    {
        auto text = m_Files.find(file);
        if (text == m_Files.end())
        {
            const auto found = m_Resolver.Reread(file);
            text = m_Files.emplace(file, found ? found->text : "").first;
        }
        return LineOf(text->second, 1, line);
    }
    // Chunks share a line where one ends and the next begins.
    std::optional<std::string_view> result;
    for (const SourceChunk& chunk : m_Program.chunks)
    {
        const auto own = LineOf(chunk.text, chunk.firstLine, line);
        result = own && line > chunk.firstLine ? own : result;
    }
    return result;
}

int ColumnFinder::Column(const HlslPlace& place, std::span<const HlslToken> preprocessed,
                         std::size_t index)
{
    constexpr std::size_t k_LongestLine = 500; // tokens
    const auto line = Find(place.file, place.location.line);
    if (!line)
    {
        return 0;
    }
    const std::string code = WithoutComments(*line);
    const std::vector<HlslToken> written = TokenizeHlsl(code);
    if (std::max(written.size(), preprocessed.size()) > k_LongestLine)
    {
        return 0;
    }
    const std::vector<std::size_t> matches = Match(preprocessed, written);
    const auto isMatched = [&](std::size_t token)
    {
        return std::find(matches.begin(), matches.end(), token) != matches.end();
    };
    std::size_t match = matches[index];
    if (match == k_None)
    {
        // A macro made it whose name, which is no more, stands before what comes next.
        const auto next =
            std::find_if(matches.begin() + static_cast<std::ptrdiff_t>(index), matches.end(),
                         [](std::size_t token) { return token != k_None; });
        match = next == matches.end() ? written.size() : *next;
        while (match > 0 && (!written[match - 1].isWord || isMatched(match - 1)))
        {
            --match;
        }
        --match; // k_None where there is no such word
    }
    return match == k_None ? 0 : static_cast<int>(written[match].Begin(code)) + 1;
}

void ColumnFinder::AddColumns(std::vector<Diagnostic>& diagnostics)
{
    for (Diagnostic& diagnostic : diagnostics)
    {
        const std::string_view word = NamedWord(diagnostic.message);
        const bool isWanted =
            diagnostic.location.line > 0 && diagnostic.location.column == 0 && !word.empty();
        const auto line = isWanted ? Find(diagnostic.file, diagnostic.location.line) : std::nullopt;
        if (!line)
        {
            continue;
        }
        // Behind its mark a directive has words like any other line.
        const std::size_t start = std::min(line->find_first_not_of(" \t#"), line->size());
        for (const HlslToken& token : TokenizeHlsl(line->substr(start)))
        {
            if (token.text == word)
            {
                diagnostic.location.column = static_cast<int>(token.Begin(*line)) + 1;
                break;
            }
        }
    }
}

bool ColumnFinder::isOfLibrary(const std::string& file)
{
    const std::optional<IncludedFile> found = m_Resolver.Reread(file);
    return found && found->isEmbedded;
}

} // namespace limn
