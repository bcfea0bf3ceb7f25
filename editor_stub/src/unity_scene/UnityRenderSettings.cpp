#include "console/Texts.h"
#include "unity_scene/UnitySceneLoader.h"

#include <algorithm>
#include <bit>
#include <limn/core/QualitySettings.h>

namespace limn
{

namespace
{

constexpr float k_MostIntensity = 8.0f; ///< of Unity's inspector
constexpr float k_MostDistance = 1e9f;  ///< metres

/// Reads a member of an enum that has gaps, or begins behind 0.
template <typename Enum>
void ReadMember(const UnityReader& reader, const char* path, std::initializer_list<Enum> members,
                Enum& value)
{
    int number = static_cast<int>(value);
    reader.Read(path, number);
    if (std::ranges::find(members, static_cast<Enum>(number)) != members.end())
    {
        value = static_cast<Enum>(number);
        return;
    }
    const std::string known =
        Joined(members, ", ", [](Enum member) { return std::to_string(static_cast<int>(member)); });
    reader.Note(path, std::to_string(number) + " is none of " + known + ", so it is left at " +
                          std::to_string(static_cast<int>(value)));
}

void ReadAmbient(const UnityReader& reader, RenderSettings& settings)
{
    settings.ambientMode = AmbientMode::Skybox;
    ReadMember(reader, "m_AmbientMode",
               {AmbientMode::Skybox, AmbientMode::Trilight, AmbientMode::Flat, AmbientMode::Custom},
               settings.ambientMode);
    settings.ambientSkyColor = {0.212f, 0.227f, 0.259f, 1.0f};
    reader.Read("m_AmbientSkyColor", settings.ambientSkyColor);
    reader.Read("m_AmbientEquatorColor", settings.ambientEquatorColor);
    reader.Read("m_AmbientGroundColor", settings.ambientGroundColor);
    reader.ReadIn("m_AmbientIntensity", 0.0f, k_MostIntensity, settings.ambientIntensity);
    if (settings.ambientMode == AmbientMode::Custom)
    {
        reader.Note("m_AmbientMode", "custom light is in a file that limn does not read, so the "
                                     "light is m_AmbientSkyColor from all sides");
        settings.ambientMode = AmbientMode::Flat;
    }
    if (settings.ambientMode == AmbientMode::Skybox && !settings.skybox)
    {
        settings.ambientMode = AmbientMode::Flat; // as Unity's inspector offers it then
    }
    const bool isGamma = QualitySettings::activeColorSpace() == ColorSpace::Gamma;
    // In the project's colour space; the first is what Unity bakes for its default sky.
    const Color ofDefaultSky{0.18028f, 0.22571f, 0.30692f, 1.0f};
    Color average = isGamma ? ofDefaultSky.gamma() : ofDefaultSky;
    reader.Read("m_IndirectSpecularColor", average);
    settings.ambientProbe.Clear();
    settings.ambientProbe.AddAmbientLight(isGamma ? average.linear() : average);
}

void ReadReflections(const UnityReader& reader, UnityMaterials& materials, RenderSettings& settings)
{
    settings.defaultReflectionMode = DefaultReflectionMode::Skybox;
    ReadMember(reader, "m_DefaultReflectionMode",
               {DefaultReflectionMode::Skybox, DefaultReflectionMode::Custom},
               settings.defaultReflectionMode);
    const UnityTarget cube = reader.Reference("m_CustomReflection");
    if (settings.defaultReflectionMode == DefaultReflectionMode::Custom && !cube.isNull())
    {
        settings.customReflectionTexture = materials.LoadReflection(cube.asset, reader);
    }
    int resolution = settings.defaultReflectionResolution;
    reader.Read("m_DefaultReflectionResolution", resolution);
    if (resolution >= 1 && resolution <= 2048 &&
        std::has_single_bit(static_cast<unsigned>(resolution)))
    {
        settings.defaultReflectionResolution = resolution;
    }
    else
    {
        reader.Note("m_DefaultReflectionResolution",
                    std::to_string(resolution) +
                        " is no power of two from 1 to 2048, so it is left at " +
                        std::to_string(settings.defaultReflectionResolution));
    }
    reader.ReadIn("m_ReflectionIntensity", 0.0f, k_MostIntensity, settings.reflectionIntensity);
}

void ReadFog(const UnityReader& reader, RenderSettings& settings)
{
    reader.Read("m_Fog", settings.fog);
    ReadMember(reader, "m_FogMode",
               {FogMode::Linear, FogMode::Exponential, FogMode::ExponentialSquared},
               settings.fogMode);
    reader.Read("m_FogColor", settings.fogColor);
    reader.ReadIn("m_FogDensity", 0.0f, 1e6f, settings.fogDensity);
    reader.ReadIn("m_LinearFogStart", -k_MostDistance, k_MostDistance, settings.fogStartDistance);
    reader.ReadIn("m_LinearFogEnd", -k_MostDistance, k_MostDistance, settings.fogEndDistance);
}

} // namespace

void ReadUnityRenderSettings(const UnityReader& reader, UnityMaterials& materials,
                             RenderSettings& settings)
{
    const UnityTarget skybox = reader.Reference("m_SkyboxMaterial");
    if (!skybox.asset.isNull())
    {
        settings.skybox = materials.LoadSkybox(skybox.asset, reader);
    }
    ReadAmbient(reader, settings);
    ReadReflections(reader, materials, settings);
    ReadFog(reader, settings);
}

} // namespace limn
