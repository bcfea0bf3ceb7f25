#include <algorithm>
#include <array>
#include <limn/core/BuiltinShaders.h>
#include <limn/shaderlab/Case.h>

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
};

constexpr SolidColor k_SolidColors[] = {
    {"white", {255, 255, 255, 255}}, {"black", {0, 0, 0, 255}}, {"gray", {128, 128, 128, 128}},
    {"bump", {128, 128, 255, 128}},  {"red", {255, 0, 0, 255}}, {"green", {0, 255, 0, 255}},
    {"blue", {0, 0, 255, 255}},      {"clear", {0, 0, 0, 0}}};

std::shared_ptr<const Texture> SolidTexture(const SolidColor& color, TextureDimension dimension)
{
    constexpr GraphicsFormat format = GraphicsFormat::R8G8B8A8_UNorm;
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

std::vector<std::shared_ptr<const Texture>> SolidTextures()
{
    using enum TextureDimension;
    std::vector<std::shared_ptr<const Texture>> textures;
    for (const TextureDimension dimension : {Tex2D, Tex3D, Cube, Tex2DArray, CubeArray})
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
    std::string lower = ToLower(name);
    lower = lower == "normal" ? "bump" : lower;
    const auto isKnown = std::any_of(std::begin(k_SolidColors), std::end(k_SolidColors),
                                     [&](const SolidColor& color) { return color.name == lower; });
    const std::string known = isKnown ? lower : "gray";
    return *std::find_if(textures.begin(), textures.end(),
                         [&](const auto& texture)
                         { return texture->dimension() == dimension && texture->name() == known; });
}

} // namespace limn
