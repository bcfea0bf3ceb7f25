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

/// Selects what a camera shows where it sees no object: the scene's skybox or the background
/// colour. Depth, and Skybox in a scene without a skybox, give the background colour as well. The
/// target also holds the background colour before the skybox is drawn (Unity leaves that
/// undefined). Unity: UnityEngine.CameraClearFlags.
enum class CameraClearFlags
{
    Skybox = 1,
    SolidColor = 2,
    Depth = 3,
    Nothing = 4
};

/// The purpose of a camera. Unity: UnityEngine.CameraType, of which limn has these values. They are
/// flags, so that several can be tested at once.
enum class CameraType
{
    Game = 1,
    SceneView = 2,
    Preview = 4,
    Reflection = 16
};
// C# has these operators for every enum: `(cameraType & CameraType::Game) != 0`.
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

/// Selects between a camera that makes a picture of its own and one that draws onto the picture of
/// the cameras before it in a stack. Unity: UnityEngine.Rendering.Universal.CameraRenderType
/// (URP 14).
enum class CameraRenderType
{
    Base = 0,
    Overlay = 1
};

/// Selects what smooths the edges of the finished picture, beside several samples per texel.
/// Unity: UnityEngine.Rendering.Universal.AntialiasingMode (URP 14), of which limn has these
/// values.
enum class AntialiasingMode
{
    None = 0,
    FastApproximateAntialiasing = 1 ///< FXAA
};

/// Selects whether opaque objects are sorted by distance.
/// Unity: UnityEngine.Rendering.OpaqueSortMode.
enum class OpaqueSortMode
{
    Default = 0,
    FrontToBack = 1,
    NoDistanceSort = 2
};

/// Selects the distance by which objects are sorted: as the camera's projection has it, from the
/// camera, along its direction, or along transparencySortAxis.
/// Unity: UnityEngine.TransparencySortMode.
enum class TransparencySortMode
{
    Default = 0,
    Perspective = 1,
    Orthographic = 2,
    CustomAxis = 3
};

