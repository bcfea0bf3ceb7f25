#pragma once

#include <array>

#include <glm/mat4x4.hpp>
#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/core/LiteralZero.h>
#include <limn/core/Transform.h>
#include <memory>
#include <optional>
#include <vector>

namespace limn
{

class RenderTexture;

/// What there is where a camera sees no object: the scene's skybox, or the background colour, as
/// with Depth and with Skybox in a scene without. The background colour is there before the skybox,
/// too (Unity leaves that undefined). Unity: UnityEngine.CameraClearFlags.
enum class CameraClearFlags
{
    Skybox = 1,
    SolidColor = 2,
    Depth = 3,
    Nothing = 4
};

/// What a camera is there for. Unity: UnityEngine.CameraType, of which limn has these; flags, so
/// that several can be asked for at once.
enum class CameraType
{
    Game = 1,
    SceneView = 2,
    Preview = 4,
    Reflection = 16
};
// As C# has them for every enum: `(cameraType & CameraType::Game) != 0`.
constexpr CameraType operator&(CameraType a, CameraType b)
{
    return static_cast<CameraType>(static_cast<int>(a) & static_cast<int>(b));
}
constexpr CameraType operator|(CameraType a, CameraType b)
{
    return static_cast<CameraType>(static_cast<int>(a) | static_cast<int>(b));
}
constexpr bool operator==(CameraType a, LiteralZero)
{
    return static_cast<int>(a) == 0;
}

/// Whether a camera makes a picture, or draws onto what the cameras before it in a stack made.
/// Unity: UnityEngine.Rendering.Universal.CameraRenderType (URP 14).
enum class CameraRenderType
{
    Base = 0,
    Overlay = 1
};

/// Whether opaque objects are sorted by distance. Unity: UnityEngine.Rendering.OpaqueSortMode.
enum class OpaqueSortMode
{
    Default = 0,
    FrontToBack = 1,
    NoDistanceSort = 2
};

/// What the distance is by which objects are sorted: as the camera's lens has it, from the camera,
/// along its direction, or along transparencySortAxis. Unity: UnityEngine.TransparencySortMode.
enum class TransparencySortMode
{
    Default = 0,
    Perspective = 1,
    Orthographic = 2,
    CustomAxis = 3
};

/// A half line in world space, metres. Unity: UnityEngine.Ray, in double precision.
struct Ray
{
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0}; ///< unit length

    glm::dvec3 GetPoint(double distance) const { return origin + direction * distance; }
};

/// Unity: UnityEngine.Camera with URP's additional data (2022.3).
struct Camera
{
    Transform transform;
    bool orthographic = false;
    float orthographicSize = 5.0f; ///< half the picture's height, metres
    float fieldOfView = 60.0f;     ///< vertical, degrees, (0, 180)
    float nearClipPlane = 0.3f;    ///< metres, > 0 for perspective
    float farClipPlane = 1000.0f;  ///< metres, > nearClipPlane
    /// In place of what fieldOfView or orthographicSize and the picture's shape make: view to clip
    /// space as OpenGL has it, z from -w at the near plane to w at the far one. Its last row is
    /// (0, 0, -1, 0), or (0, 0, 0, 1) if `orthographic`; near and far plane are what shaders
    /// believe, so keep them as in the matrix. Double, because half of z's digits go where near and
    /// far are far apart. Unity: Camera.projectionMatrix; reset() is ResetProjectionMatrix.
    std::optional<glm::dmat4> projectionMatrix;
    CameraClearFlags clearFlags = CameraClearFlags::SolidColor;
    Color backgroundColor{0.19f, 0.3f, 0.47f, 0.0f}; ///< sRGB
    LayerMask cullingMask = LayerMask::Everything();
    OpaqueSortMode opaqueSortMode = OpaqueSortMode::Default; ///< of a stack's base camera
    TransparencySortMode transparencySortMode = TransparencySortMode::Default;
    glm::vec3 transparencySortAxis{0, 0, 1}; ///< of CustomAxis: world, away from the viewer
    CameraType cameraType = CameraType::Game;
    /// What features ask before they add effects. There are none unless a feature brings them, so
    /// it is on, where a camera of Unity's begins without. In a stack each camera that has it on
    /// gets them, over all that is drawn so far. Unity: UniversalAdditionalCameraData.
    bool renderPostProcessing = true;
    /// Its colour is HDR if the pipeline supportsHDR, of hdrColorBufferPrecision; else
    /// R8G8B8A8_SRGB.
    bool allowHDR = true;
    bool allowMSAA = true;        ///< as many samples a texel as the pipeline says, else one
    LayerMask volumeLayerMask{1}; ///< layers whose volumes apply
    std::optional<glm::vec3> volumeTrigger; ///< world; default the camera's position

    // Several cameras. Unity: UniversalAdditionalCameraData (URP 14), Camera.
    CameraRenderType renderType = CameraRenderType::Base;
    bool clearDepth = true; ///< of an overlay: what is drawn before it hides nothing of it
    /// Of a base camera: the overlays that draw onto its picture, in this order, with its size,
    /// format, samples and target. None of them is null.
    std::vector<std::shared_ptr<const Camera>> cameraStack;
    float depth = 0.0f; ///< base cameras are drawn in the order of their whole depths
    /// Of a base camera: where its picture ends up, alpha included, in place of the frame's. It
    /// has this texture's size and format, and its samples unless allowMSAA is off or the
    /// pipeline's msaaSampleCount is 1. A colour; what later cameras draw may read it.
    std::shared_ptr<const RenderTexture> targetTexture;

