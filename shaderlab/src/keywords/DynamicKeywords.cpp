#include "keywords/DynamicKeywords.h"

#include "tokens/Lines.h"
#include "tokens/Tokens.h"

#include <string_view>

namespace limn
{

namespace
{

bool isCondition(std::string_view directive)
{
    return directive == "if" || directive == "ifdef" || directive == "ifndef" ||
           directive == "elif";
}

Diagnostic UnseenBy(std::string_view directive, std::string_view keyword, const std::string& file,
                    SourceLocation location)
{
    const std::string name(keyword);
    return {Severity::Warning, file, location,
            "#" + std::string(directive) + ": '" + name +
                "' is a keyword of a dynamic_branch: a variable, which no preprocessor condition "
                "sees; write 'if (" +
                name + ")'"};
}

} // namespace

std::set<std::string, std::less<>> DynamicKeywords(const PassProgram& program)
{
    std::set<std::string, std::less<>> keywords;
    for (const KeywordSet& set : program.keywordSets)
    {
        if (set.isDynamic)
        {
            keywords.insert(set.keywords.begin(), set.keywords.end());
        }
    }
    keywords.erase("");
    return keywords;
}

std::string DeclareDynamicKeywords(const PassProgram& program)
{
    std::string members;
    std::string macros;
    for (const std::string& keyword : DynamicKeywords(program))
    {
        members += " int " + keyword + ";";
        macros += "#define " + keyword + "_KEYWORD_DECLARED 1\n";
    }
    return members.empty() ? ""
                           : macros + "cbuffer " + std::string(k_DynamicKeywordBuffer) + " {" +
                                 members + " };\n";
}

std::vector<Diagnostic> CheckDynamicKeywords(const PassProgram& program)
{
    const auto keywords = DynamicKeywords(program);
    std::vector<Diagnostic> warnings;
    for (const SourceChunk& chunk : program.chunks)
    {
        HlslLines lines(chunk.text, chunk.firstLine);
        std::string line;
        int number = 0;
        while (!keywords.empty() && lines.Next(line, number))
        {
            const std::size_t mark = line.find_first_not_of(" \t\r\f\v");
            if (mark == line.npos || line[mark] != '#')
            {
                continue;
            }
            const auto words = TokenizeHlsl(std::string_view(line).substr(mark + 1));
            for (std::size_t i = 1; i < words.size() && isCondition(words[0].text); ++i)
            {
                if (keywords.count(words[i].text) > 0)
                {
                    warnings.push_back(UnseenBy(words[0].text, words[i].text, program.file,
                                                {number, static_cast<int>(mark) + 1}));
                }
            }
        }
    }
    return warnings;
}

} // namespace limn
