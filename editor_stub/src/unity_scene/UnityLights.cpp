#include "unity_scene/UnitySceneLoader.h"

#include <algorithm>
#include <glm/common.hpp>
#include <optional>

namespace limn
{

namespace
{

float Luminance(const Color& color)
{
    return 0.2126f * color.r + 0.7152f * color.g + 0.0722f * color.b;
}

/// Multiplies the light's colour by that of its temperature, where it and the project use it.
void ReadTemperature(const UnityReader& reader, UnitySceneLoader& loader, Light& light)
{
    bool isUsed = false;
    reader.Read("m_UseColorTemperature", isUsed);
    const std::string_view project =
        loader.ProjectSettings("GraphicsSettings.asset")["m_LightsUseColorTemperature"].text();
    if (!isUsed || project == "0")
    {
        return;
    }
    float kelvin = 6570.0f;
    reader.ReadIn("m_ColorTemperature", 1000.0f, 20000.0f, kelvin);
    const glm::vec3 color = glm::vec3(light.color.linear().vector()) * BlackBodyColor(kelvin);
    light.color = Color{color.r, color.g, color.b, light.color.a}.gamma();
}

/// @return nothing if it does not shine in a picture
std::optional<Light> ReadLight(UnitySceneLoader& loader, const UnityGameObject& object,
                               const UnityInstance& component)
{
    Light light;
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
        return std::nullopt;
    }
    light.type = static_cast<LightType>(type);
    light.transform.localPosition = object.drawn->transform.position();
    light.transform.localRotation = object.drawn->transform.rotation();
    reader.Read("m_Color", light.color);
    ReadTemperature(reader, loader, light);
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
    return light;
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

glm::vec3 BlackBodyColor(float kelvin)
{
    const double t = 1000.0 / std::clamp(static_cast<double>(kelvin), 1667.0, 25000.0);
    const double x = kelvin < 4000.0f
                         ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                         : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
    const double y =
        kelvin < 2222.0f   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
        : kelvin < 4000.0f ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                           : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    const double X = x / y;
    const double Z = (1.0 - x - y) / y;
    const glm::dvec3 rgb = glm::max(glm::dvec3(3.2404542 * X - 1.5371385 - 0.4985314 * Z,
                                               -0.9692660 * X + 1.8760108 + 0.0415560 * Z,
                                               0.0556434 * X - 0.2040259 + 1.0572252 * Z),
                                    0.0);
    return glm::vec3(rgb / std::max({rgb.r, rgb.g, rgb.b}));
}

void ReadUnityLights(UnitySceneLoader& loader, const UnityInstance* sun)
{
    bool isSun = false; // the main light so far is the sun
    std::optional<Light> main;
    loader.asset.scene.mainLight.intensity = 0.0f;
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        const UnityInstance* component = object->Find(UnityClass::Light);
        std::optional<Light> light = component != nullptr && object->isActive
                                         ? ReadLight(loader, *object, *component)
                                         : std::nullopt;
        if (!light)
        {
            continue;
        }
        const bool isBrighter = light->type == LightType::Directional &&
                                (!main || component == sun ||
                                 (!isSun && Luminance(light->color) * light->intensity >
                                                Luminance(main->color) * main->intensity));
        if (isBrighter)
        {
            isSun = component == sun;
            main.swap(light);
        }
        if (light)
        {
            loader.asset.scene.additionalLights.push_back(std::move(*light));
        }
    }
    if (main)
    {
        SetMainLight(*main, loader.asset.scene.mainLight);
    }
}

} // namespace limn
