#include <limn/core/Texture.h>

#include "support/UniqueId.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limn/base/Diagnostic.h>
#include <limn/base/NumberText.h>
#include <utility>

namespace limn
{

namespace
{

std::string FaceSizeText(const TextureShape& shape)
{
    return std::to_string(shape.width) + "x" + std::to_string(shape.height);
}

TextureShape WithMips(TextureShape shape, bool mipChain)
{
    shape.mipCount = mipChain ? FullMipCount(shape) : 1;
    return shape;
}

/// A cube's six slices go without saying.
bool CountsSlices(TextureDimension dimension)
{
    return dimension != TextureDimension::Tex2D && dimension != TextureDimension::Cube;
}

std::string SizeText(const TextureShape& shape)
{
    const std::string slices =
        CountsSlices(shape.dimension) ? "x" + std::to_string(shape.slices) : "";
    return FaceSizeText(shape) + slices;
}

} // namespace

int FullMipCount(const TextureShape& shape)
{
    const int depth = shape.dimension == TextureDimension::Tex3D ? shape.slices : 1;
    const int size = std::max({shape.width, shape.height, depth, 1});
    return static_cast<int>(std::bit_width(static_cast<unsigned>(size)));
}

const char* ToString(TextureDimension dimension)
{
    constexpr const char* k_Names[] = {"2D", "3D", "Cube", "2DArray", "CubeArray"};
    return k_Names[static_cast<int>(dimension) - static_cast<int>(TextureDimension::Tex2D)];
}

Texture::Texture(std::string name, const TextureShape& shape, GraphicsFormat format,
                 SamplerState sampler)
    : m_Id(NextUniqueId()),
      m_Name(std::move(name)),
      m_Shape(shape),
      m_Format(format),
      m_Sampler(sampler)
{
    if (shape.width < 1 || shape.height < 1 || shape.slices < 1)
    {
        throw ContractError("texture '" + m_Name + "': the size is " + SizeText(shape) + "; " +
                            (CountsSlices(shape.dimension) ? "all" : "both") +
                            " must be at least 1");
    }
    if (format == GraphicsFormat::None)
    {
        throw ContractError("texture '" + m_Name +
                            "': the format is None; give the texture a format");
    }
    if (const std::string problem = GraphicsFormatProblem(format); !problem.empty())
    {
        throw ContractError("texture '" + m_Name + "': the format " + ToString(format) + " " +
                            problem);
    }
    if (shape.mipCount < 1 || shape.mipCount > FullMipCount(shape))
    {
        throw ContractError("texture '" + m_Name + "': it was given " +
                            std::to_string(shape.mipCount) + " mip levels; " + SizeText(shape) +
                            " can have 1 to " + std::to_string(FullMipCount(shape)));
    }
    if (sampler.anisoLevel < 1 || sampler.anisoLevel > 16 || !std::isfinite(sampler.mipMapBias))
    {
        throw ContractError("texture '" + m_Name + "': anisoLevel is " +
                            std::to_string(sampler.anisoLevel) + " and mipMapBias is " +
                            NumberText(static_cast<double>(sampler.mipMapBias)) +
                            "; the first must be from 1 to 16, the second must be finite");
    }
}

std::string Texture::DescribeSize() const
{
    const bool isFlat = dimension() == TextureDimension::Tex2D;
    return SizeText(m_Shape) + (isFlat ? "" : std::string(" ") + ToString(dimension()));
}

TexelTexture::TexelTexture(std::string name, const TextureShape& shape, GraphicsFormat format,
                           SamplerState sampler)
    : Texture(std::move(name), shape, format, sampler)
{
    if (IsDepthFormat(format))
    {
        throw ContractError("texture '" + this->name() + "': the format is " + ToString(format) +
                            "; only a RenderTexture can hold depth");
    }
}

void TexelTexture::Append(std::vector<std::byte> texels, int slices, const std::string& part)
{
    const int w = std::max(width() >> (m_LevelsOfTexels - 1), 1);
    const int h = std::max(height() >> (m_LevelsOfTexels - 1), 1);
    const std::size_t expected = static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
                                 static_cast<std::size_t>(slices) *
                                 static_cast<std::size_t>(BytesPerTexel(graphicsFormat()));
    if (texels.size() != expected)
    {
        const TextureShape whole{dimension(), w, h, slices};
        throw ContractError("texture '" + name() + "': " + part + "there are " +
                            std::to_string(texels.size()) + " bytes of texels; " +
                            (part.empty() ? SizeText(whole) : FaceSizeText(whole)) + " of " +
                            ToString(graphicsFormat()) + " takes " + std::to_string(expected));
    }
    if (m_Texels.empty())
    {
        m_Texels = std::move(texels);
    }
    else
    {
        m_Texels.insert(m_Texels.end(), texels.begin(), texels.end());
    }
}

Texture2D::Texture2D(std::string name, int width, int height, GraphicsFormat format,
                     std::vector<std::byte> texels, SamplerState sampler, bool mipChain)
    : TexelTexture(std::move(name), WithMips({TextureDimension::Tex2D, width, height}, mipChain),
                   format, sampler)
{
    Append(std::move(texels));
}

Texture3D::Texture3D(std::string name, int width, int height, int depth, GraphicsFormat format,
                     std::vector<std::byte> texels, SamplerState sampler, bool mipChain)
    : TexelTexture(std::move(name),
                   WithMips({TextureDimension::Tex3D, width, height, depth}, mipChain), format,
                   sampler)
{
    Append(std::move(texels), depth);
}

Texture2DArray::Texture2DArray(std::string name, int width, int height, GraphicsFormat format,
                               std::vector<std::vector<std::byte>> elements, SamplerState sampler,
                               bool mipChain)
    : TexelTexture(
          std::move(name),
          WithMips({TextureDimension::Tex2DArray, width, height, static_cast<int>(elements.size())},
                   mipChain),
          format, sampler)
{
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
        Append(std::move(elements[i]), 1, "element " + std::to_string(i) + ": ");
    }
}

