#include "keywords/PragmaScanner.h"

#include "keywords/DirectiveConditions.h"
#include "tokens/Lines.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

namespace limn
{

namespace
{

struct Shortcut
{
    std::string_view name;
    std::string_view sets; ///< keywords; "|" stands between sets
};

// The first word of each set decides the default variant: the shadows and lightmaps of the built-in
// pipeline are off.
constexpr std::string_view k_ForwardBase =
    "DIRECTIONAL | _ LIGHTMAP_ON | _ DIRLIGHTMAP_COMBINED | _ DYNAMICLIGHTMAP_ON | "
    "_ LIGHTMAP_SHADOW_MIXING | _ LIGHTPROBE_SH | _ VERTEXLIGHT_ON | _ SHADOWS_SCREEN | "
    "_ SHADOWS_SHADOWMASK";
constexpr std::string_view k_AllLights =
    "POINT DIRECTIONAL SPOT POINT_COOKIE DIRECTIONAL_COOKIE | "
    "_ SHADOWS_DEPTH SHADOWS_SCREEN SHADOWS_CUBE | _ SHADOWS_SOFT | _ SHADOWS_SHADOWMASK | "
    "_ LIGHTMAP_SHADOW_MIXING";
constexpr std::array<Shortcut, 12> k_Shortcuts = {{
    {"multi_compile_fog", "_ FOG_LINEAR FOG_EXP FOG_EXP2"},
    {"multi_compile_instancing", "_ INSTANCING_ON"},
    {"multi_compile_particles", "_ SOFTPARTICLES_ON"},
    {"multi_compile_fwdbase", k_ForwardBase},
    {"multi_compile_fwdbase_fullshadows", k_ForwardBase},
    {"multi_compile_fwdbasealpha",
     "DIRECTIONAL | _ LIGHTMAP_ON | _ DIRLIGHTMAP_COMBINED | _ DYNAMICLIGHTMAP_ON | "
     "_ LIGHTMAP_SHADOW_MIXING | _ LIGHTPROBE_SH | _ VERTEXLIGHT_ON"},
    {"multi_compile_fwdadd", "POINT DIRECTIONAL SPOT POINT_COOKIE DIRECTIONAL_COOKIE"},
    {"multi_compile_fwdadd_fullshadows", k_AllLights},
    {"multi_compile_lightpass", k_AllLights},
    {"multi_compile_shadowcaster", "SHADOWS_DEPTH SHADOWS_CUBE"},
    {"multi_compile_shadowcollector", "SHADOWS_SPLIT_SPHERES SHADOWS_SINGLE_CASCADE"},
    {"multi_compile_prepassfinal",
     "_ LIGHTMAP_ON | _ DIRLIGHTMAP_COMBINED | _ DYNAMICLIGHTMAP_ON | _ UNITY_HDR_ON | "
     "_ SHADOWS_SHADOWMASK | _ LIGHTPROBE_SH"},
}};

constexpr std::array<std::string_view, 3> k_Directives = {"multi_compile", "shader_feature",
                                                          "dynamic_branch"};
constexpr std::array<std::string_view, 7> k_Suffixes = {
    "_local", "_vertex", "_fragment", "_hull", "_domain", "_geometry", "_raytracing"};

std::string_view FindShortcut(std::string_view name)
{
    const auto found = std::ranges::find(k_Shortcuts, name, &Shortcut::name);
    return found == k_Shortcuts.end() ? std::string_view() : found->sets;
}

bool isSuffixed(std::string_view name, std::string_view directive)
{
    if (!name.starts_with(directive))
    {
        return false;
    }
    name.remove_prefix(directive.size());
    while (!name.empty())
    {
        const auto suffix = std::ranges::find_if(k_Suffixes, [&](std::string_view candidate)
                                                 { return name.starts_with(candidate); });
        if (suffix == k_Suffixes.end())
        {
            return false;
        }
        name.remove_prefix(suffix->size());
    }
    return true;
}

ShaderStage StagesOf(std::string_view name)
{
    const auto has = [&](std::string_view suffix)
    {
        return name.find(suffix) != name.npos;
    };
    if (has("_vertex") || has("_fragment"))
    {
        return has("_vertex") ? ShaderStage::Vertex : ShaderStage::Fragment;
    }
    const bool isOther = has("_hull") || has("_domain") || has("_geometry") || has("_raytracing");
    return isOther ? ShaderStage::None : ShaderStage::Both;
}

/// Returns whether `#pragma name` declares keywords: multi_compile, shader_feature and
/// dynamic_branch with any of their suffixes, and shortcuts such as multi_compile_fog.
bool isKeywordDirective(std::string_view name)
{
    return !FindShortcut(name).empty() ||
           std::ranges::any_of(k_Directives, [&](std::string_view directive)
                               { return isSuffixed(name, directive); });
}

/// Returns the sets that `#pragma name words` declares; a shortcut declares sets of its own.
std::vector<KeywordSet> ReadKeywordSets(SourceLocation location, std::string_view name,
                                        std::string_view words)
{
    const std::string_view shortcut = FindShortcut(name);
    words = shortcut.empty() ? words : shortcut;
    std::vector<KeywordSet> sets(1);
    for (auto word = TakeWord(words); !word.empty(); word = TakeWord(words))
    {
        if (word == "|" && !shortcut.empty())
        {
            sets.emplace_back();
            continue;
        }
        const bool isOff = word.find_first_not_of('_') == word.npos;
        sets.back().keywords.emplace_back(isOff ? "" : word);
    }
    for (KeywordSet& set : sets)
    {
        set.location = location;
        set.directive = name;
        set.isFeature = isSuffixed(name, "shader_feature");
        set.isDynamic = isSuffixed(name, "dynamic_branch");
        set.isLocal = name.find("_local") != name.npos;
        set.stages = StagesOf(name);
        if ((set.isFeature || set.isDynamic) && set.keywords.size() == 1)
        {
            set.keywords.insert(set.keywords.begin(), "");
        }
    }
    return sets;
}

constexpr std::string_view k_IncludeWithPragmas = "include_with_pragmas";

/// The name of a directive: letters only, so that `#if(X)` and `#include"x"` are understood.
std::string_view TakeName(std::string_view& text)
{
    text = Trim(text);
    const std::string_view name = Beginning(text, isLetter);
    text.remove_prefix(name.size());
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

std::vector<std::string> KeywordDirectives()
{
    std::vector<std::string> names;
    for (const std::string_view directive : k_Directives)
    {
        for (const char* suffix :
             {"", "_local", "_vertex", "_fragment", "_local_vertex", "_local_fragment"})
        {
            names.push_back(std::string(directive) + suffix);
        }
    }
    for (const Shortcut& shortcut : k_Shortcuts)
    {
        names.emplace_back(shortcut.name);
    }
    return names;
}

void ScanPragmas(PassProgram& program, const PragmaFileReader& reader)
{
    program.vertex = program.fragment = program.geometry = {};
    program.target = PassProgram().target;
    program.keywordSets.clear();
    program.pragmas.clear();
    PragmaReader pragmas(program, reader);
    for (const SourceChunk& chunk : program.chunks)
    {
        pragmas.ReadChunk(chunk);
    }
}

} // namespace limn
