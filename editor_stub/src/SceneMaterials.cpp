#include "MaterialReader.h"
#include "SceneLoader.h"

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

} // namespace limn
