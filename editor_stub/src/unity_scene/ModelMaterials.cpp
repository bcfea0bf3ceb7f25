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

/// Returns the file that a material is External in, if there is one.
std::optional<UnityReference> FindFile(const ModelMaterial& material,
                                       const std::filesystem::path& model,
                                       const ModelImport& import, const UnityProject& project)
{
    for (const std::string& name : NamesOf(material, model.stem().string(), import.materialName))
    {
        const std::string guid =
            name.empty() ? "" : FindNearest(name + ".mat", model, import.materialSearch, project);
        if (!guid.empty())
        {
            return UnityReference{2100000, guid}; // the id that a file's material has
        }
    }
    return std::nullopt;
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
    const UnityReference defaultMaterial{10303, "0000000000000000f000000000000000"};
    for (const ModelMaterial& material : model.materials)
    {
        const auto found = import.materialLocation == ModelMaterialLocation::None
                               ? defaultMaterial
                               : FindFile(material, path, import, project);
        if (found)
        {
            import.materials.try_emplace(material.name, *found);
        }
    }
}

} // namespace limn
