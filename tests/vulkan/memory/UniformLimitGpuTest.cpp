#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "Mentions.h"
#include "faults/FaultyLoader.h"
#include <limn/core/DrawError.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

namespace
{

constexpr std::uint32_t k_LargestBlock = 16 * 16;

/// A device that binds at most k_LargestBlock of a constant buffer.
class UniformLimit : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure())
        {
            faulty_loader::LimitUniformBuffers(k_LargestBlock);
            VulkanDeviceOptions options;
            options.device = SharedDevice().deviceName();
            options.validation = true;
            m_Device.emplace(options);
        }
    }
    void TearDown() override
    {
        faulty_loader::LimitUniformBuffers(0);
        m_Device.reset();
        GpuTest::TearDown();
    }

    /// A texel drawn with a block of `count` vectors of which the last is (0, 1, 0, 1).
    Rgba8 Draw(const std::string& block, int count)
    {
        const std::string last = std::to_string(count - 1);
        const auto material = std::make_shared<Material>(Shader::FromText(
            "Shader \"Wide\" { SubShader { Pass { ZTest Always Cull Off\nHLSLPROGRAM\n"
            "#pragma vertex V\n#pragma fragment F\n" +
                block + " { float4 _Values[" + last +
                "]; float4 _Last; };\n"
                "float4 V(float3 p : POSITION) : SV_POSITION { return float4(p, 1); }\n"
                "float4 F() : SV_Target { return _Last; }\nENDHLSL } } }",
            "t.shader", std::make_shared<ShaderCompiler>()));
        material->SetVector(ShaderPropertyId("_Last"), {0, 1, 0, 1});
        const TargetPtr target = MakeTarget(1, 1);
        CommandBuffer cmd;
        cmd.SetRenderTarget(RTHandle(target));
        cmd.DrawMesh(MakeQuad(), glm::mat4(1.0f), material);
        RenderReport report;
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        m_Device->Execute(CompileFrame(context.TakeCommands(), {}, std::array{target}));
        return Texel8(m_Device->ReadBack(*target), 0, 0);
    }

    std::optional<VulkanDevice> m_Device;
};

} // namespace

TEST_F(UniformLimit, IsAnErrorThatNamesShaderAndBlockWhereABlockIsLarger)
{
    for (const std::string block : {"cbuffer UnityPerMaterial", "cbuffer Table"})
    {
        try
        {
            Draw(block, 17);
            ADD_FAILURE() << block << ": drawn";
        }
        catch (const DrawError& error)
        {
            EXPECT_THAT(error.what(), Mentions("'Wide', pass 0", "'" + block.substr(8) + "'",
                                               "272 bytes", "256"));
        }
        EXPECT_EQ((Rgba8{0, 255, 0, 255}), Draw(block, 16)) << "as large as it may be";
    }
    EXPECT_EQ("", Text(m_Device->validationMessages()));
}

} // namespace limn::test
