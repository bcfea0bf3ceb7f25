#include "scene/ProfileContext.h"

#include "assets/References.h"

namespace limn
{

std::optional<int> SceneProfileContext::FindLayer(std::string_view name) const
{
    const std::optional<int> index = m_Layers.Find(name);
    const std::optional<int> usual = ProfileContext::FindLayer(name);
    const bool isUsual = !index && usual && m_Layers.Name(*usual).empty();
    return isUsual ? usual : index;
}

std::filesystem::path SceneProfileContext::FileOf(const AssetLocation& location) const
{
    if (!location.path.empty())
    {
        return m_Profile.parent_path() / location.path;
    }
    if (!m_Project)
    {
        m_Project.emplace(m_Profile);
    }
    const std::filesystem::path* found = m_Project->Find(location.guid);
    return found ? *found : std::filesystem::path();
}

template <typename Asset, typename Loaded>
LoadedAsset<Asset> SceneProfileContext::LoadFile(
    const AssetLocation& location, std::string_view extension, const char* noun,
    std::shared_ptr<const Loaded> (AssetContext::*load)(const std::filesystem::path&)) const
{
    const std::filesystem::path file = FileOf(location);
    if (file.empty())
    {
        const std::string reason =
            location.guid.empty()
                ? "the reference has no guid"
                : "no .meta file of the project has the guid '" + location.guid + "'";
        return {nullptr, std::string("it stays without a ") + noun + ": " + reason};
    }
    if (file.extension() == ".mat")
    {
        return {nullptr, std::string("it stays without a ") + noun + ": '" +
                             file.filename().string() +
                             "' is Unity's and is not read; a .material.yaml file can be"};
    }
    if (!file.filename().string().ends_with(extension))
    {
        throw AssetError(file.generic_string(), {},
                         std::string("the file is no ") + noun + "; a " + std::string(extension) +
                             " file is expected");
    }
    // A path that a person typed, and that is in no file, may lead anywhere.
    FileRoots own;
    own.Add(m_Profile.parent_path());
    if (!m_Profile.empty() && !own.Contains(file) && !m_Assets.roots().Contains(file))
    {
        throw AssetError(file.generic_string(), {}, k_OutsideRoots);
    }
    m_HasLoaded = true;
    return {(m_Assets.*load)(file), {}};
}

LoadedAsset<Texture> SceneProfileContext::LoadTexture(const AssetLocation& location) const
{
    return LoadFile<Texture>(location, ".png", "texture", &AssetContext::LoadTexture);
}

LoadedAsset<Material> SceneProfileContext::LoadMaterial(const AssetLocation& location) const
{
    return LoadFile<Material>(location, ".material.yaml", "material", &AssetContext::LoadMaterial);
}

} // namespace limn
