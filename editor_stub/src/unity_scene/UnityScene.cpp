#include "unity_scene/UnityScene.h"

#include "console/Texts.h"
#include "scene/Loader.h"
#include "unity_scene/UnitySceneLoader.h"

#include <algorithm>
#include <limn/base/ReadFile.h>
#include <limn/core/QualitySettings.h>

namespace limn
{

namespace
{

/// Kinds of things that a scene may have and limn does not draw.
constexpr std::pair<int, const char*> k_NotDrawn[] = {{96, "trails"},
                                                      {120, "lines"},
                                                      {198, "particle systems"},
                                                      {215, "reflection probes"},
                                                      {218, "terrains"},
                                                      {220, "light probe groups"},
                                                      {223, "canvases of a user interface"},
                                                      {2083052967, "visual effects"},
                                                      {102, "text meshes"}};

/// Reads names, of which some may be empty, from the first on.
void ReadNames(const UnityNode& list, LayerNames& names)
{
    int layer = 0;
    for (const UnityNode name : list)
    {
        if (!name.text().empty() && layer < 32)
        {
            names.SetName(layer, std::string(name.text()));
        }
        ++layer;
    }
}

/// Reads the names of layers, and those of rendering layers: since Unity 6 beside them, before it
/// in the asset of URP's global settings.
void ReadLayers(UnitySceneLoader& loader)
{
    const UnityNode tags = loader.ProjectSettings("TagManager.asset");
    ReadNames(tags["layers"], loader.asset.layers);
    ReadNames(tags["m_RenderingLayers"], loader.asset.renderingLayers);
    const UnityNode pipelines =
        loader.ProjectSettings("GraphicsSettings.asset")["m_SRPDefaultSettings"];
    const UnityReference settings =
        ReadUnityReference(pipelines["UnityEngine.Rendering.Universal.UniversalRenderPipeline"]);
    const auto* path = settings.isNull() ? nullptr : loader.database.Find(settings.guid);
    if (path != nullptr && !tags["m_RenderingLayers"])
    {
        const UnityNode fields = loader.database.FieldsOf(*path, UnityClass::MonoBehaviour);
        ReadNames(fields["m_RenderingLayerNames"], loader.asset.renderingLayers);
    }
}

/// @return the light that the scene's settings call the sun; null if they name none
const UnityInstance* ReadSettings(const UnityExpansion& expansion, UnitySceneLoader& loader)
{
    const UnityInstance* sun = nullptr;
    for (const UnityInstance* object : expansion.objects())
    {
        if (object->classID == UnityClass::RenderSettings)
        {
            const UnityReader reader(*object, "RenderSettings", loader.notes);
            ReadUnityRenderSettings(reader, loader.materials, loader.asset.scene);
            sun = reader.Reference("m_Sun").object;
        }
    }
    return sun;
}

void CountOthers(UnitySceneLoader& loader)
{
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        for (const UnityInstance* component : object->components)
        {
            for (const auto& [number, what] : k_NotDrawn)
            {
                if (static_cast<int>(component->classID) == number && object->isActive)
                {
                    loader.notes.Count(what);
                }
            }
        }
    }
}

/// Returns whether a component is a script of the project itself.
bool IsOwnScript(const UnityInstance& component, const UnityProject& project)
{
    const UnityNode script = component.fields["m_Script"];
    const auto* path = component.classID == UnityClass::MonoBehaviour
                           ? project.Find(script["guid"].text())
                           : nullptr;
    return path != nullptr && path->extension() == ".cs";
}

/// Notes why a picture has nothing in it but its background, if it has not.
void NoteEmptyPicture(UnitySceneLoader& loader)
{
    std::size_t scripts = 0;
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        if (object->drawn->renderer && object->drawn->renderer->enabled &&
            object->drawn->renderer->mesh)
        {
            return;
        }
        scripts += static_cast<std::size_t>(
            std::ranges::count_if(object->components, [&loader](const UnityInstance* component)
                                  { return IsOwnScript(*component, loader.database.project()); }));
    }
    loader.notes.Add(
        loader.path.generic_string(), 0,
        "nothing but the background is drawn: none of the scene's " +
            std::to_string(loader.hierarchy.objects().size()) +
            " objects has a mesh and a renderer that is on" +
            (scripts == 0 ? ""
                          : "; limn does not run its " + CountText(scripts, "script component")));
}

/// Sets the colour space before anything is made that depends on it.
void SetColorSpace(const UnitySceneLoader& loader)
{
    const UnityNode player = loader.ProjectSettings("ProjectSettings.asset");
    PlayerSettings::SetColorSpace(player["m_ActiveColorSpace"].text() == "0" ? ColorSpace::Gamma
                                                                             : ColorSpace::Linear);
}

