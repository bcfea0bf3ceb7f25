#include "graph/GraphHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::AddRaster;
using test::AddUnsafe;
using test::Desc;
using test::Draw;
using test::GraphPass;
using test::Sample;
using testing::ElementsAre;
using testing::IsEmpty;

/// Whether a pass does what it declares: what a frame with it throws and notes.
class RenderGraphMismatch : public testing::Test
{
protected:
    void Render(GraphPass::Recording recording)
    {
        m_Pass = std::make_unique<GraphPass>(std::move(recording));
        harness.renderer.builtIn = {m_Pass.get()};
        harness.Render();
    }
    std::string ErrorOf(GraphPass::Recording recording)
    {
        return test::ThrownMessage<ContractError>([&] { Render(std::move(recording)); });
    }
    std::vector<std::string> NotesOf(GraphPass::Recording recording)
    {
        Render(std::move(recording));
        return harness.report.notes;
    }
    /// Of a raster pass "Blur" that draws into the camera's colour, behind one that wrote _Mask.
    template <typename Declare, typename Record>
    GraphPass::Recording Blur(Declare declare, Record record)
    {
        return [=](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle mask = WrittenMask(graph);
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            AddRaster(
                graph, "Blur",
                [&](auto& builder)
                {
                    builder.SetRenderAttachment(color, 0);
                    declare(builder, mask);
                },
                [=](RasterCommandBuffer& cmd) { record(cmd, mask); });
        };
    }
    static TextureHandle WrittenMask(RenderGraph& graph)
    {
        const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
        AddRaster(
            graph, "Mask", [&](auto& builder) { builder.SetRenderAttachment(mask, 0); },
            [](RasterCommandBuffer& cmd) { Draw(cmd); });
        return mask;
    }
    /// What a builder says to `declare`.
    std::string ErrorOfDeclaring(
        const std::function<void(RasterRenderGraphBuilder<test::NoData>&, RenderGraph&)>& declare)
    {
        return ErrorOf(
            [&](RenderGraph& graph, ContextContainer&)
            {
                AddRaster(
                    graph, "Blur", [&](auto& builder) { declare(builder, graph); },
                    [](RasterCommandBuffer&) {});
            });
    }

    test::RendererHarness harness;

private:
    std::unique_ptr<GraphPass> m_Pass;
};

const auto k_SampleMask = [](RasterCommandBuffer& cmd, const TextureHandle& mask)
{
    Sample(cmd, mask);
};

} // namespace

TEST_F(RenderGraphMismatch, IsNoneWhereThePassDoesWhatItDeclares)
{
    EXPECT_THAT(
        NotesOf(Blur([](auto& builder, const TextureHandle& mask) { builder.UseTexture(mask); },
                     k_SampleMask)),
        IsEmpty());
}

// Unity has given the texture back by then: nobody declares it behind the pass that wrote it.
TEST_F(RenderGraphMismatch, NamesATextureThatIsSampledUndeclared)
{
    EXPECT_EQ(
        ErrorOf(Blur([](auto&, const TextureHandle&) {}, k_SampleMask)),
        "pass 'Blur' declares no read of '_Mask', yet samples it, where its handle stands for "
        "no texture in Unity; add builder.UseTexture(<handle of '_Mask'>);");
}

TEST_F(RenderGraphMismatch, NotesAReadOfWhatThePassDeclaresToWrite)
{
    EXPECT_THAT(NotesOf(Blur([](auto& builder, const TextureHandle& mask)
                             { builder.UseTexture(mask, AccessFlags::Write); },
                             k_SampleMask)),
                ElementsAre("pass 'Blur' declares no read of '_Mask', yet samples it; "
                            "builder.UseTexture(<handle of '_Mask'>, AccessFlags::ReadWrite); "
                            "declares it"));
}

