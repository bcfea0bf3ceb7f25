#include "check/SceneFacts.h"

#include "explain/TextLines.h"

namespace limn
{

namespace
{

std::vector<std::string> FeatureNames(const SceneAsset& asset)
{
    std::vector<std::string> names;
    for (const std::unique_ptr<ScriptableRendererFeature>& feature : asset.renderer.features)
    {
        AddOnce(feature->name, names);
    }
    return names;
}

bool IsAbout(const ExplainedDraw& draw, const std::optional<std::string>& feature,
             const std::optional<std::string>& pass)
{
    return (!feature || draw.feature == *feature) && (!pass || draw.pass == *pass);
}

} // namespace

SceneFacts::SceneFacts(SceneAsset asset, AssetContext& assets)
    : m_Assets(assets),
      m_Volumes(asset.volumes),
      m_Layers(asset.layers),
      m_Features(FeatureNames(asset)),
      m_Explanation(Explain(std::move(asset), assets)),
      m_Objects(m_Explanation.objects),
      m_Manager(assets.volumeComponents())
{
    for (const Volume& volume : m_Volumes)
    {
        m_Manager.Register(&volume);
    }
}

std::vector<std::string> SceneFacts::ExecutedPasses() const
{
    return LinesOf(m_Explanation.report.passes,
                   [](const ExecutedPassReport& pass) { return pass.name.name(); });
}

std::vector<std::string> SceneFacts::PassesOf(const std::optional<std::string>& feature) const
{
    std::vector<std::string> passes;
    const RenderReport& report = m_Explanation.report;
    for (const auto* filters : {&report.draws, &report.filters})
    {
        for (const DrawRenderersReport& filter : *filters)
        {
            if (!feature || (filter.feature < report.features.size() &&
                             report.features[filter.feature].name.name() == *feature))
            {
                AddOnce(filter.pass.name(), passes);
            }
        }
    }
    return passes;
}

std::string SceneFacts::ReasonOf(const ExplainedObject& object,
                                 const std::optional<std::string>& feature,
                                 const std::optional<std::string>& pass) const
{
    if (!object.absence.empty())
    {
        return object.absence;
    }
    std::string reason;
    for (const ExplainedDraw& draw : object.draws)
    {
        if (IsAbout(draw, feature, pass))
        {
            reason = draw.verdict == FilterVerdict::Drawn ? draw.obstacle : ToString(draw.verdict);
        }
    }
    for (const ExplainedIdle& idle : m_Explanation.idleFeatures)
    {
        reason = reason.empty() && idle.name == feature ? idle.why : reason;
    }
    return !reason.empty() ? reason
           : feature       ? "'" + *feature + "' asks for no renderers"
                           : "the pass asks for no renderers";
}

DrawnFacts SceneFacts::Drawn(const std::optional<std::string>& feature,
                             const std::optional<std::string>& pass) const
{
    DrawnFacts facts;
    for (const ExplainedObject& object : m_Explanation.objects)
    {
        const bool isDrawn =
            object.absence.empty() &&
            std::ranges::any_of(object.draws, [&](const ExplainedDraw& draw)
                                { return IsAbout(draw, feature, pass) && draw.isDrawn(); });
        facts.drawn.push_back(isDrawn);
        facts.reasons.push_back(isDrawn ? "" : ReasonOf(object, feature, pass));
    }
    return facts;
}

std::unique_ptr<VolumeComponent> SceneFacts::Blend(const std::string& component,
                                                   const std::optional<glm::vec3>& position)
{
    const VolumeComponentRegistry& registry = m_Assets.volumeComponents();
    const VolumeComponentRegistry::Entry* entry = registry.Find(component);
    if (!entry)
    {
        return nullptr;
    }
    VolumeStack stack = m_Manager.CreateStack();
    m_Manager.Update(stack, position.value_or(m_Explanation.trigger.position),
                     m_Explanation.trigger.volumeLayerMask);
    std::unique_ptr<VolumeComponent> copy = registry.Create(component);
    const auto from = stack.GetComponent(entry->type)->parameters();
    const auto to = copy->parameters();
    for (std::size_t i = 0; i < to.size(); ++i)
    {
        to[i]->SetValue(*from[i]);
    }
    return copy;
}

std::string SceneFacts::SourcesOf(const std::string& component, const std::string& parameter,
                                  const std::optional<glm::vec3>& position)
{
    const VolumeTrace trace = m_Manager.Trace(position.value_or(m_Explanation.trigger.position),
                                              m_Explanation.trigger.volumeLayerMask);
    const VolumeParameterTrace* found = trace.Find(component, parameter);
    return found ? Joined(found->steps, ", ", &VolumeTraceStep::volume) : "";
}

} // namespace limn
