#include "unity/TextureImporter.h"

#include "assets/CubePicture.h"
#include "assets/PictureFile.h"
#include "assets/PictureSettings.h"
#include "unity/UnityTree.h"

#include <algorithm>
#include <limn/base/ByteStream.h>
#include <limn/core/QualitySettings.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

struct TextureImport
{
    bool mipChain = true;
    PictureSettings picture;
    CubeMapping cube = CubeMapping::None;
    SamplerState sampler;
};

constexpr int k_NormalMap = 1; ///< a textureType
constexpr int k_Cube = 2;      ///< a textureShape
constexpr int k_LargestTexture = 16384;
constexpr float k_NoMipBias = -100.0f; ///< Unity writes it where there is none

/// A number of which -1 says that there is none.
template <typename Value>
void ReadSetting(YamlMapReader& map, std::string_view key, int last, Value& value)
{
    int number = -1;
    if (map.Read(key, number, {-1.0, static_cast<double>(last)}) && number >= 0)
    {
        value = static_cast<Value>(number);
    }
}

void ReadSampler(const YamlNode& node, const std::string& subject, SamplerState& sampler,
                 AssetDiagnostics& diagnostics)
{
    constexpr int k_LastWrapMode = static_cast<int>(TextureWrapMode::MirrorOnce);
    YamlMapReader map(node, subject, diagnostics);
    ReadSetting(map, "filterMode", static_cast<int>(FilterMode::Trilinear), sampler.filterMode);
    ReadSetting(map, "wrapMode", k_LastWrapMode, sampler.wrapModeU); // of all, until Unity 2017
    sampler.wrapModeV = sampler.wrapModeW = sampler.wrapModeU;
    ReadSetting(map, "wrapU", k_LastWrapMode, sampler.wrapModeU);
    ReadSetting(map, "wrapV", k_LastWrapMode, sampler.wrapModeV);
    ReadSetting(map, "wrapW", k_LastWrapMode, sampler.wrapModeW);
    ReadSetting(map, "aniso", 16, sampler.anisoLevel);
    sampler.anisoLevel = std::max(sampler.anisoLevel, 1); // 0 is off
    float bias = k_NoMipBias;
    map.Read("mipBias", bias, {k_NoMipBias, -k_NoMipBias});
    sampler.mipMapBias = bias == k_NoMipBias ? 0.0f : bias;
}

/// Later blocks win: that of the default platform comes first.
void ReadMaxSize(YamlMapReader& importer, AssetDiagnostics& diagnostics, int& size)
{
    const auto read = [&](YamlMapReader& map, int& value)
    {
        map.Read("maxTextureSize", value, {1.0, static_cast<double>(k_LargestTexture)});
    };
    size = 2048;
    read(importer, size);
    const YamlNode* platforms = importer.Find("platformSettings");
    if (platforms == nullptr || !platforms->isSequence())
    {
        return;
    }
    for (const YamlNode& node : platforms->items())
    {
        YamlMapReader map(node, importer.SubjectOf("platformSettings"), diagnostics);
        std::string target;
        bool isOverridden = false;
        map.Read("buildTarget", target);
        map.Read("overridden", isOverridden);
        if (target == "DefaultTexturePlatform" || (target == "Standalone" && isOverridden))
        {
            read(map, size);
        }
    }
}

void ReadPictureSettings(YamlMapReader& map, AssetDiagnostics& diagnostics,
                         PictureSettings& settings)
{
    int textureType = 0;
    map.Read("textureType", textureType);
    settings.isNormalMap = textureType == k_NormalMap;
    map.Read("flipGreenChannel", settings.flipGreenChannel);
    if (const YamlNode* node = map.Find("bumpmap"))
    {
        YamlMapReader bumps(*node, map.SubjectOf("bumpmap"), diagnostics);
        bumps.Read("convertToNormalMap", settings.convertToNormalMap);
        bumps.Read("heightScale", settings.heightScale, {0.0, 1.0});
        bumps.Read("flipGreenChannel", settings.flipGreenChannel);
    }
    ReadSetting(map, "alphaUsage", static_cast<int>(PictureAlpha::FromGrayScale), settings.alpha);
    // Four bytes, that of red the lowest.
    std::uint32_t swizzle = 0x03020100;
    map.Read("swizzle", swizzle);
    for (PictureSwizzle& channel : settings.swizzle)
    {
        const std::uint32_t source = swizzle & 0xff;
        if (source <= static_cast<std::uint32_t>(PictureSwizzle::One))
        {
            channel = static_cast<PictureSwizzle>(source);
        }
        swizzle >>= 8;
    }
    ReadMaxSize(map, diagnostics, settings.maxTextureSize);
}

