#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limn/core/Camera.h>
#include <limn/core/Culling.h>
#include <limn/core/Light.h>
#include <limn/core/RTHandle.h>
#include <limn/core/RenderReport.h>
#include <limn/core/Scene.h>
#include <limn/core/TargetOrientation.h>
#include <span>
#include <vector>

namespace limn
{

class Scene;
struct Light;
struct LightData;

/// The shadows that the pipeline and the frame's lights ask for. Whether a map is drawn also
/// depends on whether objects throw and show them.
/// Unity: UnityEngine.Rendering.Universal.ShadowData (URP 14).
struct ShadowData
{
    bool supportsMainLightShadows = false; ///< the pipeline does, and the main light throws them
    int mainLightShadowmapWidth = 0;       ///< texels
    int mainLightShadowmapHeight = 0;
    int mainLightShadowCascadesCount = 0;         ///< 1...4
    glm::vec3 mainLightShadowCascadesSplit{0.0f}; ///< shares of the distance; 1, 0, 0 = one only
    float mainLightShadowCascadeBorder = 0.0f;    ///< share of the distance, 0...1
    bool supportsAdditionalLightShadows = false;  ///< as for the main light
    int additionalLightsShadowmapWidth = 0;       ///< texels
    int additionalLightsShadowmapHeight = 0;
    bool supportsSoftShadows = false;
    int shadowmapDepthBufferBits = 0; ///< 32 (Unity: 16)

    ShadowData() = default;
    /// @param lights  the lights that it points to must outlive calls of bias()
    ShadowData(const ShadowSettings& settings, const LightData& lights);

    /// Returns for each of LightData::visibleLights() the biases in texels: towards the light and
    /// along the normal, 0, 0. They are computed at each call. Unity: ShadowData.bias, a list.
    std::vector<glm::vec4> bias() const;
    /// Returns for each of these lights the texels along a side of a square that it asks for on the
    /// map of additional lights. The main light is of tier High, and has another map.
    /// Unity: ShadowData.resolution.
    std::vector<int> resolution() const;

private:
    const Scene* m_Scene = nullptr; ///< the scene, if it has a main light
    std::span<const Light* const> m_AdditionalLights;
    glm::vec4 m_Bias{0.0f}; ///< the pipeline's
    glm::ivec3 m_Tiers{0};  ///< low, medium, high
};

class RenderTexturePool;
class ScriptableRenderer;
class VolumeStack;

/// A pointer to a blended stack, or to one of defaults if none was given: never null, as in Unity.
/// VolumeStack belongs to the layer above; code that uses `->` includes its header, and only then
/// is the type complete.
class VolumeStackPointer
{
public:
    /// @param stack  must outlive this; null = the defaults
    VolumeStackPointer(const VolumeStack* stack = nullptr) : m_Stack(stack) {}

    template <typename Stack = VolumeStack>
    const Stack& operator*() const
    {
        return m_Stack != nullptr ? *m_Stack : Stack::Defaults();
    }
    template <typename Stack = VolumeStack>
    const Stack* operator->() const
    {
        return &operator*<Stack>();
    }

private:
    const VolumeStack* m_Stack;
};

/// Unity: UnityEngine.Rendering.Universal.CameraData (URP 14).
struct CameraData
{
    const Camera* camera = nullptr; ///< never null during rendering
    /// The camera's target: pixel size, colour format, 32 depth bits, samples per texel. A pass
    /// that needs a plain colour texture sets depthBufferBits to 0 and msaaSamples to 1, as in
    /// Unity.
    RenderTextureDescriptor cameraTargetDescriptor;
    ScriptableRenderer* renderer = nullptr; ///< never null during rendering
    int pixelWidth = 0; ///< of the picture; the target's is that times renderScale
    int pixelHeight = 0;
    float aspectRatio = 1.0f;      ///< of the picture, width / height
    float renderScale = 1.0f;      ///< UniversalRenderPipeline::renderScale, or 1
    int pipelineVersion = 14;      ///< UniversalRenderPipeline::pipelineVersion
    bool isDefaultViewport = true; ///< cameras draw over the whole picture
    CameraRenderType renderType = CameraRenderType::Base;
    bool clearDepth = true;         ///< Camera::clearDepth, of an overlay
    bool resolveFinalTarget = true; ///< the last camera of its stack: the picture is done
    /// The Camera::targetTexture of the stack's base camera; null = the frame's output.
    std::shared_ptr<const RenderTexture> targetTexture;
    SortingCriteria defaultOpaqueSortFlags = SortingCriteria::CommonOpaque;
    glm::dmat4 viewMatrix{1.0}; ///< in double: far away from the world's origin a float is coarse
    /// The matrix from view to clip space with y flipped, for draws into textures.
    glm::mat4 gpuProjectionMatrix{1.0f};
    glm::vec3 worldSpaceCameraPos{0.0f}; ///< metres
    /// The point to which positions are relative on the device: Camera::renderOrigin of the base
    /// camera.
    glm::dvec3 renderOrigin{0.0};
    /// If true, depth is 1 near ... 0 far, as the renderer's shaders expect it; else 0 near ... 1
    /// far. Unity: SystemInfo.usesReversedZBuffer (2022.3).
    bool usesReversedZBuffer = true;
    CameraType cameraType = CameraType::Game;
    bool postProcessEnabled = true; ///< Camera::renderPostProcessing
    /// Camera::antialiasing, of the stack's base camera.
    AntialiasingMode antialiasing = AntialiasingMode::None;
    bool isHdrEnabled = true;       ///< the camera's allowHDR, and the pipeline's supportsHDR
    Color backgroundColor;          ///< Camera::backgroundColor, linear
    float maxShadowDistance = 0.0f; ///< metres from the camera; 0 = none reach into its view
    LayerMask volumeLayerMask;      ///< Camera::volumeLayerMask, of the stack's base camera

