#include "assets/PictureFile.h"
#include "console/Texts.h"
#include "scene/Loader.h"
#include "shaders/KeywordsOfValues.h"
#include "shaders/UsedShaders.h"

#include <algorithm>
#include <limn/base/NumberText.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/Image.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

/// Pictures of one size that make a texture together, sampled as the first one's .meta file says.
using Slices = std::vector<std::shared_ptr<const Texture2D>>;

bool isCube(TextureDimension dimension)
{
    return dimension == TextureDimension::Cube || dimension == TextureDimension::CubeArray;
}

std::string ExpectedFor(TextureDimension dimension)
{
    return dimension == TextureDimension::Tex2D ? "the path of a .png file"
           : dimension == TextureDimension::Cube
               ? "a picture that its .meta file makes a cube, {faces: [six .png files, +X -X +Y -Y "
                 "+Z -Z]}"
           : dimension == TextureDimension::CubeArray
               ? "{faces: [six .png files a cube, +X -X +Y -Y +Z -Z]}"
               : "{slices: [.png files]}";
}

/// Returns whether this number is possible. If not, an error is added.
bool CheckCount(const YamlNode& list, const std::string& subject, TextureDimension dimension,
                AssetDiagnostics& diagnostics)
{
    const std::size_t count = list.items().size();
    const bool fits = dimension == TextureDimension::Cube        ? count == 6
                      : dimension == TextureDimension::CubeArray ? count > 0 && count % 6 == 0
                                                                 : count > 0;
    if (!fits)
    {
        const std::string found = list.isSequence() ? CountText(count, "file") : list.Describe();
        diagnostics.Error(list.location(), subject + ": found " + found + "; " +
                                               ExpectedFor(dimension) + " is expected");
    }
    return fits;
}

/// Returns whether the pictures fit into the memory that a texture may take; adds an error if they
/// do not. The reader calls it before it decodes the first one: a small file may hold a gigabyte.
bool CheckBytes(const YamlNode& list, const std::string& subject, const References& references,
                AssetDiagnostics& diagnostics)
{
    constexpr std::uintmax_t k_Most = std::uintmax_t{2} << 30; // Unity's limit of a texture
    std::uintmax_t bytes = 0;
    for (const YamlNode& item : list.items())
    {
        bytes += PngTexelBytes(references.Resolve(item.scalar()));
    }
    if (bytes > k_Most)
    {
        diagnostics.Error(list.location(),
                          subject + ": its " + std::to_string(list.items().size()) +
                              " pictures take " + std::to_string(bytes >> 20) +
                              " MiB; a texture may take " + std::to_string(k_Most >> 20) + " MiB");
    }
    return bytes <= k_Most;
}

/// Returns whether the pictures have one size and encoding, and are square if they are faces. If
/// not, errors are added.
bool CheckSlices(const Slices& slices, const YamlNode& list, const std::string& subject,
                 bool square, AssetDiagnostics& diagnostics)
{
    const Texture2D& first = *slices.front();
    if (square && first.width() != first.height())
    {
        diagnostics.Error(list.items()[0].location(), subject + "[0]: '" + first.name() + "' is " +
                                                          first.DescribeSize() +
                                                          "; a face must be square");
        return false;
    }
    bool fits = true;
    for (std::size_t i = 1; i < slices.size(); ++i)
    {
        const Texture2D& slice = *slices[i];
        const auto expect = [&](bool is, const std::string& found, const std::string& expected)
        {
            if (!is)
            {
                diagnostics.Error(list.items()[i].location(),
                                  subject + "[" + std::to_string(i) + "]: '" + slice.name() +
                                      "' is " + found + "; it must be " + expected + " as '" +
                                      first.name() + "' is");
            }
            fits = fits && is;
        };
        expect(slice.width() == first.width() && slice.height() == first.height(),
               slice.DescribeSize(), first.DescribeSize());
        const auto encoding = [](const Texture2D& texture)
        {
            return IsSRGBFormat(texture.graphicsFormat()) ? "sRGB" : "linear";
        };
        expect(slice.graphicsFormat() == first.graphicsFormat(), encoding(slice), encoding(first));
    }
    return fits;
}