TEST_F(RenderGraphMismatch, NotesAReadOfWhatALaterPassDeclares)
{
    EXPECT_THAT(NotesOf(
                    [&](RenderGraph& graph, ContextContainer& frameData)
                    {
                        const TextureHandle mask = WrittenMask(graph);
                        const TextureHandle color =
                            frameData.Get<UniversalResourceData>().activeColorTexture();
                        for (const bool declares : {false, true})
                        {
                            AddRaster(
                                graph, declares ? "Later" : "Blur",
                                [&](auto& builder)
                                {
                                    builder.SetRenderAttachment(color, 0);
                                    if (declares)
                                    {
                                        builder.UseTexture(mask);
                                    }
                                },
                                [=](RasterCommandBuffer& cmd) { Sample(cmd, mask); });
                        }
                    }),
                ElementsAre("pass 'Blur' declares no read of '_Mask', yet samples it; "
                            "builder.UseTexture(<handle of '_Mask'>); declares it"));
}

TEST_F(RenderGraphMismatch, NotesAReadOfWhatIsGlobal)
{
    const auto material = std::make_shared<const Material>(test::ShaderWithProgram(
        "", "Texture2D _Mask; SamplerState sampler_Mask;", "_Mask.Sample(sampler_Mask, 0.5)"));
    EXPECT_THAT(NotesOf(
                    [&](RenderGraph& graph, ContextContainer& frameData)
                    {
                        const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                        AddRaster(
                            graph, "Mask",
                            [&](auto& builder)
                            {
                                builder.SetRenderAttachment(mask, 0);
                                builder.SetGlobalTextureAfterPass(mask, "_Mask");
                            },
                            [](RasterCommandBuffer& cmd) { Draw(cmd); });
                        AddRaster(
                            graph, "Blur",
                            [&](auto& builder) {
                                builder.SetRenderAttachment(
                                    frameData.Get<UniversalResourceData>().activeColorTexture(), 0);
                            },
                            [=](RasterCommandBuffer& cmd) { Draw(cmd, material); });
                    }),
                ElementsAre("pass 'Blur' declares no read of '_Mask', yet samples it; "
                            "builder.UseTexture(<handle of '_Mask'>); declares it"));
}

// They outlive the graph, so that nothing is wrong in Unity, and here neither.
TEST_F(RenderGraphMismatch, NotesOneOfTheCamerasTexturesByItsHandle)
{
    EXPECT_THAT(NotesOf(
                    [](RenderGraph& graph, ContextContainer& frameData)
                    {
                        const auto& resources = frameData.Get<UniversalResourceData>();
                        const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                        AddRaster(
                            graph, "Blur",
                            [&](auto& builder) { builder.SetRenderAttachment(mask, 0); },
                            [color = resources.activeColorTexture()](RasterCommandBuffer& cmd)
                            { Sample(cmd, color); });
                    }),
                ElementsAre("pass 'Blur' declares no read of 'CameraColor', yet samples it; "
                            "builder.UseTexture(resourceData.activeColorTexture()); declares it"));
}

TEST_F(RenderGraphMismatch, NamesAllThatIsWrongWithAPassAtOnce)
{
    EXPECT_EQ(ErrorOf(
                  [](RenderGraph& graph, ContextContainer& frameData)
                  {
                      const TextureHandle mask = WrittenMask(graph);
                      TextureDesc other = Desc("_Other");
                      other.clearBuffer = false;
                      const TextureHandle unwritten = graph.CreateTexture(other);
                      AddRaster(
                          graph, "Blur",
                          [&](auto& builder)
                          {
                              builder.SetRenderAttachment(
                                  frameData.Get<UniversalResourceData>().activeColorTexture(), 0);
                              builder.UseTexture(unwritten);
                              builder.UseGlobalTexture("_Nobody");
                          },
                          [=](RasterCommandBuffer& cmd)
                          {
                              Sample(cmd, mask);
                              Sample(cmd, unwritten);
                              cmd.SetGlobalFloat("_Width", 2.0f);
                              cmd.SetGlobalTexture("_Shown", mask);
                          });
                  }),
              "pass 'Blur': UseGlobalTexture names '_Nobody', but no pass before it made a texture "
              "global under that name; call SetGlobalTextureAfterPass in such a pass\n"
              "pass 'Blur' reads '_Other', which no pass before it writes, and clearBuffer is "
              "false: its contents are undefined\n"
              "pass 'Blur' sets the global '_Width', for which Unity throws; add "
              "builder.AllowGlobalStateModification(true);\n"
              "pass 'Blur' sets '_Mask' as the global '_Shown' and declares no use of it, for "
              "which Unity throws; add builder.UseTexture(<handle of '_Mask'>);\n"
              "pass 'Blur' sets the global '_Shown', for which Unity throws; add "
              "builder.AllowGlobalStateModification(true);\n"
              "pass 'Blur' declares no read of '_Mask', yet samples it, where its handle stands "
              "for no texture in Unity; add builder.UseTexture(<handle of '_Mask'>);");
}

