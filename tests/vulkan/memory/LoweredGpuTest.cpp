#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "Mentions.h"
#include "compute/ComputeRun.h"
#include "core/ThrownMessage.h"
#include "faults/FaultyLoader.h"
#include "limits/Lowered.h"

#include <limn/core/AsyncGPUReadback.h>
#include <limn/core/DrawError.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

namespace
{

/// A device that has less than its driver, under validation that knows it.
class LoweredLimits : public GpuTest
{
protected:
    void Make(const std::string& lowered)
    {
        const Lowered scope(lowered);
        VulkanDeviceOptions options;
        options.device = SharedDevice().deviceName();
        options.validation = true;
        m_Device.emplace(options);
    }
    void TearDown() override
    {
        if (m_Device)
        {
            EXPECT_EQ("", Text(m_Device->validationMessages()));
        }
        m_Device.reset();
        GpuTest::TearDown();
    }

    static std::shared_ptr<const Shader> MakeShader(const std::string& declarations,
                                                    const std::string& body,
                                                    const std::string& pragmas = "")
    {
        return Shader::FromText(
            "Shader \"T\" { SubShader { Pass { ZTest Always Cull Off\nHLSLPROGRAM\n"
            "#pragma vertex V\n#pragma fragment F\n" +
                pragmas + "\n" + declarations +
                "\nfloat4 V(float3 p : POSITION) : SV_POSITION { return float4(p, 1); }\n"
                "float4 F() : SV_Target { " +
                body + " }\nENDHLSL } } }",
            "t.shader", std::make_shared<ShaderCompiler>());
    }
    template <typename... Texts>
    static std::shared_ptr<Material> MakeMaterial(const Texts&... texts)
    {
        return std::make_shared<Material>(MakeShader(texts...));
    }

    /// A texel that is drawn by each of the materials, one over the other.
    Rgba8 Draw(const std::vector<std::shared_ptr<Material>>& materials)
    {
        CommandBuffer cmd;
        cmd.SetRenderTarget(RTHandle(m_Target));
        for (const auto& material : materials)
        {
            cmd.DrawMesh(m_Quad, glm::mat4(1.0f), material);
        }
        RenderReport report;
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        m_Device->Execute(
            CompileFrame(context.TakeCommands(), m_Device->textureStates(), std::array{m_Target}));
        return Texel8(m_Device->ReadBack(*m_Target), 0, 0);
    }

    std::string Refusal(const std::vector<std::shared_ptr<Material>>& materials)
    {
        return ThrownMessage<DrawError>([&] { Draw(materials); });
    }

    /// A white texture that is read with this bias.
    std::shared_ptr<Material> Biased(float bias)
    {
        SamplerState sampler;
        sampler.mipMapBias = bias;
        static const auto shader = MakeShader("sampler2D _Map;", "return tex2D(_Map, 0.5);");
        const auto material = std::make_shared<Material>(shader);
        material->SetTexture(
            ShaderPropertyId("_Map"),
            std::make_shared<Texture2D>("Map", 1, 1, GraphicsFormat::R8G8B8A8_UNorm,
                                        std::vector<std::byte>(4, std::byte{255}), sampler));
        return material;
    }

    const Rgba8 k_White{255, 255, 255, 255};
    MeshPtr m_Quad = MakeQuad();
    TargetPtr m_Target = MakeTarget(1, 1);
    std::optional<VulkanDevice> m_Device;
};

/// `count` textures of one sampler each, or buffers, and the sum of what they hold.
std::pair<std::string, std::string> Many(int count, const std::string& declaration,
                                         const std::string& read)
{
    std::pair<std::string, std::string> text{"", "return 1"};
    for (int i = 0; i < count; ++i)
    {
        const std::string number = std::to_string(i);
        const auto with = [&](std::string pattern)
        {
            for (std::size_t at; (at = pattern.find('#')) != std::string::npos;)
            {
                pattern.replace(at, 1, number);
            }
            return pattern;
        };
        text.first += with(declaration) + "\n";
        text.second += " + " + with(read);
    }
    text.second += ";";
    return text;
}

} // namespace

TEST_F(LoweredLimits, OfOneStageAreNamedBeforeTheDriverIsAsked)
{
    Make("maxPerStageDescriptorSamplers=16,maxPerStageDescriptorSampledImages=20,"
         "maxPerStageDescriptorUniformBuffers=12,maxPerStageResources=18,"
         "maxDescriptorSetUniformBuffers=11,maxFragmentCombinedOutputResources=4");
    struct Case
    {
        int drawn; ///< so many are, and no more
        const char* declaration;
        const char* read;
        const char* noun;
    };
    const Case cases[] = {
        {16, "sampler2D _T#;", "tex2D(_T#, 0.5)", "reads 17 samplers"},
        {17, "Texture2D<float4> _T#;", "_T#.Load(0)", "reads 19 targets"}, // with the target
        {11, "cbuffer B# { float4 _V#; };", "_V#", "read 12 uniform buffers"}};
    for (const Case& each : cases)
    {
        const auto [fitting, sum] = Many(each.drawn, each.declaration, each.read);
        EXPECT_EQ(k_White, Draw({MakeMaterial(fitting, sum)})) << each.noun;
        const auto [larger, largerSum] = Many(each.drawn + 1, each.declaration, each.read);
        EXPECT_THAT(Refusal({MakeMaterial(larger, largerSum)}), testing::HasSubstr(each.noun));
    }
}

