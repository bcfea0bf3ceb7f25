#include "PluginRun.h"

#include <gmock/gmock.h>
#include <limn/features/Plugin.h>

namespace limn::test
{

namespace
{

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// What stderr and the exit code are if the plug-in cannot be used.
std::string Refusal(const std::string& sentence)
{
    return sentence + "\nexit 1\n";
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
    EXPECT_THAT(folder.Run("explain s.scene.yaml"),
                AllOf(HasSubstr("s.scene.yaml:3:11: error: plugins[0]: 'text.so' cannot be used; "
                                "see the errors of that file\n"),
                      HasSubstr("text.so: error: the file cannot be loaded as a plug-in: "),
                      EndsWith("exit 1\n")));
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
    EXPECT_EQ(
        Refusal("no.so: error: the file cannot be loaded as a plug-in: there is no such file"),
        run("no.so"));
    EXPECT_THAT(run("text.so"),
                AllOf(StartsWith("text.so: error: the file cannot be loaded as a plug-in: "),
                      Not(HasSubstr(std::filesystem::current_path().string())),
                      EndsWith("\nexit 1\n")));
    EXPECT_EQ(Refusal("missing_symbol.so: error: the file cannot be loaded as a plug-in: it uses "
                      "probe::Paint(int), which neither it nor limn has; add the source that "
                      "defines it, or build it again with this limn"),
              run("missing_symbol.so"));
    EXPECT_EQ(Refusal("no_plugin.so: error: the file is no plug-in of limn: it does not define "
                      "'limn_plugin'; "
                      "write LIMN_PLUGIN of <limn/features/Plugin.h> in one of its files"),
              run("no_plugin.so"));
    const std::string version = folder.Run("--version"); // "limn 0.1.0\nexit 0\n"
    EXPECT_EQ(Refusal("old_plugin.so: error: this plug-in cannot be used: it was built for limn "
                      "0.0.9, but this is " +
                      version.substr(0, version.find('\n')) + "; build it again with this one"),
              run("old_plugin.so"));
    std::ostringstream layout;
    layout << std::hex << PluginLayout();
    EXPECT_EQ(Refusal("other_build.so: error: this plug-in cannot be used: it was built with other "
                      "headers of limn " LIMN_VERSION_TEXT
                      ", or with another compiler (1; of this limn it is " +
                      layout.str() + "); build it again with this one"),
              run("other_build.so"));
}

TEST(Plugin, WhoseFileEndsTooEarlyIsRefusedWhereverThatIs)
{
    const PluginFolder folder;
    const std::string whole = ReadText(BuiltPlugin("probe.so"));
    for (const std::size_t size : {whole.size() - 1, whole.size() * 3 / 4, whole.size() / 2,
                                   whole.size() / 4, std::size_t{4096}, std::size_t{100}})
    {
        folder.Write("half.so", whole.substr(0, size));
        EXPECT_EQ(
            Refusal(
                "half.so: error: the file cannot be loaded as a plug-in: the file ends too early, "
                "after " +
                std::to_string(size) + " bytes; is it being written, or was the linker stopped?"),
            folder.Run("explain s.scene.yaml --plugin half.so"));
    }
    for (const std::size_t size : {std::size_t{10}, std::size_t{0}})
    {
        folder.Write("half.so", whole.substr(0, size));
        EXPECT_EQ(Refusal("half.so: error: the file cannot be loaded as a plug-in: file too short"),
                  folder.Run("explain s.scene.yaml --plugin half.so"));
    }
}

TEST(Plugin, WhoseFileIsLongEnoughButNotWrittenYetIsRefused)
{
    const PluginFolder folder;
    std::string half = ReadText(BuiltPlugin("probe.so"));
    std::fill(half.begin() + static_cast<std::ptrdiff_t>(half.size() / 2), half.end(), '\0');
    folder.Write("half.so", half);
    EXPECT_EQ(
        Refusal(
            "half.so: error: the file cannot be loaded as a plug-in: the end of the file is not "
            "there yet; is it being written, or was the linker stopped?"),
        folder.Run("explain s.scene.yaml --plugin half.so"));
}

TEST(Plugin, ThatThrowsIsNamed)
{
    const PluginFolder folder;
    const auto run = [&](const std::string& fault)
    {
        folder.WriteScene("{type: ProbeFeature, name: Red, fault: " + fault + "}");
        return folder.Run("explain s.scene.yaml --plugin probe.so");
    };
    const std::string red = "probe.so: error: 'Red' threw in ";
    EXPECT_EQ(Refusal(red + "Create: out of paint"), run("Create"));
    EXPECT_EQ(Refusal(red + "AddRenderPasses: not today"), run("AddRenderPasses"));
    EXPECT_EQ(Refusal(red + "cullingMargin: no margin"), run("Culling"));
    EXPECT_EQ(Refusal(red + "OnCameraSetup of pass 'Paint': no such texture"), run("Setup"));
    EXPECT_EQ(Refusal(red + "Execute of pass 'Paint': the brush is gone"), run("Execute"));
    EXPECT_EQ(Refusal(red + "Execute of pass 'Paint': an exception without a name"),
              run("Nameless"));
    EXPECT_EQ(Refusal(red + "Execute of pass 'Paint': a target is missing"), run("Draw"));
    EXPECT_EQ(Refusal("brush.png: error: there is no such file\n"
                      "probe.so: note: 'Red' threw in Execute of pass 'Paint' the error above"),
              run("File"));
    EXPECT_EQ(Refusal(red + "RecordRenderGraph of pass 'Graph': no paper"),
              run("RecordRenderGraph"));
    EXPECT_EQ(Refusal(red + "the render function of pass 'Wash': no water"), run("RenderFunction"));
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
    const std::string error = "x.so: error: ";
    EXPECT_EQ(Refusal(error + "'ProbeFeature' threw in its constructor: no canvas"),
              run(probe::Fault::Constructor));
    EXPECT_EQ(Refusal(error + "'Probe' threw in its constructor: no paint at all"),
              run(probe::Fault::ComponentConstructor));
    EXPECT_EQ(Refusal(error + "this plug-in cannot be used: its registration threw: nothing to "
                              "sell"),
              run(probe::Fault::Registration));
    EXPECT_EQ(Refusal(error + "'probe::Probe' threw in Override: paints do not mix"),
              run(probe::Fault::Blend));
    EXPECT_EQ(Refusal(error + "'Red' threw in Describe: lost for words"),
              run(probe::Fault::Describe));
    EXPECT_EQ(Refusal(error + "'probe::ProbeFeature' threw in Describe: lost for words"),
              run(probe::Fault::Describe, "schema scene"));
    EXPECT_EQ(Refusal(error + "'Red' threw in Describe: lost for words"),
              run(probe::Fault::Describe, "inspect s.scene.yaml"));
}

} // namespace limn::test