TEST_F(RenderGraphMismatch, IsNoneWhereABlitSamplesWhatIsGlobal)
{
    const auto material = std::make_shared<const Material>(test::ShaderWithProgram(
        "", "Texture2D _BlitTexture; Texture2D _Mask; SamplerState sampler_Mask;",
        "_BlitTexture.Sample(sampler_Mask, 0.5) + _Mask.Sample(sampler_Mask, 0.5)"));
    EXPECT_THAT(NotesOf(
                    [material](RenderGraph& graph, ContextContainer& frameData)
                    {
                        const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                        const TextureHandle source = WrittenMask(graph);
                        AddRaster(
                            graph, "Global",
                            [&](auto& builder)
                            {
                                builder.SetRenderAttachment(mask, 0);
                                builder.SetGlobalTextureAfterPass(mask, "_Mask");
                            },
                            [](RasterCommandBuffer& cmd) { Draw(cmd); });
                        graph.AddBlitPass(
                            {source, frameData.Get<UniversalResourceData>().activeColorTexture(),
                             material, 0},
                            "Blit");
                    }),
                IsEmpty());
}

TEST_F(RenderGraphMismatch, LeavesTexturesAloneThatTheGraphDoesNotKnow)
{
    const RTHandle own(test::Target("Own"));
    EXPECT_THAT(
        NotesOf(Blur([](auto&, const TextureHandle&) {},
                     [own](RasterCommandBuffer& cmd, const TextureHandle&) { Sample(cmd, own); })),
        IsEmpty());
}

/// Of an unsafe pass "Chain" that clears `target`.
template <typename Declare>
void AddClearing(RenderGraph& graph, const TextureHandle& target, Declare declare)
{
    AddUnsafe(graph, "Chain", declare,
              [target](UnsafeCommandBuffer& cmd)
              {
                  cmd.SetRenderTarget(target);
                  cmd.ClearRenderTarget(ClearFlag::Color, Color::black);
              });
}

TEST_F(RenderGraphMismatch, NamesATextureThatAnUnsafePassDrawsIntoUndeclared)
{
    EXPECT_EQ(ErrorOf([&](RenderGraph& graph, ContextContainer&)
                      { AddClearing(graph, WrittenMask(graph), [](auto&) {}); }),
              "pass 'Chain' declares no write of '_Mask', yet draws into it, where its handle "
              "stands for no texture in Unity; add builder.UseTexture(<handle of '_Mask'>, "
              "AccessFlags::Write);");
}

TEST_F(RenderGraphMismatch, NamesAPassThatUnityLeavesOut)
{
    EXPECT_EQ(ErrorOf(
                  [](RenderGraph& graph, ContextContainer& frameData) {
                      AddClearing(graph, frameData.Get<UniversalResourceData>().cameraColor,
                                  [](auto&) {});
                  }),
              "pass 'Chain' declares no write, so that Unity leaves it out; add "
              "builder.UseTexture(resourceData.activeColorTexture(), AccessFlags::Write);");
    const RTHandle own(test::Target("Own"));
    EXPECT_EQ(ErrorOf(
                  [&](RenderGraph& graph, ContextContainer&)
                  {
                      AddUnsafe(
                          graph, "Chain", [](auto&) {},
                          [own](UnsafeCommandBuffer& cmd)
                          {
                              cmd.SetRenderTarget(own);
                              cmd.ClearRenderTarget(ClearFlag::Color, Color::black);
                          });
                  }),
              "pass 'Chain' declares no write, so that Unity leaves it out; add "
              "builder.AllowPassCulling(false);");
}

