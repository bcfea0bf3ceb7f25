#include "report/StudyPlan.h"

#include "report/extremes/Stability.h"
#include "report/figures/Numbers.h"
#include "report/measure/StudyBench.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

namespace limn::study
{

namespace
{

constexpr glm::ivec2 k_ShapeSize{480, 270};
constexpr glm::ivec2 k_QuickShapeSize{240, 135};
constexpr glm::ivec2 k_MotionSize{160, 90};
constexpr double k_UsualWidth = 4.0; ///< pixels

/// The cells of error and of cost.
std::vector<CellId> PlanMeasures(const StudyOptions& options, std::span<const Technique> techniques)
{
    std::vector<CellId> cells;
    const auto add = [&](CellKind kind, const std::string& subject, double width,
                         const glm::ivec2& size, const std::string& variant = "")
    {
        for (const Technique& technique : techniques)
        {
            cells.push_back({kind, technique.name, subject, width, size.x, size.y, variant});
        }
    };
    const glm::ivec2 sceneSize = options.sceneSize;
    const bool isQuick = options.isQuick;
    const std::vector<double> widths =
        isQuick ? std::vector<double>{2, 8} : std::vector<double>{1, 2, 4, 8, 16, 32, 64};
    for (const double width : isQuick ? std::vector<double>{k_UsualWidth} : widths)
    {
        add(CellKind::Geometry, k_SceneSubject, width, sceneSize);
        for (const Technique& technique : techniques)
        {
            for (const char* part : {k_SeenPart, k_HiddenPart})
            {
                if (options.isPartlyHidden && !technique.occlusion.empty())
                {
                    cells.push_back({CellKind::Geometry, technique.name, k_SceneSubject, width,
                                     sceneSize.x, sceneSize.y, part});
                }
            }
        }
    }
    constexpr std::array k_Moving{"disc", "needle"};
    for (const char* shape : isQuick ? std::span<const char* const>(k_Moving) : k_ShapeNames)
    {
        for (const double width : widths)
        {
            add(CellKind::Geometry, shape, width, isQuick ? k_QuickShapeSize : k_ShapeSize);
        }
    }
    for (const char* shape : k_Moving)
    {
        for (const double width : isQuick ? std::vector<double>{2} : std::vector<double>{2, 8})
        {
            add(CellKind::Temporal, shape, width, k_MotionSize);
        }
    }
    for (const char* variant :
         std::span(k_NumericalVariants).first(isQuick ? 1 : k_NumericalVariants.size()))
    {
        add(CellKind::Numerical, "star", k_UsualWidth, k_MotionSize, variant);
    }
    add(CellKind::Cost, k_SceneSubject, k_UsualWidth, sceneSize);
    if (isQuick)
    {
        return cells;
    }
    for (const double width : {2.0, 8.0, 32.0})
    {
        add(CellKind::Cost, k_SceneSubject, width, sceneSize);
    }
    for (const glm::ivec2 size :
         {glm::ivec2(320, 180), glm::ivec2(640, 360), glm::ivec2(1920, 1080)})
    {
        if (size != sceneSize)
        {
            add(CellKind::Cost, k_SceneSubject, k_UsualWidth, size);
        }
    }
    for (const char* count : {"1 objects", "10 objects", "100 objects", "1000 objects"})
    {
        add(CellKind::Cost, k_BallsSubject, k_UsualWidth, {1280, 720}, count);
    }
    return cells;
}

/// These words name what a cell measures, by its kind.
constexpr std::array k_KindWords{"error", "rounding error", "flicker", "time", "stability"};

/// Returns words for a subject or a variant that results have a short key for.
std::string WordsFor(const std::string& key)
{
    static const std::map<std::string, std::string> words = {
        {k_SceneSubject, "in your scene"},
        {k_BallsSubject, "around balls"},
        {"disc", "around a disc"},
        {"ring", "around a ring"},
        {"star", "around a star"},
        {"needle", "around a needle"},
        {"two", "around two shapes"},
        {"1 objects", "1 object"},
        {"half", "half precision"},
        {"standard Z", "depth from 0 (near) to 1 (far)"},
        {"R8 targets", "8-bit targets"},
        {k_SeenPart, "the part that is seen"},
        {k_HiddenPart, "the part behind something"}};
    const auto found = words.find(key);
    return found == words.end() ? key : found->second;
}

} // namespace

int StudyOptions::RoundsOf(const CellId& cell) const
{
    const bool isCompared = cell.subject == k_SceneSubject && cell.width == k_UsualWidth &&
                            glm::ivec2(cell.pictureWidth, cell.pictureHeight) == sceneSize;
    return isQuick ? 9 : isCompared ? 101 : 31;
}

std::string StudyOptions::Text() const
{
    std::ostringstream text;
    text << (hasStability ? "stability" : "error and cost")
         << (isQuick  ? ", quick"
             : isFull ? ", all combinations"
                      : "")
         << ", " << sceneSize.x << 'x' << sceneSize.y << (isPartlyHidden ? ", partly hidden" : "");
    for (const std::string& technique : techniques)
    {
        text << ", " << technique;
    }
    return text.str();
}

std::vector<CellId> PlanStudy(const StudyOptions& options, std::span<const Technique> techniques)
{
    std::vector<Technique> wanted(techniques.begin(), techniques.end());
    std::erase_if(wanted, [&names = options.techniques](const Technique& technique)
                  { return !names.empty() && std::ranges::count(names, technique.name) == 0; });
    if (options.hasStability)
    {
        return PlanStability(wanted, options.isQuick  ? SweepSize::Sampled
                                     : options.isFull ? SweepSize::Full
                                                      : SweepSize::Pairwise);
    }
    return PlanMeasures(options, wanted);
}

std::string UnitText(std::span<const CellId> unit)
{
    const CellId& id = unit.front();
    if (id.technique == k_FormulasName)
    {
        return "the formula " + id.subject + " with extreme numbers";
    }
    const bool isExtreme = id.kind == CellKind::Stability;
    return std::string(k_KindWords.at(static_cast<std::size_t>(id.kind))) + " of " +
           (unit.size() > 1 ? "all techniques" : id.technique) + " " +
           (isExtreme ? "with extreme settings" : WordsFor(id.subject)) +
           (isExtreme || id.variant.empty() ? "" : ", " + WordsFor(id.variant)) + ", " +
           Readable(id.width) + " pixels wide, picture " +
           SizeText(id.pictureWidth, id.pictureHeight);
}

std::vector<std::vector<CellId>> UnitsOf(const std::vector<CellId>& cells)
{
    std::vector<std::vector<CellId>> units;
    for (const CellId& cell : cells)
    {
        const bool isTogether =
            cell.kind == CellKind::Cost && !units.empty() &&
            units.back().front().NameForAllTechniques() == cell.NameForAllTechniques();
        if (!isTogether)
        {
            units.emplace_back();
        }
        units.back().push_back(cell);
    }
    return units;
}

} // namespace limn::study
