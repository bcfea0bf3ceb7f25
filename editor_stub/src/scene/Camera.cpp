#include "scene/Loader.h"
#include "settings/ReadValues.h"

namespace limn
{

namespace
{

void ReadDirection(SceneMapReader& map, Camera& camera, AssetDiagnostics& diagnostics)
{
    glm::vec3 target(0.0f);
    const YamlNode* rotation = map.Find("rotation");
    const YamlNode* lookAt = map.Find("lookAt");
    if (rotation && lookAt)
    {
        diagnostics.Error(lookAt->location(),
                          map.SubjectOf("lookAt") +
                              ": the camera has a rotation already; keep one of them");
        return;
    }
    map.Read("rotation", camera.transform.localRotation);
    if (map.Read("lookAt", target))
    {
        const glm::vec3 forward = target - camera.transform.localPosition;
        const bool hasDirection = glm::dot(forward, forward) > 0.0f; // not so close that it is 0
        if (!hasDirection)
        {
            diagnostics.Error(lookAt->location(),
                              map.SubjectOf("lookAt") +
                                  ": this is the camera's own position; a point in front of it is "
                                  "expected");
            return;
        }
        camera.transform.localRotation = LookRotation(forward);
    }
}

void ReadLens(SceneMapReader& map, Camera& camera, AssetDiagnostics& diagnostics)
{
    map.Read("orthographic", camera.orthographic);
    map.Read("orthographicSize", camera.orthographicSize);
    map.Read("fieldOfView", camera.fieldOfView);
    const double nearest = camera.orthographic ? scene_keys::k_ClipPlanes.min : 1e-4;
    map.ReadFrom(nearest, "nearClipPlane", camera.nearClipPlane);
    const bool hasFar = map.ReadFrom(nearest, "farClipPlane", camera.farClipPlane);
    if (camera.farClipPlane <= camera.nearClipPlane)
    {
        const YamlNode* node = map.Find(hasFar ? "farClipPlane" : "nearClipPlane");
        diagnostics.Error(node ? node->location() : map.node().location(),
                          map.SubjectOf("farClipPlane") + ": " + NumberText(camera.farClipPlane) +
                              " is not greater than nearClipPlane, which is " +
                              NumberText(camera.nearClipPlane));
    }
}

void ReadSorting(SceneMapReader& map, Camera& camera, AssetDiagnostics& diagnostics)
{
    map.Read("transparencySortMode", k_TransparencySortModes, camera.transparencySortMode);
    const bool hasAxis = map.Read("transparencySortAxis", camera.transparencySortAxis);
    if (hasAxis && camera.transparencySortAxis == glm::vec3(0.0f))
    {
        diagnostics.Error(map.Find("transparencySortAxis")->location(),
                          map.SubjectOf("transparencySortAxis") +
                              ": it has no direction; a vector other than 0 is expected");
    }
}

template <typename AnyLight>
void ReadLightShadows(SceneMapReader& map, AnyLight& light)
{
    map.Read("shadows", k_LightShadows, light.shadows);
    map.Read("shadowStrength", light.shadowStrength);
    map.Read("softShadowQuality", k_LightShadowQualities, light.softShadowQuality);
    map.Read("usePipelineSettings", light.usePipelineSettings);
    map.Read("shadowBias", light.shadowBias);
    map.Read("shadowNormalBias", light.shadowNormalBias);
}

/// Reads the keys that base cameras and overlays have in common.
void ReadView(SceneMapReader& map, Camera& camera, SceneLoader& loader)
{
    AssetDiagnostics& diagnostics = loader.diagnostics;
    map.Read("position", camera.transform.localPosition);
    ReadDirection(map, camera, diagnostics);
    ReadLens(map, camera, diagnostics);
    map.Read("renderPostProcessing", camera.renderPostProcessing);
    ReadLayerMask(map, "cullingMask", loader.layers(), diagnostics, camera.cullingMask);
    ReadLayerMask(map, "volumeLayerMask", loader.layers(), diagnostics, camera.volumeLayerMask);
    glm::vec3 trigger(0.0f);
    if (map.Read("volumeTrigger", trigger))
    {
        camera.volumeTrigger = trigger;
    }
    ReadSorting(map, camera, diagnostics);
}

void ReadStack(SceneMapReader& base, SceneLoader& loader)
{
    for (const auto& [item, place] : ReadItems(base, "cameraStack", loader.diagnostics))
    {
        SceneMapReader map(item, place, scene_keys::k_OverlayCamera, loader.diagnostics);
        const auto overlay = std::make_shared<Camera>();
        overlay->renderType = CameraRenderType::Overlay;
        overlay->renderPostProcessing = false; // or effects would come twice
        ReadView(map, *overlay, loader);
        map.Read("clearDepth", overlay->clearDepth);
        map.Finish();
        loader.asset.camera.cameraStack.push_back(overlay);
    }
}

} // namespace

void ReadCamera(const YamlNode& node, SceneLoader& loader)
{
    Camera& camera = loader.asset.camera;
    AssetDiagnostics& diagnostics = loader.diagnostics;
    SceneMapReader map(node, "camera", scene_keys::k_Camera, diagnostics);
    ReadView(map, camera, loader);
    map.Read("clearFlags", k_ClearFlags, camera.clearFlags);
    map.Read("backgroundColor", camera.backgroundColor);
    map.Read("antialiasing", k_AntialiasingModes, camera.antialiasing);
    map.Read("allowHDR", camera.allowHDR);
    map.Read("allowMSAA", camera.allowMSAA);
    ReadStack(map, loader);
    map.Finish();
}

void ReadLight(const YamlNode& node, SceneLoader& loader)
{
    DirectionalLight& light = loader.asset.scene.mainLight;
    SceneMapReader map(node, "light", scene_keys::k_Light, loader.diagnostics);
    glm::quat rotation = glm::identity<glm::quat>();
    if (map.Read("rotation", rotation))
    {
        light.direction = rotation * glm::vec3(0.0f, 0.0f, 1.0f);
    }
    map.Read("color", light.color);
    map.Read("intensity", light.intensity);
    ReadLightShadows(map, light);
    map.Finish();
}

void ReadLights(const YamlNode& node, SceneLoader& loader)
{
    for (const auto& [item, place] : ReadItems(node, "lights", loader.diagnostics))
    {
        SceneMapReader map(item, place, scene_keys::k_AdditionalLight, loader.diagnostics);
        Light light;
        map.Read("type", k_LightTypes, light.type);
        map.Read("position", light.transform.localPosition);
        map.Read("rotation", light.transform.localRotation);
        map.Read("color", light.color);
        map.Read("intensity", light.intensity);
        map.Read("range", light.range);
        map.Read("spotAngle", light.spotAngle);
        map.Read("innerSpotAngle", light.innerSpotAngle);
        ReadLightShadows(map, light);
        map.Read("shadowNearPlane", light.shadowNearPlane);
        map.Read("additionalLightsShadowResolutionTier", k_ShadowResolutionTiers,
                 light.additionalLightsShadowResolutionTier);
        map.Read("shadowResolution", light.shadowResolution);
        map.Finish();
        loader.asset.scene.additionalLights.push_back(std::move(light));
    }
}

} // namespace limn
