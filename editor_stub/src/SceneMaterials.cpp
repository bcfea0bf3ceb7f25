#include "SceneLoader.h"

#include <limn/core/BuiltinShaders.h>

namespace limn
{

namespace
{

void ReadTextureProperty(const YamlNode& node, const std::string& subject, ShaderPropertyId id,
                         Material& material, SceneLoader& loader)
{
    if (std::filesystem::path(node.scalar()).extension() == ".png")
    {
        References& references = loader.references;
        const auto load = [&references](const std::filesystem::path& path)
        {
            return references.assets().LoadTexture(path);
        };
        material.SetTexture(id, references.Read(node, subject, load));
        return;
    }
    const std::shared_ptr<const Texture> texture = DefaultTexture(node.scalar());
    if (texture->name() != node.scalar())
    {
        loader.diagnostics.Error(node.location(),
                                 subject + ": found " + node.Describe() +
                                     "; the path of a .png file, or white, black, gray, bump or "
                                     "red is expected");
        return;
    }
    material.SetTexture(id, texture);
}

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
                  SceneLoader& loader)
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
        material.SetColor(id, ReadColor(*node, subject, loader.diagnostics).value_or(Color{}));
        break;
    case ShaderPropertyType::Vector:
        material.SetVector(
            id, ReadVector(*node, 4, subject, loader.diagnostics).value_or(glm::vec4(0.0f)));
        break;
    case ShaderPropertyType::Texture:
        ReadTextureProperty(*node, subject, id, material, loader);
        break;
    case ShaderPropertyType::Float:
    case ShaderPropertyType::Range:
    case ShaderPropertyType::Int:
    case ShaderPropertyType::Integer:
        ReadNumberProperty(property, *node, subject, material, loader.diagnostics);
        break;
    }
}

/// Null if the shader cannot be used: which properties there are is then unknown.
std::shared_ptr<const Material> ReadMaterial(const YamlEntry& entry, SceneLoader& loader)
{
    YamlMapReader map(entry.value, "material '" + entry.key + "'", loader.diagnostics, "property");
    const YamlNode* shaderNode = map.Find("shader");
    const std::shared_ptr<const Shader> shader =
        shaderNode ? loader.references.ReadShader(*shaderNode, map.SubjectOf("shader"))
                   : loader.references.assets().FindShader(k_DefaultShader);
    if (!shader)
    {
        return nullptr;
    }
    auto material = std::make_shared<Material>(shader, entry.key);
    int queue = -1;
    if (map.Read("renderQueue", queue, {-1.0, 5000.0}))
    {
        material->SetRenderQueue(queue);
    }
    for (const ShaderProperty& property : shader->document().properties)
    {
        ReadProperty(property, map, *material, loader);
    }
    map.Finish();
    return material;
}

} // namespace

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
        loader.materials.emplace(entry.key, ReadMaterial(entry, loader));
    }
}

std::shared_ptr<const Material> ReadMaterialName(const YamlNode& node, const std::string& subject,
                                                 SceneLoader& loader)
{
    const std::optional<std::string> name = ReadString(node, subject, loader.diagnostics);
    const auto found = name ? loader.materials.find(*name) : loader.materials.end();
    if (found != loader.materials.end())
    {
        return found->second;
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

} // namespace limn
