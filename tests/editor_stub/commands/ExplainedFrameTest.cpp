#include "explain/ExplainedFrame.h"
#include "Mentions.h"
#include "Paths.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/ScriptableRenderContext.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace limn::test
{

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

std::string Sample(const std::string& name)
{
    return SourcePath("samples/" + name + "/" + name + ".scene.yaml");
}

/// An outline of nothing, because no renderer is in its rendering layer.
std::vector<std::string> NothingSelected()
{
    return {"explain", Sample("furniture"), "--set",
            "Screen Space Outline.m_RenderingLayerMask=10"};
}

/// Compares with a text of tests/editor_stub/data/explained; LIMN_UPDATE_GOLDEN=1 writes it
/// instead.
void ExpectExplained(const std::vector<std::string>& args, const std::string& name)
{
    const CommandRun run = RunCommand(args);
    EXPECT_EQ(0, run.exitCode) << run.err;
    const std::string path = SourcePath("tests/editor_stub/data/explained/" + name + ".txt");
    if (std::getenv("LIMN_UPDATE_GOLDEN") != nullptr)
    {
        std::ofstream(path) << run.out;
        FAIL() << "wrote " << path << "; look at it, then run without LIMN_UPDATE_GOLDEN";
    }
    EXPECT_EQ(ReadText(path), run.out) << name;
}

nlohmann::json ExplainAsJson(std::vector<std::string> args)
{
    args.push_back("--json");
    const CommandRun run = RunCommand(args);
    EXPECT_EQ(0, run.exitCode) << run.err;
    return nlohmann::json::parse(run.out);
}

const nlohmann::json& TextureNamed(const nlohmann::json& explained, const std::string& name)
{
    for (const auto& texture : explained.at("textures"))
    {
        if (texture.at("name") == name)
        {
            return texture;
        }
    }
    throw std::out_of_range(name);
}

TEST(ExplainedFrame, OfEachSampleIsAsLookedAt)
{
    ExpectExplained({"explain", Sample("furniture")}, "furniture");
    ExpectExplained({"explain", Sample("translucent_solid")}, "translucent_solid");
    ExpectExplained(NothingSelected(), "furniture_nothing_selected");
}

TEST(ExplainedFrame, TellsLoadStoreBarriersAndDrawsOfEachPass)
{
    const auto explained = ExplainAsJson({"explain", Sample("furniture")});
    const auto& passes = explained.at("frame").at("passes");
    ASSERT_EQ(4u, passes.size());
    const auto& mask = passes[0];
    EXPECT_EQ("Screen Space Outline", mask.at("name"));
    EXPECT_EQ(13, mask.at("drawsBeforeInstancing"));
    EXPECT_LT(mask.at("draws"), 13);
    EXPECT_EQ(nlohmann::json::parse(R"([{"texture": "_RendererDrawingTexture", "load": "clear",
                                        "store": "store"}])"),
              mask.at("targets"));
    EXPECT_EQ(nlohmann::json::parse(R"(["_RendererDrawingTexture"])"), passes[1].at("samples"));
    EXPECT_EQ(nlohmann::json::parse(R"({"texture": "_RendererDrawingTexture",
                                        "before": "ColorAttachment", "after": "ShaderRead"})"),
              passes[1].at("barriers")[0]);
    EXPECT_EQ("clear", passes[2].at("targets")[0].at("load"));
    EXPECT_EQ("Draw Opaque Objects + Draw Transparent Objects + Screen Space Outline",
              passes[2].at("name"));
    EXPECT_TRUE(explained.at("leftOut").empty());
}

// 1280 x 720 texels of 8 bytes, 640 x 360 of one.
TEST(ExplainedFrame, TellsTheBytesAndTheLifeOfEachTexture)
{
    const auto explained = ExplainAsJson({"explain", Sample("furniture")});
    const auto& camera = TextureNamed(explained, "_CameraColorAttachmentA");
    EXPECT_EQ(7372800, camera.at("bytes"));
    EXPECT_EQ(3, camera.at("firstPass"));
    EXPECT_EQ(4, camera.at("lastPass"));
    const auto& mask = TextureNamed(explained, "_RendererDrawingTexture");
    EXPECT_EQ(230400, mask.at("bytes"));
    EXPECT_EQ(1, mask.at("firstPass"));
    EXPECT_EQ(2, mask.at("lastPass"));
    EXPECT_TRUE(TextureNamed(explained, "limn_Output").at("output"));
    EXPECT_FALSE(mask.at("output"));
    // The mask is not needed any more when the camera's passes begin; the edges are.
    EXPECT_EQ(nlohmann::json::parse(R"(["_CameraColorAttachmentA"])"), mask.at("sharesMemoryWith"));
    EXPECT_EQ(nlohmann::json::parse(R"(["_RendererDrawingTexture"])"),
              camera.at("sharesMemoryWith"));
    EXPECT_TRUE(TextureNamed(explained, "_OutlineTexture").at("sharesMemoryWith").empty())
        << "it is needed beside each of the others";
}

