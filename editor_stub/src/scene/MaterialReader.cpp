#include "scene/MaterialReader.h"

#include "scene/Loader.h"

#include <algorithm>
#include <limn/shaderlab/InitialKeywords.h>

namespace limn
{

namespace
{

/// What a material is read with.
struct MaterialSources
{
    References& references;
    AssetDiagnostics& diagnostics;
};

void ReadNumberProperty(const ShaderProperty& property, const YamlNode& node,
                        const std::string& subject, Material& material,
                        AssetDiagnostics& diagnostics)
{
    const ShaderPropertyId id(property.name);
    if (property.type == ShaderPropertyType::Integer)
    {
        material.SetInt(id, ReadInt(node, subject, diagnostics).value_or(0));
        return;
    }
    const bool hasRange = property.type == ShaderPropertyType::Range;
    const ValueRange range =
        hasRange ? ValueRange{property.rangeMin, property.rangeMax} : ValueRange{};
    material.SetFloat(id, ReadFloat(node, subject, diagnostics, range).value_or(0.0f));
}

void ReadProperty(const ShaderProperty& property, YamlMapReader& map, Material& material,
                  MaterialSources& sources)
{
    const YamlNode* node = map.Find(property.name);
    if (!node)
    {
        return;
    }
    const std::string subject = map.SubjectOf(property.name);
    const ShaderPropertyId id(property.name);
    switch (property.type)
    {
    case ShaderPropertyType::Color:
        material.SetColor(
            id, ReadColor(*node, subject, sources.diagnostics, k_ColorChannels).value_or(Color{}));
        break;
    case ShaderPropertyType::Vector:
        material.SetVector(
            id, ReadVector(*node, 4, subject, sources.diagnostics).value_or(glm::vec4(0.0f)));
        break;
    case ShaderPropertyType::Texture:
        ReadTextureProperty(property, *node, subject, material, sources.references,
                            sources.diagnostics);
        break;
    case ShaderPropertyType::Float:
    case ShaderPropertyType::Range:
    case ShaderPropertyType::Int:
    case ShaderPropertyType::Integer:
        ReadNumberProperty(property, *node, subject, material, sources.diagnostics);
        break;
    }
}

/// What Unity's inspector does with a value that is changed there: Toggle and KeywordEnum choose
/// keywords.
void SetKeywordsOfValues(Material& material)
{
    const Shader& shader = *material.shader();
    std::vector<ShaderProperty> properties = shader.document().properties;
    for (ShaderProperty& property : properties)
    {
        const ShaderPropertyId id(property.name);
        if (material.HasFloat(id))
        {
            property.defaultValue[0] = material.GetFloat(id);
        }
    }
    const std::vector<std::string> wanted = InitialKeywords(properties);
    for (const std::string& keyword : shader.initialKeywords())
    {
        if (std::ranges::find(wanted, keyword) == wanted.end())
        {
            material.DisableKeyword(keyword);
        }
    }
    for (const std::string& keyword : wanted)
    {
        if (!material.IsKeywordEnabled(keyword))
        {
            material.EnableKeyword(keyword);
        }
    }
}

} // namespace

std::shared_ptr<const Material> ReadMaterial(const std::string& name, const YamlNode& node,
                                             References& references, AssetDiagnostics& diagnostics)
{
    MaterialSources sources{references, diagnostics};
    YamlMapReader map(node, "material '" + name + "'", diagnostics, "property");
    const YamlNode* shaderNode = map.Find("shader");
    const std::shared_ptr<const Shader> shader =
        shaderNode ? references.ReadShader(*shaderNode, map.SubjectOf("shader"))
                   : references.assets().FindShader(k_DefaultShader);
    if (!shader)
    {
        return nullptr;
    }
    auto material = std::make_shared<Material>(shader, name);
    int queue = -1;
    if (map.Read("renderQueue", queue, k_RenderQueues))
    {
        material->SetRenderQueue(queue);
    }
    for (const ShaderProperty& property : shader->document().properties)
    {
        ReadProperty(property, map, *material, sources);
    }
    SetKeywordsOfValues(*material);
    map.Finish();
    return material;
}

std::shared_ptr<const Material> ReadMaterialFile(const std::filesystem::path& path,
                                                 AssetContext& assets)
{
    const std::vector<YamlNode> documents = LoadYamlFile(path);
    AssetDiagnostics diagnostics(path.generic_string());
    References references(assets, {path.parent_path()}, diagnostics);
    const std::string name = path.stem().stem().generic_string();
    std::shared_ptr<const Material> material =
        ReadMaterial(name, documents.front(), references, diagnostics);
    references.ThrowIfErrors();
    return material;
}

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
        loader.materials.emplace(entry.key, SceneMaterial{&entry.value, false, nullptr});
    }
}

void CheckUnusedMaterials(SceneLoader& loader)
{
    loader.references.decodesPictures = false;
    for (const auto& [name, material] : loader.materials)
    {
        if (!material.isRead)
        {
            ReadMaterial(name, *material.node, loader.references, loader.diagnostics);
        }
    }
    loader.references.decodesPictures = true;
}

SceneMaterial* FindMaterial(const YamlNode& node, const std::string& subject, SceneLoader& loader)
{
    const std::optional<std::string> name = ReadString(node, subject, loader.diagnostics);
    const auto found = name ? loader.materials.find(*name) : loader.materials.end();
    if (found != loader.materials.end())
    {
        return &found->second;
    }
    if (name)
    {
        std::vector<std::string_view> names;
        for (const auto& [known, material] : loader.materials)
        {
            names.push_back(known);
        }
        loader.diagnostics.Error(node.location(),
                                 subject + ": unknown material " + UnknownName(*name, names));
    }
    return nullptr;
}

std::shared_ptr<const Material> ReadMaterialName(const YamlNode& node, const std::string& subject,
                                                 SceneLoader& loader)
{
    SceneMaterial* found = FindMaterial(node, subject, loader);
    if (found == nullptr)
    {
        return nullptr;
    }
    if (!found->isRead)
    {
        found->isRead = true;
        found->material =
            ReadMaterial(node.scalar(), *found->node, loader.references, loader.diagnostics);
    }
    return found->material;
}

} // namespace limn
