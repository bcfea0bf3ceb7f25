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

/// The parameters along a path, from the component's own to the innermost; shorter than the path
/// where a name is unknown.
std::vector<VolumeParameter*> FindAlong(VolumeComponent& component,
                                        const std::vector<std::string>& path)
{
    std::vector<VolumeParameter*> found;
    std::span<VolumeParameter* const> known = component.parameters();
    for (const std::string& name : path)
    {
        VolumeParameter* parameter = FindParameter(known, name);
        if (!parameter)
        {
            break;
        }
        found.push_back(parameter);
        known = std::as_const(*parameter).parameters();
    }
    return found;
}

/// The target of an edit: a parameter, and perhaps one number of its value.
class Target
{
public:
    Target(const ValueAssignment& edit, const VolumeComponentRegistry& registry)
        : m_Edit(edit), m_Source(edit.Text())
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
    }

    /// Gives the parameter the edit's value, which may depend on the one that it has.
    void SetNewValue()
    {
        AssetDiagnostics diagnostics(m_Source);
        const std::string text = m_Edit.NewValue(parameter->ValueText(), m_Member, m_Source);
        parameter->ReadYaml(ParseTypedValue(text, m_Source), subject, diagnostics);
        diagnostics.ThrowWithoutPlaces();
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
        const std::size_t rest = wanted.keys.size() - found.size();
        const std::vector<std::string> members =
            parameter ? MembersOfValue(parameter->ValueText()) : std::vector<std::string>();
        if (rest == 1 && std::ranges::find(members, wanted.keys.back()) != members.end())
        {
            m_Member = wanted.keys.back();
        }
        else if (rest > 0)
        {
            ReportUnknown(wanted.keys[found.size()], found, members, diagnostics);
        }
    }

    void ReportUnknown(const std::string& name, const std::vector<VolumeParameter*>& found,
                       const std::vector<std::string>& members, AssetDiagnostics& diagnostics) const
    {
        std::string owner = component;
        std::vector<std::string> names = members;
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

    const ValueAssignment& m_Edit;
    std::string m_Source;
    std::string m_Member; ///< "r"; "": the whole value
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

/// Returns the value of one parameter in the map of a component or an object, or null.
const YamlNode* FindEntry(const YamlNode& map, const std::string& name, bool isUnity)
{
    const YamlNode* value = map.Find(name);
    value = value || isUnity ? value : map.Find(PlainSpelling(name));
    // Unity puts the override state beside the value; within an object limn reads that as well.
    const bool isWrapped = value && value->Find("m_OverrideState") && value->Find("m_Value");
    return isWrapped ? value->Find("m_Value") : value;
}

/// The part of an edit's path that a file has.
struct Reached
{
    const YamlNode* value; ///< of the parameter; null if the file does not have it
    const YamlNode* map;   ///< otherwise the innermost map, or Null, that there is
    std::size_t depth;     ///< names of the path that lead there
};

Reached Follow(const YamlNode& component, bool isUnity, const Target& target)
{
    const YamlNode* map = &component;
    for (std::size_t i = 0; i < target.path.size(); ++i)
    {
        const YamlNode* found = FindEntry(*map, target.path[i], isUnity);
        if (!found)
        {
            return {nullptr, map, i};
        }
        map = found;
    }
    return {map, nullptr, target.path.size()};
}

/// Returns whether the file spells m_Width as width.
bool IsPlainlySpelt(const YamlNode& component, const std::string& name)
{
    bool isPlain = false;
    for (const YamlEntry& entry : component.entries())
    {
        if (entry.key.starts_with("m_"))
        {
            return false;
        }
        isPlain = isPlain || entry.key != "active";
    }
    return isPlain && PlainSpelling(name) != name;
}

/// Adds what the file lacks of the path, and the value behind it.
void AddValue(const std::optional<YamlNode>& component, const YamlNode& root,
              const Reached& reached, const Target& target, YamlSplicer& splicer)
{
    const auto spelt = [&](const std::string& name)
    {
        return component && IsPlainlySpelt(*component, name) ? PlainSpelling(name) : name;
    };
    std::string text = target.parameter->ValueText();
    for (std::size_t i = target.path.size() - 1; i > reached.depth; --i)
    {
        text = "{" + spelt(target.path[i]) + ": " + text + "}";
    }
    const std::string key = spelt(target.path[reached.depth]);
    if (component)
    {
        splicer.Insert(*reached.map, key, text);
    }
    else
    {
        splicer.Append(root, target.component, key, text);
    }
}

std::string EditOne(const std::string& text, const std::string& file, const ValueAssignment& edit,
                    const VolumeComponentRegistry& registry, std::vector<ScalarChange>& changes)
{
    Target target(edit, registry);
    const ProfileText profile(text, file);
    const bool isUnity = profile.asset.has_value();
    AssetDiagnostics diagnostics(file);
    const std::optional<YamlNode> component = FindComponent(profile, target.component);
    const Reached reached = component ? Follow(*component, isUnity, target) : Reached{};
    if (!reached.value && isUnity)
    {
        throw AssetError(file, component ? component->location() : SourceLocation{},
                         target.subject + ": the file does not have it; Unity adds it when the " +
                             (component ? "parameter" : "component") + " is set in its inspector");
    }
    AssetDiagnostics ignored(file);
    const bool isRead =
        reached.value && target.parameter->ReadYaml(*reached.value, target.subject, ignored);
    const std::string old = target.parameter->ValueText();
    target.SetNewValue();
    const std::string fresh = target.parameter->ValueText();
    changes.push_back({target.subject,
                       !reached.value ? "not set"
                       : isRead       ? old
                                      : reached.value->Describe(),
                       fresh});
    YamlSplicer splicer(text, target.subject, diagnostics);
    if (!reached.value)
    {
        AddValue(component, profile.documents.front(), reached, target, splicer);
    }
    // A value that says the same in another way stays as it is written.
    else if (!isRead || old != fresh)
    {
        const std::string written = isUnity ? target.parameter->UnityText() : fresh;
        splicer.Replace(*reached.value, ParseYaml(written, file).front(), written);
    }
    diagnostics.ThrowIfErrors();
    std::string result = splicer.Result();
    ParseVolumeProfile(result, file, registry, AnyLayer()); // it must be a good one
    splicer.RequireNoOtherChange(profile.documents, ProfileText(result, file).documents,
                                 reached.value ? reached.value->location() : SourceLocation{});
    return result;
}

TextEditor EditorOf(const VolumeComponentRegistry& registry)
{
    return [&registry](const std::string& text, const std::string& file,
                       const ValueAssignment& edit, std::vector<ScalarChange>& changes)
    {
        return EditOne(text, file, edit, registry, changes);
    };
}

std::string ApplyEdits(std::string text, const std::string& file,
                       std::span<const ValueAssignment> edits, const TextEditor& editor,
                       std::vector<ScalarChange>& changes)
{
    std::vector<Diagnostic> problems;
    for (const ValueAssignment& edit : edits)
    {
        try
        {
            text = editor(text, file, edit, changes);
        }
        catch (const AssetError& error)
        {
            std::ranges::copy_if(
                error.diagnostics(), std::back_inserter(problems),
                [&problems](const Diagnostic& diagnostic)
                { return std::ranges::find(problems, diagnostic) == problems.end(); });
        }
    }
    if (!problems.empty())
    {
        throw AssetError(std::move(problems));
    }
    return text;
}

} // namespace

