#include <limn/volume/ProfileEdit.h>

#include <limn/volume/YamlSplicer.h>

#include <algorithm>
#include <limn/base/WriteFile.h>
#include <limn/volume/UnityAsset.h>
#include <limn/volume/ValueParameters.h>
#include <limn/volume/VolumeProfileLoader.h>
#include <limn/volume/YamlMapReader.h>
#include <optional>

namespace limn
{

namespace
{

/// The layers of the scene that a profile is made for are not known here; any name may be one.
class AnyLayer final : public ProfileContext
{
public:
    std::optional<int> FindLayer(std::string_view name) const override
    {
        return ProfileContext::FindLayer(name).value_or(31);
    }
};

VolumeParameter* FindNamed(std::span<VolumeParameter* const> parameters, const std::string& name)
{
    const auto found =
        std::find_if(parameters.begin(), parameters.end(),
                     [&name](const VolumeParameter* p)
                     { return p->name() == name || PlainSpelling(p->name()) == name; });
    return found == parameters.end() ? nullptr : *found;
}

/// The parameters along a path, from the component's own to the innermost; shorter than the path
/// where a name is unknown.
std::vector<VolumeParameter*> FindAlong(VolumeComponent& component,
                                        const std::vector<std::string>& path)
{
    std::vector<VolumeParameter*> found;
    std::span<VolumeParameter* const> known = component.parameters();
    for (const std::string& name : path)
    {
        VolumeParameter* parameter = FindNamed(known, name);
        if (!parameter)
        {
            break;
        }
        found.push_back(parameter);
        known = std::as_const(*parameter).parameters();
    }
    return found;
}

/// The parameter of an edit, with its new value.
class Wanted
{
public:
    Wanted(const ValueAssignment& edit, const VolumeComponentRegistry& registry)
        : m_Source(edit.path + "=" + edit.value)
    {
        AssetDiagnostics diagnostics(m_Source);
        const ValuePath wanted = ValuePath::Split(edit.path, registry.names());
        component = wanted.name;
        Find(wanted, registry, diagnostics);
        diagnostics.ThrowIfErrors();
        subject = component;
        for (const std::string& name : path)
        {
            subject += "." + name;
        }
        parameter->ReadYaml(ParseTypedValue(edit.value, m_Source), subject, diagnostics);
        ThrowWithoutPlaces(diagnostics);
    }

    VolumeParameter* parameter = nullptr;
    std::string component;
    std::string subject;
    std::vector<std::string>
        path; ///< serialised names, of one parameter unless it is inside others

private:
    void Find(const ValuePath& wanted, const VolumeComponentRegistry& registry,
              AssetDiagnostics& diagnostics)
    {
        if (!registry.Find(wanted.name))
        {
            diagnostics.Error({}, "unknown volume component " +
                                      UnknownName(wanted.name, registry.names()));
            return;
        }
        m_Component = registry.Create(wanted.name);
        if (wanted.KeysText() == "active")
        {
            parameter = &m_Active;
            path = {"active"};
            return;
        }
        const std::vector<VolumeParameter*> found = FindAlong(*m_Component, wanted.keys);
        for (VolumeParameter* known : found)
        {
            path.push_back(known->name());
            parameter = known;
        }
        if (found.size() < wanted.keys.size())
        {
            ReportUnknown(wanted.keys[found.size()], found, diagnostics);
        }
    }

    void ReportUnknown(const std::string& name, const std::vector<VolumeParameter*>& found,
                       AssetDiagnostics& diagnostics) const
    {
        std::string owner = component;
        std::vector<std::string> names;
        std::span<VolumeParameter* const> parameters = m_Component->parameters();
        for (const VolumeParameter* outer : found)
        {
            owner += "." + outer->name();
            parameters = outer->parameters();
        }
        if (found.empty())
        {
            names.emplace_back("active");
        }
        for (const VolumeParameter* known : parameters)
        {
            names.push_back(PlainSpelling(known->name()));
        }
        diagnostics.Error({}, owner + ": unknown parameter " +
                                  UnknownName(name, {names.begin(), names.end()}));
    }

    /// A place in a value typed on a command line says nothing.
    static void ThrowWithoutPlaces(const AssetDiagnostics& diagnostics)
    {
        AssetDiagnostics without(diagnostics.file());
        for (const Diagnostic& diagnostic : diagnostics.diagnostics())
        {
            without.Error({}, diagnostic.message);
        }
        without.ThrowIfErrors();
    }

    std::string m_Source;
    std::unique_ptr<VolumeComponent> m_Component;
    BoolParameter m_Active{nullptr, "active", true};
};

/// A profile's file in either form.
struct ProfileText
{
    ProfileText(std::string_view text, const std::string& file)
    {
        if (!IsUnityAsset(text))
        {
            documents = ParseYaml(text, file);
            return;
        }
        asset.emplace(std::string(text), file);
        for (const UnityHeader& header : asset->headers())
        {
            documents.push_back(asset->Read(header).fields);
        }
    }

