#include "data/port/ToolboxFeature.h"
#include "port/Ported.h"

#include <regex>
#include <set>
#include <sstream>

// C# with each construct that a render feature of URP 14 and of Unity 6 has. ToolboxFeature.h is
// the first of them in C++, by hand: that it compiles says which of its members limn has.

namespace limn::test
{

namespace
{

using testing::HasSubstr;
using testing::Not;

/// A row of the report's second table.
struct JudgedUse
{
    std::string key;
    std::string verdict;
};

std::vector<JudgedUse> UsesOf(const std::string& report)
{
    static const std::regex k_Row(R"(\| `([^`]+)` \| [^|]+ \| (\**\w+\**) \|.*)");
    std::istringstream lines(report.substr(report.find("## What it uses")));
    std::vector<JudgedUse> uses;
    for (std::string line; std::getline(lines, line);)
    {
        std::smatch match;
        if (std::regex_match(line, match, k_Row))
        {
            uses.push_back({match[1], match[2]});
        }
    }
    return uses;
}

std::set<std::string> WordsOf(const std::string& cpp)
{
    static const std::regex k_Word(R"(\w+)");
    const std::string code = std::regex_replace(cpp, std::regex("//[^\n]*"), "");
    const std::sregex_iterator begin(code.begin(), code.end(), k_Word);
    std::set<std::string> words;
    std::for_each(begin, std::sregex_iterator(),
                  [&](const std::smatch& match) { words.insert(match.str()); });
    return words;
}

} // namespace

TEST(PortToolbox, JudgesEachMemberAsTheCompiledCppHasIt)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("ToolboxFeature.cs")}, "ToolboxFeature");
    const std::set<std::string> cpp = WordsOf(ReadText(Sample("ToolboxFeature.h")));
    int same = 0;
    for (const JudgedUse& use : UsesOf(ported.report))
    {
        const std::string member = use.key.substr(use.key.rfind('.') + 1);
        EXPECT_NE(use.verdict, "**unknown**") << use.key;
        if (use.verdict == "same")
        {
            ++same;
            EXPECT_TRUE(cpp.contains(member)) << use.key << " is the same, and not in the C++";
        }
        else if (use.verdict == "missing" || use.verdict == "refused")
        {
            EXPECT_FALSE(cpp.contains(member)) << use.key << " is " << use.verdict;
        }
    }
    EXPECT_GT(same, 220);
    EXPECT_THAT(ported.run.err, Not(HasSubstr("unknown")));
}

TEST(PortToolbox, HasEachSettingPassEventAndName)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("ToolboxFeature.cs")}, "ToolboxFeature");
    ExpectAll(ported.header, {"drawEvent = RenderPassEvent::AfterRenderingOpaques;",
                              "blitEvent = RenderPassEvent::BeforeRenderingPostProcessing + 1;",
                              "layers = LayerMask::Everything();",
                              "strength = 0.5f;",
                              "copies = 3;",
                              "half = true;",
                              "tint = Color{0.25f, 0.5f, 1",
                              "offset = Vector4(1.0f, 2.0f",
                              "detail = ToolboxFeature::Detail::Middle;",
                              "passName = \"Toolbox Draw\";",
                              "Shared<const Shader> shader{};",
                              "Shared<ComputeShader> compute{};",
                              "Shared<const Mesh> mesh{};",
                              "compare = CompareFunction::LessEqual;",
                              "inspector.Header(\"When\");",
                              "Field(\"strength\", strength, {0.0, 2.0}, \"\");",
                              "Field(\"copies\", copies, {.min = 1}, \"\");",
                              "Field(\"compute\", compute, \"\");",
                              "// Mesh mesh;", // no setting of limn
                              "void Dispose(bool disposing) override;"});
    ExpectAll(ported.source,
              {"m_Targets = std::make_unique<ToolboxFeature::TargetsPass>(settings);",
               "m_Draw = std::make_unique<ToolboxFeature::DrawPass>(settings.passName, "
               "settings.drawEvent);",
               "m_Blit = std::make_unique<ToolboxFeature::BlitPass>(settings.strength);",
               "m_Blit->renderPassEvent = settings.blitEvent;",
               "profilingSampler = ProfilingSampler(k_Name);",
               "profilingSampler = ProfilingSampler(\"BlitPass\");", "renderPassEvent = when;",
               "s_Tag = ShaderTagId(\"UniversalForward\");",
               "const Shared<GraphicsBuffer>& arguments"});
    for (const char* row :
         {"| setting | `ToolboxSettings.drawEvent` |", "| setting | `ToolboxSettings.mesh` |",
          "| pass | `TargetsPass` |", "| pass | `DrawPass` |", "| pass | `BlitPass` |",
          "| event | `TargetsPass.renderPassEvent` |", "| event | `DrawPass.renderPassEvent` |",
          "| event | `BlitPass.renderPassEvent` | `settings.blitEvent` |",
          "| name of a pass | `TargetsPass.profilingSampler` |",
          "| name of a pass | `BlitPass.profilingSampler` |"})
    {
        EXPECT_THAT(ported.report, HasSubstr(row));
    }
}

