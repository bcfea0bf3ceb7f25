#include <algorithm>
#include <bit>
#include <cmath>
#include <limn/base/NumberText.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/features/WideOutlineRendererFeature.h>

namespace limn
{

namespace
{

/// The passes in the order of the shader file.
struct WideOutlineShaderPass
{
    enum
    {
        Mask,
        CutoutMask,
        Seeds,
        Flood,
        Columns,
        CompositeFlood,
        CompositeColumns
    };
};

constexpr int k_WideMaskSamples = 4;
/// Up to this many pixels two loops cost less than a flood.
constexpr int k_SeparableReach = 8;

const ShaderPropertyId _WideOutlineSource = Shader::PropertyToID("_BlitTexture");
const ShaderPropertyId _WideOutlineSize = Shader::PropertyToID("_WideOutlineSize");
const ShaderPropertyId _WideOutlineCorner = Shader::PropertyToID("_WideOutlineCorner");
const ShaderPropertyId _WideOutlineRange = Shader::PropertyToID("_WideOutlineRange");
const ShaderPropertyId _WideOutlineStep = Shader::PropertyToID("_WideOutlineStep");
const ShaderPropertyId _WideOutlineAside = Shader::PropertyToID("_WideOutlineAside");
const ShaderPropertyId _WideOutlineObjects = Shader::PropertyToID("_WideOutlineObjects");
const ShaderPropertyId _WideOutlineBand = Shader::PropertyToID("_WideOutlineBand");
const ShaderPropertyId _WideOutlineSeeds = Shader::PropertyToID("_WideOutlineSeeds");
const ShaderPropertyId _WideOutlineOuterColor = Shader::PropertyToID("_WideOutlineOuterColor");
const ShaderPropertyId _WideOutlineFalloff = Shader::PropertyToID("_WideOutlineFalloff");
const ShaderPropertyId _WideOutlineColor = Shader::PropertyToID("_WideOutlineColor");

constexpr EnumEntry k_WideMethods[] = {{"Auto", 0}, {"JumpFlood", 1}, {"Separable", 2}};
constexpr EnumEntry k_WideOcclusions[] = {{"All", 0}, {"Visible", 1}};

void RequireNumberOfWideOutline(const char* name, float value)
{
    if (!std::isfinite(value))
    {
        throw ContractError(std::string("WideOutline.") + name + " is " +
                            NumberText(static_cast<double>(value)) + "; it must be a number");
    }
}

bool IsCutout(const OutlinedObject& object)
{
    return IsAlphaTested(*object.item.material);
}

/// Returns the properties with which a material cuts holes.
MaterialPropertyBlock CutoutOf(const Material& material)
{
    static const ShaderPropertyId names[] = {
        Shader::PropertyToID("_BaseMap"), Shader::PropertyToID("_BaseMap_ST"),
        Shader::PropertyToID("_BaseColor"), Shader::PropertyToID("_Cutoff")};
    MaterialPropertyBlock block;
    for (const ShaderPropertyId name : names)
    {
        if (const ShaderPropertyValue* value = material.Find(name))
        {
            block.Set(name, *value);
        }
    }
    return block;
}

} // namespace

float WideOutline::reach() const
{
    const float width = m_OutlineWidth.value();
    if (width <= 0.0f)
    {
        return 0.0f;
    }
    switch (m_Side.value())
    {
    case WideOutlineSide::Outer:
        return m_Gap.value() + width;
    case WideOutlineSide::Centred:
        return m_Gap.value() + 0.5f * width;
    case WideOutlineSide::Inner:
        break;
    }
    return 1.0f; // what is smoothed at the edge
}

void WideOutlineSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    inspector.Header("Wide Outline");
    inspector.Field("m_Method", m_Method, k_WideMethods,
                    "The method that finds distances; the errors are alike, the times are not");
    inspector.Field("m_Occlusion", m_Occlusion, k_WideOcclusions,
                    "The treatment of objects that stand in front of an outlined one");
    DescribeGrouping(inspector, m_Grouping);
}

WideOutlineRenderPass::WideOutlineRenderPass(const std::string& featureName,
                                             const WideOutlineSettings& settings,
                                             std::shared_ptr<const Shader> shader)
    : OutlineTechniquePass(featureName, settings, std::move(shader)), m_Settings(settings)
{
    const bool isCut = settings.m_Occlusion == WideOutlineOcclusion::Visible;
    ConfigureInput(isCut ? ScriptableRenderPassInput::Depth : ScriptableRenderPassInput::None);
    // The camera's depth is one value a pixel: where an object hides a part of another one, samples
    // of the latter are lost between the two.
    m_Material->SetFloat(Shader::PropertyToID("_WideOutlineClosesSlits"), isCut ? 1.0f : 0.0f);
    if (isCut)
    {
        m_Material->EnableKeyword("_VISIBLE_ONLY");
    }
}

