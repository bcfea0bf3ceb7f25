#include "unity/UnitySceneLoader.h"

#include <algorithm>

namespace limn
{

namespace
{

float Luminance(const Color& color)
{
    return 0.2126f * color.r + 0.7152f * color.g + 0.0722f * color.b;
}

/// @return whether it shines in a picture
bool ReadLight(UnitySceneLoader& loader, const UnityGameObject& object,
               const UnityInstance& component, Light& light)
{
    const UnityReader reader = loader.ReaderOf(object, component);
    bool isEnabled = true;
    int type = 1;
    reader.Read("m_Enabled", isEnabled);
    reader.Read("m_Type", type);
    int baked = 4;
    reader.Read("m_Lightmapping", baked);
    if (isEnabled && (type > 2 || baked == 2))
    {
        loader.notes.Count("baked and area lights");
    }
    if (!isEnabled || type < 0 || type > 2 || baked == 2)
    {
        return false;
    }
    light.type = static_cast<LightType>(type);
    light.transform.localPosition = object.drawn->transform.position();
    light.transform.localRotation = object.drawn->transform.rotation();
    reader.Read("m_Color", light.color);
    reader.ReadIn("m_Intensity", 0.0f, 1e9f, light.intensity);
    reader.ReadIn("m_Range", 1e-3f, 1e9f, light.range);
    reader.ReadIn("m_SpotAngle", 1.0f, 179.0f, light.spotAngle);
    light.innerSpotAngle = std::min(light.innerSpotAngle, light.spotAngle);
    reader.ReadIn("m_InnerSpotAngle", 0.0f, light.spotAngle, light.innerSpotAngle);
    reader.ReadEnum("m_Shadows.m_Type", LightShadows::Soft, light.shadows);
    reader.ReadIn("m_Shadows.m_Strength", 0.0f, 1.0f, light.shadowStrength);
    reader.ReadIn("m_Shadows.m_Bias", 0.0f, 10.0f, light.shadowBias);
    reader.ReadIn("m_Shadows.m_NormalBias", 0.0f, 10.0f, light.shadowNormalBias);
    reader.ReadIn("m_Shadows.m_NearPlane", 0.01f, 1e9f, light.shadowNearPlane);
    if (!reader.Reference("m_Cookie").isNull())
    {
        loader.notes.Count("cookies of lights");
    }
    if (const UnityInstance* data = object.FindScript(k_LightData))
    {
        loader.ReaderOf(object, *data).Read("m_UsePipelineSettings", light.usePipelineSettings);
    }
    return true;
}

void SetMainLight(const Light& light, DirectionalLight& main)
{
    main.direction = light.transform.localRotation * glm::vec3(0.0f, 0.0f, 1.0f);
    main.color = light.color;
    main.intensity = light.intensity;
    main.shadows = light.shadows;
    main.shadowStrength = light.shadowStrength;
    main.usePipelineSettings = light.usePipelineSettings;
    main.shadowBias = light.shadowBias;
    main.shadowNormalBias = light.shadowNormalBias;
}

} // namespace

void ReadUnityLights(UnitySceneLoader& loader, const UnityInstance* sun)
{
    bool isSun = false; // the main light so far is the sun
    std::optional<Light> main;
    loader.asset.scene.mainLight.intensity = 0.0f;
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        const UnityInstance* component = object->Find(UnityClass::Light);
        if (component == nullptr || !object->isActive)
        {
            continue;
        }
        Light light;
        if (!ReadLight(loader, *object, *component, light))
        {
            continue;
        }
        const bool isBrighter = light.type == LightType::Directional &&
                                (!main || component == sun ||
                                 (!isSun && Luminance(light.color) * light.intensity >
                                                Luminance(main->color) * main->intensity));
        if (!isBrighter)
        {
            loader.asset.scene.additionalLights.push_back(std::move(light));
            continue;
        }
        if (main)
        {
            loader.asset.scene.additionalLights.push_back(std::move(*main));
        }
        isSun = component == sun;
        main = std::move(light);
    }
    if (main)
    {
        SetMainLight(*main, loader.asset.scene.mainLight);
    }
}

} // namespace limn