SceneAsset ReadScene(const std::filesystem::path& path, AssetContext& assets)
{
    UnityNotes notes;
    UnityDatabase database(path, assets, notes);
    UnityMaterials materials(database, assets, notes);
    const std::shared_ptr<const UnityFile> file = database.LoadFile(path);
    if (!file)
    {
        throw AssetError(path.generic_string(), {}, notes.Finish("").back().message);
    }
    const UnityExpansion expansion(file, [&materials](const std::string& guid)
                                   { return materials.LoadPrefab(guid); });
    notes.Add(expansion.notes());
    const UnityHierarchy hierarchy(expansion, notes);
    SceneAsset asset;
    asset.isUnityScene = true;
    asset.path = path;
    UnitySceneLoader loader{path, assets, notes, database, materials, hierarchy, asset};
    SetColorSpace(loader);
    ReadLayers(loader);
    AddUnityObjects(loader);
    const int renderer = ReadUnityCamera(loader);
    const float lodBias = ReadUnityPipeline(loader, renderer);
    AddUnityRenderers(loader, lodBias);
    const UnityInstance* sun = ReadSettings(expansion, loader);
    ReadUnityLights(loader, sun);
    ReadUnityVolumes(loader);
    ReadUnityTextureCameras(loader, renderer);
    CountOthers(loader);
    NoteEmptyPicture(loader);
    asset.notes = notes.Finish(path.generic_string());
    return asset;
}

} // namespace

UnityNode UnitySceneLoader::ProjectSettings(const char* name) const
{
    const std::filesystem::path settings = database.root() / "ProjectSettings" / name;
    std::error_code ignored;
    if (!std::filesystem::exists(settings, ignored))
    {
        assets.Reach(settings);
        return {}; // Unity's defaults hold
    }
    const auto file = database.LoadFile(settings);
    return file && !file->headers().empty() ? file->Fields(file->headers().front()) : UnityNode();
}

std::filesystem::path FindFirstUnityScene(const std::filesystem::path& project)
{
    std::error_code ignored;
    if (!std::filesystem::is_directory(project / "Assets", ignored))
    {
        throw AssetError(project.generic_string(), {},
                         "this folder is no Unity project, which has a folder Assets; name a scene "
                         "file or the project's folder");
    }
    const FileContent build =
        TryReadFile(project / "ProjectSettings" / "EditorBuildSettings.asset");
    if (build.isRead() && IsUnityAsset(build.bytes))
    {
        const UnityFile file(build.bytes, (project / "ProjectSettings").generic_string());
        for (const UnityNode scene : file.Fields(file.headers().front())["m_Scenes"])
        {
            const std::filesystem::path path =
                (project / std::string(scene["path"].text())).lexically_normal();
            if (scene["enabled"].text() == "1" && std::filesystem::is_regular_file(path, ignored))
            {
                return path;
            }
        }
    }
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             project / "Assets", std::filesystem::directory_options::skip_permission_denied,
             ignored))
    {
        if (entry.path().extension() == ".unity")
        {
            scenes.push_back(entry.path());
        }
    }
    if (scenes.size() == 1)
    {
        return scenes.front().lexically_normal();
    }
    std::ranges::sort(scenes);
    const std::size_t named = std::min<std::size_t>(scenes.size(), 12);
    const std::string paths = Joined(std::span(scenes).first(named), ", ",
                                     [&project](const std::filesystem::path& scene) {
                                         return scene.lexically_relative(project).generic_string();
                                     });
    throw AssetError(project.generic_string(), {},
                     scenes.empty()
                         ? "the project has no scene: there is no .unity file in Assets"
                         : "the project's build settings name no scene that is there; "
                           "name one with --scene, of " +
                               paths +
                               (named < scenes.size()
                                    ? " and " + std::to_string(scenes.size() - named) + " more"
                                    : ""));
}

SceneAsset LoadUnityScene(const std::filesystem::path& path, AssetContext& assets)
{
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
    {
        throw AssetError(path.generic_string(), {}, "there is no such file");
    }
    if (UnityProjectAround(path).empty())
    {
        throw AssetError(path.generic_string(), {},
                         "a .unity file is read within its project; it has no .meta file, and no "
                         "folder above it has an Assets folder");
    }
    assets.Reach(path);
    assets.AddRootsAround(path);
    return ReadScene(path, assets);
}

SceneAsset LoadScene(const std::filesystem::path& path, AssetContext& assets,
                     InactiveObjects inactive)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
    {
        return LoadUnityScene(FindFirstUnityScene(path), assets);
    }
    if (path.extension() == ".unity")
    {
        return LoadUnityScene(path, assets);
    }
    PlayerSettings::SetColorSpace(ColorSpace::Linear);
    return LoadSceneFile(path, assets, inactive);
}

} // namespace limn
