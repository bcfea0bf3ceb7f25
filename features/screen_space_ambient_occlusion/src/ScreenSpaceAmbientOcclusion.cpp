#include "ScreenSpaceAmbientOcclusionPass.h"

#include <limn/core/Inspector.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

namespace
{

constexpr EnumEntry k_Methods[] = {{"BlueNoise", 0}, {"InterleavedGradient", 1}};
constexpr EnumEntry k_Sources[] = {{"Depth", 0}, {"DepthNormals", 1}};
constexpr EnumEntry k_NormalQualities[] = {{"Low", 0}, {"Medium", 1}, {"High", 2}};
constexpr EnumEntry k_Qualities[] = {{"High", 0}, {"Medium", 1}, {"Low", 2}};
constexpr ValueRange k_NotNegative{0.0};

/// Returns why nothing is drawn; "" = something is.
std::string WhyIdle(const ScreenSpaceAmbientOcclusionSettings& settings)
{
    const std::pair<const char*, float> factors[] = {{"Intensity", settings.Intensity},
                                                     {"Radius", settings.Radius},
                                                     {"Falloff", settings.Falloff}};
    for (const auto& [setting, value] : factors)
    {
        if (!(value > 0.0f))
        {
            return std::string(setting) + " is " + (value == 0.0f ? "0" : "not above 0");
        }
    }
    return "";
}

} // namespace

void ScreenSpaceAmbientOcclusionSettings::Describe(Inspector& inspector)
{
    inspector.Field(
        "AOMethod", AOMethod, k_Methods,
        "The variation of the samples from pixel to pixel; blue noise gives the smoothest picture");
    inspector.Field("Downsample", Downsample,
                    "Computes the occlusion for one pixel of four; the blur spreads it");
    inspector.Field("AfterOpaque", AfterOpaque,
                    "On: the whole picture of opaque objects is darkened; off: their shaders "
                    "darken the ambient light only");
    inspector.Field("Source", Source, k_Sources,
                    "Depth needs only the depth texture; DepthNormals draws the normals of objects "
                    "first and sees their bumps");
    inspector.Field("NormalSamples", NormalSamples, k_NormalQualities,
                    "Source Depth: the number of neighbours from which a normal is computed");
    inspector.Field("Intensity", Intensity, k_NotNegative,
                    "The strength of the darkening; 0 draws nothing");
    inspector.Field("DirectLightingStrength", DirectLightingStrength, ValueRange{0.0, 1.0},
                    "The share of the darkening that lamps and the sun get, too");
    inspector.Field(
        "Radius", Radius, k_NotNegative,
        "The distance in metres within which one surface darkens another; 0 draws nothing");
    inspector.Field("Samples", Samples, k_Qualities,
                    "The number of samples of each pixel: 12, 8 or 4");
    inspector.Field(
        "BlurQuality", BlurQuality, k_Qualities,
        "The kind of blur: High does not blur across normals, Medium and Low cost less");
    inspector.Field(
        "Falloff", Falloff, k_NotNegative,
        "The distance in metres from the camera at which the occlusion ends; 0 draws nothing");
    inspector.Field("SampleCount", SampleCount, ValueRange{-1.0, 64.0},
                    "The setting that files of URP 12 have in place of Samples; others have -1");
}

ScreenSpaceAmbientOcclusion::ScreenSpaceAmbientOcclusion(
    ScreenSpaceAmbientOcclusionSettings settings)
    : m_Settings(settings)
{
    name = "ScreenSpaceAmbientOcclusion";
}

ScreenSpaceAmbientOcclusion::~ScreenSpaceAmbientOcclusion() = default;

void ScreenSpaceAmbientOcclusion::Create()
{
    using Settings = ScreenSpaceAmbientOcclusionSettings;
    m_SSAOPass.reset();
    if (m_Settings.SampleCount > 0) // as URP 14 does with settings of URP 12
    {
        m_Settings.AOMethod = Settings::AOMethodOptions::InterleavedGradient;
        m_Settings.Samples = m_Settings.SampleCount > 11  ? Settings::AOSampleOption::High
                             : m_Settings.SampleCount > 8 ? Settings::AOSampleOption::Medium
                                                          : Settings::AOSampleOption::Low;
        m_Settings.SampleCount = -1;
    }
}

void ScreenSpaceAmbientOcclusion::AddRenderPasses(ScriptableRenderer& renderer,
                                                  RenderingData& renderingData)
{
    const std::string why = WhyIdle(m_Settings);
    if (!why.empty())
    {
        renderingData.report->notes.push_back(name + ": it is not drawn; " + why);
        return;
    }
    if (!m_SSAOPass)
    {
        m_SSAOPass = std::make_unique<ScreenSpaceAmbientOcclusionPass>(
            name, FindTechniqueShader(renderer, ScreenSpaceAmbientOcclusionPass::k_Shader));
    }
    m_SSAOPass->Setup(m_Settings, renderingData.cameraData);
    renderer.EnqueuePass(*m_SSAOPass);
}

void RegisterScreenSpaceAmbientOcclusion(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<ScreenSpaceAmbientOcclusion>("ScreenSpaceAmbientOcclusion");
}

} // namespace limn