    bool isSceneViewCamera() const { return cameraType == CameraType::SceneView; }
    bool isPreviewCamera() const { return cameraType == CameraType::Preview; }

    const glm::dmat4& GetViewMatrix() const { return viewMatrix; }
    const glm::mat4& GetGPUProjectionMatrix() const { return gpuProjectionMatrix; }
    /// Returns the matrix from view to clip space as Unity's scripts see it, whichever depth
    /// direction the device has: OpenGL's, z from -w at the near plane to w at the far one.
    glm::dmat4 GetProjectionMatrix() const { return camera->projectionMatrixFor(aspectRatio); }
    // There is no jitter.
    glm::dmat4 GetProjectionMatrixNoJitter() const { return GetProjectionMatrix(); }
    const glm::mat4& GetGPUProjectionMatrixNoJitter() const { return gpuProjectionMatrix; }
    /// Returns true: cameras draw into textures, and a back buffer gets its picture by a blit.
    bool IsCameraProjectionMatrixFlipped() const { return true; }
    /// Returns whether a camera's projection is flipped for this target (TargetOrientation.h).
    bool IsRenderTargetProjectionMatrixFlipped(const RTHandle& color,
                                               const RTHandle& depth = {}) const
    {
        return IsHandleYFlipped(color ? color : depth);
    }
    /// Returns whether a camera's projection is flipped for this target; true for a handle that is
    /// empty or only a name.
    bool IsHandleYFlipped(const RTHandle& handle) const
    {
        return !handle.rt() || IsProjectionFlipped(*handle.rt());
    }

    /// Returns the matrix from world to clip space with z from w near to 0 far, whatever the
    /// device's depth direction is.
    glm::dmat4 reversedViewProjection() const
    {
        const glm::dmat4 projection(gpuProjectionMatrix);
        return (usesReversedZBuffer ? projection : WithTurnedDepth(projection)) * viewMatrix;
    }
};

/// A light that reaches into the camera's view. Unity: UnityEngine.Rendering.VisibleLight (2022.3).
struct VisibleLight
{
    const Light* light = nullptr; ///< null = Scene::mainLight; valid as long as the scene's list
    LightType lightType = LightType::Directional;
    Color finalColor;                   ///< linear, with its intensity
    glm::dmat4 localToWorldMatrix{1.0}; ///< it shines along its +z
    float range = 0.0f;                 ///< metres; 0 = without end
    float spotAngle = 0.0f;             ///< degrees; 0 = no spot
};

/// The lights that shaders get. Unity: UnityEngine.Rendering.Universal.LightData (URP 14).
struct LightData
{
    /// The index in visibleLights(); -1 = the scene's main light has no intensity.
    int mainLightIndex = -1;
    int additionalLightsCount = 0; ///< besides the main one
    int maxPerObjectAdditionalLightsCount =
        0; ///< UniversalRenderPipeline::maxAdditionalLightsCount
    bool shadeAdditionalLightsPerVertex = false; ///< always false
    bool supportsAdditionalLights = true;        ///< the limit is not 0
    bool supportsLightLayers = true;

    /// Returns the visible lights, the main one first if it is visible. They are computed at each
    /// call.
    std::vector<VisibleLight> visibleLights() const;

    const Scene* scene = nullptr; ///< null if no pipeline renders
    /// Valid until the camera is done; no element is null.
    std::span<const Light* const> additionalLights;
};

/// The data of a frame that passes and features receive. It is valid only while the camera is
/// rendered. Unity: UnityEngine.Rendering.Universal.RenderingData (URP 14).
struct RenderingData
{
    CameraData cameraData;
    CullingResults cullResults;
    LightData lightData;
    bool postProcessingEnabled = true; ///< a camera of the stack has renderPostProcessing on
    /// The scene that is rendered, for code that must cull it once more; null if no pipeline
    /// renders.
    const Scene* scene = nullptr;
    ShadowSettings shadowSettings; ///< of the pipeline
    ShadowData shadowData;
    /// If true, passes that override both run Execute:
    /// UniversalRenderPipeline::enableRenderCompatibilityMode.
    bool enableRenderCompatibilityMode = false;
    double time = 0.0; ///< seconds; _Time has it rounded to float
    /// Seconds since the frame before, as unity_DeltaTime has them; 0 in the first frame and where
    /// time does not go on, at most a third, as Unity's Time.maximumDeltaTime is set.
    double deltaTime = 0.0;
    /// The blended volumes, in which a feature reads its component.
    /// (Unity: VolumeManager.instance.stack; limn has no singletons.)
    VolumeStackPointer volumeStack;
    /// The pool of temporary textures; never null while a pipeline renders.
    /// (Unity: RenderTexture.GetTemporary, one pool for all.)
    RenderTexturePool* temporaryTextures = nullptr;
    /// The report, to which code adds why something is not drawn; never null during rendering.
    RenderReport* report = nullptr;
};

} // namespace limn
