#pragma once

#include <array>
#include <cstdint>
#include <limn/core/Image.h>

namespace limn
{

/// The source of a channel of an imported texture: a channel of the file, its inverse, or a
/// constant.
/// Unity: UnityEditor.TextureImporterSwizzle (2022.3).
enum class PictureSwizzle : std::uint8_t
{
    R,
    G,
    B,
    A,
    OneMinusR,
    OneMinusG,
    OneMinusB,
    OneMinusA,
    Zero,
    One
};

/// Unity: UnityEditor.TextureImporterAlphaSource (2022.3).
enum class PictureAlpha : std::uint8_t
{
    None,         ///< alpha is 1
    FromInput,    ///< the file's alpha; 1 where it has none
    FromGrayScale ///< the mean of red, green and blue
};

/// The changes that Unity's TextureImporter makes to the texels of a file.
struct PictureSettings
{
    bool sRGB = true; ///< true if the file's colours are sRGB
    PictureAlpha alpha = PictureAlpha::FromInput;
    std::array<PictureSwizzle, 4> swizzle = {PictureSwizzle::R, PictureSwizzle::G,
                                             PictureSwizzle::B, PictureSwizzle::A};
    bool isNormalMap = false; ///< normals are in red and green; alpha becomes 1
    bool flipGreenChannel = false;
    bool convertToNormalMap = false; ///< the file's grey is a height
    /// The height of white above black, in hundreds of texels. It is not known whether slopes are
    /// as strong in Unity.
    float heightScale = 0.25f;
    int maxTextureSize = 0; ///< the most texels of the longer side; 0 = any number
};

/// Changes a picture as the settings say. A picture that is too large is scaled down: each new
/// texel is the mean of the texels that it covers, in linear space if the picture is sRGB. A size
/// that is no power of two is kept: uv go from 0 to 1 whatever the size.
/// @return the picture in R8G8B8A8_SRGB or _UNorm, or in R16G16B16A16_SFloat if it was
Image ApplyPictureSettings(Image image, const PictureSettings& settings);

} // namespace limn
