#include "scene/Loader.h"
#include "settings/ReadEnum.h"

namespace limn
{

namespace
{

void ReadDirection(SceneMapReader& map, Camera& camera, AssetDiagnostics& diagnostics)
{
    glm::vec3 degrees(0.0f);
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
    if (map.Read("rotation", degrees))
    {
        camera.transform.localRotation = EulerToRotation(degrees);
    }
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
    if (const YamlNode* node = map.Find("transparencySortMode"))
    {
        const auto mode = ReadEnum(*node, k_TransparencySortModes,
                                   map.SubjectOf("transparencySortMode"), diagnostics);
        camera.transparencySortMode =
            mode ? static_cast<TransparencySortMode>(*mode) : camera.transparencySortMode;
    }
    const bool hasAxis = map.Read("transparencySortAxis", camera.transparencySortAxis);
    if (hasAxis && camera.transparencySortAxis == glm::vec3(0.0f))
    {
        diagnostics.Error(map.Find("transparencySortAxis")->location(),
                          map.SubjectOf("transparencySortAxis") +
                              ": it has no direction; a vector other than 0 is expected");
    }
}

template <typename AnyLight>
void ReadLightShadows(SceneMapReader& map, AnyLight& light, AssetDiagnostics& diagnostics)
{
    if (const YamlNode* node = map.Find("shadows"))
    {
        const auto value = ReadEnum(*node, k_LightShadows, map.SubjectOf("shadows"), diagnostics);
        light.shadows = value ? static_cast<LightShadows>(*value) : light.shadows;
    }
    map.Read("shadowStrength", light.shadowStrength);
    if (const YamlNode* node = map.Find("softShadowQuality"))
    {
        const auto value = ReadEnum(*node, k_LightShadowQualities,
                                    map.SubjectOf("softShadowQuality"), diagnostics);
        light.softShadowQuality =
            value ? static_cast<SoftShadowQuality>(*value) : light.softShadowQuality;
    }
    map.Read("usePipelineSettings", light.usePipelineSettings);
    map.Read("shadowBias", light.shadowBias);
    map.Read("shadowNormalBias", light.shadowNormalBias);
}

/// What base cameras and overlays have in common.
void ReadView(SceneMapReader& map, Camera& camera, SceneLoader& loader)
{
    AssetDiagnostics& diagnostics = loader.diagnostics;
    map.Read("position", camera.transform.localPosition);
    ReadDirection(map, camera, diagnostics);
    ReadLens(map, camera, diagnostics);
    map.Read("renderPostProcessing", camera.renderPostProcessing);
    for (const auto& [key, mask] : {std::pair("cullingMask", &camera.cullingMask),
                                    std::pair("volumeLayerMask", &camera.volumeLayerMask)})
    {
        if (const YamlNode* layers = map.Find(key))
        {
            const auto bits =
                ReadLayerBits(*layers, map.SubjectOf(key), loader.layers(), diagnostics);
            *mask = LayerMask(bits.value_or(mask->bits));
        }
    }
    glm::vec3 trigger(0.0f);
    if (map.Read("volumeTrigger", trigger))
    {
        camera.volumeTrigger = trigger;
    }
    ReadSorting(map, camera, diagnostics);
}

void ReadStack(const YamlNode& node, SceneLoader& loader)
{
    int index = 0;
    for (const YamlNode& item : ReadItems(node, "camera.cameraStack", loader.diagnostics))
    {
        SceneMapReader map(item, "camera.cameraStack[" + std::to_string(index++) + "]",
                           scene_keys::k_OverlayCamera, loader.diagnostics);
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
    if (const YamlNode* flags = map.Find("clearFlags"))
    {
        const auto value = ReadEnum(*flags, k_ClearFlags, "camera.clearFlags", diagnostics);
        camera.clearFlags = value ? static_cast<CameraClearFlags>(*value) : camera.clearFlags;
    }
    map.Read("backgroundColor", camera.backgroundColor);
    map.Read("allowHDR", camera.allowHDR);
    map.Read("allowMSAA", camera.allowMSAA);
    if (const YamlNode* stack = map.Find("cameraStack"))
    {
        ReadStack(*stack, loader);
    }
    map.Finish();
}

void ReadLight(const YamlNode& node, SceneLoader& loader)
{
    DirectionalLight& light = loader.asset.scene.mainLight;
    SceneMapReader map(node, "light", scene_keys::k_Light, loader.diagnostics);
    glm::vec3 degrees(0.0f);
    if (map.Read("rotation", degrees))
    {
        light.direction = EulerToRotation(degrees) * glm::vec3(0.0f, 0.0f, 1.0f);
    }
    map.Read("color", light.color);
    map.Read("intensity", light.intensity);
    ReadLightShadows(map, light, loader.diagnostics);
    map.Finish();
}

void ReadLights(const YamlNode& node, SceneLoader& loader)
{
    AssetDiagnostics& diagnostics = loader.diagnostics;
    int index = 0;
    for (const YamlNode& item : ReadItems(node, "lights", diagnostics))
    {
        const std::string subject = "lights[" + std::to_string(index++) + "]";
        SceneMapReader map(item, subject, scene_keys::k_AdditionalLight, diagnostics);
        Light light;
        if (const YamlNode* type = map.Find("type"))
        {
            const auto value = ReadEnum(*type, k_LightTypes, subject + ".type", diagnostics);
            light.type = value ? static_cast<LightType>(*value) : light.type;
        }
        map.Read("position", light.transform.localPosition);
        glm::vec3 degrees(0.0f);
        if (map.Read("rotation", degrees))
        {
            light.transform.localRotation = EulerToRotation(degrees);
        }
        map.Read("color", light.color);
        map.Read("intensity", light.intensity);
        map.Read("range", light.range);
        map.Read("spotAngle", light.spotAngle);
        map.Read("innerSpotAngle", light.innerSpotAngle);
        ReadLightShadows(map, light, diagnostics);
        map.Read("shadowNearPlane", light.shadowNearPlane);
        if (const YamlNode* tierNode = map.Find("additionalLightsShadowResolutionTier"))
        {
            using Tier = AdditionalLightsShadowResolutionTier;
            const auto tier =
                ReadEnum(*tierNode, k_ShadowResolutionTiers,
                         map.SubjectOf("additionalLightsShadowResolutionTier"), diagnostics);
            light.additionalLightsShadowResolutionTier =
                tier ? static_cast<Tier>(*tier) : light.additionalLightsShadowResolutionTier;
        }
        map.Read("shadowResolution", light.shadowResolution);
        map.Finish();
        loader.asset.scene.additionalLights.push_back(std::move(light));
    }
}

} // namespace limn
