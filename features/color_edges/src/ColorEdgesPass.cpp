#include <limn/features/ColorEdgesRendererFeature.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/features/OutlineRegion.h>

namespace limn
{

namespace
{

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

/// The first and the last of taps `width` texels apart. On texels where the width is whole, so that
/// a line gets as wide as it says; in between one of the two moves evenly.
glm::vec2 ColorEdgesTaps(float width)
{
    const float whole = std::floor(width);
    const float part = width - whole;
    const float half = std::floor(whole * 0.5f);
    const bool isEven = half * 2.0f == whole;
    return {-half - (isEven ? 0.0f : part), half + (isEven ? part : 1.0f)};
}

/// Returns the offsets of the columns (xz) and rows (yw). They are at most half the picture apart:
/// with a greater distance both taps of a pixel can lie beside an object in the middle of the
/// picture, whose lines are then lost.
glm::vec4 ColorEdgesTaps(float width, const glm::ivec2& picture)
{
    const auto within = [&](int side)
    {
        return ColorEdgesTaps(std::min(width, static_cast<float>(std::max(side / 2, 1))));
    };
    const glm::vec2 columns = within(picture.x);
    const glm::vec2 rows = within(picture.y);
    return {columns.x, rows.x, columns.y, rows.y};
}

} // namespace

void ColorEdgesSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    inspector.Field(
        "m_OnlyFilteredObjects", m_OnlyFilteredObjects,
        "On: lines are drawn only where a filtered object is seen; off: all over the picture");
}

std::string ColorEdgesPass::Setup(const ColorEdges& component, const RenderingData& renderingData)
{
    const CameraData& camera = renderingData.cameraData;
    const glm::ivec2 picture(camera.cameraTargetDescriptor.width,
                             camera.cameraTargetDescriptor.height);
    const glm::vec4 taps = ColorEdgesTaps(component.m_OutlineWidth.value(), picture);
    m_Part = {0, 0, picture.x, picture.y};
    if (m_Settings.m_OnlyFilteredObjects)
    {
        FindOutlinedObjects(renderingData, m_Settings, OutlineGrouping::Together, m_Found);
        if (m_Found.objects.empty())
        {
            return m_Found.why;
        }
        const auto region = FindOutlineRegion(m_Found.objects, camera, std::max(taps.z, taps.w));
        m_Part = region ? region->InPicture() : ViewportRect{};
        if (m_Part.width == 0 || m_Part.height == 0)
        {
            return "no filtered object is in the picture";
        }
    }
    SetMaterial(component, taps);
    return "";
}

void ColorEdgesPass::SetMaterial(const ColorEdges& component, const glm::vec4& taps)
{
    const float ramp = std::max(component.m_Softness.value(), k_SharpestRamp);
    m_Material->SetVector(_ColorEdgesTaps, taps);
    m_Material->SetFloat(_ColorEdgesReach, std::max(taps.z, taps.w));
    m_Material->SetVector(_ColorEdgesRamp, {component.m_Threshold.value(), 1.0f / ramp, 0, 0});
    m_Material->SetColor(_ColorEdgesColor, component.m_OutlineColor.value());
    EnableOneOf(k_ColorEdgesKeywords, static_cast<std::size_t>(component.m_Operator.value()),
                "ColorEdges.m_Operator", "Roberts 0, Sobel 1 or Prewitt 2");
    const bool hasMiddle = component.m_Operator.value() != EdgeOperator::Roberts;
    const glm::vec2 middle = 0.5f * (glm::vec2(taps.x, taps.y) + glm::vec2(taps.z, taps.w));
    const bool isWhole = taps == glm::floor(taps) && (!hasMiddle || middle == glm::floor(middle));
    isWhole ? m_Material->DisableKeyword("_BETWEEN_TEXELS")
            : m_Material->EnableKeyword("_BETWEEN_TEXELS");
}

void ColorEdgesPass::OnCameraSetup(CommandBuffer&, RenderingData& renderingData)
{
    RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
    descriptor.depthBufferBits = 0;
    descriptor.memoryless = RenderTextureMemoryless::Color; // no next frame reads them
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
    DrawFiltered(context, renderingData, m_Settings.filtering(), k_ColorEdgesMask);
}

void ColorEdgesPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    if (m_Settings.m_OnlyFilteredObjects)
    {
        DrawMask(context, renderingData);
    }
    const RTHandle& color = renderingData.cameraData.renderer->cameraColorTargetHandle();
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    BlitPart(*cmd, color, m_Brightness, k_ColorEdgesBrightness);
    BlitPart(*cmd, m_Brightness, color, k_ColorEdgesLines);
    context.ExecuteCommandBuffer(*cmd);
}

void ColorEdgesPass::BlitPart(CommandBuffer& cmd, const RTHandle& source, const RTHandle& target,
                              int shaderPass) const
{
    const glm::vec4 size(source.rt()->width(), source.rt()->height(), source.rt()->width(),
                         source.rt()->height());
    CoreUtils::SetRenderTarget(cmd, target);
    if (m_Settings.m_OnlyFilteredObjects)
    {
        cmd.SetViewport(m_Part);
    }
    Blitter::BlitTexture(cmd, source,
                         glm::vec4(m_Part.width, m_Part.height, m_Part.x, m_Part.y) / size,
                         m_Material, shaderPass);
}

void RegisterColorEdges(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<ColorEdgesRendererFeature>(
        "ColorEdgesRendererFeature", {{.name = "Color edges",
                                       .summary = "steps of the picture's brightness",
                                       .noWidth = "its lines lie on both sides of an edge",
                                       .place = 110,
                                       .component = "ColorEdges"}});
    components.Register<ColorEdges>("ColorEdges");
}

} // namespace limn
