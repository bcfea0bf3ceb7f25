#pragma once

#include "unity/UnityTree.h"

#include <limn/core/Material.h>
#include <map>
#include <string>
#include <string_view>

namespace limn
{

/// Calls `work` with the name and the value of each element of a list of m_SavedProperties: a map
/// of one key, or before Unity 5 `data: {first: {name: X}, second: ...}`.
template <typename Work>
void ForEachProperty(const UnityNode& list, const Work& work)
{
    for (const UnityNode item : list)
    {
        if (item["first"])
        {
            work(item["first"]["name"].text(), item["second"]);
            continue;
        }
        for (const UnityNode property : item)
        {
            work(property.key(), property);
        }
    }
}

/// How a shader of URP shows what a material has saved for another shader.
struct MaterialStandIn
{
    std::string shader;                                    ///< of URP
    std::map<std::string, std::string, std::less<>> names; ///< of properties, by the saved ones
    std::map<std::string, float, std::less<>> values{};    ///< of properties, whatever is saved
    bool isPremultiplied = false;

    /// Returns the property that shows a saved one; "" for what another shader has left there.
    std::string NameOf(std::string_view saved) const;
};

/// Returns how "Standard", "Legacy Shaders/Diffuse" and the like of the built-in pipeline are
/// shown.
/// @param shader  Unity's name
/// @param saved   m_SavedProperties of the material
std::optional<MaterialStandIn> StandInFor(std::string_view shader, const UnityNode& saved);

/// Returns how the material of a shader graph is shown: by Lit with the texture and the colour
/// whose names are the usual ones of a surface, or else with those that the graph mentions first.
/// @param graph  the text of the .shadergraph
MaterialStandIn StandInForGraph(std::string_view graph, const UnityNode& saved);

} // namespace limn