TEST_F(LoweredLimits, OfFeaturesAreNamedBeforeTheDriverIsAsked)
{
    Make("geometryShader=0,portability=1");
    EXPECT_EQ(k_White, Draw({Biased(0.0f)}));
    EXPECT_THAT(Refusal({Biased(0.5f)}),
                Mentions("mipMapBias", "samplerMipLodBias", "VK_KHR_portability_subset", "lacks"));
    EXPECT_THAT(Refusal({MakeMaterial("Texture2D _S; SamplerComparisonState sampler_S;",
                                      "return _S.SampleCmpLevelZero(sampler_S, 0.5, 0.5).x;")}),
                Mentions("SamplerComparisonState", "mutableComparisonSamplers",
                         "VK_KHR_portability_subset", "lacks"));
    EXPECT_THAT(
        Refusal({MakeMaterial(
            "struct P { float4 p : SV_POSITION; };\n[maxvertexcount(3)] void G(triangle P i[3], "
            "inout TriangleStream<P> o) { for (int k = 0; k < 3; ++k) o.Append(i[k]); }",
            "return 1;", "#pragma geometry G")}),
        Mentions("geometryShader", "device lacks", "missingShaderFeatures()"));
}

TEST_F(LoweredLimits, OfSamplersHoldHoweverOftenABiasChanges)
{
    Make("maxSamplerAllocationCount=16");
    const auto made = [before = faulty_loader::LiveObjects()["Sampler"]]
    {
        return faulty_loader::LiveObjects()["Sampler"] - before;
    };
    for (int i = 0; i < 100; ++i)
    {
        EXPECT_EQ(k_White, Draw({Biased(static_cast<float>(i) / 64.0f), Biased(0.0f)}));
        EXPECT_LE(made(), 16);
    }
    std::vector<std::shared_ptr<Material>> materials;
    for (int i = 0; i < 17; ++i)
    {
        materials.push_back(Biased(-static_cast<float>(i) / 64.0f));
    }
    EXPECT_THAT(Refusal(materials), Mentions("more than 16", "samplers"));
    materials.pop_back();
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_EQ(k_White, Draw(materials)) << "as many as there may be";
    }
}

TEST_F(LoweredLimits, OfThreadsAreNamedBeforeTheDriverIsAsked)
{
    Make("maxComputeWorkGroupInvocations=128");
    const auto run = [&](const std::string& threads)
    {
        const auto shader =
            MakeKernel(threads, "RWStructuredBuffer<uint> _Out;", "_Out[0] = id.x;");
        shader->SetBuffer(0, "_Out", MakeBuffer(std::vector<std::uint32_t>(1)));
        CommandBuffer cmd;
        cmd.DispatchCompute(shader, 0, 1, 1, 1);
        RenderReport report;
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        m_Device->Execute(CompileFrame(context.TakeCommands(), m_Device->textureStates(), {}));
    };
    EXPECT_NO_THROW(run("16, 8, 1"));
    const std::string refusal = ThrownMessage<ContractError>([&] { run("16, 8, 2"); });
    for (const char* fact : {"compute shader 'Test'", "kernel 'K'", "16x8x2", "at most"})
    {
        EXPECT_NE(refusal.find(fact), std::string::npos) << refusal;
    }
    EXPECT_NE(refusal.find("128"), std::string::npos) << refusal;
}

TEST_F(LoweredLimits, OfAHeapThatIsFullLeadToAnother)
{
    Make("fullHeap=1");
    EXPECT_EQ(k_White, Draw({Biased(0.0f)}));
    EXPECT_GT(m_Device->statistics().usedBytes, 0u);
}

TEST_F(LoweredLimits, OfNothingLetReadbacksOfEachFrameTakeNoMemoryAnew)
{
    Make("");
    const TargetPtr large = MakeTarget(2048, 1100); // more than half a block
    const auto readBack = [&]
    {
        Draw({Biased(0.0f)});
        m_Device->Execute(FrameOf({ClearPass(large)}, large));
        AsyncGPUReadback::Request(*m_Device, *large).WaitForCompletion();
        AsyncGPUReadback::Request(*m_Device, *m_Target).WaitForCompletion();
    };
    readBack();
    readBack();
    faulty_loader::FailFunction("vkAllocateMemory", VK_ERROR_OUT_OF_HOST_MEMORY);
    for (int i = 0; i < 20; ++i)
    {
        EXPECT_NO_THROW(readBack());
    }
    EXPECT_EQ("", faulty_loader::FailedFunction()) << "called";
    faulty_loader::FailNothing();
    const std::uint64_t kept = m_Device->statistics().allocatedBytes;
    for (int i = 0; i < 12; ++i)
    {
        m_Device->Execute(FrameOf({ClearPass(large)}, large));
    }
    EXPECT_LT(m_Device->statistics().allocatedBytes, kept) << "not for ever";
}

} // namespace limn::test