/// The pictures of a list; empty, with an error, if they do not make such a texture.
Slices ReadSlices(const YamlNode& list, const std::string& subject, TextureDimension dimension,
                  References& references, AssetDiagnostics& diagnostics)
{
    if (!CheckCount(list, subject, dimension, diagnostics) ||
        !CheckBytes(list, subject, references, diagnostics))
    {
        return {};
    }
    Slices slices;
    bool fits = true;
    for (const YamlNode& item : list.items())
    {
        const std::string which = subject + "[" + std::to_string(slices.size()) + "]";
        slices.push_back(references.ReadPicture(item, which));
        fits = fits && slices.back();
    }
    fits = fits && CheckSlices(slices, list, subject, isCube(dimension), diagnostics);
    return fits ? slices : Slices();
}

/// The cube that begins at a slice; a cube's rows go in from the top, a picture's from the bottom.
CubemapFaces FacesFrom(const Slices& slices, std::size_t first)
{
    CubemapFaces faces;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        const Texture2D& slice = *slices[first + i];
        faces[i] = FlipRows(slice.texels(), slice.height());
    }
    return faces;
}

std::shared_ptr<const Texture> MakeCubes(const Slices& slices, TextureDimension dimension)
{
    const Texture2D& first = *slices.front();
    if (dimension == TextureDimension::Cube)
    {
        return std::make_shared<const Cubemap>(first.name(), first.width(), first.graphicsFormat(),
                                               FacesFrom(slices, 0), first.sampler());
    }
    std::vector<CubemapFaces> cubes;
    for (std::size_t i = 0; i < slices.size(); i += 6)
    {
        cubes.push_back(FacesFrom(slices, i));
    }
    return std::make_shared<const CubemapArray>(first.name(), first.width(), first.graphicsFormat(),
                                                std::move(cubes), first.sampler());
}

std::shared_ptr<const Texture> MakeStack(const Slices& slices, TextureDimension dimension)
{
    const Texture2D& first = *slices.front();
    if (dimension == TextureDimension::Tex3D)
    {
        std::vector<std::byte> texels;
        for (const std::shared_ptr<const Texture2D>& slice : slices)
        {
            texels.insert(texels.end(), slice->texels().begin(), slice->texels().end());
        }
        return std::make_shared<const Texture3D>(
            first.name(), first.width(), first.height(), static_cast<int>(slices.size()),
            first.graphicsFormat(), std::move(texels), first.sampler());
    }
    std::vector<std::vector<std::byte>> elements;
    for (const std::shared_ptr<const Texture2D>& slice : slices)
    {
        elements.push_back(slice->texels());
    }
    return std::make_shared<const Texture2DArray>(first.name(), first.width(), first.height(),
                                                  first.graphicsFormat(), std::move(elements),
                                                  first.sampler());
}

/// The texture of a map with a list of pictures; null, with an error, if it makes none.
std::shared_ptr<const Texture> ReadSliced(const YamlNode& node, const std::string& subject,
                                          TextureDimension dimension, References& references,
                                          AssetDiagnostics& diagnostics)
{
    const std::string key = isCube(dimension) ? "faces" : "slices";
    YamlMapReader map(node, subject, diagnostics);
    const YamlNode* list = map.Require(key);
    map.Finish();
    const Slices slices =
        list ? ReadSlices(*list, map.SubjectOf(key), dimension, references, diagnostics) : Slices();
    if (slices.empty())
    {
        return nullptr;
    }
    return isCube(dimension) ? MakeCubes(slices, dimension) : MakeStack(slices, dimension);
}

/// Sets a material's texture property to the value in a file. The value is the name of a default
/// texture; for a 2D property a .png file; for a 3D one or an array {slices: [.png files]}; for a
/// cube or an array of cubes {faces: [.png files]}, six for each cube in the order +X -X +Y -Y +Z
/// -Z, each as seen from the centre. A wrong value adds an error at its place, and the property
/// stays as it was.
void ReadTextureProperty(const ShaderProperty& property, const YamlNode& node,
                         const std::string& subject, Material& material, References& references,
                         AssetDiagnostics& diagnostics)
{
    const TextureDimension dimension = property.dimension;
    const bool isFlat = dimension == TextureDimension::Tex2D;
    std::shared_ptr<const Texture> texture = DefaultTexture(node.scalar(), dimension);
    bool isExpected = true;
    if (isFlat && std::filesystem::path(node.scalar()).extension() == ".png")
    {
        texture = references.ReadPicture(node, subject);
    }
    else if (dimension == TextureDimension::Cube && IsPictureFile(node.scalar()))
    {
        texture = references.Read(node, subject,
                                  [&](const std::filesystem::path& path)
                                  {
                                      auto cube = references.assets().LoadCubemap(path);
                                      isExpected = cube != nullptr;
                                      return cube;
                                  });
    }
    else if (!isFlat && node.isMap())
    {
        texture = ReadSliced(node, subject, dimension, references, diagnostics);
    }
    else
    {
        isExpected = texture->name() == node.scalar();
    }
    if (!isExpected)
    {
        diagnostics.Error(node.location(), subject + ": found " + node.Describe() + "; " +
                                               ExpectedFor(dimension) + ", or one of " +
                                               Joined(DefaultTextureNames(), ", ") +
                                               " is expected");
        return;
    }
    if (texture)
    {
        material.SetTexture(ShaderPropertyId(property.name), std::move(texture));
    }
}

