#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "faults/FaultyLoader.h"
#include <glm/gtc/matrix_transform.hpp>
#include <limn/core/FrameCompiler.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

namespace
{

constexpr int k_Columns = 20;
constexpr std::uint32_t k_MostBytes = 8 * sizeof(PerDrawData);

std::shared_ptr<const Material> MaterialShowing(const std::string& value)
{
    return std::make_shared<Material>(
        Shader::FromText("Shader \"T\" { SubShader { Pass { ZTest Always Cull Off\nHLSLPROGRAM\n"
                         "#pragma vertex V\n#pragma fragment F\n#include \"UnityCG.cginc\"\n"
                         "float4 V(float3 p : POSITION) : SV_POSITION\n"
                         "{ return mul(unity_ObjectToWorld, float4(p, 1)); }\n"
                         "float4 F() : SV_Target { return " +
                             value + "; }\nENDHLSL } } }",
                         "t.shader", std::make_shared<ShaderCompiler>()));
}

float Offset(int column)
{
    return 2.0f / k_Columns * static_cast<float>(column);
}

/// A device that binds at most k_MostBytes of per-draw data.
class PerDrawLimit : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure())
        {
            faulty_loader::LimitStorageBuffers(k_MostBytes);
            VulkanDeviceOptions options;
            options.device = SharedDevice().deviceName();
            options.validation = true;
            m_Device.emplace(options);
        }
    }
    void TearDown() override
    {
        faulty_loader::LimitStorageBuffers(0);
        m_Device.reset();
        GpuTest::TearDown();
    }

    std::optional<VulkanDevice> m_Device;
};

} // namespace

TEST_F(PerDrawLimit, IsKeptByBindingTheDataInPieces)
{
    const TargetPtr target = MakeTarget(k_Columns, 2, GraphicsFormat::R32G32B32A32_SFloat);
    CommandBuffer cmd;
    cmd.SetRenderTarget(RTHandle(target));
    cmd.ClearRenderTarget(ClearFlag::Color, Color::black);
    const MeshPtr quad = MakeQuad(-1, 0, -1 + 2.0f / k_Columns, 1);
    const auto merged = MaterialShowing("1");
    const auto apart = MaterialShowing("unity_ObjectToWorld._m03 + 2");
    for (const auto& [material, y] : {std::pair(merged, 0.0f), std::pair(apart, -1.0f)})
    {
        for (int i = 0; i < k_Columns; ++i)
        {
            cmd.DrawMesh(quad, glm::translate(glm::mat4(1.0f), {Offset(i), y, 0}), material);
        }
    }
    RenderReport report;
    ScriptableRenderContext context(report);
    context.ExecuteCommandBuffer(cmd);
    const CompiledFrame frame = CompileFrame(context.TakeCommands(), {}, std::array{target});
    ASSERT_EQ(std::size_t{2 * k_Columns}, frame.perDraw.size());
    // The draws with the first material are one of 20 instances.
    ASSERT_EQ(std::size_t{1 + k_Columns}, frame.passes.at(0).commands.size());

    m_Device->Execute(frame);
    const Image image = ReadRows(*target, *m_Device);
    for (int i = 0; i < k_Columns; ++i)
    {
        EXPECT_EQ(1.0f, TexelFloat(image, i, 0)[0]) << "column " << i;
        EXPECT_FLOAT_EQ(Offset(i) + 2.0f, TexelFloat(image, i, 1)[0]) << "column " << i;
    }
    EXPECT_EQ(k_MostBytes, faulty_loader::LargestStorageBuffer());
    EXPECT_EQ("", Text(m_Device->validationMessages()));
}

TEST_F(PerDrawLimit, LeavesTheInstancesOfADrawTheirNumbers)
{
    const PassPtr pass = CompilePass(R"(
        #include "limn/PerDraw.hlsl"
        struct v2f { float4 pos : SV_POSITION; nointerpolation float id : TEXCOORD0; };
        v2f vert(float3 p : POSITION, uint id : SV_InstanceID)
        { v2f o; o.pos = mul(unity_ObjectToWorld, float4(p, 1)); o.id = id; return o; }
        float4 frag(v2f i) : SV_Target { return i.id; })");
    const TargetPtr target = MakeTarget(k_Columns, 1, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    constexpr int k_Skipped = 3; // elements of other draws
    for (int i = 0; i < k_Skipped + k_Columns; ++i)
    {
        PerDrawData data{};
        data.objectToWorld[0] = data.objectToWorld[5] = data.objectToWorld[10] =
            data.objectToWorld[15] = 1.0f;
        data.objectToWorld[12] = Offset(i - k_Skipped);
        frame.perDraw.push_back(data);
    }
    DrawBindings bindings;
    bindings.perDrawBinding = pass->layout.storageBuffers.at(0).binding;
    DrawCommand draw =
        MakeDraw(frame, pass, MakeQuad(-1, -1, -1 + 2.0f / k_Columns, 1), PlainState(), bindings);
    draw.firstInstance = k_Skipped;
    draw.instanceCount = k_Columns;
    frame.passes[0].commands.emplace_back(draw);
    m_Device->Execute(frame);
    const Image image = m_Device->ReadBack(*target);
    for (int i = 0; i < k_Columns; ++i)
    {
        EXPECT_EQ(static_cast<float>(i), TexelFloat(image, i, 0)[0]) << "column " << i;
    }
    EXPECT_EQ("", Text(m_Device->validationMessages()));
}

} // namespace limn::test