    /// World to view space: right-handed, looking along -z. Unity: Camera.worldToCameraMatrix.
    glm::mat4 worldToCameraMatrix() const;
    /// The same before it is rounded.
    glm::dmat4 viewMatrix() const;
    /// View to world space. Unity: Camera.cameraToWorldMatrix.
    glm::mat4 cameraToWorldMatrix() const;

    /// What positions are relative to where the picture is made, metres: the corner of a grid of
    /// 8 m next to the camera if that is more than 1024 m away from the world's origin along an
    /// axis, or else 0. A float is exact to 0.06 mm there, and all ways in which shaders spell a
    /// position give equal bits near the world's origin.
    glm::dvec3 renderOrigin() const;

    /// View to clip space: y up, z from w at the near plane to 0 at the far one, or from 0 to w. A
    /// camera that draws into a texture has y turned over: CameraData::gpuProjectionMatrix.
    /// Computed in double precision: exact to float rounding for any near and far.
    /// @param aspect               width / height
    /// @param usesReversedZBuffer  z is w at the near plane; see ShaderCompilerOptions
    /// @throws ContractError naming the field, if one is outside its range or not finite, or if
    ///     projectionMatrix is no projection of this camera's kind, singular or beyond a float
    /// @source Unity: GL.GetGPUProjectionMatrix(camera.projectionMatrix, false)
    glm::mat4 gpuProjectionMatrix(float aspect, bool usesReversedZBuffer = true) const;

    /// projectionMatrix, or what the fields make in its place: what to begin with for a matrix of
    /// one's own. Its z keeps as many digits as 1e16 near / far has.
    /// @throws ContractError as gpuProjectionMatrix. Unity: Camera.projectionMatrix, when read.
    glm::dmat4 projectionMatrixFor(float aspect) const;

    /// The same picture with another near plane: everything on the side of it to which its normal
    /// points. The far plane goes through where the old one meets the near one.
    /// @param clipPlane  in view space: a point p is kept where dot(clipPlane, (p, 1)) > 0; the
    ///     camera is on its other side
    /// @throws ContractError as gpuProjectionMatrix, or if the camera is on the kept side
    /// @source E. Lengyel, "Oblique View Frustum Depth Projection and Clipping", 2005
    /// Unity: Camera.CalculateObliqueMatrix (2022.3).
    glm::dmat4 CalculateObliqueMatrix(const glm::dvec4& clipPlane, float aspect) const;

    /// World to clip space, z from -w to w. Unity: Camera.cullingMatrix, when read.
    glm::dmat4 cullingMatrix(float aspect) const
    {
        return projectionMatrixFor(aspect) * viewMatrix();
    }

    // Places in a picture, whose width / height `aspect` is: x and y from 0 at its left and bottom
    // edge to 1, z metres in front of the camera. Of a screen: of `size` pixels, in them. World
    // positions are metres. They throw ContractError as gpuProjectionMatrix does. Unity's camera
    // knows its picture by itself.
    glm::vec3 WorldToViewportPoint(const glm::vec3& position, float aspect) const;
    glm::vec3 ViewportToWorldPoint(const glm::vec3& position, float aspect) const;
    /// From the near plane on.
    Ray ViewportPointToRay(const glm::vec2& position, float aspect) const;
    glm::vec3 WorldToScreenPoint(const glm::vec3& position, const glm::ivec2& size) const;
    glm::vec3 ScreenToWorldPoint(const glm::vec3& position, const glm::ivec2& size) const;
    Ray ScreenPointToRay(const glm::vec2& position, const glm::ivec2& size) const;
    static glm::vec3 ScreenToViewportPoint(const glm::vec3& position, const glm::ivec2& size);
    static glm::vec3 ViewportToScreenPoint(const glm::vec3& position, const glm::ivec2& size);
    /// The camera sees these corners of a part of the picture at that distance: bottom left, top
    /// left, top right, bottom right, in axes of its transform, so that they have z = `z`.
    /// @param viewport  x, y, width and height, 0, 0, 1 and 1 = all of it
    /// @source Unity: Camera.CalculateFrustumCorners (2022.3)
    std::array<glm::vec3, 4> CalculateFrustumCorners(const glm::vec4& viewport, float z,
                                                     float aspect) const;
};

/// Returns what shaders get of a projection with z from -w at the near plane to w at the far one,
/// as OpenGL has it and Camera::projectionMatrix.
/// @param renderIntoTexture  y is turned over: TargetOrientation.h
/// @source Unity: GL.GetGPUProjectionMatrix (2022.3)
glm::mat4 GpuProjection(const glm::dmat4& projection, bool usesReversedZBuffer,
                        bool renderIntoTexture = false);

/// Depth the other way round: of near 1 ... far 0 comes near 0 ... far 1, and back.
template <typename Matrix>
Matrix WithTurnedDepth(Matrix projection)
{
    for (int column = 0; column < 4; ++column)
    {
        projection[column][2] = projection[column][3] - projection[column][2];
    }
    return projection;
}

} // namespace limn