TEST_F(RenderGraphMismatch, NotesTheCamerasColourThatAPassDrawsIntoUndeclared)
{
    EXPECT_THAT(NotesOf(
                    [](RenderGraph& graph, ContextContainer& frameData)
                    {
                        AddClearing(graph, frameData.Get<UniversalResourceData>().cameraColor,
                                    [](auto& builder) { builder.AllowPassCulling(false); });
                    }),
                ElementsAre("pass 'Chain' declares no write of 'CameraColor', yet draws into it; "
                            "builder.UseTexture(resourceData.activeColorTexture(), "
                            "AccessFlags::Write); declares it"));
}

TEST_F(RenderGraphMismatch, IsNoneWhereAnUnsafePassTestsADepthThatItReads)
{
    EXPECT_THAT(NotesOf(
                    [](RenderGraph& graph, ContextContainer& frameData)
                    {
                        const auto& resources = frameData.Get<UniversalResourceData>();
                        AddUnsafe(
                            graph, "Chain",
                            [&](auto& builder)
                            {
                                builder.UseTexture(resources.activeColorTexture(),
                                                   AccessFlags::Write);
                                builder.UseTexture(resources.activeDepthTexture());
                            },
                            [color = resources.activeColorTexture(),
                             depth = resources.activeDepthTexture()](UnsafeCommandBuffer& cmd)
                            {
                                cmd.SetRenderTarget(color, depth);
                                Draw(cmd);
                            });
                    }),
                IsEmpty());
}

TEST_F(RenderGraphMismatch, NamesAPassThatDrawsWithoutATarget)
{
    const auto nothing = [](auto&) {
    };
    EXPECT_EQ(
        ErrorOf(
            [&](RenderGraph& graph, ContextContainer&)
            { AddRaster(graph, "Blur", nothing, [](RasterCommandBuffer& cmd) { Draw(cmd); }); }),
        "pass 'Blur' draws, yet declares no SetRenderAttachment");
    EXPECT_EQ(
        ErrorOf(
            [&](RenderGraph& graph, ContextContainer&)
            { AddUnsafe(graph, "Chain", nothing, [](UnsafeCommandBuffer& cmd) { Draw(cmd); }); }),
        "pass 'Chain' draws before it sets a render target");
}

TEST_F(RenderGraphMismatch, NamesAGlobalThatIsSetWithoutLeave)
{
    const auto set = [](RasterCommandBuffer& cmd, const TextureHandle& mask)
    {
        Sample(cmd, mask);
        cmd.SetGlobalFloat("_Width", 2.0f);
    };
    const auto declare = [](bool allows)
    {
        return [allows](auto& builder, const TextureHandle& mask)
        {
            builder.UseTexture(mask);
            builder.AllowGlobalStateModification(allows);
        };
    };
    EXPECT_EQ(ErrorOf(Blur(declare(false), set)),
              "pass 'Blur' sets the global '_Width', for which Unity throws; add "
              "builder.AllowGlobalStateModification(true);");
    EXPECT_THAT(NotesOf(Blur(declare(true), set)), IsEmpty());
    const auto setView = [](RasterCommandBuffer& cmd, const TextureHandle& mask)
    {
        Sample(cmd, mask);
        cmd.SetViewProjectionMatrices(glm::dmat4(1.0), glm::mat4(1.0f), false);
    };
    EXPECT_EQ(ErrorOf(Blur(declare(false), setView)),
              "pass 'Blur' sets the view and projection matrices, for which Unity throws; add "
              "builder.AllowGlobalStateModification(true);");
}

TEST_F(RenderGraphMismatch, NotesAGlobalThatANativeCommandBufferSets)
{
    const auto set = [](bool isKept)
    {
        return [isKept](RenderGraph& graph, ContextContainer&)
        {
            AddUnsafe(
                graph, "Chain", [&](auto& builder) { builder.AllowPassCulling(!isKept); },
                [](UnsafeCommandBuffer& cmd)
                { CommandBufferHelpers::GetNativeCommandBuffer(cmd).SetGlobalInt("_Count", 2); });
        };
    };
    EXPECT_THAT(NotesOf(set(true)),
                ElementsAre("pass 'Chain' sets '_Count' for all that follow by a native command "
                            "buffer; builder.AllowGlobalStateModification(true); declares it"));
    EXPECT_EQ(ErrorOf(set(false)), "pass 'Chain' declares no write, so that Unity leaves it out; "
                                   "add builder.AllowPassCulling(false);");
}

