#include <algorithm>
#include <bit>
#include <cmath>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/Bloom.h>
#include <limn/features/ColorAdjustments.h>
#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/PostProcessRendererFeature.h>
#include <limn/features/Tonemapping.h>
#include <limn/features/Vignette.h>
#include <limn/volume/VolumeStack.h>

namespace limn
{

namespace
{

enum BloomShaderPass
{
    Prefilter,
    BlurHorizontal,
    BlurVertical,
    Upsample
};

const ShaderPropertyId _SourceTexLowMip{"_SourceTexLowMip"};
const ShaderPropertyId _Params{"_Params"};
const ShaderPropertyId _Bloom_Texture{"_Bloom_Texture"};
const ShaderPropertyId _Bloom_Params{"_Bloom_Params"};
const ShaderPropertyId _LensDirt_Texture{"_LensDirt_Texture"};
const ShaderPropertyId _LensDirt_Params{"_LensDirt_Params"};
const ShaderPropertyId _Vignette_Params1{"_Vignette_Params1"};
const ShaderPropertyId _Vignette_Params2{"_Vignette_Params2"};
const ShaderPropertyId _ColorFilter{"_ColorFilter"};
const ShaderPropertyId _HueSatCon{"_HueSatCon"};
const ShaderPropertyId _PostExposure{"_PostExposure"};
const glm::vec4 k_WholeTexture{1.0f, 1.0f, 0.0f, 0.0f};

template <typename Component>
const Component* FindActive(const VolumeStackPointer& stack)
{
    const Component* component = stack->GetComponent<Component>();
    return component != nullptr && component->active && component->IsActive() ? component : nullptr;
}

glm::vec3 Channels(const Color& color)
{
    return glm::vec3(color.vector());
}

/// Returns the tint with the brightness that every colour gets.
glm::vec3 Tint(const Bloom& bloom)
{
    const glm::vec3 tint = Channels(bloom.tint.value().linear());
    const float luminance = glm::dot(tint, glm::vec3(0.2126729f, 0.7151522f, 0.0721750f));
    return luminance > 0.0f ? tint / luminance : glm::vec3(1.0f);
}

/// The last camera of a stack smooths what all of them have drawn.
bool isSmoothed(const RenderingData& renderingData)
{
    const CameraData& camera = renderingData.cameraData;
    return camera.antialiasing == AntialiasingMode::FastApproximateAntialiasing &&
           camera.resolveFinalTarget && renderingData.postProcessingEnabled;
}

constexpr EnumEntry k_ColorGradingModes[] = {{"LowDynamicRange", 0}, {"HighDynamicRange", 1}};

} // namespace

/// The effects that the camera's stack switches on; null = off.
struct ActiveEffects
{
    const Bloom* bloom;
    const Vignette* vignette;
    const ColorAdjustments* colorAdjustments;
    const Tonemapping* tonemapping;

    bool any() const { return bloom || vignette || colorAdjustments || tonemapping; }
};

/// Draws the active effects. Textures: _BloomMipDown<i>, _BloomMipUp<i> [H / 2^(i+1), W / 2^(i+1)],
/// B10G11R11_UFloatPack32; _UberPost [H, W], in the format of the camera's colour.
/// Unity: PostProcessPass (URP 14).
class PostProcessPass final : public ScriptableRenderPass
{
public:
    PostProcessPass(const std::string& featureName, std::shared_ptr<const Shader> bloom,
                    std::shared_ptr<const Shader> uber);

    /// @param effects  must have at least one effect
    void Setup(const ActiveEffects& effects, ColorGradingMode grading,
               const CameraData& cameraData);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    struct BloomMip
    {
        RTHandle down;
        RTHandle up;
    };

    void SetupBloom(const Bloom* bloom, const glm::ivec2& picture);
    void SetupDirt(const Bloom& bloom, const glm::ivec2& picture);
    void SetupVignette(const Vignette* vignette, const glm::ivec2& picture);
    void SetupGrading(const ActiveEffects& effects, bool isHdr);
    /// @return the texture with the glow
    const RTHandle& DrawBloom(CommandBuffer& cmd, const RTHandle& color) const;

