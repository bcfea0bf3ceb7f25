#include "study/StudyJson.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace limn::study
{

namespace
{

Json NumberToJson(double value)
{
    if (std::isfinite(value))
    {
        return value;
    }
    return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

double NumberFromJson(const Json& json)
{
    if (json.is_number())
    {
        return json.get<double>();
    }
    const auto text = json.get<std::string>();
    constexpr double k_Infinity = std::numeric_limits<double>::infinity();
    if (text == "nan")
    {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (text == "inf" || text == "-inf")
    {
        return text == "inf" ? k_Infinity : -k_Infinity;
    }
    throw std::invalid_argument("'" + text + "' is no number");
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

CellId IdFromJson(const Json& json)
{
    CellId id;
    id.kind = CellKindFrom(json.at("kind").get<std::string>());
    id.technique = json.at("technique").get<std::string>();
    id.subject = json.at("subject").get<std::string>();
    id.width = NumberFromJson(json.at("width"));
    id.pictureWidth = json.at("size").at(0).get<int>();
    id.pictureHeight = json.at("size").at(1).get<int>();
    id.variant = json.at("variant").get<std::string>();
    return id;
}

} // namespace

Json ToJson(const Study& study)
{
    Json json = {{"scene", study.scene},
                 {"sceneHash", study.sceneHash},
                 {"device", study.device},
                 {"machine", study.machine},
                 {"limnVersion", study.limnVersion},
                 {"options", study.options},
                 {"started", study.started},
                 {"loadAverage", study.loadAverage},
                 {"copyBandwidth", study.copyBandwidth},
                 {"techniques", Json::array()},
                 {"planned", Json::array()}};
    for (const TechniqueInfo& info : study.techniques)
    {
        json["techniques"].push_back({{"name", info.name},
                                      {"feature", info.feature},
                                      {"summary", info.summary},
                                      {"isArticle", info.isArticle},
                                      {"noWidth", info.noWidth}});
    }
    for (const CellId& id : study.planned)
    {
        json["planned"].push_back(IdToJson(id));
    }
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

Study StudyFromJson(const Json& json)
{
    Study study;
    study.scene = json.at("scene").get<std::string>();
    study.sceneHash = json.at("sceneHash").get<std::string>();
    study.device = json.at("device").get<std::string>();
    study.machine = json.at("machine").get<std::string>();
    study.limnVersion = json.at("limnVersion").get<std::string>();
    study.options = json.at("options").get<std::string>();
    study.started = json.at("started").get<std::string>();
    study.loadAverage = json.at("loadAverage").get<double>();
    study.copyBandwidth = json.at("copyBandwidth").get<double>();
    for (const Json& info : json.at("techniques"))
    {
        study.techniques.push_back(
            {info.at("name").get<std::string>(), info.at("feature").get<std::string>(),
             info.at("summary").get<std::string>(), info.at("isArticle").get<bool>(),
             info.at("noWidth").get<std::string>()});
    }
    for (const Json& id : json.at("planned"))
    {
        study.planned.push_back(IdFromJson(id));
    }
    return study;
}

CellResult CellFromJson(const Json& json)
{
    CellResult cell;
    cell.id = IdFromJson(json.at("id"));
    for (const auto& [key, value] : json.at("values").items())
    {
        cell.values[key] = NumberFromJson(value);
    }
    for (const auto& [key, value] : json.at("quartiles").items())
    {
        cell.quartiles[key] = {NumberFromJson(value.at(0)), NumberFromJson(value.at(1))};
    }
    cell.notes = json.at("notes").get<std::vector<std::string>>();
    cell.pictures = json.at("pictures").get<std::map<std::string, std::string>>();
    return cell;
}

} // namespace limn::study
