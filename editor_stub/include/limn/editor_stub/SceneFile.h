#pragma once

#include <filesystem>
#include <limn/core/Camera.h>
#include <limn/core/Scene.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/AssetContext.h>
#include <limn/editor_stub/LayerNames.h>
#include <limn/editor_stub/SelectController.h>
#include <limn/volume/Volume.h>
#include <memory>
#include <optional>
#include <vector>

namespace limn
{

/// The renderer of a scene before it is made. Its features may still be changed, since their Create
/// has not run. Unity: UniversalRendererData (URP 14).
struct RendererAsset
{
    std::vector<std::unique_ptr<ScriptableRendererFeature>> features;
    std::vector<std::string> featureTypes; ///< the type's name of each feature
    LayerMask opaqueLayerMask = LayerMask::Everything();
    LayerMask transparentLayerMask = LayerMask::Everything();
    std::optional<int> pipelineVersion; ///< the version of the Unity project that it was read from
};

/// An object that turns by itself.
struct Turn
{
    GameObject* object = nullptr; ///< of the scene, never null
    glm::quat rest;               ///< the rotation at time 0
    glm::vec3 degreesPerSecond{0.0f};
};

/// The values that a scene gives to the members of UniversalRenderPipeline with these names.
struct PipelineSettings
{
    int msaaSampleCount = 1;
    bool supportsHDR = true;
    HDRColorBufferPrecision hdrColorBufferPrecision = HDRColorBufferPrecision::_64Bits;
    float renderScale = 1.0f;
    int maxAdditionalLightsCount = 4;
    ShadowSettings shadows;
    int pipelineVersion = 14;
};

/// The content of a scene file, with everything that it refers to loaded.
struct SceneAsset : PipelineSettings
{
    std::filesystem::path path;
    int width = 1280; ///< of the picture, in pixels
    int height = 720;
    Scene scene;
    Camera camera;                      ///< the camera that the picture is of
    std::vector<Camera> textureCameras; ///< what they draw is there before `camera` draws
    LayerNames layers;
    LayerNames renderingLayers;
    RendererAsset renderer;
    std::vector<Volume> volumes;
    std::vector<Turn> turns;
    std::vector<Selected> selected; ///< selected by whoever loaded the scene, in that order
    bool isUnityScene = false;      ///< true if it was read from a .unity file
    std::vector<Diagnostic> notes; ///< the parts of Unity's assets that were left out, and the like
};

/// Turns the objects to where they are at `seconds`. Whole turns are subtracted in double
/// precision, so that the angle is still accurate after days.
void TurnObjects(const std::vector<Turn>& turns, double seconds);

/// Returns what is wrong with the size that cameras draw in, or "" if nothing is. That size is
/// renderScale times the picture's.
std::string ScaledSizeProblem(const SceneAsset& scene);

/// The treatment of meshes, pictures and materials that only inactive objects use.
enum class InactiveObjects
{
    Load, ///< they are loaded, so that the objects may be switched on
    Check ///< they are looked for, and not decoded; such an object has no mesh and no material
};

/// Loads a scene from a *.scene.yaml file, from a .unity file, or from a folder that is a Unity
/// project. Paths in a *.scene.yaml file start from its folder, and lead into that folder, the
/// Unity project around it or another root of the assets. It sets the colour space of the process:
/// that of a Unity scene's project, else linear.
/// @throws AssetError with every problem of the file: broken YAML, unknown keys and names, values
///     of the wrong type or outside their range, and files it refers to that are missing or wrong,
///     with the errors of those files
SceneAsset LoadScene(const std::filesystem::path& path, AssetContext& assets,
                     InactiveObjects inactive = InactiveObjects::Load);

} // namespace limn
