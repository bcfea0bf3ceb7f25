#include "report/measure/StudyFiles.h"

#include "console/Texts.h"
#include "settings/Keys.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limn/base/ParseWhole.h>
#include <limn/volume/YamlMapReader.h>

namespace limn::study
{

namespace
{

/// Counts up when figures change their meaning: 2 since times are known to bounds that hold.
constexpr int k_Format = 2;

Json NumberToJson(double value)
{
    if (std::isfinite(value))
    {
        return value;
    }
    return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

Json IdToJson(const CellId& id)
{
    return {{"kind", ToString(id.kind)},
            {"technique", id.technique},
            {"subject", id.subject},
            {"width", NumberToJson(id.width)},
            {"size", {id.pictureWidth, id.pictureHeight}},
            {"variant", id.variant}};
}

/// Hands the members that JSON has as they are to `visit(key, member)`.
template <typename AnyTechnique, typename Visit>
void VisitTechnique(AnyTechnique& technique, const Visit& visit)
{
    visit("name", technique.name);
    visit("feature", technique.feature);
    visit("summary", technique.summary);
    visit("isArticle", technique.isArticle);
    visit("noWidth", technique.noWidth);
}

template <typename AnyStudy, typename Visit>
void VisitStudy(AnyStudy& study, const Visit& visit)
{
    visit("scene", study.scene);
    visit("sceneHash", study.sceneHash);
    visit("device", study.device);
    visit("machine", study.machine);
    visit("limnVersion", study.limnVersion);
    visit("options", study.options);
    visit("started", study.started);
    visit("loadAverage", study.loadAverage);
    visit("copyBandwidth", study.copyBandwidth);
}

/// Reads one JSON value of a study. JSON is YAML: the reader of YAML knows every value's place.
class Reader
{
public:
    Reader(const YamlNode& node, std::string subject, AssetDiagnostics& diagnostics)
        : m_Diagnostics(diagnostics), m_Map(node, std::move(subject), diagnostics)
    {
    }

    template <typename T>
    void Read(const char* key, T& value)
    {
        if (const YamlNode* node = m_Map.Require(key))
        {
            ReadValue(*node, m_Map.SubjectOf(key), value);
        }
    }

private:
    template <typename T>
    void ReadValue(const YamlNode& node, const std::string& subject, std::vector<T>& list)
    {
        Expect(node.isSequence(), node, subject, "a list");
        for (const YamlNode& item : node.items())
        {
            ReadValue(item, subject, list.emplace_back());
        }
    }
    template <typename T>
    void ReadValue(const YamlNode& node, const std::string& subject, std::map<std::string, T>& map)
    {
        Expect(node.isMap(), node, subject, "a map");
        for (const YamlEntry& entry : node.entries())
        {
            ReadValue(entry.value, subject + "." + entry.key, map[entry.key]);
        }
    }
    void ReadValue(const YamlNode& node, const std::string&, Technique& technique)
    {
        Reader reader(node, "technique", m_Diagnostics);
        VisitTechnique(technique, [&](const char* key, auto& value) { reader.Read(key, value); });
    }
    void ReadValue(const YamlNode& node, const std::string& subject, std::string& value)
    {
        value = ReadString(node, subject, m_Diagnostics).value_or(value);
    }
    void ReadValue(const YamlNode& node, const std::string& subject, bool& value)
    {
        value = ReadBool(node, subject, m_Diagnostics).value_or(value);
    }
    /// The quotes around "nan" and "inf" are NumberToJson's.
    void ReadValue(const YamlNode& node, const std::string& subject, double& value)
    {
        const std::optional<double> number = ParseWhole<double>(node.scalar());
        Expect(number.has_value(), node, subject, "a number, \"nan\", \"inf\" or \"-inf\"");
        value = number.value_or(value);
    }
    void ReadValue(const YamlNode& node, const std::string& subject, CellKind& value)
    {
        const auto found = std::ranges::find(k_CellKindNames, node.scalar());
        if (found == std::end(k_CellKindNames))
        {
            m_Diagnostics.Error(node.location(),
                                subject + ": unknown kind of cell " +
                                    UnknownName(node.scalar(), {std::begin(k_CellKindNames),
                                                                std::end(k_CellKindNames)}));
            return;
        }
        value = static_cast<CellKind>(found - std::begin(k_CellKindNames));
    }
    void ReadValue(const YamlNode& node, const std::string& subject, std::pair<double, double>& two)
    {
        if (isPair(node, subject))
        {
            ReadValue(node.items()[0], subject, two.first);
            ReadValue(node.items()[1], subject, two.second);
        }
    }
    void ReadValue(const YamlNode& node, const std::string& subject, CellId& id)
    {
        Reader reader(node, subject, m_Diagnostics);
        reader.Read("kind", id.kind);
        reader.Read("technique", id.technique);
        reader.Read("subject", id.subject);
        reader.Read("width", id.width);
        reader.Read("variant", id.variant);
        const YamlNode* size = reader.m_Map.Require("size");
        if (size && isPair(*size, subject + ".size"))
        {
            const auto side = [&](std::size_t i)
            {
                constexpr ValueRange k_Sides{0.0, k_PictureSizes.max};
                return ReadInt(size->items()[i], subject + ".size", m_Diagnostics, k_Sides)
                    .value_or(0);
            };
            id.pictureWidth = side(0);
            id.pictureHeight = side(1);
        }
    }

    /// Returns whether the value is as it should be; else that is an error.
    bool Expect(bool isGood, const YamlNode& node, const std::string& subject,
                const std::string& expected)
    {
        if (!isGood)
        {
            m_Diagnostics.Error(node.location(), subject + ": found " + node.Describe() + "; " +
                                                     expected + " is expected");
        }
        return isGood;
    }
    bool isPair(const YamlNode& node, const std::string& subject)
    {
        return Expect(node.items().size() == 2, node, subject, "a list of two numbers");
    }

    AssetDiagnostics& m_Diagnostics;
    YamlMapReader m_Map;
};

/// Refuses names that limn gives no picture, such as those that lead out of the study's folder or
/// to its other files.
void RequirePictureName(const YamlNode& node, const std::string& name,
                        AssetDiagnostics& diagnostics)
{
    const std::filesystem::path path = name;
    if (path.parent_path() != "pictures" || path.extension() != ".png")
    {
        diagnostics.Error(node.location(), "cell.pictures: '" + name +
                                               "' is no picture of a study; a name such as "
                                               "pictures/disc.png is expected");
    }
}

/// Refuses results whose figures mean something else than this limn's.
void RequireFormat(const YamlNode& root, AssetDiagnostics& diagnostics)
{
    const YamlNode* format = root.Find("format");
    if (root.kind() == YamlKind::Map && (!format || format->scalar() != std::to_string(k_Format)))
    {
        diagnostics.Error(root.location(),
                          "study: these results are of another format than this limn's, which is " +
                              std::to_string(k_Format) +
                              " (before 2, the ± of a time did not hold when the load of the "
                              "machine changed); measure them again into another folder");
    }
    diagnostics.ThrowIfErrors();
}

} // namespace

Json ToJson(const Study& study)
{
    Json json = {{"format", k_Format}};
    VisitStudy(study, [&](const char* key, const auto& value) { json[key] = value; });
    json["techniques"] = JsonList(study.techniques,
                                  [](const Technique& info)
                                  {
                                      Json technique;
                                      VisitTechnique(info, [&](const char* key, const auto& value)
                                                     { technique[key] = value; });
                                      return technique;
                                  });
    json["planned"] = JsonList(study.planned, IdToJson);
    return json;
}

Json ToJson(const CellResult& cell)
{
    Json json = {{"cell", cell.id.Name()},   {"id", IdToJson(cell.id)},
                 {"values", Json::object()}, {"quartiles", Json::object()},
                 {"notes", cell.notes},      {"pictures", cell.pictures}};
    for (const auto& [key, value] : cell.values)
    {
        json["values"][key] = NumberToJson(value);
    }
    for (const auto& [key, value] : cell.quartiles)
    {
        json["quartiles"][key] = {NumberToJson(value.first), NumberToJson(value.second)};
    }
    return json;
}

Study StudyFromJson(std::string_view text, const std::string& file)
{
    const YamlNode root = ParseYaml(text, file).front();
    AssetDiagnostics diagnostics(file);
    RequireFormat(root, diagnostics);
    Reader reader(root, "study", diagnostics);
    Study study;
    VisitStudy(study, [&](const char* key, auto& value) { reader.Read(key, value); });
    reader.Read("techniques", study.techniques);
    reader.Read("planned", study.planned);
    diagnostics.ThrowIfErrors();
    return study;
}

CellResult CellFromJson(std::string_view line, const std::string& file, int lineNumber)
{
    const YamlNode root = ParseYaml(line, file, {}, lineNumber).front();
    AssetDiagnostics diagnostics(file);
    Reader reader(root, "cell", diagnostics);
    CellResult cell;
    reader.Read("id", cell.id);
    reader.Read("values", cell.values);
    reader.Read("quartiles", cell.quartiles);
    reader.Read("notes", cell.notes);
    reader.Read("pictures", cell.pictures);
    if (const YamlNode* pictures = root.Find("pictures"))
    {
        for (const YamlEntry& picture : pictures->entries())
        {
            RequirePictureName(picture.value, cell.pictures[picture.key], diagnostics);
        }
    }
    diagnostics.ThrowIfErrors();
    return cell;
}

} // namespace limn::study
