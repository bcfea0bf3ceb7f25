#include "ScreenSpaceAmbientOcclusionPass.h"

#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRenderer.h>
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
    inspector.Field("AOMethod", AOMethod, k_Methods,
                    "How samples differ from pixel to pixel: blue noise looks the smoothest");
    inspector.Field("Downsample", Downsample,
                    "Occlusion is worked out for one pixel of four, and spread by the blur");
    inspector.Field("AfterOpaque", AfterOpaque,
                    "The picture of opaque objects is darkened as a whole; else their shaders "
                    "darken the ambient light that they add");
    inspector.Field("Source", Source, k_Sources,
                    "Depth needs no more than the depth texture; DepthNormals draws objects with "
                    "their normals before, and sees bumps");
    inspector.Field("NormalSamples", NormalSamples, k_NormalQualities,
                    "With Source Depth: how many neighbours a normal is worked out from");
    inspector.Field("Intensity", Intensity, k_NotNegative, "How dark it gets; 0 draws nothing");
    inspector.Field("DirectLightingStrength", DirectLightingStrength, ValueRange{0.0, 1.0},
                    "How much of it light of lamps and sun loses, too");
    inspector.Field("Radius", Radius, k_NotNegative,
                    "Metres within which one surface hides another; 0 draws nothing");
    inspector.Field("Samples", Samples, k_Qualities, "Of each pixel: 12, 8 or 4");
    inspector.Field("BlurQuality", BlurQuality, k_Qualities,
                    "High keeps to surfaces of one normal, Medium and Low cost less");
    inspector.Field("Falloff", Falloff, k_NotNegative,
                    "Metres from the camera at which it has faded to nothing; 0 draws nothing");
    inspector.Field("SampleCount", SampleCount, ValueRange{-1.0, 64.0},
                    "What files of URP 12 have in place of Samples; -1 in others");
}

ScreenSpaceAmbientOcclusion::ScreenSpaceAmbientOcclusion()
    : ScreenSpaceAmbientOcclusion(ScreenSpaceAmbientOcclusionSettings())
{
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
        renderingData.report->notes.push_back(name + ": not drawn, " + why);
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

} // namespace limn
