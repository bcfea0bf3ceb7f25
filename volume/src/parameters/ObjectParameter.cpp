#include <limn/volume/AssetParameters.h>

#include "blending/Components.h"

#include <limn/base/Lists.h>
#include <limn/volume/YamlMapReader.h>

namespace limn::detail
{

namespace
{

/// limn names a parameter and its value; Unity puts the override state beside the value.
void ReadInner(const YamlNode& node, const std::string& subject, VolumeParameter& parameter,
               AssetDiagnostics& diagnostics, const ProfileContext& context)
{
    const YamlNode* state = node.Find("m_OverrideState");
    const YamlNode* value = node.Find("m_Value");
    if (!state || !value)
    {
        parameter.ReadYaml(node, subject, diagnostics, context);
        parameter.SetOverrideState(true);
        return;
    }
    const bool isOverridden = ReadBool(*state, subject, diagnostics).value_or(false);
    const ProfileContext plain;
    parameter.ReadYaml(*value, subject, diagnostics, isOverridden ? context : plain);
    parameter.SetOverrideState(isOverridden);
}

} // namespace

ObjectParameterBase::ObjectParameterBase(VolumeComponent* owner, std::string_view name,
                                         std::unique_ptr<VolumeComponent> value, ParameterInfo info)
    : VolumeParameter(owner, name, true, std::move(info)), m_Value(std::move(value))
{
}

std::span<VolumeParameter* const> ObjectParameterBase::parameters() const
{
    return m_Value ? m_Value->parameters() : std::span<VolumeParameter* const>();
}

bool ObjectParameterBase::ReadNode(const YamlNode& node, std::string_view subject,
                                   AssetDiagnostics& diagnostics, const ProfileContext& context)
{
    const std::size_t before = diagnostics.errorCount();
    const std::unique_ptr<VolumeComponent> read = Create();
    YamlMapReader map(node, std::string(subject), diagnostics, "parameter");
    for (VolumeParameter* parameter : read->parameters())
    {
        if (const YamlNode* value = map.Find(parameter->name()))
        {
            ReadInner(*value, map.SubjectOf(parameter->name()), *parameter, diagnostics, context);
        }
    }
    map.Finish();
    if (diagnostics.errorCount() != before)
    {
        return false;
    }
    CopyParameters(*read);
    return true;
}

std::string ObjectParameterBase::ValueText() const
{
    std::string text = "{";
    for (const VolumeParameter* parameter : parameters())
    {
        if (parameter->overrideState())
        {
            text +=
                (text.size() > 1 ? ", " : "") + parameter->name() + ": " + parameter->ValueText();
        }
    }
    return text + "}";
}

std::string ObjectParameterBase::UnityText() const
{
    const auto textOf = [](const VolumeParameter* parameter)
    {
        return parameter->name() +
               ": {m_OverrideState: " + (parameter->overrideState() ? "1" : "0") +
               ", m_Value: " + parameter->UnityText() + "}";
    };
    return "{" + Joined(parameters(), ", ", textOf) + "}";
}

void ObjectParameterBase::InterpValues(const VolumeParameter& from, const VolumeParameter& to,
                                       float t)
{
    const std::span<VolumeParameter* const> results = parameters();
    const std::span<VolumeParameter* const> sources = Cast(from).parameters();
    const std::span<VolumeParameter* const> targets = Cast(to).parameters();
    if (results.empty() || sources.empty() || targets.empty())
    {
        return; // an object is missing, which counts as nothing to blend
    }
    for (std::size_t i = 0; i < results.size(); ++i)
    {
        results[i]->SetOverrideState(targets[i]->overrideState());
        if (targets[i]->overrideState())
        {
            results[i]->Interp(*sources[i], *targets[i], t);
        }
    }
}

void ObjectParameterBase::CopyValue(const VolumeParameter& other)
{
    const ObjectParameterBase& source = Cast(other);
    if (!source.m_Value)
    {
        m_Value.reset();
        return;
    }
    CopyParameters(*source.m_Value);
}

const ObjectParameterBase& ObjectParameterBase::Cast(const VolumeParameter& other) const
{
    if (typeid(*this) != typeid(other))
    {
        RefuseOtherType(other);
    }
    return static_cast<const ObjectParameterBase&>(other);
}

void ObjectParameterBase::CopyParameters(const VolumeComponent& from)
{
    if (!m_Value)
    {
        m_Value = Create();
    }
    limn::CopyParameters(from, *m_Value);
}

} // namespace limn::detail
