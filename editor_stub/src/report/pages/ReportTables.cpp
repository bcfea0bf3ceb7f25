#include "report/pages/ReportText.h"

#include "console/Texts.h"
#include "report/figures/Numbers.h"
#include "report/measure/StudyScene.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

namespace limn::study
{

namespace
{

constexpr const char* k_NoFigure = "–";

std::string Figure(double value)
{
    return std::isnan(value) ? k_NoFigure : Readable(value);
}

std::string FromTo(const std::pair<double, double>& quartiles)
{
    return std::isnan(quartiles.first)
               ? k_NoFigure
               : Readable(quartiles.first) + " … " + Readable(quartiles.second);
}

/// Bytes are too many digits.
bool IsBytes(const Metric& metric)
{
    return std::string_view(metric.unit) == "bytes";
}

/// A figure that a cell has; NaN stays to be seen.
std::string FigureOf(const CellResult& cell, const Metric& metric)
{
    constexpr double k_BytesOfMiB = 1024.0 * 1024.0;
    return cell.Has(metric.key)
               ? Readable(cell.Value(metric.key) / (IsBytes(metric) ? k_BytesOfMiB : 1.0))
               : k_NoFigure;
}

/// Texts in the order of the numbers that they begin with, the same one once. Those that are not a
/// number as a whole come last.
using Levels = std::set<std::tuple<bool, double, std::string>>;

void AddLevel(const std::string& text, Levels& levels)
{
    double number = std::numeric_limits<double>::infinity();
    const char* const end = text.data() + text.size();
    const bool isNumber = std::from_chars(text.data(), end, number).ptr == end;
    levels.insert({!isNumber || std::isnan(number), std::isnan(number) ? 0.0 : number, text});
}

std::string TextOf(const Levels& levels)
{
    return Joined(levels, ", ", [](const auto& level) { return std::get<2>(level); });
}

/// "width 1, 8 px; picture 3x7; fov 60, 170; ratio 1e+02": variants are words "fov=60"; others
/// stand as they are.
std::string PutThrough(const std::vector<CellResult>& cells)
{
    Levels widths;
    Levels sizes;
    std::map<std::string, Levels> inputs; // by what they are of
    for (const CellResult& cell : cells)
    {
        AddLevel(Exact(cell.id.width), widths);
        AddLevel(SizeText(cell.id.pictureWidth, cell.id.pictureHeight), sizes);
        std::istringstream words(cell.id.variant);
        for (std::string word; words >> word;)
        {
            const std::size_t equals = std::min(word.find('='), word.size());
            AddLevel(word.substr(std::min(equals + 1, word.size())),
                     inputs[word.substr(0, equals)]);
        }
    }
    std::string text = "width " + TextOf(widths) + " px; picture " + TextOf(sizes);
    for (const auto& [what, levels] : inputs)
    {
        const std::string those = TextOf(levels);
        text += "; " + what + (those.empty() ? "" : " " + those);
    }
    return text;
}

double SumOf(const std::vector<CellResult>& cells, const char* metric)
{
    double sum = 0.0;
    for (const CellResult& cell : cells)
    {
        sum += cell.Has(metric) ? cell.Value(metric) : 0.0;
    }
    return sum;
}

/// Takes out the columns in which each row has this text.
void DropColumnsOf(const std::string& nothing, Table& table)
{
    for (std::size_t column = table.columns.size(); column-- > 0;)
    {
        if (std::ranges::all_of(table.rows,
                                [&](const auto& row) { return row[column] == nothing; }))
        {
            const auto offset = static_cast<std::ptrdiff_t>(column);
            table.columns.erase(table.columns.begin() + offset);
            for (auto& row : table.rows)
            {
                row.erase(row.begin() + offset);
            }
        }
    }
}

std::string TimeText(const Standing& standing)
{
    if (!standing.HasTime())
    {
        return "time not measured";
    }
    if (!std::isfinite(standing.LongestTime()) || standing.LongestTime() <= 0.0)
    {
        return "time not known";
    }
    return standing.IsTimeKnown() ? Readable(standing.at.milliseconds) + " ± " +
                                        Readable(standing.timeUncertainty) + " ms"
                                  : "at most " + Readable(standing.LongestTime()) + " ms";
}

/// The subject and the kind of the pictures, and their width.
struct Shown
{
    std::string subject;
    std::string kind;
    double width = 0.0;

