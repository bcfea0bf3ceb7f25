#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limn/core/GraphicsFormat.h>
#include <limn/shaderlab/ShaderProgram.h>
#include <string>
#include <vector>

namespace limn
{

/// Describes how a shader reads a texture.
struct SamplerState
{
    FilterMode filterMode = FilterMode::Bilinear;
    TextureWrapMode wrapModeU = TextureWrapMode::Repeat;
    TextureWrapMode wrapModeV = TextureWrapMode::Repeat;
    TextureWrapMode wrapModeW = TextureWrapMode::Repeat; ///< for 3D textures
    /// If true, samples compare depths, and depths pass that are as near as the texel or nearer.
    bool comparison = false;
    bool standardZ = false; ///< of the comparison: 0 is near
    /// The number of samples along the direction in which a surface is seen flat: 1 ... 16, where 1
    /// = one only. It is one on devices that do not support more. Unity: Texture.anisoLevel.
    int anisoLevel = 1;
    float mipMapBias = 0.0f; ///< added to the mip level. Unity: Texture.mipMapBias

    auto operator<=>(const SamplerState&) const = default;
};

/// The size of a texture. `slices` is the depth of a 3D texture, the number of elements of an
/// array, six for each cube, else 1.
struct TextureShape
{
    TextureDimension dimension = TextureDimension::Tex2D;
    int width = 0;  ///< texels
    int height = 0; ///< texels
    int slices = 1;
    /// The number of levels, each half as wide and high as the one before, but at least a texel.
    int mipCount = 1;
};

/// Returns the number of levels down to 1x1 (and 1 slice of a 3D texture).
int FullMipCount(const TextureShape& shape);

/// Returns ShaderLab's spelling: "2D", "3D", "Cube", "2DArray", "CubeArray".
const char* ToString(TextureDimension dimension);

/// Something that a shader can sample. An object of this type is a description: the device makes
/// the image when a frame first uses it, and frees it some frames after the last owner is gone.
/// Unity: UnityEngine.Texture.
class Texture
{
public:
    virtual ~Texture() = default;
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    /// Returns a number that is unique in the process and never used again.
    std::uint64_t id() const { return m_Id; }
    const std::string& name() const { return m_Name; }
    TextureDimension dimension() const { return m_Shape.dimension; }
    int width() const { return m_Shape.width; }
    int height() const { return m_Shape.height; }
    int slices() const { return m_Shape.slices; } ///< see TextureShape
    int mipmapCount() const { return m_Shape.mipCount; }
    /// Returns the size for messages: "256x256", "32x32x16 3D", "64x64 Cube", "64x64x8 2DArray",
    /// "64x64x12 CubeArray"
    std::string DescribeSize() const;
    GraphicsFormat graphicsFormat() const { return m_Format; }
    const SamplerState& sampler() const { return m_Sampler; }

protected:
    Texture(std::string name, const TextureShape& shape, GraphicsFormat format,
            SamplerState sampler);

private:
    std::uint64_t m_Id;
    std::string m_Name;
    TextureShape m_Shape;
    GraphicsFormat m_Format;
    SamplerState m_Sampler;
};

/// The texels of a cube's faces in the order +X -X +Y -Y +Z -Z, that of Unity's CubemapFace, each
/// upright as seen from the centre: the top row first, and in it the left texel. Up and right are
///
///     face    +X   -X   +Y   -Y   +Z   -Z
///     up      +Y   +Y   -Z   +Z   +Y   +Y
///     right   -Z   +Z   +X   +X   +X   -X
///
/// in limn's left-handed axes, which is how Unity, Direct3D and Vulkan look a direction up.
using CubemapFaces = std::array<std::vector<std::byte>, 6>;

/// A texture whose texels come from the CPU: those of mip level 0, or of all levels. If only level
/// 0 is given and there are more, the device makes each from the one before when it uploads them,
/// with its linear filter: for an even size the mean of 2x2 (sRGB is averaged in linear space).
class TexelTexture : public Texture
{
public:
    /// Returns the texels level by level, and slice by slice; in each, rows of texels, tightly
    /// packed.
    const std::vector<std::byte>& texels() const { return m_Texels; }
    /// Returns how many levels texels() has: 1 or mipmapCount().
    int levelsOfTexels() const { return m_LevelsOfTexels; }

protected:
    TexelTexture(std::string name, const TextureShape& shape, GraphicsFormat format,
                 SamplerState sampler);

    /// Appends texels. @param slices  the number of slices that they make
    /// @param part  for messages: "face +X: ", or nothing for all of the texture
    /// @throws ContractError naming the texture, if the number of bytes is not exactly the one
    ///     needed
    void Append(std::vector<std::byte> texels, int slices = 1, const std::string& part = {});
    void AppendFaces(CubemapFaces faces, const std::string& part = {});
    /// Begins the next mip level, of which all slices must be appended.
    void BeginNextLevel() { ++m_LevelsOfTexels; }

private:
    std::vector<std::byte> m_Texels;
    int m_LevelsOfTexels = 1;
};

// The textures below throw ContractError naming the texture, if a size is not positive, the bytes
// do not fit it, or the format is None or a depth format. A texture larger than the device supports
// throws when it is first drawn with.

/// A picture. Row 0 is at v = 0: the texels are given bottom row first, as Unity imports them, so
/// that the picture stands upright on a mesh. Unity: UnityEngine.Texture2D.
class Texture2D final : public TexelTexture
{
public:
    /// @param texels    height rows of width texels in `format`, tightly packed
    /// @param mipChain  if true, it has all mip levels, else one
    Texture2D(std::string name, int width, int height, GraphicsFormat format,
              std::vector<std::byte> texels, SamplerState sampler = {}, bool mipChain = false);
};

/// A volume; slice 0 is at w = 0. Unity: UnityEngine.Texture3D.
class Texture3D final : public TexelTexture
{
public:
    /// @param texels  depth slices, each as a Texture2D's texels
    Texture3D(std::string name, int width, int height, int depth, GraphicsFormat format,
              std::vector<std::byte> texels, SamplerState sampler = {}, bool mipChain = false);
};

/// Pictures of one size that a shader chooses from by number. Unity: UnityEngine.Texture2DArray.
class Texture2DArray final : public TexelTexture
{
public:
    /// @param elements  each as a Texture2D's texels
    Texture2DArray(std::string name, int width, int height, GraphicsFormat format,
                   std::vector<std::vector<std::byte>> elements, SamplerState sampler = {},
                   bool mipChain = false);
};

/// The surroundings of a point in all directions. Unity: UnityEngine.Cubemap.
class Cubemap final : public TexelTexture
{
public:
    /// @param width  the width of a face, which is as high
    Cubemap(std::string name, int width, GraphicsFormat format, CubemapFaces faces,
            SamplerState sampler = {}, bool mipChain = false);
    /// Makes a cube map whose mip levels need not be smaller pictures of the first, as for
    /// reflections.
    /// @param levels  at least one; each half as wide as the one before, at least a texel
    Cubemap(std::string name, int width, GraphicsFormat format, std::vector<CubemapFaces> levels,
            SamplerState sampler = {});
};

/// Cubes of one size that a shader chooses from by number. Unity: UnityEngine.CubemapArray.
class CubemapArray final : public TexelTexture
{
public:
    /// @param width  the width of a face, which is as high
    CubemapArray(std::string name, int width, GraphicsFormat format,
                 std::vector<CubemapFaces> cubes, SamplerState sampler = {}, bool mipChain = false);
};

} // namespace limn
