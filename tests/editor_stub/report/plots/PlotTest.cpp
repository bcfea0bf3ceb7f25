#include "Mentions.h"
#include "TemporaryFolder.h"
#include "report/pages/SampleStudy.h"
#include "report/plots/PlotLayout.h"
#include "report/plots/Plots.h"
#include <limn/base/RunProgram.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace limn::test
{

namespace
{

using study::LabelWish;
using study::LogAxis;
using study::PixelBox;
using study::Plot;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;

bool Meet(const PixelBox& a, const PixelBox& b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

TEST(LabelPlacement, CoversNothingWhereThereIsRoom)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 800.0);
    const PixelBox frame{0.0, 0.0, 800.0, 800.0};
    for (int round = 0; round < 100; ++round)
    {
        std::vector<LabelWish> wishes;
        std::vector<PixelBox> points;
        for (int i = 0; i < 12; ++i)
        {
            const double x = place(random);
            const double y = place(random);
            wishes.push_back({x, y, 90.0, 16.0, false});
            points.push_back({x - 5.0, y - 5.0, x + 5.0, y + 5.0});
        }
        const auto boxes = PlaceLabels(wishes, points, frame);
        ASSERT_EQ(wishes.size(), boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i)
        {
            ASSERT_TRUE(boxes[i]) << "of twelve on so much room none is left out";
            EXPECT_NEAR(90.0, boxes[i]->right - boxes[i]->left, 1e-9);
            EXPECT_GE(boxes[i]->left, 0.0);
            EXPECT_LE(boxes[i]->bottom, 800.0);
            for (std::size_t j = 0; j < boxes.size(); ++j)
            {
                EXPECT_FALSE(Meet(*boxes[i], points[j]));
                EXPECT_FALSE(i != j && Meet(*boxes[i], *boxes[j]));
            }
        }
    }
}

TEST(LabelPlacement, WithoutRoomLeavesOutOnlyWhatIsNotNeeded)
{
    const PixelBox frame{0.0, 0.0, 100.0, 100.0};
    const std::vector<PixelBox> full = {frame};
    const std::vector<LabelWish> wishes = {{50.0, 50.0, 20.0, 10.0, false},
                                           {50.0, 50.0, 20.0, 10.0, true},
                                           {50.0, 50.0, 200.0, 10.0, true}};
    const auto boxes = PlaceLabels(wishes, full, frame);
    EXPECT_FALSE(boxes[0]);
    EXPECT_TRUE(boxes[1]);
    EXPECT_FALSE(boxes[2]) << "no place within the frame is wide enough";
}

LogAxis AxisOf(const std::vector<double>& values)
{
    return study::MakeLogAxis(values);
}

TEST(LogAxis, HoldsAllValuesAndHasTicksAmongThem)
{
    const LogAxis axis = AxisOf({0.003, 2.0, 40.0});
    EXPECT_FALSE(axis.clamps);
    EXPECT_LT(axis.low, 0.003);
    EXPECT_GT(axis.high, 40.0);
    EXPECT_THAT(axis.ticks,
                ElementsAre(Pair(testing::DoubleEq(0.01), "0.01"),
                            Pair(testing::DoubleEq(0.1), "0.1"), Pair(1.0, "1"), Pair(10.0, "10")));
    EXPECT_NEAR(0.5, axis.Part(std::sqrt(axis.low * axis.high)), 1e-12);
}

TEST(LogAxis, DrawsWhatIsNotAboveZeroAtItsLowerEndAndSaysSo)
{
    for (const double value : {0.0, -0.02, -1e9})
    {
        const LogAxis axis = AxisOf({value, 0.5, 40.0});
        EXPECT_TRUE(axis.clamps);
        EXPECT_LT(axis.low, 0.5 / 1.2) << "it is apart from what is above zero";
        EXPECT_EQ(axis.low, axis.Clamped(value));
        EXPECT_EQ(0.0, axis.Part(value));
        EXPECT_THAT(axis.ticks, Contains(Pair(axis.low, "≤ 0")));
    }
}

TEST(LogAxis, IsThereForAnyValues)
{
    const double infinity = std::numeric_limits<double>::infinity();
    for (const std::vector<double>& values :
         {std::vector<double>{}, {0.0}, {1.0}, {infinity, std::nan("")}, {5e-324, 1e308}})
    {
        const LogAxis axis = AxisOf(values);
        EXPECT_GT(axis.low, 0.0);
        EXPECT_LT(axis.low, axis.high);
        EXPECT_TRUE(std::isfinite(axis.high));
    }
}

const Plot& FindPlot(const std::vector<Plot>& plots, const std::string& file)
{
    return *std::ranges::find_if(plots, [&file](const Plot& plot) { return plot.file == file; });
}

std::vector<std::string> NamesOf(const std::vector<study::PlotPoint>& points)
{
    std::vector<std::string> names;
    for (const study::PlotPoint& point : points)
    {
        names.push_back(point.name);
    }
    return names;
}

TEST(ErrorAgainstTimePlot, HasTheFrontTheFloorTheBudgetAndArticlesApart)
{
    study::Study sample = EmptySample();
    AddTechnique(sample, "Ours");
    AddTechnique(sample, "Theirs", true);
    AddTechnique(sample, "Rim", false, "it has none");
    AddPoint(sample, "Ours", 8.0, 2.0, 0.001);
    AddPoint(sample, "Theirs", 8.0, 4.0, 0.5);
    const study::Comparison comparison = Compare(sample);
    const std::vector<Plot> plots = PlotsOf(sample, comparison, 3.0);
    const Plot& plot = FindPlot(plots, "error_time");
    EXPECT_THAT(NamesOf(plot.series[0].points), ElementsAre("Ours"));
    EXPECT_THAT(NamesOf(plot.series[1].points), ElementsAre("Theirs"));
    EXPECT_FALSE(plot.series[0].isArticle);
    EXPECT_TRUE(plot.series[1].isArticle);
    EXPECT_TRUE(plot.series[0].points[0].isOnFront);
    EXPECT_FALSE(plot.series[1].points[0].isOnFront);
    ASSERT_EQ(1u, plot.front.size());
    EXPECT_EQ(2.0, plot.front[0].milliseconds);
    EXPECT_THAT(plot.verticals, ElementsAre(Pair(0.25, "floor"), Pair(3.0, "budget")));
    EXPECT_THAT(plot.caption, Mentions("Not in it", "an error", "a time", "Rim"));
    EXPECT_EQ(std::pair(1.8, 2.2), plot.series[0].points[0].barX);
    EXPECT_TRUE(plot.isLessBetter);
    EXPECT_FALSE(FindPlot(plots, "time_objects").isLessBetter) << "more objects are not worse";
}

TEST(ErrorAgainstTimePlot, HasNoPointWhereATimeHasNoBound)
{
    study::Study sample = EmptySample();
    AddTechnique(sample, "Known");
    AddTechnique(sample, "Unknown");
    AddPoint(sample, "Known", 8.0, 2.0, 0.001);
    AddPoint(sample, "Unknown", 8.0, 1.0, 0.1);
    sample.cells.back().values.erase("gpuAddedUncertainty");
    const std::vector<Plot> plots = PlotsOf(sample, Compare(sample), std::nullopt);
    const Plot& plot = FindPlot(plots, "error_time");
    EXPECT_THAT(NamesOf(plot.series[0].points), ElementsAre("Known"));
    EXPECT_THAT(plot.caption, HasSubstr("that this run knows: Unknown."));
}

TEST(LinePlots, HaveALineATechniqueThroughItsCells)
{
    const study::Study sample = FullSample();
    const study::Comparison comparison = Compare(sample);
    const std::vector<Plot> plots = PlotsOf(sample, comparison, std::nullopt);
    for (const auto& [file, places] :
         {std::pair("error_width", 7u), std::pair("time_resolution", 4u),
          std::pair("time_objects", 4u)})
    {
        const Plot& plot = FindPlot(plots, file);
        EXPECT_EQ(places, plot.ticksX.size());
        EXPECT_GE(plot.series.size(), 9u) << file;
        for (const study::PlotSeries& series : plot.series)
        {
            EXPECT_EQ(places, series.points.size()) << file << series.name;
        }
    }
    EXPECT_THAT(FindPlot(plots, "time_resolution").ticksX,
                Contains(Pair(1920.0 * 1080.0, "1920x1080")));
    EXPECT_THAT(FindPlot(plots, "time_objects").ticksX, Contains(Pair(1000.0, "1000")));
}

TEST(Plots, AreEmptyWhereNothingWasMeasured)
{
    const study::Study sample = EmptySample();
    for (const Plot& plot : PlotsOf(sample, Compare(sample), std::nullopt))
    {
        EXPECT_TRUE(plot.isEmpty()) << plot.file;
    }
}

/// A plot of two points with such names everywhere.
Plot PlotNamed(const std::string& name)
{
    Plot plot;
    plot.file = "plot";
    plot.title = plot.labelX = plot.labelY = name;
    plot.verticals = {{3.0, name}};
    plot.ticksX = {{1.0, name}, {10.0, "ten"}};
    plot.series = {{name, 0, false, false, {{{1.0, 0.0}, {0.5, 2.0}, {0.0, 0.1}, name, true}}},
                   {name, 1, true, true, {{{10.0, 0.5}, {8.0, 12.0}, {0.4, 0.6}, name, false}}}};
    plot.front = {{1.0, 0.0}};
    return plot;
}

TEST(PlotScript, GivesNoNameAsACommandToGnuplot)
{
    const TemporaryFolder folder;
    const std::string file = (folder / "made").string();
    for (const std::string& name : std::vector<std::string>{
             "`touch " + file + "`", "'; system('touch " + file + "'); '",
             "\"; system(\"touch " + file + "\")", "\n!touch " + file + "\n",
             "EOD\n!touch " + file + "\n", "@x {/*2 big} ^up _down \\ % $data1 \xFF"})
    {
        for (const auto format : {study::PlotFormat::Svg, study::PlotFormat::NarrowSvg})
        {
            const std::string svg =
                RunProgram({"gnuplot", "-d", "-"}, PlotScript(PlotNamed(name), format), "gnuplot");
            EXPECT_THAT(svg, HasSubstr("</svg>")) << name;
        }
        EXPECT_FALSE(std::filesystem::exists(file)) << name;
    }
}

TEST(PlotScript, NamesStandAsTheyAre)
{
    const std::string svg =
        RunProgram({"gnuplot", "-d", "-"},
                   PlotScript(PlotNamed("it's <b>_a_ & {b}^2"), study::PlotFormat::Svg), "gnuplot");
    EXPECT_THAT(svg, HasSubstr("it’s &lt;b>_a_ &amp; {b}^2"));
}

/// The numbers on the rest of the first line of a script that begins so; {} if there is none.
std::vector<double> NumbersAfter(const std::string& script, const std::string& beginning)
{
    std::vector<double> numbers;
    const std::size_t found = script.find(beginning);
    if (found == std::string::npos)
    {
        return numbers;
    }
    const std::size_t from = found + beginning.size();
    std::string line = script.substr(from, script.find('\n', from) - from);
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    for (std::string word; words >> word;)
    {
        const char* const end = word.data() + word.size();
        double number = 0.0;
        if (std::from_chars(word.data(), end, number).ptr == end)
        {
            numbers.push_back(number);
        }
    }
    return numbers;
}

TEST(PlotScript, HasAnArrowToTheBetterCornerBesideThePoints)
{
    Plot plot = PlotNamed("a");
    plot.front.clear();
    plot.verticals.clear();
    EXPECT_THAT(PlotScript(plot, study::PlotFormat::Svg), Not(HasSubstr("'better'")));
    plot.isLessBetter = true;
    for (const bool isCornerTaken : {false, true})
    {
        // The axes go from 1 to 10 and from 0.1 to 1; a point lies at each end.
        plot.series[0].points[0].at = {1.0, isCornerTaken ? 0.1 : 1.0};
        plot.series[1].points[0].at = {10.0, isCornerTaken ? 1.0 : 0.1};
        for (study::PlotSeries& series : plot.series)
        {
            series.points[0].barX = series.points[0].barY = {std::nan(""), std::nan("")};
        }
        const std::string script = PlotScript(plot, study::PlotFormat::Svg);
        EXPECT_THAT(script, HasSubstr("set label 'better' at graph "));
        // From x, y to x, y, in parts of the plot's width and height.
        const std::vector<double> arrow = NumbersAfter(script, "\nset arrow from graph");
        ASSERT_GE(arrow.size(), 4u) << script;
        EXPECT_LT(arrow[2], arrow[0]) << "to the left";
        EXPECT_LT(arrow[3], arrow[1]) << "down";
        if (isCornerTaken)
        {
            EXPECT_GT(std::max(arrow[2], arrow[3]), 0.04) << "the point is at 0.06 of both";
        }
        else
        {
            EXPECT_LT(std::max(arrow[2], arrow[3]), 0.04);
        }
        EXPECT_LT(std::max(arrow[2], arrow[3]), 0.3) << "and as near to the corner as it can be";
    }
}

TEST(PlotScript, NamesTwoVerticalsThatAreFartherOutBesideEachOther)
{
    Plot plot = PlotNamed("a");
    plot.ticksX.clear();
    plot.verticals = {{1e-9, "floor"}, {1e-8, "budget"}};
    const std::string script = PlotScript(plot, study::PlotFormat::Svg);
    const std::vector<double> floor =
        NumbersAfter(script, "set label 'floor 1.0e-09 ms, farther out' at graph");
    const std::vector<double> budget =
        NumbersAfter(script, "set label 'budget 1.0e-08 ms, farther out' at graph");
    ASSERT_GE(floor.size(), 2u) << script;
    ASSERT_GE(budget.size(), 2u) << script;
    EXPECT_GT(std::abs(floor[0] - budget[0]), 14.0 / 860.0) << "a letter of 14 px of 860";
}

TEST(PlotScript, NamesBothAxesLogarithmic)
{
    const std::string script = PlotScript(PlotNamed("a"), study::PlotFormat::NarrowSvg);
    EXPECT_THAT(script, HasSubstr("set xlabel 'a (logarithmic)'"));
    EXPECT_THAT(script, HasSubstr("set label 'a (logarithmic)'"));
}

TEST(PlotScript, DrawsZeroAtTheEndOfTheAxis)
{
    const std::string script = PlotScript(PlotNamed("a"), study::PlotFormat::Svg);
    std::istringstream range(script.substr(script.find("set yrange [") + 12));
    std::string low;
    std::getline(range, low, ':');
    EXPECT_THAT(script, HasSubstr("\n1 " + low + "\nEOD")) << "the point at (1, 0)";
    EXPECT_THAT(script, HasSubstr("'≤ 0' " + low));
}

TEST(PlotScript, IsAPngOnRequest)
{
    const std::string png = RunProgram(
        {"gnuplot", "-d", "-"}, PlotScript(PlotNamed("a"), study::PlotFormat::Png), "gnuplot");
    EXPECT_TRUE(png.starts_with("\x89PNG\r\n"));
}

} // namespace

} // namespace limn::test