TEST(PortToolbox, WritesThePassesOfARenderGraph)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("GraphToolboxFeature.cs")}, "GraphToolboxFeature");
    ExpectAll(
        ported.source,
        {"struct DrawData",
         "RendererListHandle objects{};",
         "BufferHandle counts{};",
         "Shared<ComputeShader> compute{};",
         "// AnimationCurve falloff;",
         "DrawData* passData = nullptr;\n",
         "auto builder = renderGraph.AddRasterRenderPass<DrawData>(\"Toolbox Draw\", passData, "
         "profilingSampler);",
         "builder.AllowPassCulling(false);",
         "builder.AllowGlobalStateModification(true);",
         "builder.SetRenderAttachment(target, 0);",
         "Draw(data, context);",
         "AddRasterRenderPass<DrawData>(\"GraphToolboxPass\", passData);",
         "builder.UseAllGlobalTextures(true);",
         "passData->kernel = m_Compute->FindKernel(\"Main\");",
         "auto builder = graph.AddComputePass<ComputeData>(\"Toolbox Compute\", passData);",
         "builder.EnableAsyncCompute(true);",
         "cmd.DispatchCompute(data.compute, data.kernel, 8, 8, 1);",
         "renderGraph.AddUnsafePass<DrawData>(k_UnsafeName, unsafeData);",
         "([[maybe_unused]] EmptyData& data, [[maybe_unused]] UnsafeGraphContext& context)",
         "AddUnsafePass<EmptyData>(std::string(\"Round \") + std::to_string(m_Rounds), passData);",
         "renderGraph.AddCopyPass(target, history, \"Toolbox Copy\");",
         "// The objects that glow."}); // comments go over, too
}

TEST(PortToolbox, SaysWhichPassesOfARenderGraphItDoesNotWrite)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("GraphToolboxFeature.cs")}, "GraphToolboxFeature");
    ExpectAll(ported.source, {"cs:145: the type 'ForeignData' is none of the pass's or file's"});
    EXPECT_THAT(ported.source, Not(HasSubstr("AddUnsafePass<ForeignData>(\"Toolbox Foreign\", "
                                             "passData)")));
    ExpectAll(ported.report, {"| `\"Toolbox Draw\"` | GraphToolboxFeature.cs:109 | done |",
                              "| `\"Toolbox Compute\"` | GraphToolboxFeature.cs:76 | done |",
                              "| `k_UnsafeName` | GraphToolboxFeature.cs:158 | done |",
                              "| `\"Toolbox Round\"` | GraphToolboxFeature.cs:134 | done |",
                              "| `ForeignData` | GraphToolboxFeature.cs:145:46"});
    EXPECT_THAT(ported.run.err, HasSubstr(" 1 unknown; "));
}

} // namespace limn::test
