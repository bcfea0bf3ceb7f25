#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <limn/core/Image.h>
#include <limn/core/SphericalHarmonicsL2.h>
#include <limn/core/Texture.h>
#include <vector>

namespace limn
{

inline constexpr int k_CubeFaces = 6;

/// A face of a cube as seen from inside, in limn's left-handed axes. The faces are in the order of
/// CubemapFaces.
struct CubeFace
{
    glm::vec3 forward;
    glm::vec3 right;
    glm::vec3 up;
};
inline constexpr std::array<CubeFace, k_CubeFaces> k_FacesOfCube{
    {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
     {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
     {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
     {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
     {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
     {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}}};

/// The light from all around a point: linear colours by direction, none below 0 or above what a
/// half can hold.
struct CubeLight
{
    int width = 0;                 ///< texels along an edge of a face
    std::vector<glm::vec3> texels; ///< face by face in CubemapFaces' order, rows from the top

    explicit CubeLight(int width_ = 0);
    std::size_t Index(int face, int x, int y) const;
    /// Returns the direction of the middle of a texel; it is not of unit length. x and y may lie
    /// outside of the face, on the plane that continues it.
    glm::vec3 Direction(int face, int x, int y) const;
};

/// Returns the light of faces that were drawn, in R16G16B16A16_SFloat and all of one size.
/// @param notNumbers  grows by the number of texels that contain one and therefore are black
CubeLight ReadCubeLight(const std::array<Image, k_CubeFaces>& faces, std::size_t& notNumbers);

/// Returns the light on white matt surfaces of each normal: the projection on harmonics of order 2
/// by the solid angles of the texels, convolved with the cosine.
/// @source R. Ramamoorthi, P. Hanrahan, "An Efficient Representation for Irradiance Environment
///         Maps", SIGGRAPH 2001
SphericalHarmonicsL2 ProjectLight(const CubeLight& light);

/// Returns the solid angle of a texel.
/// @param x, y  0 ... `width` - 1, along the edges of a face
double SolidAngle(int width, int x, int y);

/// Returns a cube map of the levels, in R16G16B16A16_SFloat.
std::shared_ptr<const Cubemap> MakeCubemap(const std::string& name,
                                           const std::vector<CubeLight>& levels);

/// The mip level that surfaces of perceptual roughness 1 mirror: UNITY_SPECCUBE_LOD_STEPS.
inline constexpr int k_RoughestLevel = 6;

/// Returns the perceptual roughness whose mip level this is: the inverse of the ShaderLibrary's
/// PerceptualRoughnessToMipmapLevel.
double PerceptualRoughnessOfLevel(int level);

/// Returns the reflections of a light in increasingly rough surfaces, seen straight on: level 0 is
/// the light itself; each next one is half as wide, down to k_RoughestLevel or one texel. Each is
/// the mean weighted by the GGX distribution and the cosine, so that light that is the same from
/// all sides stays so.
/// @param light  its width must be a power of two
/// @source B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013; J. Krivanek, M. Colbert,
///     "Real-Time Shading with Filtered Importance Sampling", EGSR 2008
std::vector<CubeLight> FilterReflection(const CubeLight& light);

} // namespace limn
