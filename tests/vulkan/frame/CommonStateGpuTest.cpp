#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/RenderTexturePool.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

namespace
{

const std::shared_ptr<ShaderCompiler>& StateCompiler()
{
    static const auto compiler = std::make_shared<ShaderCompiler>();
    return compiler;
}

/// Draws vertices as they are, in clip space.
std::shared_ptr<const Material> Paint(const std::string& color, const std::string& state)
{
    return std::make_shared<const Material>(Shader::FromText(
        "Shader \"Test/State\" { SubShader { Pass { " + state +
            "\nHLSLPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n"
            "float4 vert(float4 position : POSITION) : SV_POSITION { return position; }\n"
            "float4 frag() : SV_Target { return " +
            color + "; }\nENDHLSL } } }",
        "state.shader", StateCompiler()));
}

/// Pixels of draws behind EnableScissorRect, SetInvertCulling and SetGlobalDepthBias.
class CommonStateGpu : public GpuTest
{
protected:
    CommonStateGpu()
    {
        cmd.SetRenderTarget(target, depth);
        cmd.ClearRenderTarget(ClearFlag::All, Color::black);
    }

    Image Draw(const RTHandle& output)
    {
        RenderReport report;
        ScriptableRenderContext context(report);
        context.BeginCamera({target, depth, &pool, copyMaterial});
        context.ExecuteCommandBuffer(cmd);
        const auto texture = output.rt();
        SharedDevice().Execute(CompileFrame(context.TakeCommands(), SharedDevice().textureStates(),
                                            std::span(&texture, 1)));
        ExpectNoValidationMessages();
        return ReadRows(*texture);
    }
    void Quad(const std::shared_ptr<const Material>& material)
    {
        cmd.DrawMesh(quad, glm::mat4(1.0f), material);
    }
    /// Red and green of the middle.
    std::array<int, 2> Middle()
    {
        const Rgba8 texel = Texel8(Draw(target), 3, 2);
        return {texel[0], texel[1]};
    }
    static void ExpectRed(const Image& image, const ViewportRect& rect)
    {
        for (int y = 0; y < 5; ++y)
        {
            for (int x = 0; x < 7; ++x)
            {
                const bool isIn = x >= rect.x && x < rect.x + rect.width && y >= rect.y &&
                                  y < rect.y + rect.height;
                EXPECT_EQ(Texel8(image, x, y)[0], isIn ? 255 : 0) << x << ", " << y;
            }
        }
    }

    CommandBuffer cmd;
    RenderTexturePool pool;
    const MeshPtr quad = MakeQuad();
    const RTHandle target{MakeTarget(7, 5)};
    const RTHandle depth{MakeDepth(7, 5)};
    const RTHandle other{MakeTarget(7, 5)};
    const std::shared_ptr<const Material> copyMaterial = CoreUtils::CreateEngineMaterial(
        FindBuiltinShader("Hidden/Universal/CoreBlit", StateCompiler()));
    const std::shared_ptr<const Material> red =
        Paint("float4(1, 0, 0, 1)", "Cull Off ZTest Always");
};

} // namespace

TEST_F(CommonStateGpu, AScissorCutsDrawsOff)
{
    cmd.EnableScissorRect({2, 1, 3, 2});
    Quad(red);
    ExpectRed(Draw(target), {2, 1, 3, 2});
}

TEST_F(CommonStateGpu, AScissorReachesAsFarAsTheTargetAndTheViewport)
{
    cmd.EnableScissorRect({3, -2, 100, 5});
    Quad(red);
    ExpectRed(Draw(target), {3, 0, 4, 3});
    cmd.Clear();
    cmd.SetRenderTarget(target);
    cmd.ClearRenderTarget(ClearFlag::Color, Color::black);
    cmd.EnableScissorRect({2, 1, 4, 3});
    cmd.SetViewport({0, 0, 4, 3});
    Quad(red);
    ExpectRed(Draw(target), {2, 1, 2, 2});
}

TEST_F(CommonStateGpu, AScissorLeavesClearsAndCopiesAlone)
{
    cmd.EnableScissorRect({2, 1, 1, 1});
    cmd.ClearRenderTarget(ClearFlag::Color, Color::red);
    cmd.CopyTexture(target, other);
    ExpectRed(Draw(other), {0, 0, 7, 5});
}

TEST_F(CommonStateGpu, AScissorHoldsForBlitsUntilItIsDisabled)
{
    Quad(red);
    cmd.SetRenderTarget(other);
    cmd.ClearRenderTarget(ClearFlag::Color, Color::black);
    cmd.EnableScissorRect({1, 1, 2, 2});
    cmd.Blit(target, other);
    ExpectRed(Draw(other), {1, 1, 2, 2});
    cmd.DisableScissorRect();
    cmd.Blit(target, other);
    ExpectRed(Draw(other), {0, 0, 7, 5});
}

TEST_F(CommonStateGpu, InvertedCullingTakesTheBackForTheFront)
{
    const auto front = Paint("float4(1, 0, 0, 0)", "Cull Back Blend One One ZTest Always");
    const auto back = Paint("float4(0, 1, 0, 0)", "Cull Front Blend One One ZTest Always");
    // The quad is clockwise in clip space: its back, where no projection into a texture turns it.
    Quad(front);
    Quad(back);
    EXPECT_EQ(Middle(), (std::array{0, 255}));
    cmd.Clear();
    cmd.SetRenderTarget(target);
    cmd.ClearRenderTarget(ClearFlag::Color, Color::black);
    cmd.SetInvertCulling(true);
    Quad(front);
    Quad(back);
    EXPECT_EQ(Middle(), (std::array{255, 0}));
}

TEST_F(CommonStateGpu, ADepthBiasMovesDrawsAwayOrCloser)
{
    const auto first = Paint("float4(1, 0, 0, 1)", "Cull Off ZTest Less");
    const auto second = Paint("float4(0, 1, 0, 1)", "Cull Off ZTest Less");
    struct Case
    {
        float before;
        float after;
        std::array<int, 2> seen;
    };
    for (const auto& [before, after, seen] :
         {Case{0.0f, 0.0f, {255, 0}}, Case{0.0f, -4.0f, {0, 255}}, Case{4.0f, 0.0f, {0, 255}},
          Case{0.0f, 4.0f, {255, 0}}, Case{-4.0f, 0.0f, {255, 0}}})
    {
        cmd.Clear();
        cmd.SetRenderTarget(target, depth);
        cmd.ClearRenderTarget(ClearFlag::All, Color::black);
        cmd.SetGlobalDepthBias(before, 0.0f);
        Quad(first);
        cmd.SetGlobalDepthBias(after, 0.0f);
        Quad(second);
        EXPECT_EQ(Middle(), seen) << before << " then " << after;
    }
}

} // namespace limn::test