std::string WideOutlineRenderPass::Setup(const WideOutline& component, RenderingData& renderingData)
{
    const CameraData& camera = renderingData.cameraData;
    const glm::ivec2 picture(camera.cameraTargetDescriptor.width,
                             camera.cameraTargetDescriptor.height);
    SetBand(component, picture);

    FindOutlinedObjects(renderingData, m_Settings, m_Settings.m_Grouping, m_Found);
    if (m_Found.objects.empty())
    {
        return m_Found.why;
    }
    m_Groups.clear();
    glm::ivec2 size(0);
    ForEachGroup(m_Found.objects,
                 [&](std::span<const OutlinedObject> objects)
                 {
                     if (const auto region = FindOutlineRegion(objects, camera, m_Farthest))
                     {
                         m_Groups.push_back({objects, *region});
                         size = glm::max(size, region->size);
                     }
                 });
    // One size for all, so that the groups share their textures.
    for (Group& group : m_Groups)
    {
        group.region.size = size;
    }
    return m_Groups.empty() ? "no outline reaches into the picture" : "";
}

void WideOutlineRenderPass::SetBand(const WideOutline& component, const glm::ivec2& picture)
{
    RequireNumberOfWideOutline("m_Gap", component.m_Gap.value());
    RequireNumberOfWideOutline("m_Falloff", component.m_Falloff.value());
    if (std::isnan(component.m_OutlineWidth.value()))
    {
        RequireNumberOfWideOutline("m_OutlineWidth", component.m_OutlineWidth.value());
    }
    const float diagonal = std::hypot(static_cast<float>(picture.x), static_cast<float>(picture.y));
    const float width = std::max(component.WidthWithin(picture), 1e-3f);
    const float gap = std::min(component.m_Gap.value(), diagonal + 1.0f);
    const WideOutlineSide side = component.m_Side.value();
    const float low = side == WideOutlineSide::Outer     ? gap
                      : side == WideOutlineSide::Centred ? gap - 0.5f * width
                                                         : -gap - width;
    const float high = low + width;
    m_Farthest = std::max(std::abs(low), std::abs(high));
    m_Reach = static_cast<int>(std::ceil(m_Farthest + 1.0f));
    m_Method = m_Settings.m_Method != WideOutlineMethod::Auto ? m_Settings.m_Method
               : m_Reach <= k_SeparableReach                  ? WideOutlineMethod::Separable
                                                              : WideOutlineMethod::JumpFlood;

    const float nearest = std::min(std::abs(low), std::abs(high));
    m_Material->SetFloat(_WideOutlineAside, nearest > 0.0f ? nearest : 0.5f * m_Farthest);
    m_Material->SetFloat(_WideOutlineRange, static_cast<float>(m_Reach) + 1.0f);
    const float start = side == WideOutlineSide::Outer   ? low
                        : side == WideOutlineSide::Inner ? high
                                                         : 0.5f * (low + high);
    const float length = side == WideOutlineSide::Centred ? 0.5f * width : width;
    m_Material->SetVector(_WideOutlineBand, {low, high, start, 1.0f / length});
    m_Material->SetColor(_WideOutlineColor, component.m_OutlineColor.value());
    m_Material->SetVector(
        _WideOutlineOuterColor,
        glm::mix(
            CoreUtils::ConvertSRGBToActiveColorSpace(component.m_OutlineColor.value()).vector(),
            CoreUtils::ConvertSRGBToActiveColorSpace(component.m_OuterColor.value()).vector(),
            component.m_Gradient.value()));
    m_Material->SetFloat(_WideOutlineFalloff, component.m_Falloff.value());
}

void WideOutlineRenderPass::OnCameraSetup(CommandBuffer&, RenderingData&)
{
    const OutlineRegion& region = m_Groups.front().region;
    region.Allocate(m_Mask, GraphicsFormat::R8_UNorm, "_WideOutlineMask", k_WideMaskSamples);
    region.Allocate(m_Seeds, GraphicsFormat::R16G16B16A16_UNorm, "_WideOutlineSeeds");
    if (m_Method == WideOutlineMethod::JumpFlood)
    {
        region.Allocate(m_FloodA, GraphicsFormat::R16G16_UNorm, "_WideOutlineFloodA");
        region.Allocate(m_FloodB, GraphicsFormat::R16G16_UNorm, "_WideOutlineFloodB");
    }
    else
    {
        region.Allocate(m_Columns, GraphicsFormat::R16G16B16A16_UNorm, "_WideOutlineColumns");
    }
    const glm::vec2 size(region.size);
    m_Material->SetVector(_WideOutlineSize, {1.0f / size, size});
}

void WideOutlineRenderPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    {
        const ProfilingScope scope{*cmd, profilingSampler};
        for (const Group& group : m_Groups)
        {
            DrawMask(context, *cmd, renderingData, group);
            DrawWhole(*cmd, m_Mask, m_Seeds, WideOutlineShaderPass::Seeds, 1.0f);
            if (m_Method == WideOutlineMethod::JumpFlood)
            {
                Composite(*cmd, renderingData, group, Flood(*cmd),
                          WideOutlineShaderPass::CompositeFlood);
            }
            else
            {
                DrawWhole(*cmd, m_Seeds, m_Columns, WideOutlineShaderPass::Columns,
                          static_cast<float>(m_Reach));
                Composite(*cmd, renderingData, group, m_Columns,
                          WideOutlineShaderPass::CompositeColumns);
            }
            context.ExecuteCommandBuffer(*cmd);
            cmd->Clear();
        }
    }
    context.ExecuteCommandBuffer(*cmd);
}

void WideOutlineRenderPass::DrawMask(ScriptableRenderContext& context, CommandBuffer& cmd,
                                     const RenderingData& renderingData, const Group& group)
{
    const CameraData& camera = renderingData.cameraData;
    const glm::vec2 picture(group.region.picture);
    m_Material->SetVector(_WideOutlineCorner, {glm::vec2(group.region.corner), 1.0f / picture});
    m_Material->SetVector(_WideOutlineObjects, {glm::vec2(group.region.objectsBegin) + 0.5f,
                                                glm::vec2(group.region.objectsEnd) - 0.5f});

    CoreUtils::SetRenderTarget(cmd, m_Mask, ClearFlag::Color, Color::clear);
    SetRegionProjection(cmd, group.region, camera);
    const bool isPlain = std::ranges::none_of(group.objects, IsCutout);
    if (isPlain && m_Settings.m_Grouping == OutlineGrouping::Together)
    {
        context.ExecuteCommandBuffer(cmd);
        cmd.Clear();
        DrawFiltered(context, renderingData, m_Settings.filtering(), WideOutlineShaderPass::Mask);
    }
    else
    {
        for (const OutlinedObject& object : group.objects)
        {
            const bool isCutout = IsCutout(object);
            cmd.DrawRenderer(*object.item.object, m_Material, object.item.subMesh,
                             isCutout ? WideOutlineShaderPass::CutoutMask
                                      : WideOutlineShaderPass::Mask,
                             isCutout ? CutoutOf(*object.item.material) : MaterialPropertyBlock());
        }
    }
    SetCameraProjection(cmd, camera);
    context.ExecuteCommandBuffer(cmd);
    cmd.Clear();
}

const RTHandle& WideOutlineRenderPass::Flood(CommandBuffer& cmd)
{
    // A step of 1 first: it takes away nearly all of what a flood gets wrong.
    const auto largest = std::bit_ceil(static_cast<unsigned>(m_Reach) + 1) / 2;
    DrawWhole(cmd, m_Seeds, m_FloodA, WideOutlineShaderPass::Flood, 1.0f);
    const RTHandle* source = &m_FloodA;
    const RTHandle* target = &m_FloodB;
    for (unsigned step = largest; step > 0; step /= 2)
    {
        DrawWhole(cmd, *source, *target, WideOutlineShaderPass::Flood, static_cast<float>(step));
        std::swap(source, target);
    }
    return *source;
}

void WideOutlineRenderPass::Composite(CommandBuffer& cmd, const RenderingData& renderingData,
                                      const Group& group, const RTHandle& source, int pass)
{
    CoreUtils::SetRenderTarget(cmd, renderingData.cameraData.renderer->cameraColorTargetHandle());
    cmd.SetViewport(group.region.InPicture());
    m_Properties.Clear();
    m_Properties.SetTexture(_WideOutlineSource, source.rt());
    m_Properties.SetTexture(_WideOutlineSeeds, m_Seeds.rt());
    m_Properties.SetFloat(_WideOutlineStep, static_cast<float>(m_Reach));
    cmd.DrawProcedural(glm::mat4(1.0f), m_Material, pass, 3, m_Properties);
}

void WideOutlineRenderPass::DrawWhole(CommandBuffer& cmd, const RTHandle& source,
                                      const RTHandle& target, int pass, float step)
{
    CoreUtils::SetRenderTarget(cmd, target);
    m_Properties.Clear();
    m_Properties.SetTexture(_WideOutlineSource, source.rt());
    m_Properties.SetFloat(_WideOutlineStep, step);
    cmd.DrawProcedural(glm::mat4(1.0f), m_Material, pass, 3, m_Properties);
}

void RegisterWideOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<WideOutlineRendererFeature>(
        "WideOutlineRendererFeature",
        {{.name = "Separable",
          .summary = "distance to the edge, by columns and then by rows",
          .place = 20,
          .component = "WideOutline",
          .settings = {"Outline.m_Method=Separable"}},
         {.name = "Jump flood",
          .summary = "distance to the edge, by jump flooding",
          .place = 30,
          .component = "WideOutline",
          .settings = {"Outline.m_Method=JumpFlood"}}});
    components.Register<WideOutline>("WideOutline");
}

} // namespace limn