TEST_F(RenderGraphMismatch, NamesAKeywordThatIsSwitchedWithoutLeave)
{
    const auto wet = [](RasterCommandBuffer& cmd, const TextureHandle& mask)
    {
        Sample(cmd, mask);
        cmd.EnableShaderKeyword("WET");
    };
    EXPECT_EQ(ErrorOf(Blur(
                  [](auto& builder, const TextureHandle& mask) { builder.UseTexture(mask); }, wet)),
              "pass 'Blur' switches the keyword 'WET', for which Unity throws; add "
              "builder.AllowGlobalStateModification(true);");
}

TEST_F(RenderGraphMismatch, NamesAGlobalTextureThatNobodySet)
{
    EXPECT_EQ(
        ErrorOf(Blur([](auto& builder, const TextureHandle&)
                     { builder.UseGlobalTexture("_Nobody"); },
                     k_SampleMask)),
        "pass 'Blur': UseGlobalTexture names '_Nobody', but no pass before it made a texture "
        "global under that name; call SetGlobalTextureAfterPass in such a pass\n"
        "pass 'Blur' declares no read of '_Mask', yet samples it, where its handle stands for "
        "no texture in Unity; add builder.UseTexture(<handle of '_Mask'>);");
}

TEST_F(RenderGraphMismatch, NotesATextureThatIsReadBeforeAnythingWroteIt)
{
    const auto read = [](bool clears)
    {
        return [clears](RenderGraph& graph, ContextContainer&)
        {
            TextureDesc desc = Desc("_Mask");
            desc.clearBuffer = clears;
            const TextureHandle mask = graph.CreateTexture(desc);
            AddUnsafe(
                graph, "Blur", [&](auto& builder) { builder.UseTexture(mask); },
                [](UnsafeCommandBuffer&) {});
        };
    };
    EXPECT_THAT(NotesOf(read(true)), ElementsAre("pass 'Blur' reads '_Mask', which no pass before "
                                                 "it writes: the texture holds the clearColor"));
    EXPECT_EQ(ErrorOf(read(false)), "pass 'Blur' reads '_Mask', which no pass before it writes, "
                                    "and clearBuffer is false: its contents are undefined");
}

TEST_F(RenderGraphMismatch, NamesARendererListThatIsDrawnUndeclared)
{
    const auto record = [&](bool declares, bool draws)
    {
        return [=, this](RenderGraph& graph, ContextContainer& frameData)
        {
            const RendererListHandle list = graph.CreateRendererList(
                RendererListParams(harness.cullResults, DrawingSettings(), FilteringSettings()));
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            AddRaster(
                graph, "List",
                [&](auto& builder)
                {
                    builder.SetRenderAttachment(color, 0);
                    if (declares)
                    {
                        builder.UseRendererList(list);
                    }
                },
                [=](RasterCommandBuffer& cmd)
                {
                    Draw(cmd);
                    if (draws)
                    {
                        cmd.DrawRendererList(list);
                    }
                });
        };
    };
    EXPECT_EQ(ErrorOf(record(false, true)),
              "pass 'List' draws a renderer list without declaring it by UseRendererList, so that "
              "Unity would draw nothing; add builder.UseRendererList(<its handle>);");
    EXPECT_THAT(NotesOf(record(true, false)),
                ElementsAre("pass 'List' declares UseRendererList of a list that it does not "
                            "draw"));
}

TEST_F(RenderGraphMismatch, NotesWhatIsDeclaredForNothing)
{
    EXPECT_THAT(
        NotesOf(Blur([](auto& builder, const TextureHandle& mask) { builder.UseTexture(mask); },
                     [](RasterCommandBuffer& cmd, const TextureHandle&) { Draw(cmd); })),
        ElementsAre("pass 'Blur' declares a read of '_Mask', yet samples it nowhere"));
    EXPECT_THAT(NotesOf(Blur([](auto&, const TextureHandle&) {},
                             [](RasterCommandBuffer&, const TextureHandle&) {})),
                ElementsAre("pass 'Blur' declares a write of 'CameraColor', yet draws nothing "
                            "into it"));
}

