#include <cmath>
#include <limn/core/Inspector.h>
#include <limn/features/SelectionOutlineRendererFeature.h>

namespace limn
{

namespace
{

constexpr float k_ArticlesWidth = 14.0f; // seven blurs of two pixels
constexpr EnumEntry k_Stencils[] = {{"DrawRenderer", 0}, {"HighlightLayer", 1}};

} // namespace

SelectionOutline::SelectionOutline()
{
    m_OutlineWidth.SetValue(k_ArticlesWidth);
}

float SelectionOutline::tapOffset() const
{
    return offsetScale.value() > 0.0f ? offsetScale.value()
                                      : m_OutlineWidth.value() / static_cast<float>(blurCount());
}

SelectionOutlineSettings::SelectionOutlineSettings()
    : startTimes(std::make_shared<std::unordered_map<const Transform*, double>>())
{
    m_RenderPassEvent = RenderPassEvent::BeforeRenderingPostProcessing;
}

void SelectionOutlineSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    DescribeGrouping(inspector, m_Grouping);
    inspector.Field("m_PhaseStep", m_PhaseStep,
                    "The seconds between the colours of one object and the next, for objects "
                    "without a start time");

    inspector.Header("Stencil");
    inspector.Field("m_Stencil", m_Stencil, k_Stencils,
                    "The way to draw the selected objects: by the pass itself, or by a second "
                    "camera that sees one layer");
    inspector.Field("m_HighlightingLayer", m_HighlightingLayer, ValueRange{0, 31},
                    "The layer of that camera, into which the objects are moved meanwhile");
    inspector.Field("m_OnlySelected", m_OnlySelected,
                    "On: other objects of that layer are left out; off: they get an edge, too");

    inspector.Header("Shaders");
    inspector.Field("m_StencilShader", m_StencilShader,
                    "A shader for the mask in place of limn's own");
    inspector.Field("m_BlurShader", m_BlurShader, "A shader for the blur in place of limn's own");
    inspector.Field(
        "m_CompositeShader", m_CompositeShader,
        "A shader for the composite in place of limn's own, which needs no copy of the picture");
}

void SelectionOutlineRendererFeature::SetStartTime(const GameObject& object, double seconds)
{
    if (!std::isfinite(seconds))
    {
        throw ContractError(name + ": the start time of '" + object.name + "' is not finite");
    }
    (*settings().startTimes)[&object.transform] = seconds;
}

void SelectionOutlineRendererFeature::ClearStartTimes()
{
    settings().startTimes->clear();
}

} // namespace limn