CubeMapping ReadCubeMapping(YamlMapReader& map)
{
    int shape = 0;
    map.Read("textureShape", shape);
    CubeMapping mapping = CubeMapping::AutoCubemap;
    ReadSetting(map, "generateCubemap", static_cast<int>(CubeMapping::AutoCubemap), mapping);
    const bool isOld = mapping != CubeMapping::Cylindrical && mapping != CubeMapping::FullCubemap &&
                       mapping != CubeMapping::AutoCubemap;
    return shape != k_Cube ? CubeMapping::None : isOld ? CubeMapping::Spheremap : mapping;
}

/// Reads the settings that limn uses. There are dozens of other keys.
TextureImport ReadTextureImport(const YamlNode& meta, const std::filesystem::path& metaFile)
{
    TextureImport import;
    AssetDiagnostics diagnostics(metaFile.generic_string());
    YamlMapReader file(meta, ".meta", diagnostics);
    const YamlNode* importer = file.Find("TextureImporter");
    YamlMapReader map(importer ? *importer : YamlNode(), "TextureImporter", diagnostics);
    if (const YamlNode* node = map.Find("mipmaps"))
    {
        YamlMapReader mipmaps(*node, map.SubjectOf("mipmaps"), diagnostics);
        mipmaps.Read("enableMipMap", import.mipChain);
        mipmaps.Read("sRGBTexture", import.picture.sRGB);
    }
    if (const YamlNode* node = map.Find("textureSettings"))
    {
        ReadSampler(*node, map.SubjectOf("textureSettings"), import.sampler, diagnostics);
    }
    if (importer != nullptr)
    {
        ReadPictureSettings(map, diagnostics, import.picture);
        import.cube = ReadCubeMapping(map);
    }
    diagnostics.ThrowIfErrors();
    return import;
}

/// Returns the settings for the colour space of the process: in gamma nothing is decoded.
TextureImport InActiveSpace(TextureImport import)
{
    import.picture.sRGB =
        import.picture.sRGB && QualitySettings::activeColorSpace() == ColorSpace::Linear;
    return import;
}

YamlNode ToYamlNode(const UnityNode& node)
{
    YamlContent content;
    content.location = {node.line(), 1};
    if (node.isMap())
    {
        content.kind = YamlKind::Map;
        for (const UnityNode entry : node)
        {
            content.entries.push_back(
                {std::string(entry.key()), {entry.line(), 1}, ToYamlNode(entry)});
        }
    }
    else if (node.isList())
    {
        content.kind = YamlKind::Sequence;
        for (const UnityNode item : node)
        {
            content.items.push_back(ToYamlNode(item));
        }
    }
    else if (!node.text().empty())
    {
        content.kind = YamlKind::Scalar;
        content.scalar = node.text();
    }
    return YamlNode(std::move(content));
}

TextureImport LoadTextureImport(const std::filesystem::path& metaFile)
{
    std::error_code ignored;
    if (!std::filesystem::exists(metaFile, ignored))
    {
        return {};
    }
    const std::string text = ReadYamlText(metaFile);
    try
    {
        // The reader of all of YAML takes 25 ms for thirty of them, a third of a scene's loading.
        const UnityTree tree(text, metaFile.generic_string(), 1);
        return ReadTextureImport(ToYamlNode(tree.root()), metaFile);
    }
    catch (const AssetError&)
    {
        // Somebody wrote into it. The reader of all of YAML understands more and says more.
        return ReadTextureImport(ParseYaml(text, metaFile.generic_string()).front(), metaFile);
    }
}

