#include "explain/InspectReport.h"

#include "settings/ShadowKeys.h"
#include "shader_graph/GraphShader.h"
#include "unity/UnityDatabase.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr int k_Material = 21;

/// Returns the name of a shader of Unity's own, whose .meta file is in no project; "" for others.
std::string_view NameOfUnityShader(const UnityReference& reference)
{
    if (reference.guid == "0000000000000000f000000000000000")
    {
        return {}; // the built-in pipeline's: limn draws most of them with a stand-in
    }
    const UnityKnownAsset known = FindKnownAsset(reference);
    return reference.guid == "69c1f799e772cb6438f56c23efccb782"
               ? "Universal Render Pipeline/Terrain/Lit"
           : known.kind == UnityPackageAsset::Shader ? known.name
                                                     : "";
}

/// Settings of a pipeline that are the editor's, or that Unity itself reads no more.
bool IsUnread(std::string_view key)
{
    constexpr std::string_view k_Unread[] = {
        "m_RendererType",          "m_RendererData",   "m_RendererDataList",
        "m_DefaultRendererIndex",  "m_DebugLevel",     "m_ShadowType",
        "m_LocalShadowsSupported", "m_MaxPixelLights", "m_LocalShadowsAtlasResolution",
        "m_ShadowAtlasResolution", "m_ShadowCascades", "m_Textures",
        "m_ShaderVariantLogLevel"};
    return isUnityHeaderField(key) || key.starts_with("k_Asset") ||
           key.starts_with("m_Prefilter") || std::ranges::find(k_Unread, key) != std::end(k_Unread);
}

/// Returns whether LoadUnityRenderPipeline reads the setting.
bool IsDrawnWith(std::string_view key)
{
    bool isFound = key == "m_MSAA" || key == "m_SupportsHDR" ||
                   key == "m_HDRColorBufferPrecision" || key == "m_RenderScale" ||
                   key == "m_AdditionalLightsPerObjectLimit" ||
                   key == "m_AdditionalLightsRenderingMode";
    ShadowSettings settings;
    VisitShadowSettings(settings, [&isFound, key](std::string_view name, const auto&...)
                        { isFound = isFound || name == key; });
    return isFound;
}

/// The file that a reference leads to, from the project's folder; what is known of it if that
/// cannot be told.
std::string FileOf(const YamlNode& reference, const UnityProject& project)
{
    if (ReadFileID(reference).value_or(0) == 0)
    {
        return "none";
    }
    const std::string guid = ReadGuid(reference);
    const std::filesystem::path* path = project.Find(guid);
    return path ? path->lexically_relative(project.root()).generic_string()
                : "guid " + guid + " (the project has no .meta file with it)";
}

void Add(InspectedGroup& group, std::string header, std::string name, std::string text,
         std::string tooltip = "")
{
    InspectedValue& value = group.values.emplace_back();
    value.header = std::move(header);
    value.name = std::move(name);
    value.value = std::move(text);
    value.tooltip = std::move(tooltip);
    value.hasDefault = false;
}

std::optional<UnityObject> FindMaterial(const UnityAsset& asset)
{
    const auto headers = asset.headers();
    const auto found = std::ranges::find(headers, k_Material, &UnityHeader::classID);
    return found == headers.end() ? std::nullopt : std::optional(asset.Read(*found));
}

void AddRenderers(const UnityObject& pipeline, const UnityProject& project, InspectedGroup& group)
{
    const YamlNode* list = pipeline.fields.Find("m_RendererDataList");
    const YamlNode* index = pipeline.fields.Find("m_DefaultRendererIndex");
    std::size_t i = 0;
    for (const YamlNode& renderer : list ? list->items() : std::span<const YamlNode>())
    {
        const std::string number = std::to_string(i++);
        const bool isDefault = (index ? index->scalar() : "0") == number;
        Add(group, "Renderers", number, FileOf(renderer, project),
            isDefault ? "of cameras that choose none" : "");
    }
}

