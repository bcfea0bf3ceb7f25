#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/RenderTexturePool.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "record/RecordedCommands.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

using Target = GraphicsBuffer::Target;
using testing::ElementsAre;
using testing::HasSubstr;

std::shared_ptr<GraphicsBuffer> BufferOf(Target target, int count, const std::string& name)
{
    auto buffer = std::make_shared<GraphicsBuffer>(target, count, 4);
    buffer->SetName(name);
    return buffer;
}

/// What CopyBuffer, CopyCounterValue and SetComputeParamsFromMaterial record and refuse.
class BufferCopies : public testing::Test
{
protected:
    BufferCopies() { m_Context.BeginCamera({m_Color, {}, &m_Pool, m_CopyMaterial}); }

    std::string Error(const std::function<void()>& record)
    {
        return test::ThrownMessage<ContractError>(record);
    }

    RenderReport m_Report;
    RenderTexturePool m_Pool;
    ScriptableRenderContext m_Context{m_Report};
    CommandBuffer m_Cmd;
    const RTHandle m_Color{test::Target("CameraColor")};
    const std::shared_ptr<const Material> m_CopyMaterial = CoreUtils::CreateEngineMaterial(
        FindBuiltinShader("Hidden/Universal/CoreBlit", test::Compiler()));
    const std::shared_ptr<GraphicsBuffer> m_From =
        BufferOf(Target::Structured | Target::CopySource, 8, "from");
    const std::shared_ptr<GraphicsBuffer> m_To =
        BufferOf(Target::Structured | Target::CopyDestination, 8, "to");
};

TEST_F(BufferCopies, ReadTheOneBufferAndWriteTheOther)
{
    m_Cmd.CopyBuffer(m_From, m_To);
    m_Context.ExecuteCommandBuffer(m_Cmd);
    const FrameCommands frame = m_Context.TakeCommands();
    ASSERT_EQ(frame.commands.size(), 1u);
    const auto& dispatch = std::get<DispatchCommand>(frame.commands[0]);
    EXPECT_THAT(dispatch.groups, ElementsAre(1u, 1u, 1u));
    const auto& buffers = frame.Setup(dispatch).bindings->buffers;
    ASSERT_EQ(buffers.size(), 2u);
    for (const BufferSlot& slot : buffers)
    {
        EXPECT_EQ(slot.buffer, slot.isWritten ? m_To : m_From);
        EXPECT_EQ(slot.offset, 0u);
        EXPECT_EQ(slot.size, 32u);
    }
}

TEST_F(BufferCopies, AreRefusedAsUnitysDocumentationHasIt)
{
    EXPECT_EQ(Error([&] { m_Cmd.CopyBuffer(nullptr, m_To); }), "CopyBuffer: the buffer is null");
    EXPECT_THAT(Error([&] { m_Cmd.CopyBuffer(m_From, m_From); }),
                Mentions("CopyBuffer", "'from'", "'from'", "same buffer"));
    const auto shorter = BufferOf(Target::Structured | Target::CopyDestination, 7, "shorter");
    EXPECT_THAT(Error([&] { m_Cmd.CopyBuffer(m_From, shorter); }),
                Mentions("CopyBuffer", "'from'", "'shorter'", "32 bytes", "28", "same number"));
    EXPECT_THAT(
        Error([&] { m_Cmd.CopyBuffer(m_To, m_From); }),
        Mentions("first", "GraphicsBuffer::Target::CopySource", "second", "CopyDestination"));
    EXPECT_THAT(Error([&] { m_Cmd.CopyCounterValue(m_From, m_To, 0); }),
                Mentions("CopyCounterValue", "'from'", "no counter", "Append", "Counter"));
    const auto counted = BufferOf(Target::Append, 4, "counted");
    for (const std::uint32_t place : {2u, 32u, 0xfffffffcu})
    {
        EXPECT_THAT(Error([&] { m_Cmd.CopyCounterValue(counted, m_To, place); }),
                    Mentions("CopyCounterValue", "byte " + std::to_string(place), "'to'",
                             "32 bytes", "multiple of 4"));
    }
    m_Cmd.CopyCounterValue(counted, m_To, 28);
    EXPECT_EQ(m_Cmd.commands().size(), 1u);
}

