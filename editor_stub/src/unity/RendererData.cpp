#include "unity/RendererData.h"

#include "assets/Importer.h"
#include "assets/PictureFile.h"
#include "assets/References.h"
#include "settings/ReadValues.h"
#include "settings/SettingsReader.h"
#include "unity/ProjectShaders.h"
#include "unity/RenderPipelineAsset.h"

#include <algorithm>
#include <limn/core/ComputeShader.h>
#include <limn/features/Features.h>
#include <limn/features/PostProcessRendererFeature.h>
#include <limn/volume/UnityAsset.h>
#include <set>
#include <utility>

namespace limn
{

namespace
{

struct Loading
{
    AssetContext& assets;
    AssetDiagnostics& diagnostics;
    References references;
    const UnityProject& project;
    const UnityAssetLoaders& load;
    LayerNames layers = {};  ///< an asset's masks are numbers, so no names are needed
    bool hasShaders = false; ///< true if Shader::Find finds those of the project
};

/// The file of a guid; who watches sees it get another.
const std::filesystem::path* FindFile(const std::string& guid, Loading& loading)
{
    const std::filesystem::path* path = loading.project.Find(guid);
    if (path)
    {
        loading.assets.Reach(path->string() + ".meta");
    }
    return path;
}

/// The shader of a reference {fileID, guid}; one that comes with limn where the project's own file
/// is not there. Null, with a note, if there is neither.
std::shared_ptr<const Shader> ReadShaderReference(const YamlNode& node, const std::string& subject,
                                                  Loading& loading)
{
    if (ReadFileID(node) == 0)
    {
        return nullptr;
    }
    const std::string guid = ReadGuid(node);
    const std::filesystem::path* path = FindFile(guid, loading);
    if (path)
    {
        loading.assets.Reach(*path);
    }
    std::error_code ignored;
    if (path && std::filesystem::exists(*path, ignored))
    {
        if (!loading.references.isAllowed(*path, node, subject))
        {
            return nullptr;
        }
        try
        {
            const bool isGraph = path->extension() == ".shadergraph" && loading.load.graph;
            return isGraph ? loading.load.graph(*path, loading.assets)
                           : loading.assets.LoadShader(*path);
        }
        catch (const AssetError& error)
        {
            loading.references.Report(node, subject, error);
            return nullptr;
        }
    }
    const ShaderLabDocument* shipped =
        path ? ShippedShaders().FindFile(path->filename().string()) : nullptr;
    const std::string missing =
        path ? path->filename().string() + " is not in the project"
             : "no .meta file of the project has the shader's guid '" + guid + "'";
    if (!shipped)
    {
        loading.diagnostics.Note(node.location(), subject + ": it is left out; " + missing);
        return nullptr;
    }
    loading.diagnostics.Note(node.location(), subject + ": " + missing + ", so " + shipped->name +
                                                  " that comes with limn is used");
    return loading.assets.FindShader(shipped->name);
}

std::shared_ptr<const ComputeShader>
ReadComputeReference(const YamlNode& node, const std::string& subject, Loading& loading)
{
    if (ReadFileID(node) == 0)
    {
        return nullptr;
    }
    const std::string guid = ReadGuid(node);
    const std::filesystem::path* path = FindFile(guid, loading);
    if (!path || path->extension() != ".compute")
    {
        loading.diagnostics.Note(
            node.location(),
            subject + ": it is left out; " +
                (path ? path->filename().string() + " is no .compute file"
                      : "no .meta file of the project has the compute shader's guid '" + guid +
                            "'"));
        return nullptr;
    }
    try
    {
        loading.assets.Reach(*path);
        return loading.references.isAllowed(*path, node, subject)
                   ? ComputeShader::Load(*path, loading.assets.compiler())
                   : nullptr;
    }
    catch (const AssetError& error)
    {
        loading.references.Report(node, subject, error);
        return nullptr;
    }
}

template <typename Asset>
AssetReader<Asset> ReaderOf(const UnityAssetLoader<Asset>& load, Loading& loading)
{
    return [&load, &loading](const YamlNode& node, const std::string& subject)
    {
        const std::int64_t fileID = ReadFileID(node).value_or(0);
        const auto note = [&](const std::string& reason)
        {
            loading.diagnostics.Note(node.location(), subject + ": it is left out; " + reason);
        };
        return fileID == 0 ? nullptr : load({fileID, ReadGuid(node)}, note);
    };
}

void ReadSettings(const UnityObject& object, const std::string& type,
                  ScriptableRendererFeature& feature, Loading& loading)
{
    YamlMapReader map(object.fields, object.name, loading.diagnostics);
    const auto readShader = [&loading](const YamlNode& node, const std::string& name)
    {
        return ReadShaderReference(node, name, loading);
    };
    const auto readCompute = [&loading](const YamlNode& node, const std::string& name)
    {
        return ReadComputeReference(node, name, loading);
    };
    const AssetReaders assets{readShader, ReaderOf(loading.load.material, loading),
                              ReaderOf(loading.load.texture, loading), readCompute};
    const SettingsContext context{loading.layers, loading.layers, assets, type};
    ReadFeatureSettings(map, feature, context, loading.diagnostics);
}

/// Returns why there is no feature of this class, and what helps.
/// @param name    of the feature's object, which messages begin with
/// @param type    "" = it cannot be told
/// @param script  the file of the guid; null = there is none
std::string WhyNoFeature(const std::string& name, const std::string& type, const std::string& guid,
                         const std::filesystem::path* script)
{
    if (type.empty())
    {
        return "no .cs.meta file of the project has the script's guid '" + guid + "'";
    }
    std::error_code ignored;
    const bool isThere = script != nullptr && std::filesystem::exists(*script, ignored);
    return "limn has no feature " + (type == name ? "of this name" : type) +
           (isThere ? "; `limn port \"" + script->generic_string() + "\" -o DIR` writes one in C++"
                    : "");
}

bool IsShipped(const std::string& type)
{
    static const auto names = []
    {
        FeatureRegistry features;
        VolumeComponentRegistry components;
        RegisterFeatures(features, components);
        std::set<std::string> all;
        std::ranges::for_each(features.names(), [&](std::string_view name) { all.emplace(name); });
        return all;
    }();
    return names.contains(type);
}

void ReadFeature(const UnityObject& object, RendererAsset& renderer, Loading& loading)
{
    const YamlNode* active = object.fields.Find("m_Active");
    const bool isActive =
        !active || ReadBool(*active, object.name + ".m_Active", loading.diagnostics).value_or(true);
    const YamlNode* reference = object.fields.Find("m_Script");
    const std::string guid = reference ? ReadGuid(*reference) : std::string();
    const std::filesystem::path* script = FindFile(guid, loading);
    const std::string type = UnityScriptClass(guid, loading.project);
    std::unique_ptr<ScriptableRendererFeature> feature = loading.assets.features().Create(type);
    if (!feature)
    {
        if (isActive)
        {
            loading.diagnostics.Note(object.location,
                                     object.name + ": it is left out; " +
                                         WhyNoFeature(object.name, type, guid, script));
        }
        return;
    }
    feature->name = object.name;
    feature->SetActive(isActive);
    if (!IsShipped(type) && !std::exchange(loading.hasShaders, true))
    {
        UseShadersOf(loading.project, loading.assets, loading.load.graph);
    }
    const auto hasErrors = [&diagnostics = loading.diagnostics](const auto& step)
    {
        const std::size_t before = diagnostics.errorCount();
        step();
        return diagnostics.errorCount() > before;
    };
    if (hasErrors([&] { ReadSettings(object, type, *feature, loading); }))
    {
        loading.diagnostics.Note(object.location,
                                 object.name + ": a setting that cannot be read keeps its default");
    }
    if (hasErrors(
            [&] {
                TryCreate(*feature, loading.assets.shaderSource(), object.location, "",
                          loading.diagnostics);
            }))
    {
        loading.diagnostics.Note(object.location,
                                 object.name + ": it is left out; it cannot be created");
        return;
    }
    renderer.features.push_back(std::move(feature));
    renderer.featureTypes.push_back(type);
}

void ReadFeatures(const UnityAsset& asset, const YamlNode& references, RendererAsset& renderer,
                  Loading& loading)
{
    for (const YamlNode& reference : references.items())
    {
        const UnityHeader* header = asset.FindHeader(ReadFileID(reference).value_or(0));
        if (!header)
        {
            // Unity leaves such a reference behind where a feature's script was deleted.
            loading.diagnostics.Note(
                reference.location(),
                "m_RendererFeatures: a feature is left out; it is not in this file");
            continue;
        }
        try
        {
            ReadFeature(asset.Read(*header), renderer, loading);
        }
        catch (const AssetError& error)
        {
            loading.diagnostics.Add(error);
        }
    }
}

/// Behind all features, as URP's own passes are behind those of features.
void ReadPostProcessing(const UnityObject& root, RendererAsset& renderer)
{
    const YamlNode* data = root.fields.Find("postProcessData");
    if (data && ReadFileID(*data).value_or(0) != 0)
    {
        auto feature = std::make_unique<PostProcessRendererFeature>();
        renderer.featureTypes.push_back(std::exchange(feature->name, "Post-processing"));
        renderer.features.push_back(std::move(feature));
    }
}

void ReadLayers(const UnityObject& root, const char* field, LayerMask& mask, Loading& loading)
{
    if (const YamlNode* node = root.fields.Find(field))
    {
        const auto bits =
            ReadLayerBits(*node, field, {loading.layers, "layer"}, loading.diagnostics);
        mask = LayerMask(bits.value_or(mask.bits));
    }
}

/// Reads the asset into a renderer.
/// @throws AssetError if it is none
void ReadRenderer(const std::filesystem::path& path, RendererAsset& renderer, Loading& loading)
{
    loading.assets.Reach(path);
    const AssetContext::RootsFor roots(loading.assets, path);
    const UnityAsset asset = LoadUnityAsset(path);
    const std::optional<UnityObject> root = asset.FindWithField("m_RendererFeatures");
    if (!root)
    {
        throw AssetError(path.generic_string(), {},
                         "no renderer in this Unity asset; one is a MonoBehaviour with a list "
                         "'m_RendererFeatures'");
    }
    renderer.pipelineVersion = ProjectPipelineVersion(path, loading.assets);
    ReadFeatures(asset, *root->fields.Find("m_RendererFeatures"), renderer, loading);
    ReadPostProcessing(*root, renderer);
    ReadLayers(*root, "m_OpaqueLayerMask", renderer.opaqueLayerMask, loading);
    ReadLayers(*root, "m_TransparentLayerMask", renderer.transparentLayerMask, loading);
}

/// Returns all errors, as notes.
std::vector<Diagnostic> ErrorsAsNotes(const References& references)
{
    std::vector<Diagnostic> notes;
    try
    {
        references.ThrowIfErrors();
    }
    catch (const AssetError& error)
    {
        notes = error.diagnostics();
        std::ranges::for_each(notes, [](Diagnostic& note) { note.severity = Severity::Note; });
    }
    return notes;
}

} // namespace

UnityRendererDataLoadResult LoadUnityRendererData(const std::filesystem::path& path,
                                                  AssetContext& assets, const UnityProject& project,
                                                  const UnityAssetLoaders& load)
{
    AssetDiagnostics diagnostics(path.generic_string());
    Loading loading{assets, diagnostics, {assets, {}, diagnostics}, project, load};
    UnityRendererDataLoadResult result;
    ReadRenderer(path, result.renderer, loading);
    result.notes = ErrorsAsNotes(loading.references);
    std::ranges::copy(diagnostics.notes(), std::back_inserter(result.notes));
    return result;
}

UnityRendererDataLoadResult LoadUnityRendererData(const std::filesystem::path& path,
                                                  AssetContext& assets)
{
    const UnityProject project(path, assets.importer().cacheFolder());
    UnityAssetLoaders load;
    load.material = [](const UnityReference&, const auto& note)
    {
        note("limn reads the .mat files of Unity's scenes only; name a material of the scene in a "
             "scene file instead");
        return nullptr;
    };
    load.texture = [&](const UnityReference& texture,
                       const auto& note) -> std::shared_ptr<const Texture>
    {
        const std::filesystem::path* picture = project.Find(texture.guid);
        if (picture && IsPictureFile(*picture))
        {
            return assets.LoadTexture(*picture);
        }
        note(picture
                 ? picture->filename().string() + " is no picture"
                 : "no .meta file of the project has the texture's guid '" + texture.guid + "'");
        return nullptr;
    };
    AssetDiagnostics diagnostics(path.generic_string());
    Loading loading{assets, diagnostics, {assets, {}, diagnostics}, project, load};
    UnityRendererDataLoadResult result;
    ReadRenderer(path, result.renderer, loading);
    loading.references.ThrowIfErrors();
    result.notes = diagnostics.notes();
    return result;
}

} // namespace limn
