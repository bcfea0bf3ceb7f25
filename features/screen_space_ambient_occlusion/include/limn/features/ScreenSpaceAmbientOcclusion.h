#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <memory>
#include <string>

namespace limn
{

class ScreenSpaceAmbientOcclusionPass;

/// The settings of ScreenSpaceAmbientOcclusion, with the names and numbers that Unity serialises.
/// Unity: ScreenSpaceAmbientOcclusionSettings (URP 14).
struct ScreenSpaceAmbientOcclusionSettings
{
    /// How the samples differ from pixel to pixel.
    enum class AOMethodOptions
    {
        BlueNoise = 0,
        InterleavedGradient = 1
    };
    enum class DepthSource
    {
        Depth = 0,       ///< normals are worked out from the depth
        DepthNormals = 1 ///< objects are drawn with their normals first
    };
    enum class NormalQuality
    {
        Low = 0,
        Medium = 1,
        High = 2
    };
    enum class AOSampleOption
    {
        High = 0,   ///< 12
        Medium = 1, ///< 8
        Low = 2     ///< 4
    };
    enum class BlurQualityOptions
    {
        High = 0,   ///< three passes, along surfaces of one normal
        Medium = 1, ///< two passes
        Low = 2     ///< one pass
    };

    AOMethodOptions AOMethod = AOMethodOptions::BlueNoise;
    bool Downsample = false;  ///< half as many texels a side
    bool AfterOpaque = false; ///< over the picture, whatever its shaders do with ambient light
    DepthSource Source = DepthSource::DepthNormals;
    NormalQuality NormalSamples = NormalQuality::Medium; ///< of DepthSource::Depth
    float Intensity = 3.0f;                              ///< not negative; 0 = no pass
    float DirectLightingStrength = 0.25f;                ///< 0...1
    float Radius = 0.035f;                               ///< metres, not negative; 0 = no pass
    AOSampleOption Samples = AOSampleOption::Medium;
    BlurQualityOptions BlurQuality = BlurQualityOptions::High;
    float Falloff = 100.0f; ///< metres from the camera, not negative; 0 = no pass
    /// URP up to 12 has this in place of AOMethod and Samples; -1 = none. Create turns it into
    /// these.
    int SampleCount = -1;

    void Describe(Inspector& inspector);
};

/// Darkens what little ambient light reaches: creases, corners, where objects stand on others. Its
/// texture, _ScreenSpaceOcclusionTexture, is there for the shaders of a camera's objects while the
/// keyword _SCREEN_SPACE_OCCLUSION is on.
/// Unity: ScreenSpaceAmbientOcclusion (URP 14).
class ScreenSpaceAmbientOcclusion final : public ScriptableRendererFeature
{
public:
    ScreenSpaceAmbientOcclusion();
    explicit ScreenSpaceAmbientOcclusion(ScreenSpaceAmbientOcclusionSettings settings);
    ~ScreenSpaceAmbientOcclusion() override;

    ScreenSpaceAmbientOcclusionSettings m_Settings;

    void Create() override;
    /// Where intensity, radius or falloff is 0, nothing is drawn, no depth or normals are asked
    /// for, and the report says so.
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override;
    void Describe(Inspector& inspector) override { m_Settings.Describe(inspector); }

private:
    std::unique_ptr<ScreenSpaceAmbientOcclusionPass> m_SSAOPass; ///< made by the first frame
};

} // namespace limn
