#pragma once

#include "unity/UnityTree.h"

#include <limn/core/Material.h>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limn
{

/// Returns the names and values in a list of m_SavedProperties. An element of the list is a map of
/// one key, or before Unity 5 `data: {first: {name: X}, second: ...}`.
std::vector<std::pair<std::string_view, UnityNode>> PropertiesIn(const UnityNode& list);

/// A shader of URP in place of another shader, and the way it shows what a material has saved.
struct MaterialStandIn
{
    std::string shader; ///< a shader of URP
    /// Names of properties, by the saved names.
    std::map<std::string, std::string, std::less<>> names;
    /// Values of properties that do not depend on what is saved.
    std::map<std::string, float, std::less<>> values{};
    bool isPremultiplied = false;

    /// Returns the property that shows a saved one, or "" for one that another shader has left
    /// there.
    std::string NameOf(std::string_view saved) const;
};

/// Returns the stand-in for "Standard", "Legacy Shaders/Diffuse" and other shaders of the built-in
/// pipeline, and for URP's graphs of Autodesk Interactive.
/// @param shader  the shader's name in Unity
/// @param saved   the material's m_SavedProperties
std::optional<MaterialStandIn> StandInFor(std::string_view shader, const UnityNode& saved);

/// Returns the stand-in for the material of a shader graph: Lit with the texture and the colour
/// that have the usual names for a surface, or else with those that the graph mentions first. A
/// texture whose name promises no colours (`_NormalMap`, `_Noise`) is not taken.
/// @param graph  the text of the .shadergraph
MaterialStandIn StandInForGraph(std::string_view graph, const UnityNode& saved);

} // namespace limn