TEST_F(RenderGraphMismatch, NamesAPassWithoutARenderFunction)
{
    EXPECT_EQ(ErrorOf(
                  [](RenderGraph& graph, ContextContainer&)
                  {
                      test::NoData* data = nullptr;
                      graph.AddRasterRenderPass<test::NoData>("Blur", data);
                  }),
              "pass 'Blur' has no render function; SetRenderFunc gives it one");
}

TEST_F(RenderGraphMismatch, NamesTwoUsesOfATextureInOnePass)
{
    EXPECT_EQ(ErrorOfDeclaring(
                  [](auto& builder, RenderGraph& graph)
                  {
                      const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                      builder.SetRenderAttachment(mask, 0);
                      builder.UseTexture(mask);
                  }),
              "pass 'Blur': UseTexture: the pass draws into '_Mask' already; declare one use of a "
              "texture in a pass");
    EXPECT_EQ(ErrorOfDeclaring(
                  [](auto& builder, RenderGraph& graph)
                  {
                      const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                      builder.UseTexture(mask);
                      builder.SetRenderAttachment(mask, 0);
                  }),
              "pass 'Blur': SetRenderAttachment: the pass reads '_Mask' already; declare one use "
              "of a texture in a pass");
    EXPECT_EQ(ErrorOfDeclaring(
                  [](auto& builder, RenderGraph& graph)
                  {
                      const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                      builder.UseTexture(mask, AccessFlags::Write);
                      builder.UseTexture(mask, AccessFlags::Write);
                  }),
              "pass 'Blur': UseTexture: the pass writes '_Mask' already; declare one use of a "
              "texture in a pass");
    EXPECT_THAT(NotesOf(Blur(
                    [](auto& builder, const TextureHandle& mask)
                    {
                        builder.UseTexture(mask);
                        builder.UseTexture(mask); // two reads are fine, as in Unity
                    },
                    k_SampleMask)),
                IsEmpty());
}

TEST_F(RenderGraphMismatch, NamesAttachmentsThatDoNotFit)
{
    EXPECT_EQ(ErrorOfDeclaring(
                  [](auto& builder, RenderGraph& graph)
                  {
                      builder.SetRenderAttachment(graph.CreateTexture(Desc("_A")), 0);
                      builder.SetRenderAttachment(graph.CreateTexture(Desc("_B")), 0);
                  }),
              "pass 'Blur': SetRenderAttachment of '_B': index 0 has '_A' already");
    EXPECT_EQ(
        ErrorOfDeclaring([](auto& builder, RenderGraph& graph)
                         { builder.SetRenderAttachment(graph.CreateTexture(Desc("_A")), 8); }),
        "pass 'Blur': SetRenderAttachment of '_A': the index is 8; it must be 0 to 7");
    EXPECT_EQ(ErrorOfDeclaring(
                  [](auto& builder, RenderGraph& graph)
                  {
                      builder.SetRenderAttachment(graph.CreateTexture(Desc("_A")), 0);
                      builder.SetRenderAttachment(graph.CreateTexture(Desc("_C")), 2);
                  }),
              "pass 'Blur' has '_C' at index 2, yet nothing at 1; leave no index out");
    TextureDesc depth = Desc("_Depth");
    depth.depthBufferBits = DepthBits::Depth32;
    EXPECT_EQ(ErrorOfDeclaring([&](auto& builder, RenderGraph& graph)
                               { builder.SetRenderAttachment(graph.CreateTexture(depth), 0); }),
              "pass 'Blur': SetRenderAttachment: '_Depth' is a depth texture; call "
              "SetRenderAttachmentDepth");
    EXPECT_EQ(
        ErrorOfDeclaring([](auto& builder, RenderGraph& graph)
                         { builder.SetRenderAttachmentDepth(graph.CreateTexture(Desc("_A"))); }),
        "pass 'Blur': SetRenderAttachmentDepth: '_A' is no depth texture; call "
        "SetRenderAttachment");
    EXPECT_EQ(ErrorOfDeclaring(
                  [&](auto& builder, RenderGraph& graph)
                  {
                      builder.SetRenderAttachmentDepth(graph.CreateTexture(depth));
                      builder.SetRenderAttachmentDepth(graph.CreateTexture(depth));
                  }),
              "pass 'Blur': SetRenderAttachmentDepth of '_Depth': the pass has '_Depth' already");
}

