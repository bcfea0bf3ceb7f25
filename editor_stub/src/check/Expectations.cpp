#include "check/Expectations.h"

#include "check/Differences.h"
#include "explain/TextLines.h"
#include "scene/ProfileContext.h"

#include <algorithm>
#include <array>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

/// A text of a list and where it stands.
struct ListItem
{
    std::string text;
    SourceLocation location;
};

class Comparer
{
public:
    Comparer(SceneFacts& facts, UnknownObjects unknown, AssetDiagnostics& diagnostics)
        : m_Facts(facts), m_Unknown(unknown), m_Diagnostics(diagnostics)
    {
    }

    std::vector<Expectation> Compare(const YamlNode& root)
    {
        YamlMapReader map(root, "expectations", m_Diagnostics);
        Each(map.Find("features"), "features", [&](const YamlEntry& entry) { Feature(entry); });
        Each(map.Find("passes"), "passes", [&](const YamlEntry& entry) { Pass(entry); });
        Values(map.Find("values"));
        ExecutedPasses(map);
        Each(map.Find("textures"), "textures", [&](const YamlEntry& entry) { Texture(entry); });
        LeftOutThings(map);
        map.Finish();
        if (m_Results.empty() && !m_Diagnostics.hasErrors())
        {
            m_Diagnostics.Error(root.location(), "the file expects nothing; see 'limn help check'");
        }
        std::ranges::stable_sort(m_Results, {}, &Expectation::location);
        return std::move(m_Results);
    }

private:
    template <typename Visit>
    void Each(const YamlNode* node, const std::string& subject, const Visit& visit)
    {
        if (node)
        {
            YamlMapReader(*node, subject, m_Diagnostics, "name"); // says where it is no map
            std::ranges::for_each(node->entries(), visit);
        }
    }

    /// Reports a name that is not among the known ones.
    bool IsKnown(const YamlEntry& entry, const std::string& noun,
                 const std::vector<std::string>& known)
    {
        const bool isKnown = std::ranges::find(known, entry.key) != known.end();
        if (!isKnown)
        {
            m_Diagnostics.Error(entry.keyLocation,
                                "unknown " + noun + " " +
                                    UnknownName(entry.key, {known.begin(), known.end()}));
        }
        return isKnown;
    }

    Expectation& Add(std::string name, const YamlEntry& entry)
    {
        Expectation& result = m_Results.emplace_back();
        result.name = std::move(name);
        result.location = entry.keyLocation;
        result.value = entry.value;
        return result;
    }

    Expectation& Add(std::string name, const YamlMapReader& map, std::string_view key)
    {
        const std::span<const YamlEntry> entries = map.node().entries();
        return Add(std::move(name), *std::ranges::find(entries, key, &YamlEntry::key));
    }

    /// Returns the texts of a list, or nothing where there is no such key or it is wrong.
    std::optional<std::vector<ListItem>> List(YamlMapReader& map, std::string_view key)
    {
        const YamlNode* node = map.Find(key);
        if (!node)
        {
            return std::nullopt;
        }
        const std::string subject = map.SubjectOf(key);
        if (!node->isSequence())
        {
            m_Diagnostics.Error(node->location(), subject + ": found " + node->Describe() +
                                                      "; a list is expected, such as [Sofa, "
                                                      "Lamp], or [] for none");
            return std::nullopt;
        }
        std::vector<ListItem> items;
        for (const YamlNode& item : node->items())
        {
            if (const auto text = ReadString(item, subject, m_Diagnostics))
            {
                items.push_back({*text, item.location()});
            }
        }
        return items.size() == node->items().size() ? std::optional(items) : std::nullopt;
    }

    /// Compares the lists of a map that has one of each ListKind, or fewer.
    /// @param prefix   what the name of an expectation has in front of the key
    /// @param keys     by ListKind
    /// @param read     reads the list of a key
    /// @param compare  compares a list's names
    template <typename Read, typename Compare>
    void Lists(const YamlMapReader& map, const std::string& prefix,
               const std::array<const char*, 3>& keys, const Read& read, const Compare& compare)
    {
        for (const ListKind kind : {ListKind::Exact, ListKind::AtLeast, ListKind::None})
        {
            const char* key = keys[static_cast<std::size_t>(kind)];
            if (const auto items = read(key))
            {
                AddList(prefix + key, map, key, compare(LinesOf(*items, &ListItem::text), kind));
            }
        }
    }

    void AddList(std::string name, const YamlMapReader& map, const char* key,
                 NameDifference difference)
    {
        Expectation& result = Add(std::move(name), map, key);
        result.isList = true;
        result.diff = std::move(difference.lines);
        result.truth = std::move(difference.truth);
    }

    /// Reports names that no object has.
    std::optional<std::vector<ListItem>> ObjectList(YamlMapReader& map, std::string_view key)
    {
        std::optional<std::vector<ListItem>> items = List(map, key);
        bool isGood = items.has_value();
        for (const ListItem& item : items.value_or(std::vector<ListItem>()))
        {
            if (m_Unknown == UnknownObjects::AreErrors && m_Facts.objects().Find(item.text).empty())
            {
                m_Diagnostics.Error(item.location,
                                    map.SubjectOf(key) + ": unknown object with a mesh " +
                                        m_Facts.objects().UnknownSentence(item.text));
                isGood = false;
            }
        }
        return isGood ? items : std::nullopt;
    }