TEST(ExplainedFrame, HasNoPassAndNoTextureOfAnOutlineOfNothing)
{
    const auto explained = ExplainAsJson(NothingSelected());
    for (const auto& pass : explained.at("frame").at("passes"))
    {
        EXPECT_THAT(pass.at("name").get<std::string>(), testing::Not(HasSubstr("Outline")));
    }
    EXPECT_THROW(TextureNamed(explained, "_RendererDrawingTexture"), std::out_of_range);
    EXPECT_THROW(TextureNamed(explained, "_OutlineTexture"), std::out_of_range);
    ASSERT_EQ(3u, explained.at("leftOut").size());
    EXPECT_EQ(nlohmann::json::parse(R"(["_RendererDrawingTexture"])"),
              explained.at("leftOut")[0].at("targets"));
}

/// A kernel writes a texture and the counts of a draw, another runs by them.
TEST(ExplainedFrame, TellsWhatKernelsWriteAndWhatFindsItsCountsInABuffer)
{
    const auto compiler = std::make_shared<ShaderCompiler>();
    const auto kernels = ComputeShader::FromText(
        "#pragma kernel Fill\n#pragma kernel Use\nRWTexture2D<float4> _Out; "
        "RWStructuredBuffer<uint> _Counts; Texture2D _In;\n"
        "[numthreads(1, 1, 1)] void Fill() { _Counts[0] = 3; _Out[uint2(0, 0)] = 1; }\n"
        "[numthreads(1, 1, 1)] void Use() { _Out[uint2(0, 0)] = _In.Load(0); }\n",
        "K.compute", compiler);
    const auto texture = [](const char* name)
    {
        RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R32G32B32A32_SFloat);
        descriptor.enableRandomWrite = true;
        return std::make_shared<const RenderTexture>(name, descriptor);
    };
    const auto first = texture("First");
    const auto second = texture("Second");
    const auto counts =
        std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::IndirectArguments, 8, 4);
    kernels->SetTexture(0, "_Out", first);
    kernels->SetBuffer(0, "_Counts", counts);
    kernels->SetTexture(1, "_In", first);
    kernels->SetTexture(1, "_Out", second);
    CommandBuffer cmd;
    cmd.BeginSample("Fill");
    cmd.DispatchCompute(kernels, 0, 1, 1, 1);
    cmd.EndSample();
    cmd.BeginSample("Use");
    cmd.DispatchCompute(kernels, 1, counts, 0);
    cmd.EndSample();
    RenderReport report;
    ScriptableRenderContext context(report);
    context.ExecuteCommandBuffer(cmd);
    const ExplainedFrame frame =
        ExplainFrame(CompileFrame(context.TakeCommands(), TextureStates(), std::span(&second, 1)));
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_EQ(frame.passes[0].name, "Fill");
    EXPECT_EQ(DrawsText(frame.passes[0]), "1 dispatch");
    ASSERT_EQ(frame.passes[0].targets.size(), 1u);
    EXPECT_EQ(frame.textures[frame.passes[0].targets[0].texture].name, "First");
    EXPECT_EQ(frame.passes[0].targets[0].load, "-");
    EXPECT_EQ(DrawsText(frame.passes[1]), "1 dispatch by a buffer's counts");
    EXPECT_EQ(frame.passes[1].bufferBarriers, 1);
    ASSERT_EQ(frame.passes[1].reads.size(), 1u);
    EXPECT_EQ(frame.textures[frame.passes[1].reads[0]].name, "First");
    ExplainedPass draws;
    draws.draws = draws.instances = 3;
    draws.limited = 1;
    draws.indirect = 2;
    EXPECT_EQ(DrawsText(draws), "3 draws, 1 of them in a part, 2 of them by a buffer's counts");
}