std::string EditVolumeProfile(std::string_view text, const std::string& file,
                              std::span<const ValueAssignment> edits,
                              const VolumeComponentRegistry& registry,
                              std::vector<ScalarChange>* changes)
{
    std::vector<ScalarChange> ignored;
    return ApplyEdits(std::string(text), file, edits, EditorOf(registry),
                      changes ? *changes : ignored);
}

std::vector<ScalarChange> SetScalars(const std::filesystem::path& path,
                                     std::span<const ValueAssignment> edits,
                                     const VolumeComponentRegistry& registry, FileEdit* written)
{
    return EditFile(path, edits, EditorOf(registry), written);
}

std::vector<ScalarChange> EditFile(const std::filesystem::path& path,
                                   std::span<const ValueAssignment> edits, const TextEditor& edit,
                                   FileEdit* written)
{
    std::vector<ScalarChange> changes;
    const FileLock lock(path);
    std::string text = ReadYamlText(path);
    std::string edited = ApplyEdits(text, path.generic_string(), edits, edit, changes);
    if (edited != text)
    {
        ReplaceContent(path, text, edited);
        if (written)
        {
            *written = {std::move(text), std::move(edited)};
        }
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
                                       "the file has been changed by another program meanwhile, "
                                       "so limn does not write it; try again");
                  }
              });
}

} // namespace limn