    std::optional<UnityAsset> asset; ///< only of Unity's form
    std::vector<YamlNode> documents; ///< the fields of each object in Unity's form
};

/// The component's map; nothing if the file does not have it.
std::optional<YamlNode> FindComponent(const ProfileText& profile, const std::string& name)
{
    if (!profile.asset)
    {
        const YamlNode* component = profile.documents.front().Find(name);
        return component ? std::optional(*component) : std::nullopt;
    }
    const std::optional<UnityObject> root = profile.asset->FindWithField("components");
    for (const YamlNode& reference :
         root ? root->fields.Find("components")->items() : std::span<const YamlNode>())
    {
        const auto object = profile.asset->Find(ReadFileID(reference).value_or(0));
        if (object && object->name == name)
        {
            return object->fields;
        }
    }
    return std::nullopt;
}

/// What stands for one parameter in the map of a component or an object; null without it.
const YamlNode* FindEntry(const YamlNode& map, const std::string& name, bool isUnity)
{
    const YamlNode* value = map.Find(name);
    value = value || isUnity ? value : map.Find(PlainSpelling(name));
    // Unity puts the override state beside the value; within an object limn reads that as well.
    const bool isWrapped = value && value->Find("m_OverrideState") && value->Find("m_Value");
    return isWrapped ? value->Find("m_Value") : value;
}

/// The node that holds the parameter's value; an error if there is none.
const YamlNode* FindValue(const std::optional<YamlNode>& component, bool isUnity,
                          const Wanted& wanted, AssetDiagnostics& diagnostics)
{
    if (!component)
    {
        diagnostics.Error({}, wanted.subject + ": the file has no '" + wanted.component +
                                  "'; only values that are in the file can be set");
        return nullptr;
    }
    const YamlNode* value = &*component;
    SourceLocation place = component->location();
    for (const std::string& name : wanted.path)
    {
        place = value->location();
        value = FindEntry(*value, name, isUnity);
        if (!value)
        {
            diagnostics.Error(place, wanted.subject +
                                         ": the file does not set it; only values that are in "
                                         "the file can be set, so add a line '" +
                                         name + ": " + wanted.parameter->ValueText() + "' by hand");
            return nullptr;
        }
    }
    return value;
}

/// Throws unless the new text is a good profile that differs from the old one in what was replaced.
void CheckResult(const std::vector<YamlNode>& before, const std::string& text,
                 const std::string& file, const YamlSplicer& splicer, const YamlNode& place,
                 const std::string& subject, const VolumeComponentRegistry& registry)
{
    ParseVolumeProfile(text, file, registry, AnyLayer());
    const std::vector<YamlNode> after = ProfileText(text, file).documents;
    std::size_t count = after.size() == before.size() ? 0 : splicer.count() + 1;
    for (std::size_t i = 0; i < before.size() && i < after.size(); ++i)
    {
        count += CountDifferences(before[i], after[i]);
    }
    if (count != splicer.count())
    {
        throw AssetError(file, place.location(),
                         subject + ": other values repeat this one by an alias (*), and would "
                                   "change as well; change it by hand");
    }
}

std::string EditOne(const std::string& text, const std::string& file, const ValueAssignment& edit,
                    const VolumeComponentRegistry& registry, std::vector<ScalarChange>& changes)
{
    const Wanted wanted(edit, registry);
    const ProfileText profile(text, file);
    const bool isUnity = profile.asset.has_value();
    AssetDiagnostics diagnostics(file);
    const std::optional<YamlNode> component = FindComponent(profile, wanted.component);
    const YamlNode* value = FindValue(component, isUnity, wanted, diagnostics);
    diagnostics.ThrowIfErrors();

    const std::string fresh =
        isUnity ? wanted.parameter->UnityText() : wanted.parameter->ValueText();
    YamlSplicer splicer(text, wanted.subject, diagnostics);
    // A value that says the same in another way stays as it is written.
    AssetDiagnostics ignored(file);
    const auto old = registry.Create(wanted.component);
    const std::vector<VolumeParameter*> current = FindAlong(*old, wanted.path);
    BoolParameter active{nullptr, "active", true};
    VolumeParameter& before = current.empty() ? active : *current.back();
    const bool isRead = before.ReadYaml(*value, wanted.subject, ignored);
    const bool isSame = isRead && before.ValueText() == wanted.parameter->ValueText();
    changes.push_back({wanted.subject, isRead ? before.ValueText() : value->Describe(),
                       wanted.parameter->ValueText()});
    if (!isSame)
    {
        splicer.Replace(*value, ParseYaml(fresh, file).front(), fresh);
    }
    diagnostics.ThrowIfErrors();
    std::string result = splicer.Result();
    CheckResult(profile.documents, result, file, splicer, *value, wanted.subject, registry);
    return result;
}

} // namespace

std::string EditVolumeProfile(std::string_view text, const std::string& file,
                              std::span<const ValueAssignment> edits,
                              const VolumeComponentRegistry& registry,
                              std::vector<ScalarChange>* changes)
{
    std::vector<ScalarChange> ignored;
    std::string result(text);
    std::vector<Diagnostic> problems;
    for (const ValueAssignment& edit : edits)
    {
        try
        {
            result = EditOne(result, file, edit, registry, changes ? *changes : ignored);
        }
        catch (const AssetError& error)
        {
            for (const Diagnostic& diagnostic : error.diagnostics())
            {
                if (std::find(problems.begin(), problems.end(), diagnostic) == problems.end())
                {
                    problems.push_back(diagnostic);
                }
            }
        }
    }
    if (!problems.empty())
    {
        throw AssetError(std::move(problems));
    }
    return result;
}

std::vector<ScalarChange> SetScalars(const std::filesystem::path& path,
                                     std::span<const ValueAssignment> edits,
                                     const VolumeComponentRegistry& registry)
{
    std::vector<ScalarChange> changes;
    const FileLock lock(path);
    const std::string text = ReadYamlText(path);
    const std::string edited =
        EditVolumeProfile(text, path.generic_string(), edits, registry, &changes);
    if (edited != text)
    {
        ReplaceContent(path, text, edited);
    }
    return changes;
}

void ReplaceContent(const std::filesystem::path& path, std::string_view expected,
                    std::string_view content)
{
    WriteFile(path, content,
              [&path, expected]
              {
                  if (ReadYamlText(path) != expected)
                  {
                      throw AssetError(path.generic_string(), {},
                                       "was changed by another program meanwhile, and is left as "
                                       "that wrote it; try again");
                  }
              });
}

} // namespace limn
