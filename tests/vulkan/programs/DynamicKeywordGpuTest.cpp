#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include <limn/core/FrameCompiler.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

using DynamicKeywords = GpuTest;

TEST_F(DynamicKeywords, ChangeThePictureWithoutAnotherVariant)
{
    const auto compiler = std::make_shared<ShaderCompiler>();
    const auto material = std::make_shared<Material>(
        Shader::FromText("Shader \"T\" { SubShader { Pass { ZTest Always Cull Off\nHLSLPROGRAM\n"
                         "#pragma vertex V\n#pragma fragment F\n"
                         "#pragma dynamic_branch SMALL\n#pragma dynamic_branch_local _ RED BLUE\n"
                         "float4 V(uint id : SV_VertexID) : SV_POSITION\n"
                         "{ float side = SMALL ? 1 : 3;\n"
                         "  return float4(id == 1 ? side : -1, id == 2 ? side : -1, 0.5, 1); }\n"
                         "float4 F() : SV_Target\n"
                         "{ float4 c = BLUE ? float4(0, 0, 1, 1) : float4(0, 0, 0, 1);\n"
                         "  if (RED && !SMALL) { c.r = 1; } return c; }\nENDHLSL } } }",
                         "t.shader", compiler));
    const TargetPtr target = MakeTarget(2, 2);
    // The texels at the top right and at the bottom left.
    const auto draw = [&]
    {
        RenderReport report;
        ScriptableRenderContext context(report);
        CommandBuffer cmd;
        cmd.SetRenderTarget(RTHandle(target));
        cmd.ClearRenderTarget(ClearFlag::Color, Color::green);
        cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3, {});
        context.ExecuteCommandBuffer(cmd);
        SharedDevice().Execute(CompileFrame(context.TakeCommands(), SharedDevice().textureStates(),
                                            std::array{target}));
        const Image image = ReadRows(*target);
        return std::pair(Texel8(image, 1, 0), Texel8(image, 0, 1));
    };
    constexpr Rgba8 k_Black = {0, 0, 0, 255};
    constexpr Rgba8 k_Blue = {0, 0, 255, 255};
    constexpr Rgba8 k_Magenta = {255, 0, 255, 255};
    EXPECT_EQ(std::pair(k_Black, k_Black), draw());
    material->EnableKeyword("BLUE");
    EXPECT_EQ(std::pair(k_Blue, k_Blue), draw());
    material->EnableKeyword("RED");
    EXPECT_EQ(std::pair(k_Magenta, k_Magenta), draw());
    material->EnableKeyword("SMALL"); // the triangle leaves the centre at the top right out
    EXPECT_EQ(std::pair(k_Green, k_Blue), draw());
    material->DisableKeyword("BLUE");
    EXPECT_EQ(std::pair(k_Green, k_Black), draw());
    EXPECT_EQ(1, compiler->statistics().compiled);
}

} // namespace limn::test
