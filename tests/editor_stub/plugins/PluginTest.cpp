#include "Mentions.h"
#include "PluginRun.h"

#include <gmock/gmock.h>
#include <limn/features/Plugin.h>

namespace limn::test
{

namespace
{

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

/// Matches stderr and the exit code if the plug-in cannot be used, for which one line mentions
/// these.
template <typename... Parts>
auto Refuses(const Parts&... parts)
{
    return testing::ResultOf(LinesOf, ElementsAre(Mentions(parts...), "exit 1"));
}

} // namespace

TEST(Plugin, IsInWhatInspectAndSchemaAndExplainAndSetSay)
{
    const PluginFolder folder;
    const std::string inspected = folder.Run("inspect s.scene.yaml --plugin probe.so");
    EXPECT_THAT(inspected, AllOf(HasSubstr("ProbeFeature"), HasSubstr("fault"), HasSubstr("Probe"),
                                 HasSubstr("strength"), HasSubstr("0.75"), EndsWith("exit 0\n")));
    EXPECT_THAT(folder.Run("schema scene --plugin ./probe.so"),
                AllOf(HasSubstr("ProbeFeature"), HasSubstr("Where it throws")));
    EXPECT_THAT(folder.Run("schema profile --plugin probe.so"), HasSubstr("How red the picture"));
    EXPECT_THAT(folder.Run("explain -v s.scene.yaml --plugin probe.so"),
                AllOf(HasSubstr("Paint"), HasSubstr("Hidden/Probe"), HasSubstr("strength"),
                      EndsWith("exit 0\n")));
    EXPECT_THAT(folder.Run("set p.profile.yaml Probe.strength=0.5 --plugin probe.so"),
                HasSubstr("Probe.strength: 0.75 → 0.5\n"));
}

TEST(Plugin, OfASceneNeedsNoOption)
{
    const PluginFolder folder;
    EXPECT_THAT(folder.Run("explain s.scene.yaml"),
                AllOf(HasSubstr("unknown feature 'ProbeFeature'"), EndsWith("exit 1\n")));
    std::filesystem::remove("probe.so"); // a link that leads out of the scene's folder
    std::filesystem::copy_file(std::filesystem::path(LimnExecutable()).parent_path() /
                                   "../tests/plugins/probe.so",
                               "probe.so");
    folder.WriteScene("{type: ProbeFeature}", "plugins: [probe.so]\n");
    EXPECT_THAT(folder.Run("explain -v s.scene.yaml"),
                AllOf(HasSubstr("Hidden/Probe"), EndsWith("exit 0\n")));
    EXPECT_THAT(folder.Run("explain -v s.scene.yaml --plugin probe.so"), EndsWith("exit 0\n"));
}

TEST(Plugin, OfASceneThatCannotBeUsedIsAnErrorAtItsPlace)
{
    const PluginFolder folder;
    folder.WriteScene("", "plugins: [text.so]\n");
    EXPECT_THAT(
        LinesOf(folder.Run("explain s.scene.yaml")),
        AllOf(Contains(Mentions("s.scene.yaml:3:11:", "plugins[0]", "'text.so'", "cannot be used")),
              Contains(Mentions("text.so:", "cannot be loaded")), Contains("exit 1")));
    folder.WriteScene("", "plugins: [probe.so]\n"); // the link
    EXPECT_THAT(
        folder.Run("explain s.scene.yaml"),
        AllOf(HasSubstr("plugins[0]: 'probe.so' lies outside the folders"), EndsWith("exit 1\n")));
}

TEST(Plugin, ThatCannotBeUsedIsRefusedWithAReason)
{
    const PluginFolder folder;
    const auto run = [&](const std::string& module)
    {
        return folder.Run("explain s.scene.yaml --plugin " + module);
    };
    EXPECT_THAT(run("no.so"), Refuses("no.so:", "cannot be loaded", "no such file"));
    EXPECT_THAT(run("text.so"), AllOf(Refuses("text.so:", "cannot be loaded"),
                                      Not(HasSubstr(std::filesystem::current_path().string()))));
    EXPECT_THAT(run("missing_symbol.so"),
                Refuses("missing_symbol.so:", "probe::Paint(int)", "source"));
    EXPECT_THAT(run("no_plugin.so"), Refuses("no_plugin.so:", "no plug-in", "'limn_plugin'",
                                             "LIMN_PLUGIN", "<limn/features/Plugin.h>"));
    const std::string version = folder.Run("--version"); // "limn 0.1.0\nexit 0\n"
    EXPECT_THAT(run("old_plugin.so"),
                Refuses("old_plugin.so:", "limn 0.0.9", version.substr(0, version.find('\n')),
                        "build it again"));
    std::ostringstream layout;
    layout << std::hex << PluginLayout();
    EXPECT_THAT(run("other_build.so"), Refuses("other_build.so:", "headers", LIMN_VERSION_TEXT,
                                               "compiler", layout.str(), "build it again"));
}

TEST(Plugin, WhoseFileEndsTooEarlyIsRefusedWhereverThatIs)
{
    const PluginFolder folder;
    const std::string whole = ReadText(BuiltPlugin("probe.so"));
    for (const std::size_t size : {whole.size() - 1, whole.size() * 3 / 4, whole.size() / 2,
                                   whole.size() / 4, std::size_t{4096}, std::size_t{100}})
    {
        folder.Write("half.so", whole.substr(0, size));
        EXPECT_THAT(folder.Run("explain s.scene.yaml --plugin half.so"),
                    Refuses("half.so:", "too early", std::to_string(size) + " bytes", "linker"));
    }
    for (const std::size_t size : {std::size_t{10}, std::size_t{0}})
    {
        folder.Write("half.so", whole.substr(0, size));
        EXPECT_THAT(folder.Run("explain s.scene.yaml --plugin half.so"),
                    Refuses("half.so:", "cannot be loaded", "too short"));
    }
}

TEST(Plugin, WhoseFileIsLongEnoughButNotWrittenYetIsRefused)
{
    const PluginFolder folder;
    std::string half = ReadText(BuiltPlugin("probe.so"));
    std::fill(half.begin() + static_cast<std::ptrdiff_t>(half.size() / 2), half.end(), '\0');
    folder.Write("half.so", half);
    EXPECT_THAT(folder.Run("explain s.scene.yaml --plugin half.so"),
                Refuses("half.so:", "end of the file", "not there", "linker"));
}

TEST(Plugin, ThatThrowsIsNamed)
{
    const PluginFolder folder;
    const auto run = [&](const std::string& fault)
    {
        folder.WriteScene("{type: ProbeFeature, name: Red, fault: " + fault + "}");
        return folder.Run("explain s.scene.yaml --plugin probe.so");
    };
    const auto threw = [](const std::string& where, const std::string& what)
    {
        return Refuses("probe.so:", "'Red' threw", where, what);
    };
    EXPECT_THAT(run("Create"), threw("Create", "out of paint"));
    EXPECT_THAT(run("AddRenderPasses"), threw("AddRenderPasses", "not today"));
    EXPECT_THAT(run("Culling"), threw("cullingMargin", "no margin"));
    EXPECT_THAT(run("Setup"), threw("OnCameraSetup of pass 'Paint'", "no such texture"));
    EXPECT_THAT(run("Execute"), threw("Execute of pass 'Paint'", "the brush is gone"));
    EXPECT_THAT(run("Nameless"), threw("Execute of pass 'Paint'", "without a name"));
    EXPECT_THAT(run("Draw"), threw("Execute of pass 'Paint'", "a target is missing"));
    EXPECT_THAT(LinesOf(run("File")),
                ElementsAre(Mentions("brush.png:", "no such file"),
                            Mentions("probe.so: note", "'Red' threw", "Execute of pass 'Paint'"),
                            "exit 1"));
    EXPECT_THAT(run("RecordRenderGraph"), threw("RecordRenderGraph of pass 'Graph'", "no paper"));
    EXPECT_THAT(run("RenderFunction"), threw("render function of pass 'Wash'", "no water"));
}

TEST(Plugin, ThatThrowsOutsideOfAFrameIsNamed)
{
    const PluginFolder folder;
    folder.WriteScene("{type: ProbeFeature, name: Red}");
    const auto run = [&](probe::Fault fault, const std::string& command = "explain s.scene.yaml")
    {
        folder.Write("x.so", FaultyProbe(fault));
        return folder.Run(command + " --plugin x.so");
    };
    EXPECT_THAT(run(probe::Fault::Constructor),
                Refuses("x.so:", "'ProbeFeature' threw", "constructor", "no canvas"));
    EXPECT_THAT(run(probe::Fault::ComponentConstructor),
                Refuses("x.so:", "'Probe' threw", "constructor", "no paint at all"));
    EXPECT_THAT(run(probe::Fault::Registration),
                Refuses("x.so:", "registration threw", "nothing to sell"));
    EXPECT_THAT(run(probe::Fault::Blend),
                Refuses("x.so:", "'probe::Probe' threw", "Override", "paints do not mix"));
    EXPECT_THAT(run(probe::Fault::Describe),
                Refuses("x.so:", "'Red' threw", "Describe", "lost for words"));
    EXPECT_THAT(run(probe::Fault::Describe, "schema scene"),
                Refuses("x.so:", "'probe::ProbeFeature' threw", "Describe", "lost for words"));
    EXPECT_THAT(run(probe::Fault::Describe, "inspect s.scene.yaml"),
                Refuses("x.so:", "'Red' threw", "Describe", "lost for words"));
}

} // namespace limn::test
