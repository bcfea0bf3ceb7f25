#pragma once

namespace limn
{

/// The space in which colours are lit, blended and stored. Unity: UnityEngine.ColorSpace (2022.3).
enum class ColorSpace
{
    Gamma = 0, ///< as they are written, which is sRGB
    Linear = 1 ///< in proportion to light
};

/// Unity: UnityEngine.QualitySettings (2022.3).
namespace QualitySettings
{
/// Returns the colour space of the process: Linear, unless PlayerSettings::SetColorSpace set it.
ColorSpace activeColorSpace();
} // namespace QualitySettings

/// Unity: UnityEditor.PlayerSettings (2022.3).
namespace PlayerSettings
{
/// Sets the colour space of the process. In Gamma, colours reach shaders as they are written,
/// cameras without HDR draw into R8G8B8A8_UNorm, and shaders are compiled with
/// UNITY_COLORSPACE_GAMMA. Shaders and scenes that were drawn before keep what they have, so it
/// must be called before them.
void SetColorSpace(ColorSpace space);
} // namespace PlayerSettings

} // namespace limn
