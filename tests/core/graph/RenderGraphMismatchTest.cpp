#include "graph/GraphHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <optional>

#include "Mentions.h"
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
using test::Mentions;
using test::MessageLines;
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
        return test::OnlyLine(MessageOf(std::move(recording)));
    }
    std::string MessageOf(GraphPass::Recording recording)
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
    EXPECT_THAT(ErrorOf(Blur([](auto&, const TextureHandle&) {}, k_SampleMask)),
                Mentions("'Blur'", "no read of '_Mask'", "samples", "no texture", "UseTexture",
                         "'_Mask'>)"));
}

TEST_F(RenderGraphMismatch, NotesAReadOfWhatThePassDeclaresToWrite)
{
    EXPECT_THAT(NotesOf(Blur([](auto& builder, const TextureHandle& mask)
                             { builder.UseTexture(mask, AccessFlags::Write); },
                             k_SampleMask)),
                ElementsAre(Mentions("'Blur'", "no read of '_Mask'", "samples", "UseTexture",
                                     "AccessFlags::ReadWrite")));
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
                ElementsAre(Mentions("'Blur'", "no read of '_Mask'", "samples", "UseTexture",
                                     "'_Mask'>)")));
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
                ElementsAre(Mentions("'Blur'", "no read of '_Mask'", "samples", "UseTexture",
                                     "'_Mask'>)")));
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
                ElementsAre(Mentions("'Blur'", "no read of 'CameraColor'", "samples",
                                     "UseTexture(resourceData.activeColorTexture())")));
}

TEST_F(RenderGraphMismatch, NamesAllThatIsWrongWithAPassAtOnce)
{
    EXPECT_THAT(
        MessageLines(MessageOf(
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
            })),
        ElementsAre(
            Mentions("'Blur'", "UseGlobalTexture", "'_Nobody'", "SetGlobalTextureAfterPass"),
            Mentions("'Blur'", "reads '_Other'", "no pass before", "clearBuffer"),
            Mentions("'Blur'", "global '_Width'", "throws", "AllowGlobalStateModification(true)"),
            Mentions("'Blur'", "'_Mask'", "global '_Shown'", "no use", "throws", "UseTexture"),
            Mentions("'Blur'", "sets the global '_Shown'", "throws",
                     "AllowGlobalStateModification(true)"),
            Mentions("'Blur'", "no read of '_Mask'", "samples", "no texture", "UseTexture")));
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
    EXPECT_THAT(ErrorOf([&](RenderGraph& graph, ContextContainer&)
                        { AddClearing(graph, WrittenMask(graph), [](auto&) {}); }),
                Mentions("'Chain'", "no write of '_Mask'", "draws into", "no texture", "UseTexture",
                         "AccessFlags::Write"));
}

