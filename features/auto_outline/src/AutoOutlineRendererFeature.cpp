#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limn/core/Inspector.h>
#include <limn/features/AutoOutlineRendererFeature.h>

namespace limn
{

namespace
{

constexpr EnumEntry k_Techniques[] = {
    {"Auto", 0}, {"Strokes", 1}, {"Separable", 2}, {"JumpFlood", 3}};

/// Pixels of the groups' regions.
double RegionArea(const std::vector<OutlinedObject>& objects, const CameraData& camera, float reach)
{
    double area = 0.0;
    ForEachGroup(objects,
                 [&](std::span<const OutlinedObject> group)
                 {
                     if (const auto region = FindOutlineRegion(group, camera, reach))
                     {
                         area += static_cast<double>(region->size.x) * region->size.y;
                     }
                 });
    return area;
}

/// Gives a technique's component the values of this one's.
void CopyValues(const AutoOutline& from, OutlineComponent& to)
{
    to.m_Enable.Override(true);
    to.m_OutlineColor.Override(from.m_OutlineColor.value());
    to.m_OutlineWidth.Override(from.m_OutlineWidth.value());
}

template <typename Settings>
Settings SettingsFor(const AutoOutlineSettings& from)
{
    Settings settings;
    static_cast<OutlineSettings&>(settings) = from;
    settings.m_Grouping = from.m_Grouping;
    return settings;
}

// The cost of a pixel in reads of a texture (1.2 ns), from the times of outline_benchmark on
// lavapipe with two cores.
constexpr double k_ReadsOfStroke = 15.0;
constexpr double k_ReadsOfOwnDepth = 7.0; ///< and the composite
constexpr double k_ReadsOfFloodStep = 8.5;
constexpr double k_ReadsOfSeeds = 30.0; ///< the mask, the places on its edge, and the composite

double CostOfStrokes(const OutlineWork& work)
{
    return work.strokeArea * k_ReadsOfStroke + work.regionArea * k_ReadsOfOwnDepth;
}

double CostOfSeparable(const OutlineWork& work)
{
    return work.regionArea * (k_ReadsOfSeeds + 2.0 * (2.0 * std::ceil(work.width) + 1.0));
}

double CostOfJumpFlood(const OutlineWork& work)
{
    const double steps = 1.0 + std::ceil(std::log2(work.width + 1.0));
    return work.regionArea * (k_ReadsOfSeeds + k_ReadsOfFloodStep * steps);
}

/// Appends "0.25 million".
void AppendMillions(PooledString& text, double number)
{
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number * 1e-6,
                                   std::chars_format::general, number < 1e6 ? 2 : 3);
    text.append(digits.data(), end.ptr).append(" million");
}

} // namespace

const char* ToString(OutlineTechnique technique)
{
    constexpr std::array k_Names{"Auto", "Strokes", "Separable", "JumpFlood"};
    const auto index = static_cast<std::size_t>(technique);
    return index < k_Names.size() ? k_Names[index] : "?";
}

OutlineChoice ChooseOutlineTechnique(const OutlineWork& work)
{
    const double separable = CostOfSeparable(work);
    const double flood = CostOfJumpFlood(work);
    const double transform = std::min(separable, flood);
    const OutlineTechnique best =
        separable <= flood ? OutlineTechnique::Separable : OutlineTechnique::JumpFlood;
    if (work.isAlphaTested)
    {
        return {best,
                "a material is alpha-tested, so the mesh's silhouette is not the one that is seen"};
    }
    const double strokes = CostOfStrokes(work);
    std::array<char, 16> edges{};
    const auto end = std::to_chars(edges.data(), edges.data() + edges.size(), work.edgeCount);
    PooledString costs(edges.data(), end.ptr);
    costs.append(" silhouette edges cost about ");
    AppendMillions(costs, strokes);
    costs.append(" texture reads, a distance transform ");
    AppendMillions(costs, transform);
    return {strokes <= transform ? OutlineTechnique::Strokes : best, std::move(costs)};
}

void AutoOutlineSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    inspector.Header("Technique");
    inspector.Field("m_Technique", m_Technique, k_Techniques,
                    "The technique that draws it; Auto chooses by the objects and the width, and "
                    "`limn explain` prints why");
    DescribeGrouping(inspector, m_Grouping);
}

void AutoOutlineRendererFeature::Create()
{
    m_Strokes.reset();
    m_Wide[0].reset();
    m_Wide[1].reset();
}

std::string AutoOutlineRendererFeature::AddTechnique(const AutoOutline& component,
                                                     ScriptableRenderer& renderer,
                                                     RenderingData& renderingData)
{
    CopyValues(component, m_StrokeValues);
    CopyValues(component, m_WideValues);
    FindOutlinedObjects(renderingData, settings(), settings().m_Grouping, m_Found);
    if (m_Found.objects.empty())
    {
        return m_Found.why;
    }
    OutlineWork work;
    work.isAlphaTested = std::ranges::any_of(m_Found.objects, [](const OutlinedObject& object)
                                             { return IsAlphaTested(*object.item.material); });
    const OutlineTechnique wanted = settings().m_Technique;
    const bool isAuto = wanted == OutlineTechnique::Auto;
    if (wanted == OutlineTechnique::Strokes || (isAuto && !work.isAlphaTested))
    {
        MakeStrokes(renderer);
        const std::string why = m_Strokes->Setup(m_StrokeValues, renderingData);
        if (!why.empty())
        {
            return why;
        }
        work.edgeCount = m_Strokes->edgeCount();
        work.strokeArea = m_Strokes->strokeArea();
    }
    work.width = component.m_OutlineWidth.value();
    work.regionArea = RegionArea(m_Found.objects, renderingData.cameraData, component.reach());
    const OutlineChoice choice =
        isAuto ? ChooseOutlineTechnique(work) : OutlineChoice{wanted, "as m_Technique requires"};
    std::string why;
    if (choice.technique == OutlineTechnique::Strokes)
    {
        renderer.EnqueuePass(*m_Strokes);
    }
    else
    {
        why = AddWide(renderer, renderingData, choice.technique);
    }
    if (why.empty())
    {
        PooledString& text = renderingData.report->choices.emplace_back(std::string_view(name));
        text.append(": ").append(ToString(choice.technique)).append(", ").append(choice.why);
    }
    return why;
}

void AutoOutlineRendererFeature::MakeStrokes(const ScriptableRenderer& renderer)
{
    if (!m_Strokes)
    {
        m_Strokes = std::make_unique<StrokeOutlinePass>(
            name, SettingsFor<StrokeOutlineSettings>(settings()),
            FindTechniqueShader(renderer, StrokeOutlinePass::k_Shader));
    }
}

std::string AutoOutlineRendererFeature::AddWide(ScriptableRenderer& renderer,
                                                RenderingData& renderingData,
                                                OutlineTechnique technique)
{
    const bool isFlood = technique == OutlineTechnique::JumpFlood;
    std::unique_ptr<WideOutlineRenderPass>& pass = m_Wide[isFlood ? 1 : 0];
    if (!pass)
    {
        auto wide = SettingsFor<WideOutlineSettings>(settings());
        wide.m_Method = isFlood ? WideOutlineMethod::JumpFlood : WideOutlineMethod::Separable;
        pass = std::make_unique<WideOutlineRenderPass>(
            name, wide, FindTechniqueShader(renderer, WideOutlineRenderPass::k_Shader));
    }
    const std::string why = pass->Setup(m_WideValues, renderingData);
    if (why.empty())
    {
        renderer.EnqueuePass(*pass);
    }
    return why;
}

void RegisterAutoOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<AutoOutlineRendererFeature>(
        "AutoOutlineRendererFeature", {{.name = "Auto",
                                        .summary = "strokes or distances, whichever is cheaper",
                                        .place = 40,
                                        .component = "AutoOutline",
                                        .settings = {"Outline.m_Grouping=Together"}}});
    components.Register<AutoOutline>("AutoOutline");
}

} // namespace limn
