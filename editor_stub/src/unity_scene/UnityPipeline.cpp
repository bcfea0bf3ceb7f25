#include "unity/RenderPipelineAsset.h"
#include "unity/RendererData.h"
#include "unity_scene/UnitySceneLoader.h"

#include <charconv>

namespace limn
{

namespace
{

/// The asset of the quality level that the editor shows, or else of GraphicsSettings.
const std::filesystem::path* FindPipeline(const UnitySceneLoader& loader, float& lodBias)
{
    const UnityNode quality = loader.ProjectSettings("QualitySettings.asset");
    int current = 0;
    const std::string_view text = quality["m_CurrentQuality"].text();
    std::from_chars(text.data(), text.data() + text.size(), current);
    int level = 0;
    for (const UnityNode entry : quality["m_QualitySettings"])
    {
        if (level++ == current)
        {
            const std::string_view bias = entry["lodBias"].text();
            std::from_chars(bias.data(), bias.data() + bias.size(), lodBias);
            const UnityReference asset = ReadUnityReference(entry["customRenderPipeline"]);
            if (const auto* path = asset.isNull() ? nullptr : loader.database.Find(asset.guid))
            {
                return path;
            }
        }
    }
    const UnityReference asset = ReadUnityReference(
        loader.ProjectSettings("GraphicsSettings.asset")["m_CustomRenderPipeline"]);
    return asset.isNull() ? nullptr : loader.database.Find(asset.guid);
}

void ReadRenderer(UnitySceneLoader& loader, const std::filesystem::path& pipeline, int index)
{
    const auto file = loader.database.LoadFile(pipeline);
    const UnityHeader* header = file ? FindClass(*file, UnityClass::MonoBehaviour) : nullptr;
    const UnityNode fields = header != nullptr ? file->Fields(*header) : UnityNode();
    if (index < 0)
    {
        const std::string_view text = fields["m_DefaultRendererIndex"].text();
        index = 0;
        std::from_chars(text.data(), text.data() + text.size(), index);
    }
    int at = 0;
    for (const UnityNode entry : fields["m_RendererDataList"])
    {
        const UnityReference renderer = ReadUnityReference(entry);
        const auto* path = at++ == index ? loader.database.Find(renderer.guid) : nullptr;
        if (path != nullptr)
        {
            const auto loadMaterial = [&loader](const UnityReference& material, const auto& note)
            {
                return loader.materials.LoadForFeature(material, note);
            };
            UnityRendererDataLoadResult result = LoadUnityRendererData(
                *path, loader.assets, loader.database.project(), loadMaterial);
            loader.asset.renderer = std::move(result.renderer);
            loader.notes.Add(result.notes);
        }
    }
}

} // namespace

float ReadUnityPipeline(UnitySceneLoader& loader, int renderer)
{
    float lodBias = 1.0f;
    const std::filesystem::path* path = FindPipeline(loader, lodBias);
    if (path == nullptr)
    {
        loader.notes.Add(loader.path.generic_string(), 0,
                         "the project has no asset of the Universal Render Pipeline, so limn's own "
                         "settings are used");
        return lodBias;
    }
    const auto file = loader.database.LoadFile(*path);
    const UnityHeader* header = file ? FindClass(*file, UnityClass::MonoBehaviour) : nullptr;
    if (header != nullptr && !file->Fields(*header)["m_MSAA"])
    {
        loader.notes.Add(file->name(), 0,
                         "this pipeline is not the Universal Render Pipeline, but the High "
                         "Definition one or the project's own, so limn's own settings are used");
        return lodBias;
    }
    try
    {
        Apply(LoadUnityRenderPipeline(*path, loader.assets), loader.asset);
        ReadRenderer(loader, *path, renderer);
    }
    catch (const AssetError& error)
    {
        loader.notes.Add(error.diagnostics());
    }
    return lodBias;
}

} // namespace limn
