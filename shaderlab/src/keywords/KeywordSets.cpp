#include "keywords/KeywordSets.h"

#include <limn/base/Text.h>

#include <algorithm>
#include <array>

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
    for (const Shortcut& shortcut : k_Shortcuts)
    {
        if (shortcut.name == name)
        {
            return shortcut.sets;
        }
    }
    return {};
}

bool isSuffixed(std::string_view name, std::string_view directive)
{
    if (name.substr(0, directive.size()) != directive)
    {
        return false;
    }
    name.remove_prefix(directive.size());
    while (!name.empty())
    {
        const auto suffix = std::find_if(k_Suffixes.begin(), k_Suffixes.end(),
                                         [&](std::string_view candidate)
                                         { return name.substr(0, candidate.size()) == candidate; });
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

} // namespace

bool isKeywordDirective(std::string_view name)
{
    return !FindShortcut(name).empty() ||
           std::any_of(k_Directives.begin(), k_Directives.end(),
                       [&](std::string_view directive) { return isSuffixed(name, directive); });
}

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

} // namespace limn
