#include "unity_scene/ModelMaterials.h"

#include "unity/UnityDatabase.h"

namespace limn
{

namespace
{

/// Returns the names that the .mat file of a material may have, the best first.
std::vector<std::string> NamesOf(const ModelMaterial& material, const std::string& model,
                                 ModelMaterialName rule)
{
    const std::string whole = model + "-" + material.name;
    switch (rule)
    {
    case ModelMaterialName::BasedOnMaterialName:
        return {material.name};
    case ModelMaterialName::BasedOnModelNameAndMaterialName:
        return {whole};
    case ModelMaterialName::BasedOnTextureName_Or_ModelNameAndMaterialName:
        return {material.texture, whole};
    case ModelMaterialName::BasedOnTextureName:
        break;
    }
    return {material.texture, material.name};
}

/// Returns the guid of the file of this name that is nearest to the model, or "" if there is none.
std::string FindNearest(const std::string& filename, const std::filesystem::path& model,
                        ModelMaterialSearch search, const UnityProject& project)
{
    const std::map<std::filesystem::path, std::string> files = project.FindByName(filename);
    if (files.empty())
    {
        return "";
    }
    std::filesystem::path folder = model.parent_path();
    while (true)
    {
        const auto found = files.find(folder / "Materials" / filename);
        if (found != files.end())
        {
            return found->second;
        }
        if (search == ModelMaterialSearch::Local || folder == project.root() ||
            folder == folder.parent_path())
        {
            break;
        }
        folder = folder.parent_path();
    }
    return search == ModelMaterialSearch::Everywhere ? files.begin()->second : "";
}

} // namespace

void FindModelMaterials(Model& model, const std::filesystem::path& path,
                        const UnityProject& project)
{
    ModelImport& import = model.import;
    if (import.materialLocation == ModelMaterialLocation::InPrefab)
    {
        return;
    }
    for (const ModelMaterial& material : model.materials)
    {
        if (import.materialLocation == ModelMaterialLocation::None)
        {
            import.materials.try_emplace(material.name,
                                         UnityReference{10303, "0000000000000000f000000000000000"});
            continue;
        }
        for (const std::string& name : NamesOf(material, path.stem().string(), import.materialName))
        {
            const std::string guid =
                name.empty() ? ""
                             : FindNearest(name + ".mat", path, import.materialSearch, project);
            if (!guid.empty())
            {
                constexpr std::int64_t k_MaterialOfFile = 2100000;
                import.materials.try_emplace(material.name, UnityReference{k_MaterialOfFile, guid});
            }
        }
    }
}

} // namespace limn