    std::shared_ptr<Material> m_BloomMaterial;
    std::shared_ptr<Material> m_UberMaterial;
    std::vector<BloomMip> m_BloomMips; ///< from the largest on; kept while bloom is off
    std::size_t m_BloomMipCount = 0;   ///< the number of mips that are drawn; 0 without bloom
    glm::ivec2 m_BloomSize{0};         ///< the size of the largest
    RTHandle m_Result;
};

/// Smooths the finished picture, behind the passes that features add after post-processing.
/// Unity: PostProcessPass, as the renderer's finalPostProcessPass (URP 14).
class FinalPostProcessPass final : public ScriptableRenderPass
{
public:
    FinalPostProcessPass(const std::string& featureName, std::shared_ptr<const Shader> finalPost)
        : m_Material(CoreUtils::CreateEngineMaterial(std::move(finalPost)))
    {
        profilingSampler = ProfilingSampler(featureName + " FXAA");
        renderPassEvent = RenderPassEvent::AfterRenderingPostProcessing;
    }

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        Blit(*cmd, renderingData, m_Material);
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    std::shared_ptr<Material> m_Material;
};

PostProcessPass::PostProcessPass(const std::string& featureName,
                                 std::shared_ptr<const Shader> bloom,
                                 std::shared_ptr<const Shader> uber)
    : m_BloomMaterial(CoreUtils::CreateEngineMaterial(std::move(bloom))),
      m_UberMaterial(CoreUtils::CreateEngineMaterial(std::move(uber)))
{
    profilingSampler = ProfilingSampler(featureName);
    renderPassEvent = RenderPassEvent::BeforeRenderingPostProcessing;
}

void PostProcessPass::Setup(const ActiveEffects& effects, ColorGradingMode grading,
                            const CameraData& cameraData)
{
    const RenderTextureDescriptor& camera = cameraData.cameraTargetDescriptor;
    const glm::ivec2 picture(camera.width, camera.height);
    SetupBloom(effects.bloom, picture);
    SetupVignette(effects.vignette, picture);
    SetupGrading(effects, grading == ColorGradingMode::HighDynamicRange && cameraData.isHdrEnabled);
}

void PostProcessPass::SetupBloom(const Bloom* bloom, const glm::ivec2& picture)
{
    const bool isHighQuality = bloom != nullptr && bloom->highQualityFiltering.value();
    CoreUtils::SetKeyword(*m_UberMaterial, "_BLOOM_LQ", bloom != nullptr && !isHighQuality);
    CoreUtils::SetKeyword(*m_UberMaterial, "_BLOOM_HQ", isHighQuality);
    CoreUtils::SetKeyword(*m_BloomMaterial, "_BLOOM_HQ", isHighQuality);
    m_BloomMipCount = 0;
    if (bloom == nullptr)
    {
        m_UberMaterial->DisableKeyword("_BLOOM_DIRT");
        return;
    }
    m_BloomSize =
        glm::max(bloom->downscale.value() == BloomDownscaleMode::Half ? picture / 2 : picture / 4,
                 glm::ivec2(1));
    const auto longest = static_cast<unsigned>(std::max(m_BloomSize.x, m_BloomSize.y));
    const int halvings = static_cast<int>(std::bit_width(longest)) - 2; // down to 2 or 3 texels
    m_BloomMipCount =
        static_cast<std::size_t>(std::clamp(halvings, 1, bloom->maxIterations.value()));

    const float threshold = Color{bloom->threshold.value(), 0, 0, 0}.linear().r;
    const float scatter = 0.05f + 0.9f * bloom->scatter.value();
    m_BloomMaterial->SetVector(_Params,
                               {scatter, bloom->clamp.value(), threshold, 0.5f * threshold});
    m_UberMaterial->SetVector(_Bloom_Params, glm::vec4(bloom->intensity.value() * Tint(*bloom),
                                                       bloom->dirtIntensity.value()));
    SetupDirt(*bloom, picture);
}

void PostProcessPass::SetupDirt(const Bloom& bloom, const glm::ivec2& picture)
{
    const std::shared_ptr<const Texture>& dirt = bloom.dirtTexture.value().asset;
    const bool isSeen = dirt && bloom.dirtIntensity.value() > 0.0f;
    CoreUtils::SetKeyword(*m_UberMaterial, "_BLOOM_DIRT", isSeen);
    if (!isSeen)
    {
        return;
    }
    // The dirt is as large as the picture; the part that is too long is cut off on both sides.
    const glm::vec2 texture(dirt->width(), dirt->height());
    const float ratio = texture.x / texture.y * static_cast<float>(picture.y) /
                        static_cast<float>(picture.x); // of the dirt's shape to the picture's
    const glm::vec2 scale(std::min(1.0f / ratio, 1.0f), std::min(ratio, 1.0f));
    m_UberMaterial->SetTexture(_LensDirt_Texture, dirt);
    m_UberMaterial->SetVector(_LensDirt_Params, glm::vec4(scale, 0.5f * (1.0f - scale)));
}

void PostProcessPass::SetupVignette(const Vignette* vignette, const glm::ivec2& picture)
{
    CoreUtils::SetKeyword(*m_UberMaterial, "_VIGNETTE", vignette != nullptr);
    if (vignette == nullptr)
    {
        return;
    }
    // The colour as it stands, though it is sRGB: as URP takes it.
    const float aspect = static_cast<float>(picture.x) / static_cast<float>(picture.y);
    m_UberMaterial->SetVector(
        _Vignette_Params1,
        glm::vec4(Channels(vignette->color.value()), vignette->rounded.value() ? aspect : 1.0f));
    m_UberMaterial->SetVector(_Vignette_Params2,
                              {vignette->center.value(), 3.0f * vignette->intensity.value(),
                               5.0f * vignette->smoothness.value()});
}

void PostProcessPass::SetupGrading(const ActiveEffects& effects, bool isHdr)
{
    const TonemappingMode mode =
        effects.tonemapping ? effects.tonemapping->mode.value() : TonemappingMode::None;
    CoreUtils::SetKeyword(*m_UberMaterial, "_TONEMAP_NEUTRAL", mode == TonemappingMode::Neutral);
    CoreUtils::SetKeyword(*m_UberMaterial, "_TONEMAP_ACES", mode == TonemappingMode::ACES);
    CoreUtils::SetKeyword(*m_UberMaterial, "_HDR_GRADING", isHdr);
    const ColorAdjustments* adjustments = effects.colorAdjustments;
    CoreUtils::SetKeyword(*m_UberMaterial, "_COLOR_ADJUSTMENTS", adjustments != nullptr);
    m_UberMaterial->SetFloat(_PostExposure,
                             adjustments ? std::exp2(adjustments->postExposure.value()) : 1.0f);
    if (adjustments == nullptr)
    {
        return;
    }
    m_UberMaterial->SetVector(_ColorFilter, adjustments->colorFilter.value().linear().vector());
    m_UberMaterial->SetVector(_HueSatCon, {adjustments->hueShift.value() / 360.0f,
                                           1.0f + adjustments->saturation.value() / 100.0f,
                                           1.0f + adjustments->contrast.value() / 100.0f, 0.0f});
}

void PostProcessPass::OnCameraSetup(CommandBuffer&, RenderingData& renderingData)
{
    RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
    descriptor.depthBufferBits = 0;
    descriptor.msaaSamples = 1;
    descriptor.memoryless = RenderTextureMemoryless::Color; // no next frame reads them
    const auto allocate = [&](RTHandle& handle, const std::string& textureName)
    {
        RenderingUtils::ReAllocateIfNeeded(handle, descriptor, FilterMode::Bilinear,
                                           TextureWrapMode::Clamp, textureName);
    };
    allocate(m_Result, "_UberPost");
    descriptor.graphicsFormat = GraphicsFormat::B10G11R11_UFloatPack32;
    m_BloomMips.resize(std::max(m_BloomMips.size(), m_BloomMipCount));
    glm::ivec2 size = m_BloomSize;
    for (std::size_t i = 0; i < m_BloomMipCount; ++i)
    {
        descriptor.width = size.x;
        descriptor.height = size.y;
        allocate(m_BloomMips[i].down, "_BloomMipDown" + std::to_string(i));
        allocate(m_BloomMips[i].up, "_BloomMipUp" + std::to_string(i));
        size = glm::max(size / 2, glm::ivec2(1));
    }
}

void PostProcessPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    const RTHandle& color = renderingData.cameraData.renderer->cameraColorTargetHandle();
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    MaterialPropertyBlock properties;
    if (m_BloomMipCount > 0)
    {
        properties.SetTexture(_Bloom_Texture, DrawBloom(*cmd, color).rt());
    }
    properties.SetTexture(Blitter::BlitShaderIDs::_BlitTexture, color.rt());
    properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias, k_WholeTexture);
    CoreUtils::SetRenderTarget(*cmd, m_Result);
    CoreUtils::DrawFullScreen(*cmd, m_UberMaterial, properties);
    Blit(*cmd, m_Result, color);
    context.ExecuteCommandBuffer(*cmd);
}