/// The settings as they go to a worker.
void TransferSettings(auto& stream, auto& settings, auto& cube)
{
    stream.Value(cube);
    stream.Values(settings.sRGB, settings.alpha, settings.isNormalMap, settings.flipGreenChannel,
                  settings.convertToNormalMap, settings.heightScale, settings.maxTextureSize);
    for (auto& channel : settings.swizzle)
    {
        stream.Value(channel);
    }
}

/// The picture as it comes back, and is kept.
void TransferImage(auto& stream, auto& image)
{
    stream.Values(image.width, image.height, image.format);
    stream.Array(image.texels);
}

Image FacesOf(Image picture, CubeMapping mapping, const std::filesystem::path& path)
{
    const std::string size = std::to_string(picture.width) + "x" + std::to_string(picture.height);
    std::optional<Image> faces = CutCube(std::move(picture), mapping);
    if (!faces)
    {
        throw AssetError(path.generic_string(), {},
                         "it is to be a cube, and its " + size +
                             " texels are a mirroring ball or too few for six faces; limn reads "
                             "pictures twice as wide as high (longitude and latitude), 4:3 or 3:4 "
                             "(a cross), and 6:1 or 1:6 (a strip)");
    }
    return *std::move(faces);
}

std::string ImportPicture(const ImportedFile& file)
{
    std::string ending;
    PictureSettings settings;
    CubeMapping cube = CubeMapping::None;
    ByteReader reader(file.settings);
    reader.Value(ending);
    TransferSettings(reader, settings, cube);
    Image image = DecodePicture(file.path, file.bytes);
    if (cube == CubeMapping::None)
    {
        image = ApplyPictureSettings(std::move(image), settings);
        image.texels = FlipRows(image.texels, image.height);
    }
    else
    {
        settings.maxTextureSize *= FacesAlong(image, cube);
        image = FacesOf(ApplyPictureSettings(std::move(image), settings), cube, file.path);
    }
    ByteWriter writer;
    TransferImage(writer, image);
    return writer.bytes();
}

constexpr ImportKind k_Picture{"picture", "picture 2", ImportInWorker<ImportPicture>};

Image Import(const std::filesystem::path& path, const TextureImport& import,
             const Importer& importer)
{
    ByteWriter settings;
    settings.Value(path.extension().string()); // it tells how the bytes are read
    TransferSettings(settings, import.picture, import.cube);
    const FileCache::Entry entry =
        importer.Import(k_Picture, path, settings.bytes(), ReadForImport(k_Picture, path));
    Image image;
    ByteReader reader(entry.payload());
    TransferImage(reader, image);
    return image;
}

} // namespace

std::filesystem::path MetaFileOf(const std::filesystem::path& texture)
{
    return texture.string() + ".meta";
}

std::shared_ptr<const Texture2D> ImportTexture(const std::filesystem::path& path,
                                               const Importer& importer)
{
    TextureImport import = InActiveSpace(LoadTextureImport(MetaFileOf(path)));
    import.cube = CubeMapping::None;
    Image image = Import(path, import, importer);
    return std::make_shared<const Texture2D>(path.filename().string(), image.width, image.height,
                                             image.format, std::move(image.texels), import.sampler,
                                             import.mipChain);
}

std::shared_ptr<const Cubemap> ImportCubemap(const std::filesystem::path& path,
                                             const Importer& importer)
{
    const TextureImport import = InActiveSpace(LoadTextureImport(MetaFileOf(path)));
    if (import.cube == CubeMapping::None)
    {
        ReadForImport(k_Picture, path); // a file that is not there is no other kind of picture
        return nullptr;
    }
    const Image image = Import(path, import, importer);
    CubemapFaces faces;
    const std::size_t bytes = image.texels.size() / faces.size();
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        const std::byte* const first = image.texels.data() + i * bytes;
        faces[i].assign(first, first + bytes);
    }
    return std::make_shared<const Cubemap>(path.filename().string(), image.width, image.format,
                                           std::move(faces), import.sampler, import.mipChain);
}

} // namespace limn
