#pragma once

#include <cstdint>
#include <limn/core/SphericalHarmonicsL2.h>
#include <memory>

namespace limn
{

class Material;
class Texture;

/// The source of ambient light: the sky, three colours by height, one colour, or the value of
/// ambientProbe. Unity: UnityEngine.Rendering.AmbientMode (2022.3).
enum class AmbientMode : std::uint8_t
{
    Skybox = 0,
    Trilight = 1,
    Flat = 3,
    Custom = 4
};

/// The curve by which fog thickens. Unity: UnityEngine.FogMode (2022.3).
enum class FogMode : std::uint8_t
{
    Linear = 1,
    Exponential = 2,
    ExponentialSquared = 3
};

/// The surroundings that surfaces mirror: the sky, or customReflectionTexture.
/// Unity: UnityEngine.Rendering.DefaultReflectionMode (2022.3).
enum class DefaultReflectionMode : std::uint8_t
{
    Skybox = 0,
    Custom = 1
};

/// The light and fog of a scene besides its lights; each Scene has them. By default the ambient
/// light is one colour, nothing is mirrored and there is no fog, while Unity's new scenes begin
/// with Skybox for both. Unity: UnityEngine.RenderSettings (2022.3).
struct RenderSettings
{
    RenderSettings() {} // a union does not make itself

    AmbientMode ambientMode = AmbientMode::Flat;
    /// An sRGB colour: for Flat the light from all sides, for Trilight the light on surfaces that
    /// face up. Unity has both names for this one colour.
    union
    {
        Color ambientLight{0.2f, 0.2f, 0.2f, 1.0f};
        Color ambientSkyColor;
    };
    Color ambientEquatorColor{0.114f, 0.125f, 0.133f, 1.0f}; ///< sRGB; facing sideways
    Color ambientGroundColor{0.047f, 0.043f, 0.035f, 1.0f};  ///< sRGB; facing down
    float ambientIntensity = 1.0f;                           ///< multiplies the light of Skybox
    /// The ambient light of Skybox, which DynamicGI::UpdateEnvironment sets, and of Custom.
    SphericalHarmonicsL2 ambientProbe;

    bool fog = false;
    FogMode fogMode = FogMode::ExponentialSquared;
    Color fogColor{0.5f, 0.5f, 0.5f, 1.0f}; ///< sRGB
    float fogDensity = 0.01f;               ///< 1/metre; of the exponential modes
    float fogStartDistance = 0.0f;          ///< metres; of Linear, as the next
    float fogEndDistance = 300.0f;          ///< metres; nothing but fog is seen behind

    DefaultReflectionMode defaultReflectionMode = DefaultReflectionMode::Custom;
    /// A cube whose mip levels 0 ... 6 are increasingly blurred, for Custom. Null = none: URP's
    /// shaders mirror the ambient light then, and the cube that others read is black.
    std::shared_ptr<const Texture> customReflectionTexture;
    /// The cube for Skybox, which DynamicGI::UpdateEnvironment makes; null = none, too.
    /// Unity: ReflectionProbe.defaultTexture.
    std::shared_ptr<const Texture> skyReflection;
    /// The number of texels along an edge of skyReflection: a power of two from 1 to 2048.
    int defaultReflectionResolution = 128;
    float reflectionIntensity = 1.0f; ///< multiplies the reflections

    /// The sky that cameras with CameraClearFlags::Skybox see; null = none. Its first pass draws a
    /// ball around the camera whose POSITION is the direction in world axes. A shader with six
    /// passes draws the cube's sides +Z -Z +X -X +Y -Y, one each, with TEXCOORD0 from bottom left
    /// to top right as seen from inside.
    std::shared_ptr<const Material> skybox;

    /// Returns the ambient light of the current mode, as surfaces of each normal show it. Trilight
    /// is exact for normals up, sideways and down, and follows the parabola between them.
    SphericalHarmonicsL2 AmbientLight() const;
    /// Returns the cube that the mode mirrors; null = none.
    const std::shared_ptr<const Texture>& ReflectionTexture() const
    {
        return defaultReflectionMode == DefaultReflectionMode::Skybox ? skyReflection
                                                                      : customReflectionTexture;
    }
};

} // namespace limn
