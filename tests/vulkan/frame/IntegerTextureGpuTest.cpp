#include "Mentions.h"
#include "compute/ComputeRun.h"

#include <cstring>
#include <limits>
#include <limn/core/DrawError.h>
#include <limn/core/Material.h>

namespace limn::test
{

namespace
{

/// Targets and textures of integers, of 2x2 texels.
class IntegerTextureGpu : public GpuTest
{
protected:
    static std::shared_ptr<Material> MakeMaterial(const std::string& declarations,
                                                  const std::string& type, const std::string& value,
                                                  const std::string& state = "")
    {
        return std::make_shared<Material>(Shader::FromText(
            "Shader \"Test/Integers\" { SubShader { Pass { Cull Off ZTest Always ZWrite Off " +
                state + "\nHLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n" + declarations +
                "\nfloat4 V(uint id : SV_VertexID) : SV_POSITION { return float4(id == 1 ? 3 : "
                "-1, id == 2 ? 3 : -1, 0.5, 1); }\n" +
                type + " F(float4 p : SV_POSITION) : SV_Target { return " + value +
                "; }\nENDHLSL\n} } }",
            "Integers.shader", ComputeCompiler()));
    }
    static TargetPtr Make(GraphicsFormat format, const std::string& name = "Target")
    {
        return std::make_shared<RenderTexture>(name, RenderTextureDescriptor(2, 2, format));
    }
    template <typename Integer>
    static std::vector<Integer> ValuesOf(const TargetPtr& target)
    {
        const Image image = ReadRows(*target);
        std::vector<Integer> values(image.texels.size() / sizeof(Integer));
        std::memcpy(values.data(), image.texels.data(), image.texels.size());
        return values;
    }
    static std::string ErrorOf(const TargetPtr& target, const std::shared_ptr<Material>& material)
    {
        CommandBuffer cmd;
        CoreUtils::SetRenderTarget(cmd, RTHandle(target), ClearFlag::Color);
        CoreUtils::DrawFullScreen(cmd, material);
        try
        {
            RunCommands(cmd, {target});
        }
        catch (const DrawError& error)
        {
            return error.what();
        }
        return "no error";
    }
};

} // namespace

TEST_F(IntegerTextureGpu, KeepsEveryBitFromDrawToDraw)
{
    const TargetPtr first = Make(GraphicsFormat::R32G32_UInt, "First");
    const TargetPtr second = Make(GraphicsFormat::R32G32B32A32_SInt, "Second");
    const auto reader = MakeMaterial("Texture2D<uint2> _First;", "int4",
                                     "int4(_First.Load(int3(p.xy, 0)), -7, (int)p.x - 1)");
    reader->SetTexture("_First", first);
    CommandBuffer cmd;
    CoreUtils::SetRenderTarget(cmd, RTHandle(first));
    CoreUtils::DrawFullScreen(
        cmd, MakeMaterial("", "uint2", "uint2(0xfffffffeu + (uint)p.x, 16777217u + (uint)p.y)"));
    CoreUtils::SetRenderTarget(cmd, RTHandle(second));
    CoreUtils::DrawFullScreen(cmd, reader);
    RunCommands(cmd, {first, second});
    ExpectNoValidationMessages();
    // 16777217 = 2^24 + 1 is no float.
    EXPECT_EQ(ValuesOf<std::uint32_t>(first),
              (std::vector<std::uint32_t>{0xfffffffe, 16777217, 0xffffffff, 16777217, 0xfffffffe,
                                          16777218, 0xffffffff, 16777218}));
    EXPECT_EQ(ValuesOf<std::int32_t>(second),
              (std::vector<std::int32_t>{-2, 16777217, -7, -1, -1, 16777217, -7, 0, -2, 16777218,
                                         -7, -1, -1, 16777218, -7, 0}));
}

TEST_F(IntegerTextureGpu, IsClearedToTheNearestIntegers)
{
    const TargetPtr target = Make(GraphicsFormat::R32G32B32A32_SInt);
    const TargetPtr unsignedTarget = Make(GraphicsFormat::R32G32B32A32_UInt);
    CommandBuffer cmd;
    CoreUtils::SetRenderTarget(cmd, RTHandle(target), ClearFlag::Color,
                               Color(-3.4f, 300.0f, 1e20f, -1e20f));
    CoreUtils::SetRenderTarget(cmd, RTHandle(unsignedTarget), ClearFlag::Color,
                               Color(-3.4f, 300.6f, 1e20f, 0.0f));
    RunCommands(cmd, {target, unsignedTarget});
    const auto seen = ValuesOf<std::int32_t>(target);
    const auto unsignedSeen = ValuesOf<std::uint32_t>(unsignedTarget);
    using Least = std::numeric_limits<std::int32_t>;
    EXPECT_EQ(std::vector(seen.begin(), seen.begin() + 4),
              (std::vector<std::int32_t>{-3, 300, Least::max(), Least::min()}));
    EXPECT_EQ(std::vector(unsignedSeen.begin(), unsignedSeen.begin() + 4),
              (std::vector<std::uint32_t>{0, 301, 0xffffffff, 0}));
}

TEST_F(IntegerTextureGpu, IsWrittenByKernels)
{
    const auto target = MakeWritable(2, 2, GraphicsFormat::R32_UInt);
    const auto shader = MakeKernel("4, 4, 1", "RWTexture2D<uint> _Out;",
                                   "InterlockedMax(_Out[id.xy / 2], 16777217u + id.x);\n");
    const auto doubled =
        MakeKernel("2, 2, 1", "RWTexture2D<uint> _Out;", "_Out[id.xy] = 2 * _Out[id.xy] + id.y;");
    shader->SetTexture(0, "_Out", target);
    doubled->SetTexture(0, "_Out", target);
    CommandBuffer cmd;
    CoreUtils::SetRenderTarget(cmd, RTHandle(target), ClearFlag::Color, Color::clear);
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    cmd.DispatchCompute(doubled, 0, 1, 1, 1);
    RunCommands(cmd, {target});
    ExpectNoValidationMessages();
    EXPECT_EQ(ValuesOf<std::uint32_t>(target),
              (std::vector<std::uint32_t>{33554436, 33554440, 33554437, 33554441}));
}

TEST_F(IntegerTextureGpu, IsRefusedWhereItIsTakenForSomethingElse)
{
    EXPECT_THAT(ErrorOf(Make(GraphicsFormat::R32_SInt), MakeMaterial("", "float4", "1")),
                Mentions("'Test/Integers', pass 0", "'Target' of R32_SInt", "takes int",
                         "SV_Target0 is float"));
    EXPECT_THAT(ErrorOf(Make(GraphicsFormat::R8_UNorm), MakeMaterial("", "uint", "1")),
                Mentions("'Test/Integers', pass 0", "'Target' of R8_UNorm", "takes float",
                         "SV_Target0 is uint"));
    EXPECT_THAT(
        ErrorOf(Make(GraphicsFormat::R32_UInt), MakeMaterial("", "uint", "1", "Blend One One")),
        Mentions("'Test/Integers', pass 0", "'Target' of R32_UInt", "blends", "Blend Off"));
    const auto reader = MakeMaterial("Texture2D<float4> _Map;", "float4", "_Map.Load(0)");
    reader->SetTexture("_Map", Make(GraphicsFormat::R32_SInt, "Map"));
    EXPECT_THAT(ErrorOf(Make(GraphicsFormat::R8_UNorm), reader),
                Mentions("'Test/Integers'", "'_Map'", "of float", "'Map' of R32_SInt", "of int"));
    EXPECT_THAT(ErrorOf(Make(GraphicsFormat::R8_UNorm),
                        MakeMaterial("Texture2D<uint> _Ids;", "float4", "_Ids.Load(0)")),
                Mentions("'Test/Integers'", "'_Ids'", "not set", "global"));
}

} // namespace limn::test