    void Feature(const YamlEntry& entry)
    {
        if (!IsKnown(entry, "feature", m_Facts.features()))
        {
            return;
        }
        YamlMapReader map(entry.value, "features." + entry.key, m_Diagnostics);
        Renderers(map, entry.key, std::nullopt);
        const std::vector<std::string> passes = m_Facts.PassesOf(entry.key);
        const auto pass = [&](const YamlEntry& one)
        {
            YamlMapReader own(one.value, map.SubjectOf("passes") + "." + one.key, m_Diagnostics);
            Renderers(own, entry.key, one.key, passes.empty() ? "" : Absence(one.key, passes));
            own.Finish();
        };
        Each(map.Find("passes"), map.SubjectOf("passes"), pass);
        map.Finish();
    }

    void Pass(const YamlEntry& entry)
    {
        std::vector<std::string> passes = m_Facts.PassesOf(std::nullopt);
        std::ranges::copy(m_Facts.ExecutedPasses(), std::back_inserter(passes));
        YamlMapReader map(entry.value, "passes." + entry.key, m_Diagnostics);
        Renderers(map, std::nullopt, entry.key, Absence(entry.key, passes));
        map.Finish();
    }

    /// Returns a line about a pass that does not run; "" if it does. A frame without it may be what
    /// is wrong, so this is no error of the file.
    static std::string Absence(const std::string& pass, const std::vector<std::string>& known)
    {
        return std::ranges::find(known, pass) != known.end()
                   ? ""
                   : "- " + pass + "  no pass of this name runs" +
                         DidYouMean(pass, {known.begin(), known.end()});
    }

    /// Reads what a feature or a pass draws.
    /// @param absence  of the pass
    void Renderers(YamlMapReader& map, const std::optional<std::string>& feature,
                   const std::optional<std::string>& pass, const std::string& absence = "")
    {
        const auto compare = [&](const std::vector<std::string>& items, ListKind kind)
        {
            NameDifference difference =
                CompareRenderers(m_Facts.objects(), items, m_Facts.Drawn(feature, pass), kind);
            if (!absence.empty())
            {
                difference.lines = {absence};
            }
            return difference;
        };
        Lists(
            map, map.SubjectOf(""), {"drawn", "drawnAtLeast", "notDrawn"},
            [&](const char* key) { return ObjectList(map, key); }, compare);
    }

    void Values(const YamlNode* node)
    {
        if (node && !node->isSequence())
        {
            m_Diagnostics.Error(node->location(), "values: found " + node->Describe() +
                                                      "; a list is expected, one '- at: camera' or "
                                                      "'- at: {x: 0, y: 1, z: 0}' for each place");
            return;
        }
        for (std::size_t i = 0; node && i < node->items().size(); ++i)
        {
            ValuesAt(node->items()[i], "values[" + std::to_string(i) + "]");
        }
    }

    void ValuesAt(const YamlNode& node, const std::string& subject)
    {
        YamlMapReader map(node, subject, m_Diagnostics);
        std::optional<glm::vec3> position;
        const YamlNode* at = map.Require("at");
        bool isPlace = at && at->isScalar() && at->scalar() == "camera";
        if (at && at->isScalar() && !isPlace)
        {
            m_Diagnostics.Error(at->location(), map.SubjectOf("at") + ": found " + at->Describe() +
                                                    "; camera or {x: 0, y: 1, z: 0} is expected");
        }
        else if (at && !isPlace)
        {
            const auto vector = ReadVector(*at, 3, map.SubjectOf("at"), m_Diagnostics);
            isPlace = vector.has_value();
            position = vector ? std::optional(glm::vec3(*vector)) : std::nullopt;
        }
        float tolerance = 0.0f;
        const bool hasTolerance = map.Read("tolerance", tolerance, {0.0, 1e30});
        for (const YamlEntry& entry : node.entries())
        {
            if (entry.key != "at" && entry.key != "tolerance" && isPlace)
            {
                Value(entry, subject, position,
                      hasTolerance ? std::optional<double>(tolerance) : std::nullopt);
            }
        }
    }

