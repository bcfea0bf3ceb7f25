#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <memory>

namespace limn
{

class ScreenSpaceAmbientOcclusionPass;

/// The settings of ScreenSpaceAmbientOcclusion, with the names and numbers that Unity serialises.
/// Unity: ScreenSpaceAmbientOcclusionSettings (URP 14).
struct ScreenSpaceAmbientOcclusionSettings
{
    /// The pattern by which the samples differ from pixel to pixel.
    enum class AOMethodOptions
    {
        BlueNoise = 0,
        InterleavedGradient = 1
    };
    enum class DepthSource
    {
        Depth = 0,       ///< normals are computed from the depth
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
    bool Downsample = false; ///< uses half as many texels per side
    /// Darkens the finished picture, whatever its shaders do with ambient light.
    bool AfterOpaque = false;
    DepthSource Source = DepthSource::DepthNormals;
    /// The quality of the normals of DepthSource::Depth.
    NormalQuality NormalSamples = NormalQuality::Medium;
    float Intensity = 3.0f;               ///< not negative; 0 = no pass
    float DirectLightingStrength = 0.25f; ///< 0...1
    float Radius = 0.035f;                ///< metres, not negative; 0 = no pass
    AOSampleOption Samples = AOSampleOption::Medium;
    BlurQualityOptions BlurQuality = BlurQualityOptions::High;
    float Falloff = 100.0f; ///< metres from the camera, not negative; 0 = no pass
    /// The setting that URP up to 12 has in place of AOMethod and Samples; -1 = none. Create
    /// converts it into these.
    int SampleCount = -1;

    void Describe(Inspector& inspector);
};

/// Darkens places that little ambient light reaches: creases, corners, and where objects stand on
/// others. The shaders of a camera's objects can read its texture, _ScreenSpaceOcclusionTexture,
/// while the keyword _SCREEN_SPACE_OCCLUSION is on. Unity: ScreenSpaceAmbientOcclusion (URP 14).
class ScreenSpaceAmbientOcclusion final : public ScriptableRendererFeature
{
public:
    explicit ScreenSpaceAmbientOcclusion(ScreenSpaceAmbientOcclusionSettings settings = {});
    ~ScreenSpaceAmbientOcclusion() override;

    ScreenSpaceAmbientOcclusionSettings m_Settings;

    void Create() override;
    /// Adds the passes. If intensity, radius or falloff is 0, nothing is drawn, no depth or normals
    /// are required, and the report says so.
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override;
    void Describe(Inspector& inspector) override { m_Settings.Describe(inspector); }

private:
    std::unique_ptr<ScreenSpaceAmbientOcclusionPass> m_SSAOPass; ///< made by the first frame
};

} // namespace limn