void TexelTexture::AppendFaces(CubemapFaces faces, const std::string& part)
{
    static constexpr const char* k_Names[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        Append(std::move(faces[i]), 1, part + "face " + k_Names[i] + ": ");
    }
}

Cubemap::Cubemap(std::string name, int width, GraphicsFormat format, CubemapFaces faces,
                 SamplerState sampler, bool mipChain)
    : TexelTexture(std::move(name), WithMips({TextureDimension::Cube, width, width, 6}, mipChain),
                   format, sampler)
{
    AppendFaces(std::move(faces));
}

Cubemap::Cubemap(std::string name, int width, GraphicsFormat format,
                 std::vector<CubemapFaces> levels, SamplerState sampler)
    : TexelTexture(std::move(name),
                   {TextureDimension::Cube, width, width, 6, static_cast<int>(levels.size())},
                   format, sampler)
{
    AppendFaces(std::move(levels.front()));
    for (std::size_t i = 1; i < levels.size(); ++i)
    {
        BeginNextLevel();
        AppendFaces(std::move(levels[i]), "level " + std::to_string(i) + ", ");
    }
}

CubemapArray::CubemapArray(std::string name, int width, GraphicsFormat format,
                           std::vector<CubemapFaces> cubes, SamplerState sampler, bool mipChain)
    : TexelTexture(
          std::move(name),
          WithMips({TextureDimension::CubeArray, width, width, 6 * static_cast<int>(cubes.size())},
                   mipChain),
          format, sampler)
{
    for (std::size_t i = 0; i < cubes.size(); ++i)
    {
        AppendFaces(std::move(cubes[i]), "cube " + std::to_string(i) + ", ");
    }
}

} // namespace limn
