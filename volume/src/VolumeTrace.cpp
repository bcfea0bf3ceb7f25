#include <limn/volume/VolumeTrace.h>

#include "CloneComponent.h"
#include "VolumeBlending.h"

#include <algorithm>
#include <cmath>
#include <limn/volume/VolumeManager.h>
#include <map>

namespace limn
{

namespace
{

/// What a component's steps are told from.
struct Contribution
{
    const Volume* volume;
    VolumeInfluence influence;
    std::shared_ptr<const VolumeComponent> target;
};

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
        step.distance = std::sqrt(*influence.squaredDistance);
    }
    step.targetText = contribution.target->parameters()[index]->ValueText();
    step.valueText = result.ValueText();
    step.target = contribution.target;
    return step;
}

/// The traces of one component's overridden parameters.
void AddTraces(const VolumeComponentRegistry::Entry& entry, VolumeComponent& state,
               const VolumeComponentRegistry& registry,
               const std::vector<Contribution>& contributions, VolumeTrace& trace)
{
    const std::shared_ptr<const VolumeComponent> start = CloneComponent(state, registry);
    std::vector<VolumeParameterTrace> traces(state.parameters().size());
    for (const Contribution& contribution : contributions)
    {
        contribution.target->Override(state, contribution.influence.factor);
        for (std::size_t i = 0; i < traces.size(); ++i)
        {
            if (contribution.target->parameters()[i]->overrideState())
            {
                traces[i].steps.push_back(MakeStep(contribution, i, *state.parameters()[i]));
            }
        }
    }
    for (std::size_t i = 0; i < traces.size(); ++i)
    {
        if (!traces[i].steps.empty())
        {
            traces[i].component = entry.name;
            traces[i].parameter = state.parameters()[i]->name();
            traces[i].index = i;
            traces[i].startText = start->parameters()[i]->ValueText();
            traces[i].start = start;
            trace.parameters.push_back(std::move(traces[i]));
        }
    }
}

} // namespace

void VolumeParameterTrace::Replay(VolumeParameter& value) const
{
    value.SetValue(*start->parameters()[index]);
    for (const VolumeTraceStep& step : steps)
    {
        value.Interp(value, *step.target->parameters()[index], step.factor);
    }
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
        AddTraces(*entry, *stack.Find(entry->type), m_Registry, contributions[entry->type], trace);
    }
    return trace;
}

} // namespace limn
