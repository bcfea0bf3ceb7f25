#include "scene/Loader.h"
#include "scene/MaterialReader.h"

namespace limn
{

void ReadMaterials(const YamlNode& node, SceneLoader& loader)
{
    if (!node.isMap() && !node.isNull())
    {
        loader.diagnostics.Error(node.location(),
                                 "materials: found " + node.Describe() +
                                     "; names with their properties are expected: {wood: "
                                     "{_BaseColor: \"#a9743f\"}}");
    }
    for (const YamlEntry& entry : node.entries())
    {
        loader.materials.emplace(
            entry.key, ReadMaterial(entry.key, entry.value, loader.references, loader.diagnostics));
    }
}

std::shared_ptr<const Material> ReadMaterialName(const YamlNode& node, const std::string& subject,
                                                 SceneLoader& loader)
{
    const std::optional<std::string> name = ReadString(node, subject, loader.diagnostics);
    const auto found = name ? loader.materials.find(*name) : loader.materials.end();
    if (found != loader.materials.end())
    {
        return found->second;
    }
    if (name)
    {
        std::vector<std::string_view> names;
        for (const auto& [known, material] : loader.materials)
        {
            names.push_back(known);
        }
        loader.diagnostics.Error(node.location(),
                                 subject + ": unknown material " + UnknownName(*name, names));
    }
    return nullptr;
}

} // namespace limn