TEST_F(RenderGraphMismatch, NamesHandlesThatStandForNothing)
{
    EXPECT_EQ(ErrorOfDeclaring([](auto& builder, RenderGraph&) { builder.UseTexture({}); }),
              "pass 'Blur': UseTexture: the handle is empty");
    EXPECT_EQ(ErrorOfDeclaring([](auto& builder, RenderGraph&) { builder.UseRendererList({}); }),
              "pass 'Blur': UseRendererList: the handle is empty");
    TextureHandle old;
    Render([&](RenderGraph& graph, ContextContainer&) { old = graph.CreateTexture(Desc("_Old")); });
    EXPECT_EQ(ErrorOfDeclaring([&](auto& builder, RenderGraph&) { builder.UseTexture(old); }),
              "pass 'Blur': UseTexture: '_Old' is a handle of an earlier frame; a handle is valid "
              "in one camera's frame only");
    EXPECT_EQ(ErrorOf([](RenderGraph& graph, ContextContainer&) { graph.ImportTexture({}); }),
              "ImportTexture: the handle has no texture");
}

TEST_F(RenderGraphMismatch, NamesATransientTextureOfAnotherPass)
{
    EXPECT_EQ(ErrorOf(
                  [](RenderGraph& graph, ContextContainer&)
                  {
                      TextureHandle transient;
                      AddRaster(
                          graph, "Own",
                          [&](auto& builder)
                          {
                              transient = builder.CreateTransientTexture(Desc("_Transient"));
                              builder.SetRenderAttachment(transient, 0);
                          },
                          [](RasterCommandBuffer& cmd) { Draw(cmd); });
                      AddRaster(
                          graph, "Other", [&](auto& builder) { builder.UseTexture(transient); },
                          [](RasterCommandBuffer&) {});
                  }),
              "pass 'Other': UseTexture: '_Transient' is a transient texture of pass 'Own'");
}

TEST_F(RenderGraphMismatch, NamesACameraColourOfAnotherSize)
{
    EXPECT_EQ(ErrorOf(
                  [](RenderGraph& graph, ContextContainer& frameData)
                  {
                      TextureDesc desc(4, 2);
                      desc.name = "_Small";
                      frameData.Get<UniversalResourceData>().cameraColor =
                          graph.CreateTexture(desc);
                  }),
              "pass 'Feature': cameraColor is set to '_Small', 4x2 of 1 samples per texel; the "
              "camera's colour is 8x4 of 1 samples per texel");
}

TEST_F(RenderGraphMismatch, NamesTexturesThatCannotBeCopied)
{
    EXPECT_EQ(ErrorOf(
                  [](RenderGraph& graph, ContextContainer&)
                  {
                      TextureDesc half(4, 2);
                      half.name = "_Half";
                      graph.AddCopyPass(graph.CreateTexture(Desc("_A")), graph.CreateTexture(half),
                                        "Copy");
                  }),
              "AddCopyPass 'Copy': '_A' is 8x4 R8G8B8A8_UNorm of 1 samples per texel and '_Half' "
              "is 4x2 R8G8B8A8_UNorm of 1 samples per texel; both must be colours of one size, "
              "format and number of samples");
}

TEST_F(RenderGraphMismatch, LeavesTheNextFrameAsItWouldBe)
{
    EXPECT_NE(ErrorOf(Blur([](auto&, const TextureHandle&) {}, k_SampleMask)), "");
    EXPECT_THAT(
        NotesOf(Blur([](auto& builder, const TextureHandle& mask) { builder.UseTexture(mask); },
                     k_SampleMask)),
        IsEmpty());
}

} // namespace limn
