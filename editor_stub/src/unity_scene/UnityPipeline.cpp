#include "shader_graph/GraphShader.h"
#include "unity/RenderPipelineAsset.h"
#include "unity/RendererData.h"
#include "unity_scene/UnitySceneLoader.h"

namespace limn
{

namespace
{

/// The asset of the quality level that the editor shows, or else of GraphicsSettings.
const std::filesystem::path* FindPipeline(const UnitySceneLoader& loader, float& lodBias)
{
    const UnityNode quality = loader.ProjectSettings("QualitySettings.asset");
    const UnityNode graphics = loader.ProjectSettings("GraphicsSettings.asset");
    const UnityNode level = quality["m_QualitySettings"].At(
        static_cast<std::size_t>(NumberOf(quality["m_CurrentQuality"], 0)));
    lodBias = NumberOf(level["lodBias"], lodBias);
    for (const UnityNode& asset :
         {level["customRenderPipeline"], graphics["m_CustomRenderPipeline"]})
    {
        const UnityReference reference = ReadUnityReference(asset);
        const auto* path = reference.isNull() ? nullptr : loader.database.Find(reference.guid);
        if (path != nullptr)
        {
            return path;
        }
    }
    return nullptr;
}

void ReadRenderer(UnitySceneLoader& loader, const UnityNode& pipeline, int index)
{
    loader.defaultRenderer = NumberOf(pipeline["m_DefaultRendererIndex"], 0);
    index = index < 0 ? loader.defaultRenderer : index;
    const UnityNode renderer = pipeline["m_RendererDataList"].At(static_cast<std::size_t>(index));
    if (const auto* path = loader.database.Find(ReadUnityReference(renderer).guid))
    {
        const UnityAssetLoaders load{
            [&loader](const UnityReference& material, const auto& note)
            { return loader.materials.LoadForFeature(material, note); },
            [&loader](const UnityReference& texture, const auto& note)
            { return loader.materials.textures().LoadForFeature(texture, note); },
            [](const std::filesystem::path& graph, AssetContext& assets)
            {
                return std::make_shared<const Shader>(LoadShaderFile(graph).TakeDocument(),
                                                      assets.compiler());
            }};
        UnityRendererDataLoadResult result =
            LoadUnityRendererData(*path, loader.assets, loader.database.project(), load);
        loader.asset.renderer = std::move(result.renderer);
        loader.notes.Add(result.notes);
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
    const UnityNode pipeline = loader.database.FieldsOf(*path, UnityClass::MonoBehaviour);
    if (pipeline && !pipeline["m_MSAA"])
    {
        loader.notes.Add(path->generic_string(), 0,
                         "this pipeline is not the Universal Render Pipeline, but the High "
                         "Definition one or the project's own, so limn's own settings are used");
        return lodBias;
    }
    try
    {
        PipelineSettings& settings = loader.asset;
        settings = LoadUnityRenderPipeline(*path, loader.assets, settings.pipelineVersion);
        ReadRenderer(loader, pipeline, renderer);
    }
    catch (const AssetError& error)
    {
        loader.notes.Add(error.diagnostics());
    }
    return lodBias;
}

} // namespace limn
