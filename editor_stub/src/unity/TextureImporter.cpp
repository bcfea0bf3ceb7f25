#include "unity/TextureImporter.h"

#include "assets/PictureFile.h"

#include <algorithm>
#include <limn/core/Image.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

struct TextureImport
{
    bool mipChain = true;
    bool sRGB = true;
    bool isNormalMap = false;
    bool flipGreenChannel = false; ///< of a normal map
    SamplerState sampler;
};

constexpr int k_NormalMap = 1;         ///< a textureType
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

/// Of other keys there are dozens, about what limn does without.
TextureImport ReadTextureImport(const std::filesystem::path& metaFile)
{
    TextureImport import;
    std::error_code ignored;
    if (!std::filesystem::exists(metaFile, ignored))
    {
        return import;
    }
    const std::vector<YamlNode> documents = LoadYamlFile(metaFile);
    AssetDiagnostics diagnostics(metaFile.generic_string());
    YamlMapReader file(documents.front(), ".meta", diagnostics);
    const YamlNode* importer = file.Find("TextureImporter");
    YamlMapReader map(importer ? *importer : YamlNode(), "TextureImporter", diagnostics);
    if (const YamlNode* node = map.Find("mipmaps"))
    {
        YamlMapReader mipmaps(*node, map.SubjectOf("mipmaps"), diagnostics);
        mipmaps.Read("enableMipMap", import.mipChain);
        mipmaps.Read("sRGBTexture", import.sRGB);
    }
    if (const YamlNode* node = map.Find("textureSettings"))
    {
        ReadSampler(*node, map.SubjectOf("textureSettings"), import.sampler, diagnostics);
    }
    int textureType = 0;
    map.Read("textureType", textureType);
    map.Read("flipGreenChannel", import.flipGreenChannel);
    import.isNormalMap = textureType == k_NormalMap;
    import.sRGB = import.sRGB && !import.isNormalMap;
    diagnostics.ThrowIfErrors();
    return import;
}

/// A normal is in red and green. Its alpha is 1 whatever the file has there, as shaders multiply by
/// it: of Unity's own packing, alpha and green are what counts.
void MakeNormals(std::vector<std::byte>& texels, bool flipsGreen)
{
    for (std::size_t i = 0; i + 3 < texels.size(); i += 4)
    {
        texels[i + 1] = flipsGreen ? ~texels[i + 1] : texels[i + 1];
        texels[i + 3] = std::byte{255};
    }
}

} // namespace

std::filesystem::path MetaFileOf(const std::filesystem::path& texture)
{
    return texture.string() + ".meta";
}

std::shared_ptr<const Texture2D> ImportTexture(const std::filesystem::path& path)
{
    const TextureImport import = ReadTextureImport(MetaFileOf(path));
    const Image image = ReadPicture(path);
    const GraphicsFormat format = import.sRGB ? image.format : GraphicsFormat::R8G8B8A8_UNorm;
    std::vector<std::byte> texels = FlipRows(image.texels, image.height);
    if (import.isNormalMap)
    {
        MakeNormals(texels, import.flipGreenChannel);
    }
    return std::make_shared<const Texture2D>(path.filename().string(), image.width, image.height,
                                             format, std::move(texels), import.sampler,
                                             import.mipChain);
}

} // namespace limn