const RTHandle& PostProcessPass::DrawBloom(CommandBuffer& cmd, const RTHandle& color) const
{
    const auto blit = [&](const RTHandle& source, const RTHandle& target, BloomShaderPass pass)
    {
        Blitter::BlitCameraTexture(cmd, source, target, m_BloomMaterial, pass);
    };
    blit(color, m_BloomMips[0].down, Prefilter);
    for (std::size_t i = 1; i < m_BloomMipCount; ++i)
    {
        blit(m_BloomMips[i - 1].down, m_BloomMips[i].up, BlurHorizontal);
        blit(m_BloomMips[i].up, m_BloomMips[i].down, BlurVertical);
    }
    const RTHandle* sum = &m_BloomMips[m_BloomMipCount - 1].down;
    for (std::size_t i = m_BloomMipCount - 1; i-- > 0;)
    {
        MaterialPropertyBlock properties;
        properties.SetTexture(Blitter::BlitShaderIDs::_BlitTexture, m_BloomMips[i].down.rt());
        properties.SetTexture(_SourceTexLowMip, sum->rt());
        properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias, k_WholeTexture);
        CoreUtils::SetRenderTarget(cmd, m_BloomMips[i].up);
        CoreUtils::DrawFullScreen(cmd, m_BloomMaterial, properties, Upsample);
        sum = &m_BloomMips[i].up;
    }
    return *sum;
}

