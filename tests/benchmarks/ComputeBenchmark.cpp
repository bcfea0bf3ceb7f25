// A jump flood as compute kernels against the same one as full-screen passes: the HLSL of
// features/wide_outline does the work in both. Both run in turns; printed are the medians of a
// flood's time on the wall, and of the ratio with its tenth and ninetieth part. Above 1 kernels are
// faster.
//
//   build/release/tests/compute_benchmark [--quick] [--pairs N] [--device NAME]

#include "Samples.h"

#include <array>
#include <cstdlib>
#include <limn/core/CommandBuffer.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderContext.h>
#include <limn/vulkan/VulkanDevice.h>
#include <string_view>

namespace limn::benchmarks
{

namespace
{

constexpr int k_Range = 32; // pixels
constexpr const char* k_Includes =
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
    "#include \"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl\"\n"
    "#include \"limn/outline/NearestSeed.hlsl\"\n";

/// A flood's textures and the frame that runs it.
class Flood
{
public:
    Flood(int width, int height, bool isKernel, const std::shared_ptr<ShaderCompiler>& compiler)
        : m_IsKernel(isKernel)
    {
        RenderTextureDescriptor descriptor(width, height, GraphicsFormat::R16G16_UNorm);
        descriptor.enableRandomWrite = isKernel;
        for (RTHandle& texture : m_Textures)
        {
            texture = RTHandle(std::make_shared<RenderTexture>("flood", descriptor));
        }
        const std::string includes = k_Includes;
        m_Kernel = ComputeShader::FromText(
            "#pragma kernel Flood\n" + includes +
                "RWTexture2D<float2> _Result;\n"
                "[numthreads(8, 8, 1)] void Flood(uint3 id : SV_DispatchThreadID)\n"
                "{ if (all(float2(id.xy) < _WideOutlineSize.zw))\n"
                "  { _Result[id.xy] = FloodSeeds(id.xy + 0.5); } }\n",
            "Flood.compute", compiler);
        m_Material = std::make_shared<Material>(Shader::FromText(
            "Shader \"Flood\" { SubShader { ZTest Always ZWrite Off Cull Off\nHLSLINCLUDE\n" +
                includes +
                "ENDHLSL\nPass { HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Step\n"
                "float2 Step(float4 p : SV_POSITION) : SV_Target { return FloodSeeds(p.xy); }\n"
                "ENDHLSL }\nPass { HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Seed\n"
                "float2 Seed(float4 p : SV_POSITION) : SV_Target\n"
                "{ uint2 at = (uint2)p.xy; return all(at % 23 == 7) ? EncodeSeed(float2(0.25, "
                "-0.25), _WideOutlineRange) : 0; }\nENDHLSL } } }",
            "Flood.shader", compiler));
        Record(width, height);
    }

    void Run(VulkanDevice& device)
    {
        FrameCommands commands = m_Commands;
        const std::array outputs{result()};
        device.Execute(*m_Cache.Compile(commands, device.textureStates(), outputs, {}));
        device.Wait();
    }

    const std::shared_ptr<const RenderTexture>& result() const { return m_Textures[m_Last].rt(); }

private:
    void Record(int width, int height)
    {
        const auto w = static_cast<float>(width);
        const auto h = static_cast<float>(height);
        CommandBuffer cmd;
        cmd.SetGlobalVector("_WideOutlineSize", {1 / w, 1 / h, w, h});
        cmd.SetGlobalFloat("_WideOutlineRange", k_Range);
        cmd.SetRenderTarget(m_Textures[0]);
        CoreUtils::DrawFullScreen(cmd, m_Material, {}, 1);
        for (int step = k_Range / 2; step > 0; step /= 2)
        {
            const std::size_t next = 1 - m_Last;
            cmd.SetGlobalFloat("_WideOutlineStep", static_cast<float>(step));
            cmd.SetGlobalTexture("_BlitTexture", m_Textures[m_Last]);
            if (m_IsKernel)
            {
                cmd.SetComputeTextureParam(m_Kernel, 0, "_Result", m_Textures[next]);
                cmd.DispatchCompute(m_Kernel, 0, (width + 7) / 8, (height + 7) / 8, 1);
            }
            else
            {
                cmd.SetRenderTarget(m_Textures[next]);
                CoreUtils::DrawFullScreen(cmd, m_Material, {}, 0);
            }
            m_Last = next;
        }
        RenderReport report;
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        m_Commands = context.TakeCommands();
    }

    bool m_IsKernel;
    std::array<RTHandle, 2> m_Textures;
    std::size_t m_Last = 0;
    std::shared_ptr<ComputeShader> m_Kernel;
    std::shared_ptr<Material> m_Material;
    FrameCommands m_Commands;
    FrameCache m_Cache;
};

void Compare(VulkanDevice& device, int width, int height, int pairs)
{
    const auto compiler = std::make_shared<ShaderCompiler>();
    Flood raster(width, height, false, compiler);
    Flood kernel(width, height, true, compiler);
    for (int i = 0; i < 3; ++i)
    {
        raster.Run(device);
        kernel.Run(device);
    }
    raster.Run(device);
    const Image wanted = device.ReadBack(*raster.result());
    kernel.Run(device);
    const bool isSame = wanted.texels == device.ReadBack(*kernel.result()).texels;
    Comparison comparison;
    for (int i = 0; i < pairs; ++i)
    {
        const double first = Time([&] { raster.Run(device); });
        comparison.Add(first, Time([&] { kernel.Run(device); }));
    }
    const std::string name = std::to_string(width) + "x" + std::to_string(height) +
                             (isSame ? ", same texels" : ", OTHER TEXELS");
    comparison.Print(name.c_str());
}

int Run(int argc, char** argv)
{
    bool isQuick = false;
    int pairs = 31;
    VulkanDeviceOptions options;
    for (int i = 1; i < argc; ++i)
    {
        const std::string_view argument = argv[i];
        isQuick = isQuick || argument == "--quick";
        pairs = argument == "--pairs" && i + 1 < argc ? std::atoi(argv[i + 1]) : pairs;
        options.device = argument == "--device" && i + 1 < argc ? argv[i + 1] : options.device;
    }
    VulkanDevice device(options);
    std::printf("%s\n%-44s %12s %12s   %s\n", device.ChoiceSentence().c_str(),
                "jump flood of 32 pixels", "passes", "kernels", "ratio");
    Compare(device, 64, 64, isQuick ? 3 : pairs);
    if (!isQuick)
    {
        Compare(device, 640, 360, pairs);
        Compare(device, 1280, 720, pairs);
    }
    return 0;
}

} // namespace

} // namespace limn::benchmarks

int main(int argc, char** argv)
{
    try
    {
        return limn::benchmarks::Run(argc, argv);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
