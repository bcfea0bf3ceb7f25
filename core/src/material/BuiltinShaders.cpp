#include <algorithm>
#include <array>
#include <limn/base/Case.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/QualitySettings.h>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> BuiltinShaders();
}

namespace
{

struct SolidColor
{
    const char* name;
    std::array<std::uint8_t, 4> rgba;
    GraphicsFormat format = GraphicsFormat::R8G8B8A8_UNorm;
};

/// The alpha of bump, for which Unity's manual has a half, is one: UnpackNormal multiplies by it.
constexpr SolidColor k_SolidColors[] = {
    {"white", {255, 255, 255, 255}},
    {"black", {0, 0, 0, 255}},
    {"gray", {128, 128, 128, 128}, GraphicsFormat::R8G8B8A8_SRGB},
    {"linearGray", {128, 128, 128, 128}},
    {"bump", {128, 128, 255, 255}},
    {"red", {255, 0, 0, 255}},
    {"green", {0, 255, 0, 255}},
    {"blue", {0, 0, 255, 255}},
    {"clear", {0, 0, 0, 0}}};

constexpr std::array k_Dimensions = {TextureDimension::Tex2D, TextureDimension::Tex3D,
                                     TextureDimension::Cube, TextureDimension::Tex2DArray,
                                     TextureDimension::CubeArray};

std::shared_ptr<const Texture> SolidTexture(const SolidColor& color, TextureDimension dimension)
{
    const GraphicsFormat format = color.format;
    std::vector<std::byte> texel;
    for (const std::uint8_t channel : color.rgba)
    {
        texel.push_back(std::byte{channel});
    }
    const CubemapFaces faces{texel, texel, texel, texel, texel, texel};
    switch (dimension)
    {
    case TextureDimension::Tex3D:
        return std::make_shared<const Texture3D>(color.name, 1, 1, 1, format, texel);
    case TextureDimension::Cube:
        return std::make_shared<const Cubemap>(color.name, 1, format, faces);
    case TextureDimension::Tex2DArray:
        return std::make_shared<const Texture2DArray>(color.name, 1, 1, format,
                                                      std::vector<std::vector<std::byte>>{texel});
    case TextureDimension::CubeArray:
        return std::make_shared<const CubemapArray>(color.name, 1, format,
                                                    std::vector<CubemapFaces>{faces});
    case TextureDimension::Tex2D:
        break;
    }
    return std::make_shared<const Texture2D>(color.name, 1, 1, format, texel);
}

/// Returns the textures of one colour, ordered by dimension and then by colour.
std::vector<std::shared_ptr<const Texture>> SolidTextures()
{
    std::vector<std::shared_ptr<const Texture>> textures;
    for (const TextureDimension dimension : k_Dimensions)
    {
        for (const SolidColor& color : k_SolidColors)
        {
            textures.push_back(SolidTexture(color, dimension));
        }
    }
    return textures;
}

} // namespace

const ShaderDatabase& BuiltinShaders()
{
    static const ShaderDatabase shaders = []
    {
        ShaderDatabase database;
        database.Add(embedded::BuiltinShaders());
        return database;
    }();
    return shaders;
}

std::vector<std::string_view> DefaultTextureNames()
{
    std::vector<std::string_view> names;
    std::ranges::transform(k_SolidColors, std::back_inserter(names), &SolidColor::name);
    return names;
}

std::shared_ptr<const Texture> DefaultTexture(std::string_view name, TextureDimension dimension)
{
    static const std::vector<std::shared_ptr<const Texture>> textures = SolidTextures();
    const auto place = [&](std::string_view known)
    {
        return std::ranges::find_if(k_SolidColors, [&](const SolidColor& color)
                                    { return EqualsIgnoringCase(color.name, known); }) -
               std::begin(k_SolidColors);
    };
    const std::ptrdiff_t count = std::ssize(k_SolidColors);
    const std::ptrdiff_t found = place(EqualsIgnoringCase(name, "normal")       ? "bump"
                                       : EqualsIgnoringCase(name, "linearGrey") ? "linearGray"
                                                                                : name);
    // Shaders read the same number in gamma space, where no texel is decoded.
    const bool isGamma = QualitySettings::activeColorSpace() == ColorSpace::Gamma;
    const std::ptrdiff_t gray = place(isGamma ? "linearGray" : "gray");
    const std::ptrdiff_t color = found < count && found != place("gray") ? found : gray;
    const std::ptrdiff_t row = std::ranges::find(k_Dimensions, dimension) - k_Dimensions.begin();
    return textures.at(static_cast<std::size_t>(row * count + color));
}

} // namespace limn