PostProcessRendererFeature::PostProcessRendererFeature()
{
    name = "PostProcessRendererFeature";
}

PostProcessRendererFeature::~PostProcessRendererFeature() = default;

void PostProcessRendererFeature::Create()
{
    m_Pass.reset();
    m_FinalPass.reset();
}

void PostProcessRendererFeature::AddRenderPasses(ScriptableRenderer& renderer,
                                                 RenderingData& renderingData)
{
    AddEffects(renderer, renderingData);
    if (isSmoothed(renderingData))
    {
        if (!m_FinalPass)
        {
            m_FinalPass = std::make_unique<FinalPostProcessPass>(
                name, FindTechniqueShader(renderer, "Hidden/Universal Render Pipeline/FinalPost"));
        }
        renderer.EnqueuePass(*m_FinalPass);
    }
}

void PostProcessRendererFeature::AddEffects(ScriptableRenderer& renderer,
                                            RenderingData& renderingData)
{
    const VolumeStackPointer& stack = renderingData.volumeStack;
    const ActiveEffects effects{FindActive<Bloom>(stack), FindActive<Vignette>(stack),
                                FindActive<ColorAdjustments>(stack),
                                FindActive<Tonemapping>(stack)};
    const bool isEnabled = renderingData.cameraData.postProcessEnabled;
    if (!effects.any() && (!isEnabled || isSmoothed(renderingData)))
    {
        return; // nobody asks for more
    }
    if (!effects.any() || !isEnabled)
    {
        renderingData.report->notes.push_back(
            name + ": it is not drawn; " +
            (isEnabled ? "no volume switches Bloom, Vignette, ColorAdjustments or Tonemapping on"
                       : "the camera's renderPostProcessing is off"));
        return;
    }
    if (!m_Pass)
    {
        m_Pass = std::make_unique<PostProcessPass>(
            name, FindTechniqueShader(renderer, "Hidden/Universal Render Pipeline/Bloom"),
            FindTechniqueShader(renderer, "Hidden/Universal Render Pipeline/UberPost"));
    }
    m_Pass->Setup(effects, m_ColorGradingMode, renderingData.cameraData);
    renderer.EnqueuePass(*m_Pass);
}

void PostProcessRendererFeature::Describe(Inspector& inspector)
{
    inspector.Field("m_ColorGradingMode", m_ColorGradingMode, k_ColorGradingModes,
                    "The place of colour grading: before or after tonemapping");
}

void RegisterPostProcess(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<PostProcessRendererFeature>("PostProcessRendererFeature");
    components.Register<Bloom>("Bloom");
    components.Register<ColorAdjustments>("ColorAdjustments");
    components.Register<Tonemapping>("Tonemapping");
    components.Register<Vignette>("Vignette");
}

} // namespace limn