TEST_F(RenderGraphMismatch, NamesAPassThatUnityLeavesOut)
{
    EXPECT_THAT(ErrorOf(
                    [](RenderGraph& graph, ContextContainer& frameData) {
                        AddClearing(graph, frameData.Get<UniversalResourceData>().cameraColor,
                                    [](auto&) {});
                    }),
                Mentions("'Chain'", "no write", "leaves it out", "UseTexture",
                         "activeColorTexture()", "AccessFlags::Write"));
    const RTHandle own(test::Target("Own"));
    EXPECT_THAT(ErrorOf(
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
                Mentions("'Chain'", "no write", "leaves it out", "AllowPassCulling(false)"));
}

TEST_F(RenderGraphMismatch, NotesTheCamerasColourThatAPassDrawsIntoUndeclared)
{
    EXPECT_THAT(NotesOf(
                    [](RenderGraph& graph, ContextContainer& frameData)
                    {
                        AddClearing(graph, frameData.Get<UniversalResourceData>().cameraColor,
                                    [](auto& builder) { builder.AllowPassCulling(false); });
                    }),
                ElementsAre(Mentions("'Chain'", "no write of 'CameraColor'", "draws into",
                                     "UseTexture", "activeColorTexture()", "AccessFlags::Write")));
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
    EXPECT_THAT(
        ErrorOf(
            [&](RenderGraph& graph, ContextContainer&)
            { AddRaster(graph, "Blur", nothing, [](RasterCommandBuffer& cmd) { Draw(cmd); }); }),
        Mentions("'Blur'", "draws", "no SetRenderAttachment"));
    EXPECT_THAT(
        ErrorOf(
            [&](RenderGraph& graph, ContextContainer&)
            { AddUnsafe(graph, "Chain", nothing, [](UnsafeCommandBuffer& cmd) { Draw(cmd); }); }),
        Mentions("'Chain'", "draws before", "render target"));
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
    EXPECT_THAT(ErrorOf(Blur(declare(false), set)), Mentions("'Blur'", "global '_Width'", "throws",
                                                             "AllowGlobalStateModification(true)"));
    EXPECT_THAT(NotesOf(Blur(declare(true), set)), IsEmpty());
    const auto setView = [](RasterCommandBuffer& cmd, const TextureHandle& mask)
    {
        Sample(cmd, mask);
        cmd.SetViewProjectionMatrices(glm::dmat4(1.0), glm::mat4(1.0f), false);
    };
    EXPECT_THAT(
        ErrorOf(Blur(declare(false), setView)),
        Mentions("'Blur'", "view and projection", "throws", "AllowGlobalStateModification(true)"));
}

// Unity: RenderGraph.AddUnsafePass allows globals by itself, and lets the pass be culled (core 17).
TEST_F(RenderGraphMismatch, IsNoneWhereAnUnsafePassSetsGlobals)
{
    const auto set = [](bool isKept, std::optional<bool> allows = std::nullopt)
    {
        return [isKept, allows](RenderGraph& graph, ContextContainer&)
        {
            AddUnsafe(
                graph, "Chain",
                [&](auto& builder)
                {
                    builder.AllowPassCulling(!isKept);
                    if (allows)
                    {
                        builder.AllowGlobalStateModification(*allows);
                    }
                },
                [](UnsafeCommandBuffer& cmd)
                {
                    CommandBufferHelpers::GetNativeCommandBuffer(cmd).SetGlobalInt("_Count", 2);
                    cmd.SetGlobalFloat("_Width", 2.0f);
                });
        };
    };
    EXPECT_THAT(NotesOf(set(true)), IsEmpty());
    EXPECT_THAT(NotesOf(set(false, true)), IsEmpty()) << "who allows globals, is never culled";
    EXPECT_THAT(ErrorOf(set(true, false)), Mentions("'Chain'", "global '_Width'", "throws",
                                                    "AllowGlobalStateModification(true)"));
    EXPECT_THAT(ErrorOf(set(false)),
                Mentions("'Chain'", "no write", "leaves it out", "AllowPassCulling(false)"));
}

TEST_F(RenderGraphMismatch, NamesAKeywordThatIsSwitchedWithoutLeave)
{
    const auto wet = [](RasterCommandBuffer& cmd, const TextureHandle& mask)
    {
        Sample(cmd, mask);
        cmd.EnableShaderKeyword("WET");
    };
    EXPECT_THAT(
        ErrorOf(
            Blur([](auto& builder, const TextureHandle& mask) { builder.UseTexture(mask); }, wet)),
        Mentions("'Blur'", "keyword 'WET'", "throws", "AllowGlobalStateModification(true)"));
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
    EXPECT_THAT(
        NotesOf(read(true)),
        ElementsAre(Mentions("'Blur'", "reads '_Mask'", "no pass before", "holds the clearColor")));
    EXPECT_THAT(ErrorOf(read(false)),
                Mentions("'Blur'", "reads '_Mask'", "no pass before", "clearBuffer", "undefined"));
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
    EXPECT_THAT(ErrorOf(record(false, true)),
                Mentions("'List'", "draws", "without", "UseRendererList"));
    EXPECT_THAT(NotesOf(record(true, false)),
                ElementsAre(Mentions("'List'", "declares UseRendererList", "not draw")));
}

TEST_F(RenderGraphMismatch, NotesWhatIsDeclaredForNothing)
{
    EXPECT_THAT(
        NotesOf(Blur([](auto& builder, const TextureHandle& mask) { builder.UseTexture(mask); },
                     [](RasterCommandBuffer& cmd, const TextureHandle&) { Draw(cmd); })),
        ElementsAre(Mentions("'Blur'", "a read of '_Mask'", "nowhere")));
    EXPECT_THAT(NotesOf(Blur([](auto&, const TextureHandle&) {},
                             [](RasterCommandBuffer&, const TextureHandle&) {})),
                ElementsAre(Mentions("'Blur'", "a write of 'CameraColor'", "draws nothing")));
}

TEST_F(RenderGraphMismatch, NamesAPassWithoutARenderFunction)
{
    EXPECT_THAT(ErrorOf(
                    [](RenderGraph& graph, ContextContainer&)
                    {
                        test::NoData* data = nullptr;
                        graph.AddRasterRenderPass<test::NoData>("Blur", data);
                    }),
                Mentions("'Blur'", "no render function", "SetRenderFunc"));
}

TEST_F(RenderGraphMismatch, NamesTwoUsesOfATextureInOnePass)
{
    EXPECT_THAT(ErrorOfDeclaring(
                    [](auto& builder, RenderGraph& graph)
                    {
                        const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                        builder.SetRenderAttachment(mask, 0);
                        builder.UseTexture(mask);
                    }),
                Mentions("'Blur'", "UseTexture", "draws into '_Mask'", "already"));
    EXPECT_THAT(ErrorOfDeclaring(
                    [](auto& builder, RenderGraph& graph)
                    {
                        const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                        builder.UseTexture(mask);
                        builder.SetRenderAttachment(mask, 0);
                    }),
                Mentions("'Blur'", "SetRenderAttachment", "reads '_Mask'", "already"));
    EXPECT_THAT(ErrorOfDeclaring(
                    [](auto& builder, RenderGraph& graph)
                    {
                        const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                        builder.UseTexture(mask, AccessFlags::Write);
                        builder.UseTexture(mask, AccessFlags::Write);
                    }),
                Mentions("'Blur'", "UseTexture", "writes '_Mask'", "already"));
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
    EXPECT_THAT(ErrorOfDeclaring(
                    [](auto& builder, RenderGraph& graph)
                    {
                        builder.SetRenderAttachment(graph.CreateTexture(Desc("_A")), 0);
                        builder.SetRenderAttachment(graph.CreateTexture(Desc("_B")), 0);
                    }),
                Mentions("'Blur'", "SetRenderAttachment", "'_B'", "index 0", "'_A'", "already"));
    EXPECT_THAT(
        ErrorOfDeclaring([](auto& builder, RenderGraph& graph)
                         { builder.SetRenderAttachment(graph.CreateTexture(Desc("_A")), 8); }),
        Mentions("'Blur'", "SetRenderAttachment", "'_A'", "8", "0 to 7"));
    EXPECT_THAT(ErrorOfDeclaring(
                    [](auto& builder, RenderGraph& graph)
                    {
                        builder.SetRenderAttachment(graph.CreateTexture(Desc("_A")), 0);
                        builder.SetRenderAttachment(graph.CreateTexture(Desc("_C")), 2);
                    }),
                Mentions("'Blur'", "'_C' at index 2", "nothing at 1"));
    TextureDesc depth = Desc("_Depth");
    depth.depthBufferBits = DepthBits::Depth32;
    EXPECT_THAT(ErrorOfDeclaring([&](auto& builder, RenderGraph& graph)
                                 { builder.SetRenderAttachment(graph.CreateTexture(depth), 0); }),
                Mentions("'Blur'", "SetRenderAttachment", "'_Depth' is a depth",
                         "SetRenderAttachmentDepth"));
    EXPECT_THAT(
        ErrorOfDeclaring([](auto& builder, RenderGraph& graph)
                         { builder.SetRenderAttachmentDepth(graph.CreateTexture(Desc("_A"))); }),
        Mentions("'Blur'", "SetRenderAttachmentDepth", "'_A' is no depth", "SetRenderAttachment"));
    EXPECT_THAT(ErrorOfDeclaring(
                    [&](auto& builder, RenderGraph& graph)
                    {
                        builder.SetRenderAttachmentDepth(graph.CreateTexture(depth));
                        builder.SetRenderAttachmentDepth(graph.CreateTexture(depth));
                    }),
                Mentions("'Blur'", "SetRenderAttachmentDepth", "'_Depth'", "'_Depth' already"));
}

TEST_F(RenderGraphMismatch, NamesInputAttachmentsThatDoNotFit)
{
    EXPECT_THAT(ErrorOfDeclaring(
                    [](auto& builder, RenderGraph& graph)
                    {
                        builder.SetInputAttachment(graph.CreateTexture(Desc("_A")), 1);
                        builder.SetInputAttachment(graph.CreateTexture(Desc("_B")), 1);
                    }),
                Mentions("'Blur'", "SetInputAttachment", "'_B'", "index 1", "'_A'", "already"));
    EXPECT_THAT(
        ErrorOfDeclaring([](auto& builder, RenderGraph& graph)
                         { builder.SetInputAttachment(graph.CreateTexture(Desc("_A")), -1); }),
        Mentions("'Blur'", "SetInputAttachment", "'_A'", "-1", "0 to 7"));
    EXPECT_THAT(ErrorOfDeclaring(
                    [](auto& builder, RenderGraph& graph)
                    {
                        const TextureHandle both = graph.CreateTexture(Desc("_A"));
                        builder.SetRenderAttachment(both, 0);
                        builder.SetInputAttachment(both, 0);
                    }),
                Mentions("'Blur'", "SetInputAttachment", "draws into '_A' already"));
}

TEST_F(RenderGraphMismatch, NamesHandlesThatStandForNothing)
{
    EXPECT_THAT(ErrorOfDeclaring([](auto& builder, RenderGraph&) { builder.UseTexture({}); }),
                Mentions("'Blur'", "UseTexture", "handle is empty"));
    EXPECT_THAT(ErrorOfDeclaring([](auto& builder, RenderGraph&) { builder.UseRendererList({}); }),
                Mentions("'Blur'", "UseRendererList", "handle is empty"));
    TextureHandle old;
    Render([&](RenderGraph& graph, ContextContainer&) { old = graph.CreateTexture(Desc("_Old")); });
    EXPECT_THAT(ErrorOfDeclaring([&](auto& builder, RenderGraph&) { builder.UseTexture(old); }),
                Mentions("'Blur'", "UseTexture", "'_Old'", "earlier frame"));
    EXPECT_THAT(ErrorOf([](RenderGraph& graph, ContextContainer&) { graph.ImportTexture({}); }),
                Mentions("ImportTexture", "no texture"));
}

TEST_F(RenderGraphMismatch, NamesATransientTextureOfAnotherPass)
{
    EXPECT_THAT(ErrorOf(
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
                Mentions("'Other'", "UseTexture", "'_Transient'", "pass 'Own'"));
}

TEST_F(RenderGraphMismatch, NamesACameraColourOfAnotherSize)
{
    EXPECT_THAT(ErrorOf(
                    [](RenderGraph& graph, ContextContainer& frameData)
                    {
                        TextureDesc desc(4, 2);
                        desc.name = "_Small";
                        frameData.Get<UniversalResourceData>().cameraColor =
                            graph.CreateTexture(desc);
                    }),
                Mentions("'Feature'", "cameraColor", "'_Small'", "4x2 with 1 sample per",
                         "8x4 with 1 sample per"));
}

TEST_F(RenderGraphMismatch, NamesTexturesThatCannotBeCopied)
{
    EXPECT_THAT(ErrorOf(
                    [](RenderGraph& graph, ContextContainer&)
                    {
                        TextureDesc half(4, 2);
                        half.name = "_Half";
                        graph.AddCopyPass(graph.CreateTexture(Desc("_A")),
                                          graph.CreateTexture(half), "Copy");
                    }),
                Mentions("AddCopyPass", "'Copy'", "'_A' is 8x4", "'_Half' is 4x2", "one size"));
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