/// A frame of two passes with a pass that is left out between them.
ExplainedFrame SmallFrame()
{
    ExplainedFrame frame;
    frame.textures = {{"Mask <1>", "8x8", "R8_UNorm", 1, 64, 1, 2, true, false},
                      {"Out", "8x8", "R8G8B8A8_SRGB", 1, 256, 2, 2, true, true},
                      {"Depth", "8x8", "D32_SFloat", 1, 256, 2, 2, true, false},
                      {"wood", "4x4", "R8G8B8A8_SRGB", 1, 64, 2, 2, false, false}};
    ExplainedPass mask{0, "Mask & co", 8, 8, {{0, "clear", "store"}}, {}, {}, 5, 2, 0};
    ExplainedPass blit{2,      "Blit", 8, 8, {{1, "-", "store"}, {2, "clear", "-"}},
                       {0, 3}, {},     1, 1, 1};
    frame.passes = {mask, blit};
    frame.leftOut = {{"Copy", "nothing reads 'Unread'", {"Unread"}, 1}};
    return frame;
}

TEST(FrameGraphText, HasPassesInOrderWithWhatIsLeftOutBetweenThem)
{
    const std::string graph = FrameGraph(SmallFrame());
    EXPECT_THAT(graph, HasSubstr("pass1 -> leftout1 [style=invis"));
    EXPECT_THAT(graph, HasSubstr("leftout1 -> pass2 [style=invis"));
    EXPECT_THAT(graph, HasSubstr("Copy → Unread"));
    EXPECT_THAT(graph, HasSubstr("left out: nothing reads 'Unread'"));
}

TEST(FrameGraphText, HasTexturesBetweenPassesWithLoadAndStoreOnTheArrows)
{
    const std::string graph = FrameGraph(SmallFrame());
    EXPECT_THAT(graph, HasSubstr("pass1 -> texture0_1 [label=\" clear, store\"]"));
    EXPECT_THAT(graph, HasSubstr("texture0_1 -> pass2 [label=\" sample\""));
    EXPECT_THAT(graph, HasSubstr("pass2 -> texture1_2 [label=\" store\"]"));
    EXPECT_THAT(graph, HasSubstr("pass2 -> texture2_2 [label=\" clear, not stored\""));
    EXPECT_THAT(graph, HasSubstr("64 B"));
    EXPECT_THAT(graph, HasSubstr("256 B, the result"));
    EXPECT_THAT(graph, HasSubstr("5 → 2 draws"));
    EXPECT_THAT(graph, HasSubstr("1 draw in a part only, 1 texture given"));
    EXPECT_THAT(graph, testing::Not(HasSubstr("wood")));
}

TEST(FrameGraphText, CannotBeBrokenByAName)
{
    const std::string graph = FrameGraph(SmallFrame());
    EXPECT_THAT(graph, HasSubstr("Mask &amp; co"));
    EXPECT_THAT(graph, HasSubstr("Mask &lt;1&gt;"));
    EXPECT_THAT(graph, testing::Not(HasSubstr("Mask <1>")));
}

TEST(FrameGraphFile, IsDrawnByGraphviz)
{
    const TemporaryFolder folder;
    for (const char* name : {"a b'.dot", "a b'.svg"})
    {
        const CommandRun run =
            RunCommand({"explain", Sample("furniture"), "--graph", (folder / name).string()});
        ASSERT_EQ(0, run.exitCode) << run.err;
    }
    EXPECT_THAT(ReadText(folder / "a b'.dot"), testing::StartsWith("digraph frame"));
    const std::string svg = ReadText(folder / "a b'.svg");
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_THAT(svg, HasSubstr("_RendererDrawingTexture"));
}

TEST(FrameGraphFile, NeedsGraphvizOnlyWhereItIsToBeDrawn)
{
    const TemporaryFolder folder;
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder.path().c_str(), 1);
    const CommandRun svg =
        RunCommand({"explain", Sample("furniture"), "--graph", (folder / "a.svg").string()});
    const CommandRun dot =
        RunCommand({"explain", Sample("furniture"), "--graph", (folder / "a.dot").string()});
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(3, svg.exitCode);
    EXPECT_THAT(svg.err, Mentions("program 'dot'", "cannot be started"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.svg"));
    EXPECT_EQ(0, dot.exitCode) << dot.err;
}

TEST(FrameGraphFile, HasAnEndingThatSaysWhatItIs)
{
    const CommandRun run = RunCommand({"explain", Sample("furniture"), "--graph", "a.bmp"});
    EXPECT_EQ(2, run.exitCode);
    EXPECT_THAT(run.err, Mentions("'a.bmp'", ".svg, .png, .pdf or .dot"));
}

} // namespace

} // namespace limn::test
