#include "scene/Loader.h"
#include "settings/ReadValues.h"
#include "settings/SettingsReader.h"
#include "settings/ShadowKeys.h"
#include "unity/RenderPipelineAsset.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limn/base/Lists.h>
#include <limn/editor_stub/UnityRendererData.h>
#include <limn/features/PostProcessRendererFeature.h>

namespace limn
{

namespace
{

void ReadSize(const YamlNode& node, SceneLoader& loader)
{
    if (node.items().size() != 2)
    {
        loader.diagnostics.Error(node.location(),
                                 "size: found " + node.Describe() +
                                     "; width and height in pixels are expected: [1280, 720]");
        return;
    }
    SceneAsset& asset = loader.asset;
    asset.width =
        ReadInt(node.items()[0], "size[0]", loader.diagnostics, k_PictureSizes).value_or(1);
    asset.height =
        ReadInt(node.items()[1], "size[1]", loader.diagnostics, k_PictureSizes).value_or(1);
}

void ReadPipeline(SceneMapReader& map, SceneLoader& loader)
{
    SceneAsset& asset = loader.asset;
    AssetDiagnostics& diagnostics = loader.diagnostics;
    const YamlNode* count = map.Find("msaaSampleCount");
    const YamlNode* hdr = map.Find("supportsHDR");
    const YamlNode* bits = map.Find("hdrColorBufferPrecision");
    const YamlNode* scale = map.Find("renderScale");
    const YamlNode* lights = map.Find("maxAdditionalLightsCount");
    const YamlNode* shadows = map.Find("shadows");
    const YamlNode* pipeline = map.Find("renderPipelineAsset");
    for (const auto& [node, what] : {std::pair(count, "msaaSampleCount: the count comes"),
                                     std::pair(hdr, "supportsHDR: it comes"),
                                     std::pair(bits, "hdrColorBufferPrecision: it comes"),
                                     std::pair(scale, "renderScale: it comes"),
                                     std::pair(lights, "maxAdditionalLightsCount: it comes"),
                                     std::pair(shadows, "shadows: they come")})
    {
        if (node && pipeline)
        {
            diagnostics.Error(node->location(), std::string(what) + " from renderPipelineAsset "
                                                                    "already; keep one of them");
            return;
        }
    }
    if (count)
    {
        asset.msaaSampleCount =
            ReadEnum(*count, k_MsaaQualities, "msaaSampleCount", diagnostics).value_or(1);
    }
    map.Read("supportsHDR", asset.supportsHDR);
    if (bits)
    {
        const auto value = ReadEnum(*bits, k_HdrBits, "hdrColorBufferPrecision", diagnostics);
        asset.hdrColorBufferPrecision = value == k_LeastHdrBits ? HDRColorBufferPrecision::_32Bits
                                                                : HDRColorBufferPrecision::_64Bits;
    }
    map.Read("renderScale", asset.renderScale);
    if (lights)
    {
        asset.maxAdditionalLightsCount =
            ReadInt(*lights, "maxAdditionalLightsCount", diagnostics, scene_keys::k_LightLimits)
                .value_or(0);
    }
    if (shadows)
    {
        YamlMapReader settings(*shadows, "shadows", diagnostics);
        ReadShadowSettings(settings, asset.shadows, diagnostics);
        settings.Finish();
    }
    if (pipeline)
    {
        PipelineSettings& settings = asset;
        const auto load = [&](const std::filesystem::path& path)
        {
            return LoadUnityRenderPipeline(path, loader.references.assets(),
                                           settings.pipelineVersion);
        };
        settings = loader.references.Read(*pipeline, "renderPipelineAsset", load);
    }
    const std::string problem = ScaledSizeProblem(asset);
    if (!problem.empty())
    {
        diagnostics.Error((scale ? scale : pipeline)->location(), problem);
    }
}

void ReadPlugins(const YamlNode& node, SceneLoader& loader)
{
    for (const auto& [item, place] : ReadItems(node, "plugins", loader.diagnostics))
    {
        const auto load = [&loader](const std::filesystem::path& path)
        {
            loader.references.assets().LoadPlugin(path);
            return true;
        };
        loader.references.Read(item, place, load);
    }
}

/// Calls `read` with the value of a key that may be absent.
template <typename Read>
void ReadPart(SceneMapReader& map, std::string_view key, SceneLoader& loader, Read&& read)
{
    if (const YamlNode* node = map.Find(key))
    {
        read(*node, loader);
    }
}

/// Reads what lights and veils the scene besides its lights.
void ReadRenderSettings(const YamlNode& node, SceneLoader& loader)
{
    SceneMapReader map(node, "renderSettings", scene_keys::k_RenderSettings, loader.diagnostics);
    RenderSettings& settings = loader.asset.scene;
    map.Read("ambientMode", k_AmbientModes, settings.ambientMode);
    map.Read("ambientEquatorColor", settings.ambientEquatorColor);
    map.Read("ambientGroundColor", settings.ambientGroundColor);
    map.Read("ambientIntensity", settings.ambientIntensity);
    map.Read("fog", settings.fog);
    map.Read("fogMode", k_FogModes, settings.fogMode);
    map.Read("fogColor", settings.fogColor);
    map.Read("fogDensity", settings.fogDensity);
    map.Read("fogStartDistance", settings.fogStartDistance);
    map.Read("fogEndDistance", settings.fogEndDistance);
    map.Read("defaultReflectionMode", k_DefaultReflectionModes, settings.defaultReflectionMode);
    if (const YamlNode* resolution = map.Find("defaultReflectionResolution"))
    {
        const std::string subject = map.SubjectOf("defaultReflectionResolution");
        const int texels = ReadInt(*resolution, subject, loader.diagnostics, {1.0, 2048.0})
                               .value_or(settings.defaultReflectionResolution);
        if (std::has_single_bit(static_cast<unsigned>(texels)))
        {
            settings.defaultReflectionResolution = texels;
        }
        else
        {
            loader.diagnostics.Error(resolution->location(),
                                     subject + ": " + std::to_string(texels) +
                                         " is no power of two, as 64 and 128 are");
        }
    }
    map.Read("reflectionIntensity", settings.reflectionIntensity);
    map.Finish();
}

/// Looks for the sky of a scene that is lit by one. Until it is drawn, ambientLight stands for it.
void CheckSky(const YamlNode& settings, bool hasSky, SceneLoader& loader)
{
    Scene& scene = loader.asset.scene;
    scene.ambientProbe.AddAmbientLight(scene.ambientLight.linear());
    const bool isLit = scene.ambientMode == AmbientMode::Skybox;
    if (!hasSky && (isLit || scene.defaultReflectionMode == DefaultReflectionMode::Skybox))
    {
        loader.diagnostics.Error(settings.location(),
                                 std::string("renderSettings.") +
                                     (isLit ? "ambientMode" : "defaultReflectionMode") +
                                     ": Skybox, but the scene has no sky; `skybox` names a "
                                     "material that draws one");
    }
}

/// Adds a note where the camera asks for antialiasing that nothing draws.
void CheckAntialiasing(const YamlNode& node, SceneLoader& loader)
{
    const Camera& camera = loader.asset.camera;
    const YamlNode* key = node.Find("antialiasing");
    if (key == nullptr || camera.antialiasing == AntialiasingMode::None)
    {
        return;
    }
    const bool isAllowed = camera.renderPostProcessing ||
                           std::ranges::any_of(camera.cameraStack, [](const auto& overlay)
                                               { return overlay->renderPostProcessing; });
    const bool hasFeature = std::ranges::any_of(
        loader.asset.renderer.features, [](const auto& feature)
        { return dynamic_cast<const PostProcessRendererFeature*>(feature.get()) != nullptr; });
    if (!isAllowed)
    {
        loader.diagnostics.Note(key->location(), "camera.antialiasing: nothing smooths the "
                                                 "picture; renderPostProcessing is off");
    }
    else if (!hasFeature)
    {
        loader.diagnostics.Note(key->location(),
                                "camera.antialiasing: nothing smooths the picture, unless a "
                                "feature of yours does; add {type: PostProcessRendererFeature} to "
                                "renderer.features");
    }
}

void ReadScene(const YamlNode& root, SceneLoader& loader)
{
    SceneMapReader map(root, "scene", scene_keys::k_Scene, loader.diagnostics);
    SceneAsset& asset = loader.asset;
    ReadPart(map, "size", loader, ReadSize);
    ReadPipeline(map, loader);
    if (const YamlNode* node = map.Find("layers"))
    {
        ReadLayerNames(*node, "layers", asset.layers, loader.diagnostics);
    }
    if (const YamlNode* node = map.Find("renderingLayers"))
    {
        ReadLayerNames(*node, "renderingLayers", asset.renderingLayers, loader.diagnostics);
    }
    ReadPart(map, "camera", loader, ReadCamera);
    ReadPart(map, "light", loader, ReadLight);
    ReadPart(map, "lights", loader, ReadLights);
    map.Read("ambientLight", asset.scene.ambientLight);
    ReadPart(map, "renderSettings", loader, ReadRenderSettings);
    ReadPart(map, "plugins", loader, ReadPlugins);     // whose shaders materials may name
    ReadPart(map, "materials", loader, ReadMaterials); // which features may name
    const YamlNode* skybox = map.Find("skybox");
    if (skybox != nullptr)
    {
        asset.scene.skybox = ReadMaterialName(*skybox, "skybox", loader);
    }
    ReadPart(map, "renderSettings", loader,
             [&](const YamlNode& node, SceneLoader&)
             { CheckSky(node, skybox != nullptr, loader); });
    ReadPart(map, "renderer", loader, ReadRenderer);
    ReadPart(map, "camera", loader, CheckAntialiasing);
    if (!map.Find("renderPipelineAsset"))
    {
        asset.pipelineVersion = asset.renderer.pipelineVersion.value_or(asset.pipelineVersion);
    }
    if (const YamlNode* node = map.Find("pipelineVersion"))
    {
        asset.pipelineVersion =
            ReadInt(*node, "pipelineVersion", loader.diagnostics, scene_keys::k_PipelineVersions)
                .value_or(asset.pipelineVersion);
    }
    ReadPart(map, "volumes", loader, ReadVolumes);
    ReadPart(map, "objects", loader, ReadObjects);
    CheckUnusedMaterials(loader);
    map.Finish();
}

void ReadFeature(const YamlNode& node, const std::string& subject, SceneLoader& loader)
{
    AssetDiagnostics& diagnostics = loader.diagnostics;
    YamlMapReader map(node, subject, diagnostics);
    std::string type;
    map.Require("type");
    if (!map.Read("type", type))
    {
        return;
    }
    const FeatureRegistry& features = loader.references.assets().features();
    std::unique_ptr<ScriptableRendererFeature> feature = features.Create(type);
    if (!feature)
    {
        diagnostics.Error(map.Find("type")->location(), map.SubjectOf("type") +
                                                            ": unknown feature " +
                                                            UnknownName(type, features.names()));
        return;
    }
    feature->name = type;
    map.Read("name", feature->name);
    AssetReaders assets = ReadersOfFiles(loader.references);
    assets.material = [&loader](const YamlNode& value, const std::string& setting)
    {
        return ReadMaterialName(value, setting, loader);
    };
    const SettingsContext context{loader.asset.layers, loader.asset.renderingLayers, assets};
    ReadFeatureSettings(map, *feature, context, diagnostics);
    TryCreate(*feature, loader.references.assets().shaderSource(), node.location(), subject + ": ",
              diagnostics);
    loader.asset.renderer.features.push_back(std::move(feature));
    loader.asset.renderer.featureTypes.push_back(type);
}

void ReadRendererData(const YamlNode& node, const char* key, SceneLoader& loader)
{
    References& references = loader.references;
    if (node.isScalar() && std::filesystem::path(node.scalar()).extension() != ".asset")
    {
        loader.diagnostics.Error(node.location(),
                                 std::string(key) + ": '" + node.scalar() +
                                     "' is no renderer of Unity's; an .asset file is expected");
        return;
    }
    const auto load = [&references](const std::filesystem::path& path)
    {
        return LoadUnityRendererData(path, references.assets());
    };
    UnityRendererDataLoadResult result = references.Read(node, key, load);
    loader.asset.renderer = std::move(result.renderer);
    loader.AddNotes(result.notes);
}

} // namespace

void SceneLoader::AddNotes(const std::vector<Diagnostic>& notes)
{
    for (const Diagnostic& note : notes)
    {
        AddOnce(note, asset.notes);
    }
}

void TurnObjects(const std::vector<Turn>& turns, double seconds)
{
    for (const Turn& turn : turns)
    {
        glm::vec3 degrees;
        for (int axis = 0; axis < 3; ++axis)
        {
            const double rate = static_cast<double>(turn.degreesPerSecond[axis]);
            degrees[axis] = static_cast<float>(std::fmod(rate * seconds, 360.0));
        }
        turn.object->transform.localRotation = turn.rest * EulerToRotation(degrees);
    }
}

std::string ScaledSizeProblem(const SceneAsset& scene)
{
    const auto scaled = [&scene](int side)
    {
        return static_cast<int>(static_cast<float>(side) * scene.renderScale);
    };
    const int width = scaled(scene.width);
    const int height = scaled(scene.height);
    return std::max(width, height) <= static_cast<int>(k_PictureSizes.max)
               ? ""
               : "renderScale: it makes " + std::to_string(width) + "x" + std::to_string(height) +
                     " of " + std::to_string(scene.width) + "x" + std::to_string(scene.height) +
                     " pixels, and cameras draw in at most " + NumberText(k_PictureSizes.max) +
                     " either way; lower it, or draw a smaller picture";
}

std::vector<SceneItem> ReadItems(const YamlNode& node, const std::string& subject,
                                 AssetDiagnostics& diagnostics)
{
    if (!node.isSequence() && !node.isNull())
    {
        diagnostics.Error(node.location(), subject + ": found " + node.Describe() +
                                               "; a list is expected, each item behind a '- '");
    }
    std::vector<SceneItem> items;
    for (const YamlNode& item : node.items())
    {
        items.push_back({item, subject + "[" + std::to_string(items.size()) + "]"});
    }
    return items;
}

std::vector<SceneItem> ReadItems(SceneMapReader& map, std::string_view key,
                                 AssetDiagnostics& diagnostics)
{
    const YamlNode* node = map.Find(key);
    return node ? ReadItems(*node, map.SubjectOf(key), diagnostics) : std::vector<SceneItem>();
}

void ReadTransform(SceneMapReader& map, Transform& transform, AssetDiagnostics& diagnostics)
{
    map.Read("position", transform.localPosition);
    map.Read("rotation", transform.localRotation);
    const YamlNode* scale = map.Find("scale");
    if (scale && scale->isScalar())
    {
        transform.localScale =
            glm::vec3(ReadFloat(*scale, map.SubjectOf("scale"), diagnostics).value_or(1.0f));
    }
    else
    {
        map.Read("scale", transform.localScale);
    }
}

SceneAsset LoadSceneFile(const std::filesystem::path& path, AssetContext& assets,
                         InactiveObjects inactive)
{
    assets.Reach(path);
    assets.AddRootsAround(path);
    const std::vector<YamlNode> documents = LoadYamlFile(path);
    AssetDiagnostics diagnostics(path.generic_string());
    References references(assets, {path.parent_path()}, diagnostics);
    SceneAsset asset;
    asset.path = path;
    SceneLoader loader{diagnostics, references, asset, inactive};
    if (documents.size() > 1)
    {
        diagnostics.Error(
            documents[1].location(),
            "a second document begins here, but a scene is a single one; remove the line '---'");
    }
    ReadScene(documents.front(), loader);
    references.ThrowIfErrors();
    loader.AddNotes(diagnostics.notes());
    return asset;
}

void ReadRenderer(const YamlNode& node, SceneLoader& loader)
{
    if (node.isScalar())
    {
        ReadRendererData(node, "renderer", loader);
        return;
    }
    SceneMapReader map(node, "renderer", scene_keys::k_Renderer, loader.diagnostics);
    const YamlNode* data = map.Find("rendererData");
    const YamlNode* features = map.Find("features");
    map.Finish();
    if (data && features)
    {
        loader.diagnostics.Error(features->location(),
                                 "renderer.features: the features come from rendererData already; "
                                 "keep one of them");
        return;
    }
    if (data)
    {
        ReadRendererData(*data, "renderer.rendererData", loader);
    }
    if (features)
    {
        for (const auto& [item, place] :
             ReadItems(*features, "renderer.features", loader.diagnostics))
        {
            ReadFeature(item, place, loader);
        }
    }
}

} // namespace limn