TEST_F(BufferCopies, NeedACamera)
{
    ScriptableRenderContext context(m_Report);
    m_Cmd.CopyBuffer(m_From, m_To);
    EXPECT_THAT(Error([&] { context.ExecuteCommandBuffer(m_Cmd); }),
                HasSubstr("CopyBuffer: no camera is rendered"));
}

constexpr const char* k_Kernels = "#pragma kernel A\n#pragma kernel B\n"
                                  "Texture2D _Map; Texture2D _Other; RWTexture2D<float4> _Out;\n"
                                  "float4 _Tint; float _Size; float4 _Map_ST;\n"
                                  "[numthreads(1, 1, 1)] void A(uint3 id : SV_DispatchThreadID)\n"
                                  "{ _Out[id.xy] = _Map.Load(0) * _Tint * _Size + _Map_ST; }\n"
                                  "[numthreads(1, 1, 1)] void B(uint3 id : SV_DispatchThreadID)\n"
                                  "{ _Out[id.xy] = _Other.Load(0); }\n";

TEST(ComputeParams, OfAMaterialAreTakenOverWhenTheBufferIsExecuted)
{
    const auto shader = ComputeShader::FromText(k_Kernels, "Params.compute", test::Compiler());
    const auto material = std::make_shared<Material>(test::ShaderOf(
        "Shader \"T\" { Properties { _Tint (\"\", Color) = (1, 0.5, 0, 1) _Size (\"\", Float) = 3\n"
        "_Map (\"\", 2D) = \"black\" {} _Other (\"\", 2D) = \"white\" {} }\nSubShader { Pass {\n" +
        test::Program() + "} } }"));
    const std::shared_ptr<const Texture> map = DefaultTexture("red");
    CommandBuffer cmd;
    cmd.SetComputeParamsFromMaterial(shader, 0, material);
    EXPECT_EQ(shader->Find(0, "_Size"), nullptr) << "not yet";
    material->SetFloat("_Size", 5);
    material->SetTexture("_Map", map);
    material->SetTextureScale("_Map", {2, 4});
    RenderReport report;
    ScriptableRenderContext context(report);
    context.ExecuteCommandBuffer(cmd);

    EXPECT_EQ(*shader->Find(0, "_Size"), ShaderPropertyValue(5.0f));
    EXPECT_EQ(*shader->Find(1, "_Size"), ShaderPropertyValue(5.0f)) << "numbers are of all kernels";
    EXPECT_EQ(*shader->Find(0, "_Tint"), ShaderPropertyValue(Color(1, 0.5f, 0, 1)));
    EXPECT_EQ(*shader->Find(0, "_Map_ST"), ShaderPropertyValue(glm::vec4(2, 4, 0, 0)));
    EXPECT_EQ(*shader->Find(0, "_Map"), ShaderPropertyValue(map));
    EXPECT_EQ(*shader->Find(0, "_Other"), ShaderPropertyValue(DefaultTexture("white")));
    EXPECT_EQ(shader->Find(1, "_Map"), nullptr) << "textures are of the kernel alone";
}

TEST(ComputeParams, AreRefusedWithoutAMaterialOrKernel)
{
    const auto shader = ComputeShader::FromText(k_Kernels, "Params.compute", test::Compiler());
    CommandBuffer cmd;
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { cmd.SetComputeParamsFromMaterial(shader, 0, nullptr); }),
                Mentions("SetComputeParamsFromMaterial", "'Params'", "material", "null"));
    const auto material = std::make_shared<Material>(test::ShaderWithProgram(""));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { cmd.SetComputeParamsFromMaterial(shader, 2, material); }),
                Mentions("'Params'", "no kernel 2", "has 2"));
}

} // namespace
} // namespace limn
