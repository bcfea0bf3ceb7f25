#include <limn/features/ColorEdgesPass.h>

#include <algorithm>
#include <cmath>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/ColorEdgesRendererFeature.h>
#include <limn/features/OutlinedObjects.h>

namespace limn
{

namespace
{

// Names that no other technique has: a library may be compiled as one translation unit.
constexpr int k_ColorEdgesMask = 0;
constexpr int k_ColorEdgesBrightness = 1;
constexpr int k_ColorEdgesLines = 2;
constexpr float k_SharpestRamp = 1e-6f; ///< less than two brightnesses of a texture differ by

const ShaderPropertyId _ColorEdgesColor{"_ColorEdgesColor"};
const ShaderPropertyId _ColorEdgesMask{"_ColorEdgesMask"};
const ShaderPropertyId _ColorEdgesTaps{"_ColorEdgesTaps"};
const ShaderPropertyId _ColorEdgesReach{"_ColorEdgesReach"};
const ShaderPropertyId _ColorEdgesRamp{"_ColorEdgesRamp"};

constexpr const char* k_ColorEdgesKeywords[] = {"_ROBERTS", "_SOBEL",
                                                "_PREWITT"}; // by EdgeOperator

/// Rows of taps, `width` texels apart: the first, the last, the middle. On texels where the width
/// is whole, so that a line gets as wide as it says; in between one of the two moves evenly.
glm::vec4 ColorEdgesTaps(float width)
{
    const float whole = std::floor(width);
    const float part = width - whole;
    const float half = std::floor(whole * 0.5f);
    const bool isEven = half * 2.0f == whole;
    const float before = half + (isEven ? 0.0f : part);
    const float behind = half + (isEven ? part : 1.0f);
    return {-before, behind, (behind - before) * 0.5f, 0.0f};
}

} // namespace

void ColorEdgesSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    inspector.Field("m_OnlyFilteredObjects", m_OnlyFilteredObjects,
                    "Whether lines are drawn only where a filtered object is seen, or else all "
                    "over the picture");
}

ColorEdgesPass::ColorEdgesPass(const std::string& featureName, const ColorEdgesSettings& settings,
                               std::shared_ptr<const Shader> shader)
    : m_Settings(settings), m_Material(CoreUtils::CreateEngineMaterial(std::move(shader)))
{
    profilingSampler = ProfilingSampler(featureName);
    renderPassEvent = settings.m_RenderPassEvent;
}

std::string ColorEdgesPass::Setup(const ColorEdges& component, const RenderingData& renderingData)
{
    if (m_Settings.m_OnlyFilteredObjects)
    {
        std::string why =
            FindOutlinedObjects(renderingData, m_Settings, OutlineGrouping::Together).why;
        if (!why.empty())
        {
            return why;
        }
    }
    const RenderTextureDescriptor& camera = renderingData.cameraData.cameraTargetDescriptor;
    const glm::vec4 taps = ColorEdgesTaps(component.WidthWithin({camera.width, camera.height}));
    const float ramp = std::max(component.m_Softness.value(), k_SharpestRamp);
    m_Material->SetVector(_ColorEdgesTaps, taps);
    m_Material->SetFloat(_ColorEdgesReach, taps.y);
    m_Material->SetVector(_ColorEdgesRamp, {component.m_Threshold.value(), 1.0f / ramp, 0, 0});
    m_Material->SetColor(_ColorEdgesColor, component.m_OutlineColor.value());
    SetOperator(component.m_Operator.value());
    return "";
}

void ColorEdgesPass::SetOperator(EdgeOperator edgeOperator)
{
    const auto chosen = static_cast<std::size_t>(edgeOperator);
    if (chosen >= std::size(k_ColorEdgesKeywords))
    {
        throw ContractError("ColorEdges.m_Operator is " + std::to_string(chosen) +
                            "; it must be Roberts 0, Sobel 1 or Prewitt 2");
    }
    for (const char* keyword : k_ColorEdgesKeywords)
    {
        m_Material->DisableKeyword(keyword);
    }
    m_Material->EnableKeyword(k_ColorEdgesKeywords[chosen]);
}

void ColorEdgesPass::OnCameraSetup(CommandBuffer&, RenderingData& renderingData)
{
    RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
    descriptor.depthBufferBits = 0;
    std::shared_ptr<const Texture> mask = DefaultTexture("white");
    if (m_Settings.m_OnlyFilteredObjects) // as many samples as the depth that it is tested against
    {
        descriptor.graphicsFormat = GraphicsFormat::R8_UNorm;
        RenderingUtils::ReAllocateIfNeeded(m_Mask, descriptor, FilterMode::Point,
                                           TextureWrapMode::Clamp, "_ColorEdgesMask");
        mask = m_Mask.rt();
    }
    m_Material->SetTexture(_ColorEdgesMask, std::move(mask));
    descriptor.graphicsFormat = GraphicsFormat::R16_SFloat;
    descriptor.msaaSamples = 1;
    RenderingUtils::ReAllocateIfNeeded(m_Brightness, descriptor, FilterMode::Bilinear,
                                       TextureWrapMode::Clamp, "_ColorEdgesBrightness");
}

void ColorEdgesPass::DrawMask(ScriptableRenderContext& context,
                              const RenderingData& renderingData) const
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    CoreUtils::SetRenderTarget(*cmd, m_Mask,
                               renderingData.cameraData.renderer->cameraDepthTargetHandle(),
                               ClearFlag::Color, Color::clear);
    context.ExecuteCommandBuffer(*cmd);
    DrawingSettings drawing =
        CreateDrawingSettings(ForwardShaderTags(), renderingData, SortingCriteria::CommonOpaque);
    drawing.overrideMaterial = m_Material;
    drawing.overrideMaterialPassIndex = k_ColorEdgesMask;
    context.DrawRenderers(renderingData.cullResults, drawing, m_Settings.filtering());
}

void ColorEdgesPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    if (m_Settings.m_OnlyFilteredObjects)
    {
        DrawMask(context, renderingData);
    }
    const RTHandle& color = renderingData.cameraData.renderer->cameraColorTargetHandle();
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    Blitter::BlitCameraTexture(*cmd, color, m_Brightness, m_Material, k_ColorEdgesBrightness);
    Blitter::BlitCameraTexture(*cmd, m_Brightness, color, m_Material, k_ColorEdgesLines);
    context.ExecuteCommandBuffer(*cmd);
}

} // namespace limn