    /// "ScreenSpaceOutline.m_OutlineWidth: 4"
    void Value(const YamlEntry& entry, const std::string& subject,
               const std::optional<glm::vec3>& position, std::optional<double> tolerance)
    {
        const std::vector<std::string> names = SplitText(entry.key, '.');
        const VolumeComponentRegistry& components = m_Facts.assets().volumeComponents();
        if (names.size() < 2)
        {
            m_Diagnostics.Error(entry.keyLocation,
                                subject + ": unknown key " +
                                    UnknownName(entry.key, {"at", "tolerance"}) +
                                    " (a value is written 'Component.parameter: value')");
            return;
        }
        const std::unique_ptr<VolumeComponent> found = m_Facts.Blend(names[0], position);
        if (!found)
        {
            m_Diagnostics.Error(entry.keyLocation, subject + ": unknown volume component " +
                                                       UnknownName(names[0], components.names()));
            return;
        }
        const std::unique_ptr<VolumeComponent> expected = components.Create(names[0]);
        VolumeParameter* actual = FindParameter(*found, names, entry, subject);
        VolumeParameter* wanted =
            actual ? FindParameter(*expected, names, entry, subject) : nullptr;
        const SceneProfileContext context(m_Facts.assets(), {}, m_Facts.layers());
        if (!wanted ||
            !wanted->ReadYaml(entry.value, subject + "." + entry.key, m_Diagnostics, context))
        {
            return;
        }
        Expectation& result = Add(subject + "." + entry.key, entry);
        result.truth = {actual->ValueText()};
        if (!IsSameValue(wanted->ValueText(), actual->ValueText(), tolerance))
        {
            const std::string from = m_Facts.SourcesOf(names[0], actual->name(), position);
            result.diff = {"- " + wanted->ValueText() + "  expected",
                           "+ " + actual->ValueText() + "  found, " +
                               (from.empty() ? "the default" : "by " + from)};
        }
    }

    VolumeParameter* FindParameter(VolumeComponent& component,
                                   const std::vector<std::string>& names, const YamlEntry& entry,
                                   const std::string& subject)
    {
        std::span<VolumeParameter* const> known = component.parameters();
        VolumeParameter* found = nullptr;
        for (std::size_t i = 1; i < names.size(); ++i)
        {
            found = limn::FindParameter(known, names[i]);
            if (!found)
            {
                m_Diagnostics.Error(
                    entry.keyLocation,
                    subject + ": unknown parameter " +
                        UnknownName(names[i],
                                    NamesOf(known, [](const VolumeParameter* parameter)
                                            { return std::string_view(parameter->name()); })));
                return nullptr;
            }
            known = found->parameters();
        }
        return found;
    }

    void Names(YamlMapReader& map, const char* key, const std::vector<std::string>& actual,
               const NameWords& words)
    {
        if (const auto items = List(map, key))
        {
            AddList(key, map, key, CompareNames(LinesOf(*items, &ListItem::text), actual, words));
        }
    }

    void ExecutedPasses(YamlMapReader& map)
    {
        const std::vector<std::string> passes = m_Facts.ExecutedPasses();
        Names(map, "order", passes,
              {ListKind::Exact, "expected here, but it does not run here",
               "runs here, but is not expected here"});
        Names(map, "orderAtLeast", passes,
              {ListKind::AtLeast, "expected, but it does not run behind those before it", ""});
    }

    void LeftOutThings(YamlMapReader& map)
    {
        const auto compare = [&](const std::vector<std::string>& items, ListKind kind)
        {
            return CompareLeftOut(items, m_Facts.explanation().frame.leftOut, kind);
        };
        Lists(
            map, "", {"leftOut", "leftOutAtLeast", "notLeftOut"},
            [&](const char* key) { return List(map, key); }, compare);
    }

    void Texture(const YamlEntry& entry)
    {
        const std::vector<ExplainedTexture>& all = m_Facts.explanation().frame.textures;
        const std::vector<std::string> names = LinesOf(all, &ExplainedTexture::name);
        YamlMapReader map(entry.value, "textures." + entry.key, m_Diagnostics);
        const auto check = [&](const char* key, const auto& textOf)
        {
            std::string wanted;
            if (!map.Read(key, wanted))
            {
                return;
            }
            Expectation& result = Add(map.SubjectOf(key), map, key);
            for (const ExplainedTexture& texture : all)
            {
                if (texture.name == entry.key)
                {
                    result.truth.push_back(textOf(texture));
                }
            }
            if (result.truth.empty())
            {
                result.diff = {"- " + entry.key + "  the frame has no texture of this name" +
                               DidYouMean(entry.key, {names.begin(), names.end()})};
            }
            else if (std::ranges::find(result.truth, wanted) == result.truth.end())
            {
                result.diff = {"- " + wanted + "  expected",
                               "+ " + Joined(result.truth, ", ") + "  found"};
            }
        };
        check("size", [](const ExplainedTexture& texture) { return texture.size; });
        check("format", [](const ExplainedTexture& texture) { return texture.format; });
        check("samples",
              [](const ExplainedTexture& texture) { return std::to_string(texture.samples); });
        map.Finish();
    }

    SceneFacts& m_Facts;
    UnknownObjects m_Unknown;
    AssetDiagnostics& m_Diagnostics;
    std::vector<Expectation> m_Results;
};

} // namespace

std::vector<Expectation> CompareExpectations(const std::string& text, const std::string& file,
                                             SceneFacts& facts, UnknownObjects unknown)
{
    const std::vector<YamlNode> documents = ParseYaml(text, file);
    AssetDiagnostics diagnostics(file);
    if (documents.size() > 1)
    {
        diagnostics.Error(documents[1].location(),
                          "a second document begins here; one is expected");
    }
    std::vector<Expectation> results =
        Comparer(facts, unknown, diagnostics).Compare(documents.front());
    diagnostics.ThrowIfErrors();
    return results;
}

} // namespace limn