/// A material's shader: its name or file, and a sentence on what limn has of it.
struct MaterialShader
{
    std::string text;
    std::string remark;
    std::shared_ptr<const Shader> shader; ///< null if limn has none
};

MaterialShader FindShaderOf(const UnityObject& material, const UnityProject& project,
                            AssetContext& assets)
{
    const YamlNode* reference = material.fields.Find("m_Shader");
    if (!reference || ReadFileID(*reference).value_or(0) == 0)
    {
        return {"none", "", nullptr};
    }
    const std::string guid = ReadGuid(*reference);
    const std::string_view name = NameOfUnityShader({*ReadFileID(*reference), guid});
    if (!name.empty())
    {
        const std::shared_ptr<const Shader> shader = assets.FindShader(name);
        return {std::string(name),
                shader ? "limn's own of this name is drawn with" : "limn has none of this name",
                shader};
    }
    const std::string file = FileOf(*reference, project);
    const std::filesystem::path* path = project.Find(guid);
    const bool isGraph = path && IsShaderGraph(*path);
    if (!isGraph && (!path || path->extension() != ".shader"))
    {
        return {file, path ? "limn reads .shader and .shadergraph files only" : "", nullptr};
    }
    try
    {
        const std::shared_ptr<const Shader> shader =
            isGraph ? std::make_shared<const Shader>(LoadShaderFile(*path).TakeDocument(),
                                                     assets.compiler())
                    : assets.LoadShader(*path);
        return {shader->name(), file, shader};
    }
    catch (const AssetError&)
    {
        return {file, "'limn shader' shows its errors", nullptr};
    }
}

std::string KeywordsOf(const UnityObject& material)
{
    const YamlNode* valid = material.fields.Find("m_ValidKeywords");
    const YamlNode* old = material.fields.Find("m_ShaderKeywords");
    return valid ? OnOneLine(*valid) : old ? "[" + old->scalar() + "]" : "[]";
}

/// Each property of one of the lists of m_SavedProperties, each a map of one key.
void AddProperties(const YamlNode& properties, const char* list, const char* header,
                   const UnityProject& project, const Shader* shader, InspectedGroup& group)
{
    const YamlNode* node = properties.Find(list);
    for (const YamlNode& item : node ? node->items() : std::span<const YamlNode>())
    {
        for (const YamlEntry& entry : item.entries())
        {
            const YamlNode* texture = entry.value.Find("m_Texture");
            std::string text = texture ? FileOf(*texture, project) : OnOneLine(entry.value);
            if (texture && text != "none" && entry.value.Find("m_Scale") &&
                entry.value.Find("m_Offset"))
            {
                text += ", scale " + OnOneLine(*entry.value.Find("m_Scale")) + ", offset " +
                        OnOneLine(*entry.value.Find("m_Offset"));
            }
            const bool isLeftOver = shader && shader->FindPropertyIndex(entry.key) < 0;
            Add(group, header, entry.key, text, isLeftOver ? "unknown to limn's shader" : "");
        }
    }
}

} // namespace

std::string KindOfUnityAsset(const UnityAsset& asset)
{
    for (const auto& [field, kind] :
         {std::pair("m_RendererFeatures", "renderer"), std::pair("m_RendererDataList", "pipeline"),
          std::pair("m_MSAA", "pipeline"), std::pair("components", "profile")})
    {
        if (asset.FindWithField(field))
        {
            return kind;
        }
    }
    if (FindMaterial(asset))
    {
        return "material";
    }
    std::string found;
    if (!asset.headers().empty())
    {
        const UnityObject object = asset.Read(asset.headers().front());
        found =
            "; it holds " + object.typeName + (object.name.empty() ? "" : " '" + object.name + "'");
    }
    throw AssetError(
        asset.file(), {},
        "no volume profile, renderer, render pipeline or material in this Unity asset" + found);
}

