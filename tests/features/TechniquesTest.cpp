#include "Paths.h"
#include "ShippedTechniques.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/features/RenderObjects.h>
#include <map>
#include <regex>
#include <set>

namespace limn::test
{
namespace
{

std::vector<std::string> LinesOf(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

/// The feature folder with a source that registers the feature under its name.
std::string FolderOf(const Technique& technique)
{
    for (const auto& file : std::filesystem::recursive_directory_iterator(SourcePath("features")))
    {
        for (const std::string& line : LinesOf(file.path()))
        {
            if (file.path().extension() == ".cpp" &&
                line.find('"' + technique.feature + '"') != std::string::npos)
            {
                return file.path().parent_path().parent_path().filename().string();
            }
        }
    }
    return "";
}

Technique Named(const std::string& name, int place)
{
    Technique technique;
    technique.name = name;
    technique.place = place;
    return technique;
}

TEST(FeatureRegistry, ListsTheTechniquesOfAllFeaturesByTheirPlaces)
{
    FeatureRegistry features;
    features.Register<RenderObjects>("Later", {Named("Third", 7), Named("First", 2)});
    features.Register<RenderObjects>("Plain");
    features.Register<RenderObjects>("Last", {Named("Fourth", 7), Named("Second", 3)});
    std::vector<std::string> listed;
    for (const Technique& technique : features.techniques())
    {
        listed.push_back(technique.name + " of " + technique.feature);
    }
    EXPECT_THAT(listed, testing::ElementsAre("First of Later", "Second of Last", "Third of Later",
                                             "Fourth of Last"));
    EXPECT_EQ(FindTechnique(features.techniques(), "fOURTH"), &features.techniques()[3]);
    EXPECT_EQ(FindTechnique(features.techniques(), "Fifth"), nullptr);
}

TEST(FeatureRegistry, RefusesATechniqueWhoseNameIsEmptyOrTakenAndItsFeature)
{
    FeatureRegistry features;
    features.Register<RenderObjects>("Feature", {Named("Ink", 1)});
    for (const char* name : {"", "ink"})
    {
        EXPECT_THROW(features.Register<RenderObjects>("Other", {Named("New", 1), Named(name, 1)}),
                     ContractError);
    }
    EXPECT_THROW(features.Register<RenderObjects>("Other", {Named("A", 1), Named("a", 1)}),
                 ContractError);
    EXPECT_EQ(features.names().size(), 1u);
    EXPECT_EQ(features.techniques().size(), 1u);
}

TEST(Techniques, AreTheRowsOfTheTableOfFeatures)
{
    const std::regex row("(\\| [^|]+ \\| `\\w+` \\| [^|]+ \\|) [^|]+ \\|");
    std::vector<std::string> rows;
    for (const std::string& line : LinesOf(SourcePath("features/README.md")))
    {
        std::smatch cells;
        if (std::regex_match(line, cells, row))
        {
            rows.push_back(cells[1]);
        }
    }
    std::vector<std::string> expected;
    for (const Technique& technique : ShippedTechniques())
    {
        expected.push_back("| " + technique.name + " | `" + FolderOf(technique) + "` | " +
                           technique.summary + " |");
    }
    EXPECT_THAT(rows, testing::ElementsAreArray(expected));
}

TEST(Techniques, AreInBothTablesOfFiguresByTheNamesOfTheirComponents)
{
    std::set<std::string> expected;
    for (const Technique& technique : ShippedTechniques())
    {
        expected.insert(technique.component + " in " + FolderOf(technique));
    }
    const auto rowsOf = [](const char* page, const std::string& folder)
    {
        const std::regex link("\\| \\[(\\w+)\\]\\(" + folder + "(\\w+)/(README\\.md)?\\) \\|");
        std::set<std::string> rows;
        for (const std::string& line : LinesOf(SourcePath(page)))
        {
            std::smatch cells;
            if (std::regex_search(line, cells, link))
            {
                rows.insert(cells.str(1) + " in " + cells.str(2));
            }
        }
        return rows;
    };
    EXPECT_EQ(expected, rowsOf("README.md", "features/"));
    EXPECT_EQ(expected, rowsOf("features/README.md", ""));
}

TEST(Techniques, HaveTheSameFiguresInBothTables)
{
    const auto figuresOf = [](const char* page, const std::string& folder, const std::string& cells)
    {
        const std::regex row("\\| \\[(\\w+)\\]\\(" + folder + "[^|]* \\| " + cells);
        std::map<std::string, std::string> figures;
        for (const std::string& line : LinesOf(SourcePath(page)))
        {
            std::smatch match;
            if (std::regex_search(line, match, row))
            {
                const std::string error = match.str(2).empty() ? "–" : match.str(2);
                figures[match[1]] = error + ", " + match.str(3) + " ms";
            }
        }
        return figures;
    };
    const auto first = figuresOf("README.md", "features/", "(.*), (.*) ms \\|$");
    EXPECT_EQ(10u, first.size());
    // Mean error, perhaps of what; width; flicker; time, known to so much.
    const auto measured =
        figuresOf("features/README.md", "",
                  "?([0-9.]+|as chosen|)(?: of [^|]*)? ?\\|.*\\| ([0-9.]+) ± [0-9.]+ \\|$");
    EXPECT_EQ(measured, first);
}

TEST(Techniques, HaveAProfileAndAFeatureInTheSamples)
{
    const std::filesystem::path folder = SourcePath("samples/selection");
    AssetContext assets;
    const SceneAsset scene = LoadScene(folder / "selection.scene.yaml", assets);
    std::set<std::string> components;
    for (const auto& file : std::filesystem::directory_iterator(folder))
    {
        const std::vector<std::string> lines = LinesOf(file.path());
        if (file.path().string().ends_with(".profile.yaml") && lines.size() > 2 &&
            lines[0].find(": ") != std::string::npos) // the caption in the contact sheet
        {
            for (const auto& component : assets.LoadProfile(file).profile->components())
            {
                const VolumeComponent& one = *component;
                components.insert(assets.volumeComponents().Find(typeid(one))->name);
            }
        }
    }
    for (const Technique& technique : ShippedTechniques())
    {
        EXPECT_THAT(scene.renderer.featureTypes, testing::Contains(technique.feature));
        EXPECT_THAT(components, testing::Contains(technique.component));
    }
}

} // namespace
} // namespace limn::test
