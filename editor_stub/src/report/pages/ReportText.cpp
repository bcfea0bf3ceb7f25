#include "report/pages/ReportText.h"

#include "explain/TextLines.h"
#include "report/figures/Numbers.h"
#include "report/measure/StudyScene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace limn::study
{

namespace
{

void AddTable(Section& section, Table table)
{
    if (!table.rows.empty())
    {
        section.tables.push_back(std::move(table));
    }
}

/// The cells that have figures as a table, the others in a sentence for each reason.
void AddCells(Section& section, const Study& study, const std::string& id, const std::string& title,
              const std::function<bool(const CellResult&)>& isWanted)
{
    AddTable(section, CellsTable(study, id, title,
                                 [&isWanted](const CellResult& cell)
                                 { return isWanted(cell) && !cell.values.empty(); }));
    std::map<std::string, std::vector<std::string>> names; // by the reason
    for (const CellResult& cell : study.cells)
    {
        if (isWanted(cell) && cell.values.empty())
        {
            for (const std::string& note : cell.notes)
            {
                AddOnce(cell.id.technique, names[note]);
            }
        }
    }
    for (const auto& [reason, those] : names)
    {
        AddOnce(Joined(those, ", ") + ": " + reason + ".", section.paragraphs);
    }
}

Section Choice(const Comparison& comparison)
{
    Section section{"choice", "Error against time", {"error_time"}};
    if (std::ranges::all_of(
            comparison.standings, [](const Standing& standing)
            { return std::isnan(standing.at.error) && std::isnan(standing.at.milliseconds); }))
    {
        return section; // of stability only
    }
    AddTable(section, BudgetsTable(comparison));
    AddTable(section, TechniquesTable(comparison));
    section.paragraphs.push_back(
        "The mean error is over all pixels that the drawn or the exact outline covers, of the "
        "coverage, 0 to 1. Rows that stand out are on the front: nothing is both quicker and "
        "nearer to the exact outline.");
    return section;
}

Section Error(const Study& study, const Comparison& comparison)
{
    Section section{"error", "Error against the exact outline", {"error_width"}};
    std::set<std::string> subjects;
    for (const CellResult& cell : study.cells)
    {
        if (cell.id.kind == CellKind::Geometry && cell.Has("meanAbsoluteError"))
        {
            subjects.insert(cell.id.subject);
        }
    }
    for (const std::string& subject : subjects)
    {
        Table table = WidthsTable(study, subject);
        table.id += "-" + std::to_string(section.tables.size() + 1);
        if (table.columns.size() > 2) // several widths
        {
            section.tables.push_back(std::move(table));
        }
    }
    const auto isCompared = [&comparison](const CellResult& cell)
    {
        return cell.id.kind == CellKind::Geometry && cell.id.variant.empty() &&
               cell.id.width == comparison.width;
    };
    AddCells(section, study, "geometry", "All measures at " + Readable(comparison.width) + " px",
             isCompared);
    AddCells(section, study, "parts", "What is seen and what is hidden of the outline",
             [](const CellResult& cell)
             { return cell.id.kind == CellKind::Geometry && !cell.id.variant.empty(); });
    return section;
}

Section Numerical(const Study& study)
{
    Section section{"numerical-error", "Numerical error"};
    section.paragraphs.push_back(
        "What the device drew against the same algorithm in double precision; and against what it "
        "draws with fewer bits, coarser targets or another depth.");
    AddCells(section, study, "numerical", "Against the same algorithm in double",
             [](const CellResult& cell) { return cell.id.kind == CellKind::Numerical; });
    return section;
}

Section Temporal(const Study& study)
{
    Section section{"motion", "In motion", {"flicker_time"}};
    AddCells(section, study, "temporal", "Over steps of a sixteenth of a pixel",
             [](const CellResult& cell) { return cell.id.kind == CellKind::Temporal; });
    return section;
}

Section Cost(const Study& study, const Comparison& comparison)
{
    Section section{"cost", "Cost", {"time_resolution", "time_objects"}};
    const auto isCompared = [&comparison](const CellResult& cell)
    {
        return cell.id.variant.empty() && cell.id.width == comparison.width &&
               cell.id.pictureWidth == comparison.pictureWidth &&
               cell.id.pictureHeight == comparison.pictureHeight;
    };
    section.paragraphs.push_back(
        "Each frame with an outline is drawn between two without one, warm, and each technique "
        "once a round, in another order each round. The time added is the median of what the frame "
        "took longer than the mean of its two neighbours. A pair counts if the frames without an "
        "outline in it and around it took about the run's quiet time; if more than a tenth of all "
        "frames without an outline did not, the load of the machine changed. The ± holds with 95 % "
        "the time added at the run's quietest moments, whatever the distribution (sign test), "
        "pairs "
        "that resemble their neighbours in time counting as fewer. A load that lasts as long as "
        "the "
        "run is not told from a slower machine: see how many processors other programs kept busy.");
    AddCells(section, study, "costs", "Where techniques are compared",
             [&](const CellResult& cell)
             { return cell.id.kind == CellKind::Cost && isCompared(cell); });
    AddCells(section, study, "other-costs", "Other widths, sizes and scenes",
             [&](const CellResult& cell)
             { return cell.id.kind == CellKind::Cost && !isCompared(cell); });
    return section;
}

Section Pictures(const Study& study, const Comparison& comparison)
{
    Section section{"pictures", "Pictures"};
    section.paragraphs.push_back(
        "The scene, and four times as large what was drawn, the exact outline, and the "
        "difference.");
    std::vector<std::string> subjects;
    for (const CellResult& cell : study.cells)
    {
        if (!cell.pictures.empty())
        {
            AddOnce(cell.id.subject, subjects);
        }
    }
    for (const std::string& subject : subjects)
    {
        const double width =
            NearestWidth(study, comparison.width,
                         [&](const CellResult& cell)
                         { return !cell.pictures.empty() && cell.id.subject == subject; });
        for (const CellResult& cell : study.cells)
        {
            if (cell.pictures.empty() || cell.id.subject != subject || cell.id.width != width ||
                cell.id.kind != CellKind::Geometry || !cell.id.variant.empty())
            {
                continue;
            }
            Strip strip{cell.id.technique + ", " + subject + ", " + Readable(width) + " px", {}};
            for (const auto& [kind, what] :
                 {std::pair("scene", "in the scene"), std::pair("picture", "drawn"),
                  std::pair("reference", "exact"),
                  std::pair("difference", "red: too much, blue: too little")})
            {
                if (const auto found = cell.pictures.find(kind); found != cell.pictures.end())
                {
                    strip.pictures.emplace_back(what, found->second);
                }
            }
            section.strips.push_back(std::move(strip));
        }
    }
    return section;
}

Section Stability(const Study& study, const Comparison& comparison)
{
    Section section{"extremes", "Stability"};
    section.paragraphs.push_back("Extreme inputs, and what came out.");
    AddTable(section, StabilityTable(study, comparison));
    AddTable(section, CellsTable(study, "failures", "Checks that failed",
                                 [](const CellResult& cell) {
                                     return cell.id.kind == CellKind::Stability &&
                                            cell.Value("failures") > 0.0;
                                 }));
    AddTable(section, FormulasTable(study));
    return section;
}

/// Planned cells that are not there, the first few by name.
std::string Missing(const Study& study)
{
    constexpr std::size_t k_Named = 10;
    std::vector<std::string> names = study.MissingCells();
    const std::size_t count = names.size();
    names.resize(std::min(count, k_Named));
    return count == 0 ? ""
                      : CountText(count, "planned cell") + " not measured: " + Joined(names, ", ") +
                            (count > k_Named ? ", ..." : "") + ".";
}

/// Returns the techniques that passed, and how often the others failed, for a study of stability
/// only.
std::string Verdict(const Comparison& comparison)
{
    std::vector<std::string> passed;
    std::vector<std::string> failed;
    for (const Standing& standing : comparison.standings)
    {
        const std::string& name = standing.technique->name;
        if (standing.failures > 0)
        {
            failed.push_back(name + " " + std::to_string(standing.failures) + " of " +
                             std::to_string(standing.stabilityCells));
        }
        else if (standing.stabilityCells > 0)
        {
            passed.push_back(name);
        }
    }
    return (passed.empty() ? "No technique passes all checks."
                           : Joined(passed, ", ") + " passed all checks.") +
           (failed.empty() ? "" : " Checks failed: " + Joined(failed, ", ") + ".");
}

} // namespace

std::vector<std::string> SceneRemarks(const Study& study)
{
    std::vector<std::string> notes; // in the order of the cells
    std::map<std::string, std::vector<std::string>> namesOf;
    std::vector<std::string> all;
    for (const CellResult& cell : study.cells)
    {
        const CellId& id = cell.id;
        if (id.kind != CellKind::Geometry || id.subject != k_SceneSubject || cell.values.empty())
        {
            continue;
        }
        const std::string name = id.technique + (id.variant.empty() ? "" : " (" + id.variant + ")");
        AddOnce(name, all);
        for (const std::string& note : cell.notes)
        {
            AddOnce(note, notes);
            AddOnce(name, namesOf[note]);
        }
    }
    std::vector<std::string> sentences;
    for (const std::string& note : notes)
    {
        const std::vector<std::string>& names = namesOf[note];
        sentences.push_back((names.size() == all.size() ? "The scene" : Joined(names, ", ")) +
                            ": " + note + ".");
    }
    return sentences;
}

ReportText ReportOf(const Study& study, const Comparison& comparison, const ReportOptions& options)
{
    ReportText report;
    const std::string name = std::filesystem::path(study.scene).filename().string();
    report.title = "Outlines of " + (name.empty() ? study.scene : name);
    report.subtitle = study.device + ", " + study.started;
    const Recommendation recommendation = Recommend(
        comparison, options.budgetMilliseconds.value_or(std::numeric_limits<double>::infinity()));
    report.recommendation = recommendation.sentence;
    report.more = recommendation.more;
    report.tiles = TilesOf(study, comparison, recommendation.standing, report.tilesCaption);
    const bool hasStability = std::ranges::any_of(comparison.standings, [](const Standing& standing)
                                                  { return standing.stabilityCells > 0; });
    if (comparison.front.empty() && hasStability)
    {
        report.recommendation = Verdict(comparison);
    }
    report.remarks = WarningsOf(comparison);
    const std::vector<std::string> ofScene = SceneRemarks(study);
    report.remarks.insert(report.remarks.end(), ofScene.begin(), ofScene.end());
    report.remarks.insert(report.remarks.end(), options.remarks.begin(), options.remarks.end());
    if (const std::string missing = Missing(study); !missing.empty())
    {
        report.remarks.push_back(missing);
    }
    report.plots = PlotsOf(study, comparison, options.budgetMilliseconds);
    std::erase_if(report.plots, [](const Plot& plot) { return plot.isEmpty(); });

    Section without{"without-width", "Without a width"};
    AddTable(without, NoWidthTable(study));
    Section provenance{"measured", "How this was measured"};
    AddTable(provenance, ProvenanceTable(study));
    for (Section section : {Choice(comparison), Error(study, comparison), Numerical(study),
                            Temporal(study), Cost(study, comparison), Pictures(study, comparison),
                            Stability(study, comparison), without, provenance})
    {
        std::erase_if(section.plots, [&report](const std::string& file)
                      { return std::ranges::count(report.plots, file, &Plot::file) == 0; });
        if (!section.plots.empty() || !section.tables.empty() || !section.strips.empty())
        {
            report.sections.push_back(std::move(section));
        }
    }
    return report;
}

} // namespace limn::study
