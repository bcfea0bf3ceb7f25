#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "assets/OutputFiles.h"
#include "check/Expectations.h"

#include <algorithm>
#include <limn/base/WriteFile.h>

namespace limn
{

namespace
{

void WriteFull(const CheckOptions& options, SceneFacts& facts, Console& console)
{
    const std::string text =
        FullExpectations(facts, "The expectations of 'limn check' for " + options.rendering.scene +
                                    ", as --update wrote them: take out what may change.");
    const auto written =
        CompareExpectations(text, options.expectations, facts, UnknownObjects::AreErrors);
    WriteFile(options.expectations, text);
    console.Results(CheckText(written, options.expectations, "failed", false));
}

/// Writes what does not hold anew.
void Update(const CheckOptions& options, const std::string& text, SceneFacts& facts,
            Console& console)
{
    const std::string& file = options.expectations;
    const std::vector<Expectation> old =
        CompareExpectations(text, file, facts, UnknownObjects::AreDifferences);
    const std::string updated = UpdateExpectations(text, file, old);
    for (const Expectation& one :
         CompareExpectations(updated, file, facts, UnknownObjects::AreErrors))
    {
        if (!one.holds())
        {
            throw AssetError(file, one.location,
                             one.name + ": cannot be written anew; change it "
                                        "by hand");
        }
    }
    if (updated != text)
    {
        WriteFile(file, updated);
    }
    console.Results(CheckText(old, file, "written anew", console.isVerbose()));
}

} // namespace

ExitCode RunCheck(const CheckOptions& options, Console& console)
{
    const RenderOptions& rendering = options.rendering;
    RequireKind(rendering.scene, {FileKind::Scene, FileKind::UnityScene}, "check");
    AssetContext assets(ChooseCompilerOptions(rendering, console));
    std::error_code ignored;
    const bool isNew = options.isUpdate && !std::filesystem::exists(options.expectations, ignored);
    const std::string text = isNew ? "" : ReadYamlText(options.expectations);
    SceneAsset asset = LoadForRendering(rendering, assets);
    console.Print(asset.notes);
    SceneFacts facts(std::move(asset), assets);
    std::set<std::filesystem::path> inputs = assets.reachedFiles();
    const std::string own[] = {options.isUpdate ? options.expectations : "", options.junit};
    RequireOwnFiles(own, inputs);
    if (options.isUpdate)
    {
        isNew ? WriteFull(options, facts, console) : Update(options, text, facts, console);
        return ExitCode::Done;
    }
    inputs.insert(options.expectations);
    RequireOwnFiles(own, inputs);
    const std::vector<Expectation> results =
        CompareExpectations(text, options.expectations, facts, UnknownObjects::AreErrors);
    if (!options.junit.empty())
    {
        WriteFile(options.junit, JUnitXml(results, options.expectations, rendering.scene));
    }
    options.json
        ? console.Data(CheckJson(results, options.expectations, rendering.scene))
        : console.Results(CheckText(results, options.expectations, "failed", console.isVerbose()));
    return std::ranges::all_of(results, &Expectation::holds) ? ExitCode::Done : ExitCode::BadInput;
}

} // namespace limn
