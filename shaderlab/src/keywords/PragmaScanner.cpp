#include "keywords/PragmaScanner.h"

#include "keywords/DirectiveConditions.h"
#include "keywords/KeywordSets.h"
#include "tokens/Lines.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

namespace limn
{

namespace
{

constexpr std::string_view k_IncludeWithPragmas = "include_with_pragmas";

/// The name of a directive: letters only, so that `#if(X)` and `#include"x"` are understood.
std::string_view TakeName(std::string_view& text)
{
    text = Trim(text);
    std::size_t size = 0;
    while (size < text.size() && isLetter(text[size]))
    {
        ++size;
    }
    const std::string_view name = text.substr(0, size);
    text.remove_prefix(size);
    return name;
}

/// "4.5" is 45; 0 where it is no number.
int TargetNumber(std::string_view text)
{
    double number = 0.0; // whatever the locale is
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number > 0.0 && number < 100.0 ? static_cast<int>(std::lround(number * 10.0)) : 0;
}

class PragmaReader
{
public:
    PragmaReader(PassProgram& program, const PragmaFileReader& files)
        : m_Program(program), m_Files(files)
    {
    }

    void ReadChunk(const SourceChunk& chunk) { Read(chunk.text, chunk.firstLine, m_Program.file); }

private:
    void Read(std::string_view text, int firstLine, const std::string& file)
    {
        HlslLines lines(text, firstLine);
        std::string line;
        int number = 0;
        while (lines.Next(line, number))
        {
            const std::size_t mark = line.find_first_not_of(" \t\r\f\v");
            if (mark != line.npos && line[mark] == '#')
            {
                // Everything in an included file stands where the .shader file includes it.
                m_Location =
                    m_Depth > 0 ? m_Location : SourceLocation{number, static_cast<int>(mark) + 1};
                ReadDirective(std::string_view(line).substr(mark + 1), file);
            }
        }
    }

    void ReadDirective(std::string_view rest, const std::string& file)
    {
        const std::string_view name = TakeName(rest);
        if (name != "pragma" && name != k_IncludeWithPragmas)
        {
            m_Conditions.Apply(name, rest);
            return;
        }
        if (name == k_IncludeWithPragmas)
        {
            Include(Trim(rest), file);
            return;
        }
        // Real files contain `#pragma x#define y`, a line break forgotten.
        const std::size_t glued = std::min(rest.find('#'), rest.size());
        if (m_Conditions.isActive())
        {
            Apply(Trim(rest.substr(0, glued)));
        }
        if (glued < rest.size())
        {
            ReadDirective(rest.substr(glued + 1), file);
        }
    }

    void Include(std::string_view name, const std::string& file)
    {
        constexpr int k_MaximumDepth = 32;
        if (!m_Conditions.isActive())
        {
            return;
        }
        const std::size_t close = name.size() > 1 ? name.find_first_of("\">", 1) : name.npos;
        const std::string_view path = close == name.npos ? name : name.substr(1, close - 1);
        if (m_Depth == 0)
        {
            m_Program.pragmas.push_back(
                {m_Location, std::string(k_IncludeWithPragmas), std::string(path)});
        }
        if (!m_Files || m_Depth >= k_MaximumDepth)
        {
            return;
        }
        const auto found = m_Files(path, file);
        if (found && m_Read.insert(found->name).second)
        {
            ++m_Depth;
            Read(found->text, 1, found->name);
            --m_Depth;
        }
    }

    void Apply(std::string_view text)
    {
        const std::string_view name = TakeWord(text);
        text = Trim(text);
        std::string_view rest = text;
        if (name.empty())
        {
            return;
        }
        EntryPoint* const entry = name == "vertex"     ? &m_Program.vertex
                                  : name == "fragment" ? &m_Program.fragment
                                  : name == "geometry" ? &m_Program.geometry
                                                       : nullptr;
        if (entry)
        {
            const std::string_view function = TakeWord(rest);
            *entry = {std::string(function.substr(0, function.find(';'))), m_Location};
        }
        else if (name == "target" && TargetNumber(text) > 0)
        {
            m_Program.target = TargetNumber(TakeWord(rest));
        }
        else if (isKeywordDirective(name))
        {
            for (KeywordSet& set : ReadKeywordSets(m_Location, name, text))
            {
                m_Program.keywordSets.push_back(std::move(set));
            }
        }
        else
        {
            m_Program.pragmas.push_back({m_Location, std::string(name), std::string(text)});
        }
    }

    PassProgram& m_Program;
    const PragmaFileReader& m_Files;
    DirectiveConditions m_Conditions;
    SourceLocation m_Location;
    int m_Depth = 0;
    std::set<std::string> m_Read; ///< each file counts once, as if guarded
};

} // namespace

void ScanPragmas(PassProgram& program, const PragmaFileReader& reader)
{
    const PassProgram fresh;
    program.vertex = fresh.vertex;
    program.fragment = fresh.fragment;
    program.geometry = fresh.geometry;
    program.target = fresh.target;
    program.keywordSets.clear();
    program.pragmas.clear();
    PragmaReader pragmas(program, reader);
    for (const SourceChunk& chunk : program.chunks)
    {
        pragmas.ReadChunk(chunk);
    }
}

} // namespace limn
