#include <gtest/gtest.h>
#include <limn/core/DrawError.h>
#include <limn/core/FrameCompiler.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "record/RecordedCommands.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

using Buffer = std::shared_ptr<GraphicsBuffer>;

/// Draws and dispatches that take their counts from a buffer.
class IndirectDraws : public testing::Test
{
protected:
    static Buffer MakeBuffer(GraphicsBuffer::Target target, int count = 5)
    {
        auto buffer = std::make_shared<GraphicsBuffer>(target, count, 4);
        buffer->SetName("Args");
        return buffer;
    }
    std::string Message(const Buffer& buffer, int offset = 0) const
    {
        return test::ThrownMessage<ContractError>(
            [&]
            {
                CommandBuffer cmd;
                cmd.DrawMeshInstancedIndirect(m_Mesh, 0, m_Material, 0, buffer, offset);
            });
    }
    std::shared_ptr<ComputeShader> MakeKernel(const std::string& body) const
    {
        return ComputeShader::FromText("#pragma kernel K\nRWStructuredBuffer<uint> _Out;\n"
                                       "[numthreads(1, 1, 1)] void K() { " +
                                           body + " }",
                                       "K.compute", test::Compiler());
    }

    std::shared_ptr<const Mesh> m_Mesh = test::Cube();
    std::shared_ptr<const Material> m_Material =
        std::make_shared<Material>(test::ShaderWithProgram(""));
    RTHandle m_Target{std::make_shared<RenderTexture>(
        "Target", RenderTextureDescriptor(4, 4, GraphicsFormat::R8G8B8A8_UNorm))};
    Buffer m_Args = MakeBuffer(GraphicsBuffer::Target::IndirectArguments);
};

TEST_F(IndirectDraws, SayWhatIsWrongWithTheirBuffer)
{
    EXPECT_THAT(Message(nullptr), Mentions("DrawMeshInstancedIndirect", "buffer", "null"));
    EXPECT_THAT(Message(MakeBuffer(GraphicsBuffer::Target::Structured)),
                Mentions("DrawMeshInstancedIndirect", "'Args'",
                         "GraphicsBuffer::Target::IndirectArguments"));
    const auto part = [](const std::string& offset)
    {
        return Mentions("DrawMeshInstancedIndirect", "20 bytes", "byte " + offset, "'Args'",
                        "20 bytes", "multiple of 4");
    };
    EXPECT_THAT(Message(m_Args, 4), part("4"));
    EXPECT_THAT(Message(m_Args, -4), part("-4"));
    EXPECT_THAT(Message(m_Args, 2), part("2"));
    CommandBuffer cmd;
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&]
                                           { cmd.DispatchCompute(MakeKernel(""), 0, m_Args, 12); }),
        Mentions("DispatchCompute", "12 bytes", "byte 12", "'Args'", "20 bytes", "multiple of 4"));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { cmd.DrawMeshInstancedProcedural(m_Mesh, 0, m_Material, 0, -1); }),
                Mentions("DrawMeshInstancedProcedural", "instance count -1", "negative"));
    EXPECT_TRUE(cmd.commands().empty());
}

TEST_F(IndirectDraws, FindAReleasedBufferWhenTheyAreExecuted)
{
    CommandBuffer cmd;
    cmd.SetRenderTarget(m_Target);
    cmd.DrawMeshInstancedIndirect(m_Mesh, 0, m_Material, 0, m_Args);
    m_Args->Release();
    RenderReport report;
    ScriptableRenderContext context(report);
    EXPECT_THAT(test::ThrownMessage<DrawError>([&] { context.ExecuteCommandBuffer(cmd); }),
                Mentions("'Test/Program'", "arguments", "'Args'", "released"));
}

/// What a frame with a kernel that writes the arguments, and two draws with them, compiles to.
TEST_F(IndirectDraws, KeepAndWaitForTheKernelThatWritesTheirArguments)
{
    const auto kernel = MakeKernel("_Out[0] = 3;");
    kernel->SetBuffer(0, "_Out", m_Args);
    CommandBuffer cmd;
    cmd.DispatchCompute(kernel, 0, 1, 1, 1);
    cmd.SetRenderTarget(m_Target);
    cmd.DrawMeshInstancedIndirect(m_Mesh, 0, m_Material, 0, m_Args);
    cmd.DrawMeshInstancedIndirect(m_Mesh, 0, m_Material, 0, m_Args);
    RenderReport report;
    ScriptableRenderContext context(report);
    context.ExecuteCommandBuffer(cmd);
    const auto output = m_Target.rt();
    const CompiledFrame frame =
        CompileFrame(context.TakeCommands(), TextureStates(), std::span(&output, 1));
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_TRUE(frame.passes[0].isCompute());
    ASSERT_EQ(frame.passes[1].bufferBarriers.size(), 1u);
    const BufferBarrier& barrier = frame.passes[1].bufferBarriers[0];
    EXPECT_EQ(barrier.buffer, m_Args);
    EXPECT_TRUE(barrier.wasWritten);
    EXPECT_EQ(barrier.after, ShaderStage::Indirect);
    EXPECT_FALSE(barrier.isWritten);
    std::size_t draws = 0;
    for (const PassCommand& command : frame.passes[1].commands)
    {
        if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            ++draws;
            EXPECT_EQ(draw->instanceCount, 1u);
            EXPECT_FALSE(draw->bounds);
            const BufferSlot* arguments = frame.Setup(*draw).bindings->arguments();
            ASSERT_NE(arguments, nullptr);
            EXPECT_EQ(arguments->buffer, m_Args);
            EXPECT_EQ(arguments->size, 20u);
        }
    }
    EXPECT_EQ(draws, 2u) << "they are not instances of each other";
}

} // namespace
} // namespace limn
