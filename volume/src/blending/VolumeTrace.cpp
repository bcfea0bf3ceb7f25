#include <limn/volume/VolumeTrace.h>

#include "blending/Components.h"
#include "blending/VolumeBlending.h"

#include <algorithm>
#include <cmath>
#include <limn/volume/VolumeManager.h>
#include <map>

namespace limn
{

namespace
{

/// A contribution to a component, from which the steps of the trace are made.
struct Contribution
{
    const Volume* volume;
    VolumeInfluence influence;
    std::shared_ptr<const VolumeComponent> target;
};

std::vector<std::string> TextsOf(std::span<const VolumeParameter* const> parameters)
{
    std::vector<std::string> texts;
    for (const VolumeParameter* parameter : parameters)
    {
        texts.push_back(parameter->ValueText());
    }
    return texts;
}

VolumeTraceStep MakeStep(const Contribution& contribution, std::size_t index,
                         const VolumeParameter& result)
{
    const VolumeInfluence& influence = contribution.influence;
    VolumeTraceStep step;
    step.volume = contribution.volume->name;
    step.factor = influence.factor;
    step.weight = influence.weight;
    if (influence.squaredDistance)
    {
        step.distance = static_cast<float>(std::sqrt(*influence.squaredDistance));
    }
    step.targetText = contribution.target->parameters()[index]->ValueText();
    step.valueText = result.ValueText();
    step.target = contribution.target;
    return step;
}

std::shared_ptr<const VolumeComponentTrace>
MakeComponentTrace(const VolumeComponentRegistry::Entry& entry, const VolumeComponent& state,
                   const VolumeComponentRegistry& registry,
                   const std::vector<Contribution>& contributions)
{
    auto trace = std::make_shared<VolumeComponentTrace>();
    trace->component = entry.name;
    trace->start = CloneComponent(state, registry);
    trace->create = entry.create;
    for (const Contribution& contribution : contributions)
    {
        trace->steps.push_back({contribution.target, contribution.influence.factor});
    }
    return trace;
}

/// The traces of one component's parameters that a volume overrides or changes.
void AddTraces(std::shared_ptr<const VolumeComponentTrace> whole, VolumeComponent& state,
               const std::vector<Contribution>& contributions, VolumeTrace& trace)
{
    const std::span<const VolumeParameter* const> results = std::as_const(state).parameters();
    std::vector<VolumeParameterTrace> traces(results.size());
    for (const Contribution& contribution : contributions)
    {
        const std::vector<std::string> before = TextsOf(results);
        OverrideState(*contribution.target, state, contribution.influence.factor);
        for (std::size_t i = 0; i < traces.size(); ++i)
        {
            const bool isOverridden = contribution.target->parameters()[i]->overrideState();
            if (isOverridden || results[i]->ValueText() != before[i])
            {
                traces[i].steps.push_back(MakeStep(contribution, i, *results[i]));
            }
        }
    }
    for (std::size_t i = 0; i < traces.size(); ++i)
    {
        if (!traces[i].steps.empty())
        {
            traces[i].component = whole->component;
            traces[i].parameter = results[i]->name();
            traces[i].index = i;
            traces[i].startText = whole->start->parameters()[i]->ValueText();
            traces[i].whole = whole;
            trace.parameters.push_back(std::move(traces[i]));
        }
    }
}

} // namespace

std::unique_ptr<VolumeComponent> VolumeComponentTrace::Replay() const
{
    std::unique_ptr<VolumeComponent> state = create();
    CopyParameters(*start, *state);
    for (const Step& step : steps)
    {
        OverrideState(*step.target, *state, step.factor);
    }
    return state;
}

void VolumeParameterTrace::Replay(VolumeParameter& value) const
{
    const std::unique_ptr<VolumeComponent> result = whole->Replay();
    value.SetValue(*result->parameters()[index]);
}

const VolumeParameterTrace* VolumeTrace::Find(std::string_view component,
                                              std::string_view parameter) const
{
    const auto found =
        std::find_if(parameters.begin(), parameters.end(),
                     [&](const VolumeParameterTrace& known)
                     { return known.component == component && known.parameter == parameter; });
    return found == parameters.end() ? nullptr : &*found;
}

VolumeTrace VolumeManager::Trace(const std::optional<glm::vec3>& trigger, LayerMask layerMask)
{
    std::map<std::type_index, std::vector<Contribution>> contributions;
    const auto collect = [&](const Volume& volume, const VolumeComponent& component,
                             const VolumeInfluence& influence)
    {
        contributions[typeid(component)].push_back(
            {&volume, influence, CloneComponent(component, m_Registry)});
    };
    ForEachContribution(GetVolumes(layerMask), trigger, collect);

    VolumeStack stack = CreateStack();
    VolumeTrace trace;
    for (const auto& entry : m_Registry.entries())
    {
        VolumeComponent& state = *stack.Find(entry->type);
        const std::vector<Contribution>& steps = contributions[entry->type];
        AddTraces(MakeComponentTrace(*entry, state, m_Registry, steps), state, steps, trace);
    }
    return trace;
}

} // namespace limn