void ReadProperty(const ShaderProperty& property, YamlMapReader& map, Material& material,
                  References& references, AssetDiagnostics& diagnostics)
{
    const YamlNode* node = map.Find(property.name);
    if (!node)
    {
        return;
    }
    const std::string subject = map.SubjectOf(property.name);
    const ShaderPropertyId id(property.name);
    const ValueRange range = property.type == ShaderPropertyType::Range
                                 ? ValueRange{property.rangeMin, property.rangeMax}
                                 : ValueRange{};
    switch (property.type)
    {
    case ShaderPropertyType::Color:
        material.SetColor(
            id, ReadColor(*node, subject, diagnostics, k_ColorChannels).value_or(Color{}));
        break;
    case ShaderPropertyType::Vector:
        material.SetVector(id,
                           ReadVector(*node, 4, subject, diagnostics).value_or(glm::vec4(0.0f)));
        break;
    case ShaderPropertyType::Texture:
        ReadTextureProperty(property, *node, subject, material, references, diagnostics);
        break;
    case ShaderPropertyType::Integer:
        material.SetInt(id, ReadInt(*node, subject, diagnostics).value_or(0));
        break;
    case ShaderPropertyType::Float:
    case ShaderPropertyType::Range:
    case ShaderPropertyType::Int:
        material.SetFloat(id, ReadFloat(*node, subject, diagnostics, range).value_or(0.0f));
        break;
    }
}

/// Returns a material as scenes and material files write it, {shader: ..., _BaseColor: ...}.
/// Returns null and adds an error if the shader cannot be used, since its properties are then
/// unknown.
std::shared_ptr<const Material> ReadMaterial(const std::string& name, const YamlNode& node,
                                             References& references, AssetDiagnostics& diagnostics)
{
    YamlMapReader map(node, "material '" + name + "'", diagnostics, "property");
    const YamlNode* shaderNode = map.Find("shader");
    const std::shared_ptr<const Shader> shader =
        shaderNode ? references.ReadShader(*shaderNode, map.SubjectOf("shader"))
                   : references.assets().FindShader(k_DefaultShader);
    if (!shader)
    {
        return nullptr;
    }
    if (const std::string builtIn = BuiltInPassOf(*shader); !builtIn.empty())
    {
        diagnostics.Note(shaderNode->location(),
                         map.SubjectOf("shader") + ": " + builtIn +
                             ", so only features can draw the objects that have it");
    }
    auto material = std::make_shared<Material>(shader, name);
    int queue = -1;
    if (map.Read("renderQueue", queue, k_RenderQueues))
    {
        material->SetRenderQueue(queue);
    }
    for (const ShaderProperty& property : shader->document().properties)
    {
        ReadProperty(property, map, *material, references, diagnostics);
    }
    SetKeywordsOfValues(*material);
    map.Finish();
    return material;
}

/// Returns a material that the scene writes, or that of the .material.yaml file that it names.
std::shared_ptr<const Material> ReadSceneMaterial(const std::string& name, const YamlNode& node,
                                                  SceneLoader& loader)
{
    References& references = loader.references;
    if (node.isScalar() && node.scalar().ends_with(".material.yaml"))
    {
        return references.Read(node, "material '" + name + "'",
                               [&references](const std::filesystem::path& path)
                               { return references.assets().LoadMaterial(path); });
    }
    return ReadMaterial(name, node, references, loader.diagnostics);
}

} // namespace

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
                                     "{_BaseColor: \"#a9743f\"}, oak: oak.material.yaml}");
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
            ReadSceneMaterial(name, *material.node, loader);
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
        loader.diagnostics.Error(
            node.location(),
            subject + ": unknown material " +
                UnknownName(*name, NamesOf(loader.materials,
                                           &decltype(loader.materials)::value_type::first)));
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
        found->material = ReadSceneMaterial(node.scalar(), *found->node, loader);
    }
    return found->material;
}

} // namespace limn