    bool Has(const CellResult& cell) const
    {
        return cell.id.kind == CellKind::Geometry && cell.id.variant.empty() &&
               cell.id.subject == subject && cell.id.width == width && cell.pictures.contains(kind);
    }
};

/// The scene, or what stands first of a study without one.
Shown ShownOf(const Study& study, double width)
{
    Shown shown{k_SceneSubject, "closeUp", 0.0};
    const auto isShown = [&shown](const CellResult& cell)
    {
        return cell.id.kind == CellKind::Geometry && cell.id.subject == shown.subject &&
               cell.pictures.contains(shown.kind);
    };
    if (std::ranges::none_of(study.cells, isShown))
    {
        shown.kind = "picture";
        const auto first = std::ranges::find_if(
            study.cells, [](const CellResult& cell)
            { return cell.id.kind == CellKind::Geometry && cell.pictures.contains("picture"); });
        shown.subject = first == study.cells.end() ? "" : first->id.subject;
    }
    shown.width = NearestWidth(study, width, isShown);
    return shown;
}

} // namespace

Table TechniquesTable(const Comparison& comparison)
{
    Table table{"techniques",
                "All techniques at " + Readable(comparison.width) + " px",
                {{"technique"},
                 {"mean error", "", true},
                 {"error quartiles", "", true},
                 {"GPU time added", "ms", true},
                 {"known to ±", "ms", true},
                 {"its quartiles", "ms", true},
                 {"flicker", "", true},
                 {"stability checks failed", "", true},
                 {"what it is"}}};
    for (std::size_t i = 0; i < comparison.standings.size(); ++i)
    {
        const Standing& standing = comparison.standings[i];
        const Technique& technique = *standing.technique;
        table.rows.push_back(
            {technique.name, Figure(standing.at.error), FromTo(standing.errorQuartiles),
             Figure(standing.at.milliseconds),
             standing.HasTime() && std::isnan(standing.timeUncertainty)
                 ? "not known"
                 : Figure(standing.timeUncertainty),
             FromTo(standing.timeQuartiles), Figure(standing.flicker.median),
             standing.stabilityCells == 0 ? k_NoFigure
                                          : std::to_string(standing.failures) + " of " +
                                                std::to_string(standing.stabilityCells),
             technique.summary + (technique.isArticle ? " (an article's own formula)" : "")});
        if (std::ranges::find(comparison.front, i) != comparison.front.end())
        {
            table.marked.push_back(i);
        }
    }
    DropColumnsOf(k_NoFigure, table);
    return table;
}

Table BudgetsTable(const Comparison& comparison)
{
    Table table{
        "budgets",
        "What a budget buys",
        {{"take"}, {"from a budget of", "ms", true}, {"mean error", "", true}, {"what it is"}}};
    for (const std::size_t index : comparison.front)
    {
        const Standing& standing = comparison.standings[index];
        table.rows.push_back({standing.technique->name, Readable(standing.LongestTime()),
                              Readable(standing.at.error), standing.technique->summary});
    }
    return table;
}

Table CellsTable(const Study& study, const std::string& id, const std::string& title,
                 const std::function<bool(const CellResult&)>& isWanted)
{
    Table table{
        id, title, {{"technique"}, {"of"}, {"with"}, {"width", "px", true}, {"picture", "", true}}};
    for (const Metric& metric : Metrics())
    {
        table.columns.push_back({metric.title, IsBytes(metric) ? "MiB" : metric.unit, true});
    }
    table.columns.push_back({"notes"});
    for (const CellResult& cell : study.cells)
    {
        if (isWanted(cell))
        {
            std::vector<std::string>& row = table.rows.emplace_back();
            row = {cell.id.technique, cell.id.subject, cell.id.variant, Readable(cell.id.width),
                   SizeText(cell.id.pictureWidth, cell.id.pictureHeight)};
            for (const Metric& metric : Metrics())
            {
                row.push_back(FigureOf(cell, metric));
            }
            row.push_back(Joined(cell.notes, " "));
        }
    }
    DropColumnsOf(k_NoFigure, table);
    DropColumnsOf("", table);
    return table;
}

Table WidthsTable(const Study& study, const std::string& subject)
{
    std::set<double> widths;
    std::map<std::string, std::map<double, std::string>> errors; // by technique and width
    for (const CellResult& cell : study.cells)
    {
        const CellId& id = cell.id;
        if (id.kind == CellKind::Geometry && id.variant.empty() && id.subject == subject &&
            cell.Has("meanAbsoluteError") && std::isfinite(id.width))
        {
            widths.insert(id.width);
            errors[id.technique].emplace(id.width, Readable(cell.Value("meanAbsoluteError")));
        }
    }
    Table table{"widths", "Mean error by width: " + subject, {{"technique"}}};
    for (const double width : widths)
    {
        table.columns.push_back({Readable(width), "px", true});
    }
    for (const Technique& technique : study.techniques)
    {
        std::map<double, std::string>& own = errors[technique.name];
        if (!own.empty())
        {
            std::vector<std::string>& row = table.rows.emplace_back();
            row = {technique.name};
            for (const double width : widths)
            {
                row.push_back(own.try_emplace(width, k_NoFigure).first->second);
            }
        }
    }
    return table;
}

Table StabilityTable(const Study& study, const Comparison& comparison)
{
    Table table{"stability",
                "Stability",
                {{"technique"},
                 {"checks", "", true},
                 {"failed", "", true},
                 {"NaN or infinite texels", "", true},
                 {"texels outside 0...1", "", true},
                 {"validation messages", "", true},
                 {"what it was put through"}}};
    for (const Standing& standing : comparison.standings)
    {
        std::vector<CellResult> cells;
        std::ranges::copy_if(study.cells, std::back_inserter(cells),
                             [&standing](const CellResult& cell) {
                                 return cell.id.kind == CellKind::Stability &&
                                        cell.id.technique == standing.technique->name;
                             });
        if (!cells.empty())
        {
            if (standing.failures > 0)
            {
                table.marked.push_back(table.rows.size());
            }
            table.rows.push_back({standing.technique->name, std::to_string(cells.size()),
                                  std::to_string(standing.failures),
                                  Readable(SumOf(cells, "badTexels")),
                                  Readable(SumOf(cells, "outOfRange")),
                                  Readable(SumOf(cells, "validationMessages")), PutThrough(cells)});
        }
    }
    return table;
}

Table FormulasTable(const Study& study)
{
    Table table{"formulas",
                "Formulas of the articles, and ours",
                {{"formula"},
                 {"input"},
                 {"meant", "", true},
                 {"the article's", "", true},
                 {"ours", "", true},
                 {"why"}}};
    const auto text = [](double value)
    {
        return std::isfinite(value) ? Readable(value) : Exact(value);
    };
    for (const CellResult& cell : study.cells)
    {
        if (cell.Has("formulaMeant"))
        {
            table.rows.push_back({cell.id.subject, cell.id.variant,
                                  text(cell.Value("formulaMeant")),
                                  text(cell.Value("formulaArticle")),
                                  text(cell.Value("formulaOurs")), Joined(cell.notes, " ")});
        }
    }
    return table;
}

Table NoWidthTable(const Study& study)
{
    Table table{"no-width", "Techniques without a width", {{"technique"}, {"why"}}};
    for (const Technique& technique : study.techniques)
    {
        if (!technique.noWidth.empty())
        {
            table.rows.push_back({technique.name, technique.noWidth});
        }
    }
    return table;
}

Table ProvenanceTable(const Study& study)
{
    const std::vector<std::vector<std::string>> rows = {
        {"scene", study.scene},
        {"hash of the scene's files", study.sceneHash},
        {"device", study.device},
        {"machine", study.machine},
        {"load average while cost was measured", Readable(study.loadAverage)},
        {"bandwidth of a copy", study.copyBandwidth > 0.0
                                    ? Readable(study.copyBandwidth / 1e9) + " GB/s"
                                    : "not measured"},
        {"options", study.options},
        {"limn", study.limnVersion},
        {"begun", study.started},
        {"cells", std::to_string(study.cells.size()) + " of " +
                      std::to_string(study.planned.size()) + " planned"}};
    return {"provenance", "", {{"what"}, {""}}, rows};
}

std::vector<Tile> TilesOf(const Study& study, const Comparison& comparison,
                          const Standing* recommended, std::string& caption)
{
    const Shown shown = ShownOf(study, comparison.width);
    caption = "The same part of " +
              (shown.subject == k_SceneSubject ? "the scene" : "'" + shown.subject + "'") +
              " with each technique, enlarged, its outline " + Readable(shown.width) +
              " px wide. Below it stand the mean error of the outline's coverage, 0 to 1, and the "
              "GPU time added to a frame. An article's own formula is marked 'article'.";
    std::vector<Standing> order = comparison.standings;
    std::ranges::stable_sort(order, {},
                             [](const Standing& standing)
                             {
                                 const double error = standing.at.error;
                                 return std::pair(std::isnan(error), std::isnan(error) ? 0 : error);
                             });
    std::vector<Tile> tiles;
    for (const Standing& standing : order)
    {
        const Technique& technique = *standing.technique;
        const auto found = std::ranges::find_if(
            study.cells, [&](const CellResult& cell)
            { return cell.id.technique == technique.name && shown.Has(cell); });
        if (found != study.cells.end())
        {
            tiles.push_back(
                {technique.name,
                 std::isnan(standing.at.error) ? "error not compared"
                                               : "error " + Readable(standing.at.error),
                 TimeText(standing), found->pictures.at(shown.kind), technique.isArticle,
                 recommended != nullptr && standing.technique == recommended->technique});
        }
    }
    return tiles;
}

} // namespace limn::study