InspectedGroup InspectPipeline(const UnityAsset& asset)
{
    const std::optional<UnityObject> list = asset.FindWithField("m_RendererDataList");
    const UnityObject pipeline = list ? *list : *asset.FindWithField("m_MSAA");
    const UnityProject project(asset.file());
    InspectedGroup group{"UniversalRenderPipelineAsset", pipeline.name, true, {}};
    if (const YamlNode* version = pipeline.fields.Find("k_AssetVersion"))
    {
        Add(group, "", "k_AssetVersion", OnOneLine(*version));
    }
    AddRenderers(pipeline, project, group);
    for (const bool isDrawn : {true, false})
    {
        for (const YamlEntry& entry : pipeline.fields.entries())
        {
            if (!IsUnread(entry.key) && IsDrawnWith(entry.key) == isDrawn)
            {
                Add(group,
                    isDrawn ? "Drawn with, by a scene's renderPipelineAsset"
                            : "Left out, limn does not draw by these",
                    entry.key, OnOneLine(entry.value));
            }
        }
    }
    return group;
}

InspectedGroup InspectRenderer(const UnityAsset& asset)
{
    const UnityObject renderer = *asset.FindWithField("m_RendererFeatures");
    InspectedGroup group{"UniversalRendererData", renderer.name, true, {}};
    const auto add = [&renderer, &group](const char* key, const char* tooltip)
    {
        if (const YamlNode* node = renderer.fields.Find(key))
        {
            const YamlNode* bits = node->Find("m_Bits");
            const YamlNode* stencil = node->Find("overrideStencilState");
            Add(group, "", key, OnOneLine(bits ? *bits : stencil ? *stencil : *node), tooltip);
        }
    };
    add("m_OpaqueLayerMask", "The bits of the layers whose opaque objects are drawn");
    add("m_TransparentLayerMask", "The bits of the layers whose transparent objects are drawn");
    add("m_RenderingMode", "0 forward, 1 deferred, 2 forward+; limn draws all of them forward");
    add("m_DefaultStencilState",
        "1 replaces the Stencil block of all objects, which limn leaves out");
    const YamlNode* data = renderer.fields.Find("postProcessData");
    const bool isOn = data && ReadFileID(*data).value_or(0) != 0;
    Add(group, "", "postProcessData", isOn ? "URP's" : "none",
        isOn ? "draws Bloom, Tonemapping and their like, behind all features"
             : "no post-processing");
    return group;
}

InspectedGroup InspectMaterial(const UnityAsset& asset, AssetContext& assets)
{
    // KindOfUnityAsset has found that there is one.
    const UnityObject material = *FindMaterial(asset);
    const UnityProject project(asset.file());
    InspectedGroup group{"Material", material.name, true, {}};
    const MaterialShader shader = FindShaderOf(material, project, assets);
    Add(group, "", "m_Shader", shader.text, shader.remark);
    Add(group, "", "keywords", KeywordsOf(material));
    for (const auto& [key, tooltip] :
         {std::pair("m_InvalidKeywords", "that the shader did not know when Unity saved it"),
          std::pair("m_CustomRenderQueue", "-1: the shader's own"),
          std::pair("stringTagMap", "tags in place of the shader's"),
          std::pair("disabledShaderPasses", "LightMode tags of passes that are not drawn")})
    {
        const YamlNode* node = material.fields.Find(key);
        if (node && (node->isScalar() || node->items().size() + node->entries().size() > 0))
        {
            Add(group, "", key, OnOneLine(*node), tooltip);
        }
    }
    if (const YamlNode* properties = material.fields.Find("m_SavedProperties"))
    {
        for (const auto& [list, header] :
             {std::pair("m_TexEnvs", "Textures"), std::pair("m_Ints", "Integers"),
              std::pair("m_Floats", "Numbers"), std::pair("m_Colors", "Colours and vectors")})
        {
            AddProperties(*properties, list, header, project, shader.shader.get(), group);
        }
    }
    return group;
}

} // namespace limn