/// A half line in world space, in metres. Unity: UnityEngine.Ray, in double precision.
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
    /// Replaces the projection that fieldOfView or orthographicSize and the picture's aspect ratio
    /// give. It goes from view to clip space as in OpenGL, with z from -w at the near plane to w at
    /// the far one. Its last row must be (0, 0, -1, 0), or (0, 0, 0, 1) if `orthographic`. Shaders
    /// still read the near and far plane from the fields, so keep those as in the matrix. It is in
    /// double precision, because half of z's digits are lost where near and far are far apart.
    /// Unity: Camera.projectionMatrix; reset() is ResetProjectionMatrix.
    std::optional<glm::dmat4> projectionMatrix;
    CameraClearFlags clearFlags = CameraClearFlags::SolidColor;
    Color backgroundColor{0.19f, 0.3f, 0.47f, 0.0f}; ///< sRGB
    LayerMask cullingMask = LayerMask::Everything();
    OpaqueSortMode opaqueSortMode = OpaqueSortMode::Default; ///< used by a stack's base camera
    TransparencySortMode transparencySortMode = TransparencySortMode::Default;
    glm::vec3 transparencySortAxis{0, 0, 1}; ///< for CustomAxis: world, away from the viewer
    CameraType cameraType = CameraType::Game;
    /// Allows features to add effects; they ask before they do. There are no effects unless a
    /// feature brings them, so it is on by default, whereas a camera of Unity's begins with it off.
    /// In a stack each camera that has it on gets the effects, over all that is drawn so far.
    /// Unity: UniversalAdditionalCameraData.
    bool renderPostProcessing = true;
    /// Smooths the picture of a base camera and its overlays, behind all their effects. It has no
    /// effect unless one of them has renderPostProcessing on and the renderer has a feature that
    /// does it, PostProcessRendererFeature. Unity: UniversalAdditionalCameraData.antialiasing.
    AntialiasingMode antialiasing = AntialiasingMode::None;
    /// If true and the pipeline supportsHDR, the camera's colour is HDR, in the pipeline's
    /// hdrColorBufferPrecision; otherwise it has the format of DefaultFormat::LDR.
    bool allowHDR = true;
    /// If true, there are as many samples per texel as the pipeline sets, else one.
    bool allowMSAA = true;
    LayerMask volumeLayerMask{1};           ///< layers whose volumes apply
    std::optional<glm::vec3> volumeTrigger; ///< world; default the camera's position

    // The following fields are for several cameras. Unity: UniversalAdditionalCameraData (URP 14),
    // Camera.
    CameraRenderType renderType = CameraRenderType::Base;
    /// If true, an overlay clears the depth, so that nothing drawn before hides it.
    bool clearDepth = true;
    /// The overlays that draw onto the picture of a base camera, in this order, with its size,
    /// format, samples and target. No element may be null.
    std::vector<std::shared_ptr<const Camera>> cameraStack;
    /// Base cameras are drawn in the order of their depths, without their fractions.
    float depth = 0.0f;
    /// The texture that receives the picture of a base camera, alpha included, in place of the
    /// frame's output. The picture has this texture's size and format, and its samples unless
    /// allowMSAA is off or the pipeline's msaaSampleCount is 1. Must be a colour texture. What
    /// later cameras draw may read it.
    std::shared_ptr<const RenderTexture> targetTexture;

    /// Returns the matrix from world to view space: right-handed, looking along -z.
    /// Unity: Camera.worldToCameraMatrix.
    glm::mat4 worldToCameraMatrix() const { return glm::mat4(viewMatrix()); }
    /// Returns worldToCameraMatrix() before it is rounded to float.
    glm::dmat4 viewMatrix() const;
    /// Returns the matrix from view to world space. Unity: Camera.cameraToWorldMatrix.
    glm::mat4 cameraToWorldMatrix() const;

    /// Returns the point to which positions are relative while the picture is drawn, in metres: the
    /// corner of an 8 m grid next to the camera if the camera is more than 1024 m away from the
    /// world's origin along an axis, or else 0. A float is exact to 0.06 mm there, and all ways in
    /// which shaders write a position give equal bits near the world's origin.
    glm::dvec3 renderOrigin() const;

    /// Returns the matrix from view to clip space: y up, z from w at the near plane to 0 at the far
    /// one, or from 0 to w. For a camera that draws into a texture y is flipped: see
    /// CameraData::gpuProjectionMatrix. It is computed in double precision and exact to float
    /// rounding for any near and far.
    /// @param aspect               width / height
    /// @param usesReversedZBuffer  z is w at the near plane; see ShaderCompilerOptions
    /// @throws ContractError naming the field, if one is outside its range or not finite, or if
    ///     projectionMatrix is no projection of this camera's kind, singular or beyond a float
    /// @source Unity: GL.GetGPUProjectionMatrix(camera.projectionMatrix, false)
    glm::mat4 gpuProjectionMatrix(float aspect, bool usesReversedZBuffer = true) const;

    /// Returns projectionMatrix, or the matrix that the fields give in its place. A matrix of one's
    /// own can start from it. Its z keeps as many digits as 1e16 near / far has.
    /// @throws ContractError as gpuProjectionMatrix. Unity: Camera.projectionMatrix, when read.
    glm::dmat4 projectionMatrixFor(float aspect) const;

    /// Returns the projection of the same picture with another near plane. It keeps everything on
    /// the side of the plane to which the plane's normal points. The far plane goes through the
    /// line where the old one meets the near one.
    /// @param clipPlane  in view space: a point p is kept where dot(clipPlane, (p, 1)) > 0; the
    ///     camera is on its other side
    /// @throws ContractError as gpuProjectionMatrix, or if the camera is on the kept side
    /// @source E. Lengyel, "Oblique View Frustum Depth Projection and Clipping", 2005
    /// Unity: Camera.CalculateObliqueMatrix (2022.3).
    glm::dmat4 CalculateObliqueMatrix(const glm::dvec4& clipPlane, float aspect) const;

    /// Returns the matrix from world to clip space, z from -w to w. Unity: Camera.cullingMatrix,
    /// when read.
    glm::dmat4 cullingMatrix(float aspect) const
    {
        return projectionMatrixFor(aspect) * viewMatrix();
    }

    // These convert places in a picture, whose width / height is `aspect`. Viewport x and y go from
    // 0 at the left and bottom edge to 1; z is in metres in front of the camera. Screen places are
    // in pixels of a screen of `size` pixels. World positions are in metres. They throw
    // ContractError as gpuProjectionMatrix does. Unity's camera knows its picture by itself.
    glm::vec3 WorldToViewportPoint(const glm::vec3& position, float aspect) const;
    glm::vec3 ViewportToWorldPoint(const glm::vec3& position, float aspect) const;
    /// Returns the ray through a place of the picture; it begins at the near plane.
    Ray ViewportPointToRay(const glm::vec2& position, float aspect) const;
    glm::vec3 WorldToScreenPoint(const glm::vec3& position, const glm::ivec2& size) const;
    glm::vec3 ScreenToWorldPoint(const glm::vec3& position, const glm::ivec2& size) const;
    Ray ScreenPointToRay(const glm::vec2& position, const glm::ivec2& size) const;
    static glm::vec3 ScreenToViewportPoint(const glm::vec3& position, const glm::ivec2& size);
    static glm::vec3 ViewportToScreenPoint(const glm::vec3& position, const glm::ivec2& size);
    /// Returns the corners of a part of the picture at the distance `z` in front of the camera:
    /// bottom left, top left, top right, bottom right, in the axes of the camera's transform, so
    /// that they have z = `z`.
    /// @param viewport  x, y, width and height, 0, 0, 1 and 1 = all of it
    /// @source Unity: Camera.CalculateFrustumCorners (2022.3)
    std::array<glm::vec3, 4> CalculateFrustumCorners(const glm::vec4& viewport, float z,
                                                     float aspect) const;
};

/// Returns the projection matrix that shaders get, from one with z from -w at the near plane to w
/// at the far one, as in OpenGL and Camera::projectionMatrix.
/// @param renderIntoTexture  if true, y is flipped: see TargetOrientation.h
/// @source Unity: GL.GetGPUProjectionMatrix (2022.3)
glm::mat4 GpuProjection(const glm::dmat4& projection, bool usesReversedZBuffer,
                        bool renderIntoTexture = false);

/// Returns the projection with depth reversed: near 1 ... far 0 becomes near 0 ... far 1, and the
/// other way round.
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
