#pragma once

#include <array>
#include <cstdint>
#include <limn/core/Image.h>

namespace limn
{

/// A channel of an imported texture by what it takes of the file's.
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
    None,         ///< 1
    FromInput,    ///< the file's, 1 where it has none
    FromGrayScale ///< the mean of red, green and blue
};

/// The changes that Unity's TextureImporter makes to the texels of a file.
struct PictureSettings
{
    bool sRGB = true; ///< the file's colours are
    PictureAlpha alpha = PictureAlpha::FromInput;
    std::array<PictureSwizzle, 4> swizzle = {PictureSwizzle::R, PictureSwizzle::G,
                                             PictureSwizzle::B, PictureSwizzle::A};
    bool isNormalMap = false; ///< normals in red and green; its alpha becomes 1
    bool flipGreenChannel = false;
    bool convertToNormalMap = false; ///< the file's grey is a height
    /// The height of white above black, in hundreds of texels. Whether slopes are as strong in
    /// Unity is not known.
    float heightScale = 0.25f;
    int maxTextureSize = 0; ///< of the longer side, in texels; 0 = any
};

/// Changes a picture as the settings say. One that is too large becomes smaller by the mean of the
/// texels that a new one covers, in linear space where it is sRGB. A size that is no power of two
/// stays one: uv go from 0 to 1 whatever the size.
/// @return the picture in R8G8B8A8_SRGB or _UNorm, or in R16G16B16A16_SFloat if it was
Image ApplyPictureSettings(Image image, const PictureSettings& settings);

} // namespace limn
