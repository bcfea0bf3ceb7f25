#include "graph/GraphHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn::test
{
namespace
{

using testing::HasSubstr;

/// Whatever form of Blitter's a test is about, of any kind of command buffer.
struct Form
{
    const char* name;
    std::function<void(BaseCommandBuffer&, const TextureHandle&)> graph;
    std::function<void(CommandBuffer&, const TextureHandle&)> native;
};

template <typename Record>
Form MakeForm(const char* name, Record record)
{
    return {name, record, record};
}

const std::vector<Form>& Forms()
{
    static const std::vector<Form> k_Forms{
        MakeForm("BlitTexture of a handle, with a material",
                 [](auto& cmd, const TextureHandle& source) {
                     Blitter::BlitTexture(cmd, source, {0.5f, 1, 0.25f, 0}, Sampling(), 0);
                 }),
        MakeForm("BlitTexture of an identifier",
                 [](auto& cmd, const TextureHandle& source) {
                     Blitter::BlitTexture(cmd, RenderTargetIdentifier(source), {2, 1, 0, 0},
                                          Sampling(), 0);
                 }),
        MakeForm("BlitTexture without a source",
                 [](auto& cmd, const TextureHandle& source)
                 {
                     cmd.SetGlobalTexture("_BlitTexture", source);
                     Blitter::BlitTexture(cmd, {3, 1, 0, 0}, Sampling(), 0);
                 }),
        MakeForm("BlitTexture without a material",
                 [](auto& cmd, const TextureHandle& source) {
                     Blitter::BlitTexture(cmd, source, {1, 0.5f, 0, 0.5f}, 0.0f, true);
                 }),
        MakeForm("BlitTexture2D",
                 [](auto& cmd, const TextureHandle& source) {
                     Blitter::BlitTexture2D(cmd, source, {1, 1, 0, 0}, 0.0f, false);
                 }),
        MakeForm("BlitQuad of a handle",
                 [](auto& cmd, const TextureHandle& source) {
                     Blitter::BlitQuad(cmd, source, {1, 1, 0, 0}, {0.5f, 0.5f, 0.25f, 0}, 0, true);
                 }),
        MakeForm("BlitQuad of a texture",
                 [](auto& cmd, const TextureHandle& source) {
                     Blitter::BlitQuad(cmd, source.rt(), {1, 1, 0, 0}, {1, 0.5f, 0, 0}, 0, false);
                 }),
        MakeForm(
            "BlitColorAndDepth of a colour",
            [](auto& cmd, const TextureHandle& source) {
                Blitter::BlitColorAndDepth(cmd, source, TextureHandle(), {1, 1, 0, 0}, 0, false);
            }),
        MakeForm("BlitColorAndDepth of textures",
                 [](auto& cmd, const TextureHandle& source) {
                     Blitter::BlitColorAndDepth(cmd, source.rt(), nullptr, {2, 2, 0, 0}, 0, false);
                 })};
    return k_Forms;
}

/// A graph pass "Blit" behind one that wrote _Mask.
class GraphBlitter : public testing::Test
{
protected:
    using Declare = std::function<void(BaseRenderGraphBuilder&, const TextureHandle&)>;

    static void DeclareAll(BaseRenderGraphBuilder& builder, const TextureHandle& mask)
    {
        builder.UseTexture(mask);
        builder.AllowGlobalStateModification(true);
    }

    /// @param add  adds the pass: AddRaster, AddUnsafe
    template <typename Add>
    RenderResult Render(Add add)
    {
        GraphPass pass(
            [&](RenderGraph& graph, ContextContainer& frameData)
            {
                const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
                AddRaster(
                    graph, "Mask", [&](auto& builder) { builder.SetRenderAttachment(mask, 0); },
                    [](RasterCommandBuffer& cmd) { Draw(cmd); });
                add(graph, mask, frameData.Get<UniversalResourceData>().activeColorTexture());
            });
        Log log;
        UniversalRenderer renderer(Compiler());
        renderer.AddFeature(std::make_unique<LoggingFeature>(
            "Feature", log, std::vector<ScriptableRenderPass*>{&pass}));
        return m_Pipeline.RenderSingleCamera(renderer, m_Request);
    }
    RenderResult InRaster(const Form& form, const Declare& declare = DeclareAll)
    {
        return Render(
            [&](RenderGraph& graph, const TextureHandle& mask, const TextureHandle& color)
            {
                AddRaster(
                    graph, "Blit",
                    [&](auto& builder)
                    {
                        builder.SetRenderAttachment(color, 0);
                        declare(builder, mask);
                    },
                    [=](RasterCommandBuffer& cmd) { form.graph(cmd, mask); });
            });
    }
    RenderResult InUnsafe(std::function<void(UnsafeCommandBuffer&, const TextureHandle&)> record)
    {
        return Render(
            [&](RenderGraph& graph, const TextureHandle& mask, const TextureHandle& color)
            {
                AddUnsafe(
                    graph, "Blit",
                    [&](auto& builder)
                    {
                        builder.SetRenderAttachment(color, 0);
                        DeclareAll(builder, mask);
                    },
                    [=](UnsafeCommandBuffer& cmd) { record(cmd, mask); });
            });
    }

    /// What the pass draws: shader, vertices, textures, and the bytes of its uniforms.
    static std::string DrawsOf(const RenderResult& result)
    {
        const CompiledFrame& frame = *result.frame;
        std::string text;
        for (const CompiledRenderPass& pass : frame.passes)
        {
            for (const PassCommand& command : pass.commands)
            {
                const auto* draw = std::get_if<DrawCommand>(&command);
                if (draw == nullptr || pass.name != "Blit")
                {
                    continue;
                }
                const DrawSetup& setup = frame.Setup(*draw);
                text += setup.shader->name() + " " + std::to_string(setup.shaderPass) + ", " +
                        std::to_string(draw->vertexCount) + " of " +
                        (frame.MeshOf(*draw) ? frame.MeshOf(*draw)->name() : "no mesh") + ":";
                for (const TextureSlot& slot : setup.bindings->textures)
                {
                    text += " " + slot.texture->name();
                }
                for (const UniformSlice& slice : setup.bindings->uniforms)
                {
                    text += "|" + std::string(reinterpret_cast<const char*>(
                                                  frame.uniformData.data() + slice.offset),
                                              slice.size);
                }
                text += "\n";
            }
        }
        return text;
    }

    GraphBlitter()
    {
        m_Request.scene = &m_Scene;
        m_Request.camera = &m_Camera;
        m_Request.width = 8;
        m_Request.height = 4;
    }

private:
    Scene m_Scene;
    Camera m_Camera;
    RecordingDevice m_Device;
    UniversalRenderPipeline m_Pipeline{m_Device};
    RenderRequest m_Request;
};

TEST_F(GraphBlitter, DrawsInGraphPassesWhatItDrawsWithACommandBuffer)
{
    for (const Form& form : Forms())
    {
        SCOPED_TRACE(form.name);
        const std::string expected = DrawsOf(
            InUnsafe([&](UnsafeCommandBuffer& cmd, const TextureHandle& mask)
                     { form.native(CommandBufferHelpers::GetNativeCommandBuffer(cmd), mask); }));
        EXPECT_THAT(expected, HasSubstr(" _Mask"));
        EXPECT_EQ(DrawsOf(InRaster(form)), expected);
        EXPECT_EQ(DrawsOf(InUnsafe(form.graph)), expected);
    }
}

TEST_F(GraphBlitter, HasItsSourceDeclared)
{
    for (const Form& form : Forms())
    {
        EXPECT_THAT(ThrownMessage<ContractError>(
                        [&]
                        {
                            InRaster(form, [](BaseRenderGraphBuilder& builder, const TextureHandle&)
                                     { builder.AllowGlobalStateModification(true); });
                        }),
                    Mentions("'Blit'", "no read of '_Mask'", "samples", "no texture", "UseTexture"))
            << form.name;
    }
}

// Unity's Blitter sets it behind the back of the pass's commands, which would ask for leave.
TEST_F(GraphBlitter, IsNotedWhereItMakesAnIdentifierGlobal)
{
    const RenderResult result =
        InRaster(Forms().at(1), [](BaseRenderGraphBuilder& builder, const TextureHandle& mask)
                 { builder.UseTexture(mask); });
    EXPECT_THAT(result.report.notes,
                testing::ElementsAre(Mentions("'Blit'", "sets '_BlitTexture'", "native",
                                              "AllowGlobalStateModification(true)")));
}

} // namespace
} // namespace limn::test
