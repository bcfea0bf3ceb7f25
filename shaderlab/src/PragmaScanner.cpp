#include "PragmaScanner.h"

#include "Text.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace limn
{

namespace
{

/// Reads lines of a chunk; comments are gone and `\` continues a line.
class LineReader
{
public:
    explicit LineReader(const SourceChunk& chunk) : m_Text(chunk.text), m_Line(chunk.firstLine) {}

    bool Next(std::string& line, int& number)
    {
        line.clear();
        number = m_Line;
        bool any = false;
        for (; m_Position < m_Text.size(); ++m_Position)
        {
            any = true;
            const std::string_view rest = std::string_view(m_Text).substr(m_Position);
            if (rest[0] == '\n')
            {
                ++m_Line;
                ++m_Position;
                const std::size_t size = Trim(line).size();
                if (m_InComment || size == 0 || Trim(line).back() != '\\')
                {
                    return true;
                }
                line = std::string(Trim(line).substr(0, size - 1)) + " ";
                --m_Position;
            }
            else
            {
                Take(rest, line);
            }
        }
        return any;
    }

private:
    void Take(std::string_view rest, std::string& line)
    {
        if (m_InComment)
        {
            m_InComment = rest.substr(0, 2) != "*/";
            m_Position += m_InComment ? 0 : 1;
        }
        else if (rest.substr(0, 2) == "/*")
        {
            m_InComment = true;
            ++m_Position;
            line += ' ';
        }
        else if (rest.substr(0, 2) == "//")
        {
            m_Position += std::min(rest.find('\n'), rest.size()) - 1;
        }
        else
        {
            line += rest[0];
        }
    }

    std::string_view m_Text;
    std::size_t m_Position = 0;
    int m_Line;
    bool m_InComment = false;
};

std::string_view TakeWord(std::string_view& text)
{
    text = Trim(text);
    std::size_t size = 0;
    while (size < text.size() && !isBlank(text[size]))
    {
        ++size;
    }
    const std::string_view word = text.substr(0, size);
    text = Trim(text.substr(size));
    return word;
}

bool isOnlyUnderscores(std::string_view word)
{
    return word.find_first_not_of('_') == std::string_view::npos;
}

bool StartsWith(std::string_view text, std::string_view start)
{
    return text.substr(0, start.size()) == start;
}

struct Shortcut
{
    std::string_view name;
    std::string_view keywords;
};

// Only what decides a default; the shadow keywords of the built-in pipeline are never on here.
constexpr Shortcut k_Shortcuts[] = {
    {"multi_compile_fog", "_ FOG_LINEAR FOG_EXP FOG_EXP2"},
    {"multi_compile_instancing", "_ INSTANCING_ON"},
    {"multi_compile_particles", "_ SOFTPARTICLES_ON"},
    {"multi_compile_fwdbase", "DIRECTIONAL"},
    {"multi_compile_fwdbase_fullshadows", "DIRECTIONAL"},
    {"multi_compile_fwdbasealpha", "DIRECTIONAL"},
    {"multi_compile_fwdadd", "POINT DIRECTIONAL SPOT POINT_COOKIE DIRECTIONAL_COOKIE"},
    {"multi_compile_fwdadd_fullshadows", "POINT DIRECTIONAL SPOT POINT_COOKIE DIRECTIONAL_COOKIE"},
    {"multi_compile_shadowcaster", "SHADOWS_DEPTH SHADOWS_CUBE"},
};

bool isKeywordDirective(std::string_view name)
{
    return StartsWith(name, "multi_compile") || StartsWith(name, "shader_feature") ||
           name == "dynamic_branch";
}

KeywordSet ReadKeywordSet(SourceLocation location, std::string_view name, std::string_view words)
{
    KeywordSet set{location, std::string(name), {}};
    set.isFeature = StartsWith(name, "shader_feature");
    set.isLocal = name.find("_local") != std::string_view::npos;
    if (name.find("_vertex") != std::string_view::npos)
    {
        set.stages = ShaderStage::Vertex;
    }
    else if (name.find("_fragment") != std::string_view::npos)
    {
        set.stages = ShaderStage::Fragment;
    }
    for (const Shortcut& shortcut : k_Shortcuts)
    {
        words = name == shortcut.name ? shortcut.keywords : words;
    }
    while (!words.empty())
    {
        const std::string_view word = TakeWord(words);
        set.keywords.emplace_back(isOnlyUnderscores(word) ? "" : word);
    }
    if (set.isFeature && set.keywords.size() == 1)
    {
        set.keywords.insert(set.keywords.begin(), "");
    }
    return set;
}

int TargetNumber(std::string_view text)
{
    return static_cast<int>(std::lround(std::atof(std::string(text).c_str()) * 10.0));
}

void Apply(PassProgram& program, SourceLocation location, std::string_view text)
{
    const std::string_view name = TakeWord(text);
    std::string_view rest = text;
    if (name == "vertex")
    {
        program.vertex = {std::string(TakeWord(rest)), location};
    }
    else if (name == "fragment")
    {
        program.fragment = {std::string(TakeWord(rest)), location};
    }
    else if (name == "target")
    {
        program.target = TargetNumber(TakeWord(rest));
    }
    else if (isKeywordDirective(name))
    {
        program.keywordSets.push_back(ReadKeywordSet(location, name, text));
    }
    else
    {
        program.pragmas.push_back({location, std::string(name), std::string(text)});
    }
}

} // namespace

void ScanPragmas(PassProgram& program)
{
    for (const SourceChunk& chunk : program.chunks)
    {
        LineReader reader(chunk);
        std::string line;
        int number = 0;
        while (reader.Next(line, number))
        {
            std::string_view text = Trim(line);
            if (text.empty() || text.front() != '#')
            {
                continue;
            }
            text = Trim(text.substr(1));
            if (StartsWith(text, "pragma") && text.size() > 6 && isBlank(text[6]))
            {
                const int column = static_cast<int>(line.find('#')) + 1;
                // Real files contain `#pragma x#define y`, a line break forgotten.
                Apply(program, {number, column},
                      text.substr(6, text.find('#') == text.npos ? text.npos : text.find('#') - 6));
            }
        }
    }
}

} // namespace limn
