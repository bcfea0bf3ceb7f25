#include "scene/MaterialReader.h"

#include <array>
#include <fstream>
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
    switch (dimension)
    {
    case TextureDimension::Tex3D:
    case TextureDimension::Tex2DArray:
        return "{slices: [.png files]}";
    case TextureDimension::Cube:
        return "{faces: [six .png files, +X -X +Y -Y +Z -Z]}";
    case TextureDimension::CubeArray:
        return "{faces: [six .png files a cube, +X -X +Y -Y +Z -Z]}";
    case TextureDimension::Tex2D:
        break;
    }
    return "the path of a .png file";
}

bool BeginsAsPng(const std::filesystem::path& path)
{
    constexpr std::string_view k_Signature = "\x89PNG\r\n\x1A\n";
    std::array<char, k_Signature.size()> begin{};
    std::error_code error; // of a pipe the opening would wait
    return std::filesystem::is_regular_file(path, error) &&
           std::ifstream(path, std::ios::binary).read(begin.data(), begin.size()) &&
           std::string_view(begin.data(), begin.size()) == k_Signature;
}

std::shared_ptr<const Texture2D> ReadPicture(const YamlNode& node, const std::string& subject,
                                             References& references)
{
    return references.Read(node, subject,
                           [&references](const std::filesystem::path& path)
                           {
                               return references.decodesPictures || !BeginsAsPng(path)
                                          ? references.assets().LoadTexture(path)
                                          : std::dynamic_pointer_cast<const Texture2D>(
                                                DefaultTexture("white"));
                           });
}

/// Whether there can be that many; an error says it otherwise.
bool CheckCount(const YamlNode& list, const std::string& subject, TextureDimension dimension,
                AssetDiagnostics& diagnostics)
{
    const std::size_t count = list.items().size();
    const bool fits = dimension == TextureDimension::Cube        ? count == 6
                      : dimension == TextureDimension::CubeArray ? count > 0 && count % 6 == 0
                                                                 : count > 0;
    if (!fits)
    {
        const std::string found =
            list.isSequence() ? std::to_string(count) + " files" : list.Describe();
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

/// Whether the pictures are of one size and encoding, and square where they are faces; errors say
/// it otherwise.
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
        slices.push_back(ReadPicture(item, which, references));
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

} // namespace

void ReadTextureProperty(const ShaderProperty& property, const YamlNode& node,
                         const std::string& subject, Material& material, References& references,
                         AssetDiagnostics& diagnostics)
{
    const TextureDimension dimension = property.dimension;
    const bool isFlat = dimension == TextureDimension::Tex2D;
    std::shared_ptr<const Texture> texture = DefaultTexture(node.scalar(), dimension);
    if (isFlat && std::filesystem::path(node.scalar()).extension() == ".png")
    {
        texture = ReadPicture(node, subject, references);
    }
    else if (!isFlat && node.isMap())
    {
        texture = ReadSliced(node, subject, dimension, references, diagnostics);
    }
    else if (texture->name() != node.scalar())
    {
        std::string names;
        for (const std::string_view name : DefaultTextureNames())
        {
            names += (names.empty() ? "" : ", ") + std::string(name);
        }
        diagnostics.Error(node.location(), subject + ": found " + node.Describe() + "; " +
                                               ExpectedFor(dimension) + ", or one of " + names +
                                               " is expected");
        return;
    }
    if (texture)
    {
        material.SetTexture(ShaderPropertyId(property.name), std::move(texture));
    }
}

} // namespace limn
