#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include <gmock/gmock.h>
#include <limn/core/DrawError.h>

namespace limn::test
{

namespace
{

using Float4 = std::array<float, 4>;

/// Draws `source` over a float target that holds `destination`.
Float4 BlendOn(VulkanDevice& device, Color source, Color destination,
               const RenderTargetBlendState& blend)
{
    const TargetPtr target = MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target, destination)}, target);
    PipelineState state = PlainState();
    state.targets[0] = blend;
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), source, state));
    device.Execute(frame);
    return TexelFloat(device.ReadBack(*target), 0, 0);
}

RenderTargetBlendState Factors(BlendMode srcColor, BlendMode dstColor, BlendMode srcAlpha,
                               BlendMode dstAlpha)
{
    RenderTargetBlendState blend;
    blend.sourceColorBlendMode = srcColor;
    blend.destinationColorBlendMode = dstColor;
    blend.sourceAlphaBlendMode = srcAlpha;
    blend.destinationAlphaBlendMode = dstAlpha;
    return blend;
}

/// Writes 0.5 to the first target and 0.25 to the second.
PassPtr TwoOutputPass()
{
    static const PassPtr pass = CompilePass(R"(
        struct Outputs { float4 a : SV_Target0; float4 b : SV_Target1; };
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        Outputs frag()
        {
            Outputs o;
            o.a = float4(0.5, 0.5, 0.5, 0.5);
            o.b = float4(0.25, 0.25, 0.25, 0.25);
            return o;
        })");
    return pass;
}

constexpr Color k_Source{0.5f, 0.25f, 1.0f, 0.5f};
constexpr Color k_Destination{0.25f, 1.0f, 0.5f, 0.25f};

/// Draws the frame, or finds that the device says it lacks the feature.
bool DrawsUnlessItLacks(const std::string& feature, VulkanDevice& device,
                        const CompiledFrame& frame)
{
    try
    {
        device.Execute(frame);
        return true;
    }
    catch (const DrawError& error)
    {
        EXPECT_THAT(error.what(), testing::HasSubstr("the device lacks " + feature));
        return false;
    }
}

} // namespace

/// Runs on the shared device and on one without extensions, where blending is baked in.
class Blending : public GpuTest, public testing::WithParamInterface<bool>
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure() && !GetParam())
        {
            VulkanDeviceOptions options;
            options.device = SharedDevice().deviceName();
            options.validation = true;
            options.optionalExtensions = false;
            m_Plain = std::make_unique<VulkanDevice>(options);
        }
    }
    void TearDown() override
    {
        GpuTest::TearDown();
        if (m_Plain)
        {
            EXPECT_EQ("", Text(m_Plain->validationMessages()));
        }
    }
    VulkanDevice& Device() { return m_Plain ? *m_Plain : SharedDevice(); }

private:
    std::unique_ptr<VulkanDevice> m_Plain;
};

TEST_P(Blending, ReplacesWhereItIsOff)
{
    EXPECT_EQ((Float4{0.5f, 0.25f, 1.0f, 0.5f}), BlendOn(Device(), k_Source, k_Destination, {}));
}

TEST_P(Blending, AddsAlphaWeightedColorAndKeepsAlpha)
{
    // Blend One SrcAlpha, Zero One: colour = src + dst * 0.5, alpha = dst.
    const RenderTargetBlendState blend =
        Factors(BlendMode::One, BlendMode::SrcAlpha, BlendMode::Zero, BlendMode::One);
    EXPECT_EQ((Float4{0.625f, 0.75f, 1.25f, 0.25f}),
              BlendOn(Device(), k_Source, k_Destination, blend));
}

TEST_P(Blending, MixesByAlpha)
{
    const RenderTargetBlendState blend = Factors(BlendMode::SrcAlpha, BlendMode::OneMinusSrcAlpha,
                                                 BlendMode::One, BlendMode::OneMinusSrcAlpha);
    EXPECT_EQ((Float4{0.375f, 0.625f, 0.75f, 0.625f}),
              BlendOn(Device(), k_Source, k_Destination, blend));
}

TEST_P(Blending, MixesLinearColorsInAnSrgbTarget)
{
    const TargetPtr target = MakeTarget(1, 1, GraphicsFormat::R8G8B8A8_SRGB);
    CompiledFrame frame = FrameOf({ClearPass(target, Color::black)}, target);
    PipelineState state = PlainState();
    state.targets[0] = Factors(BlendMode::SrcAlpha, BlendMode::OneMinusSrcAlpha, BlendMode::One,
                               BlendMode::OneMinusSrcAlpha);
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), {1, 1, 1, 0.5f}, state));
    Device().Execute(frame);
    // Linear 0.5 is 187.5 in sRGB; mixed as bytes it would be 128.
    EXPECT_NEAR(187.5, Texel8(Device().ReadBack(*target), 0, 0)[0], 1.0);
}

TEST_P(Blending, SubtractsInBothDirections)
{
    RenderTargetBlendState blend =
        Factors(BlendMode::One, BlendMode::One, BlendMode::One, BlendMode::One);
    blend.colorBlendOperation = BlendOp::Subtract;
    blend.alphaBlendOperation = BlendOp::ReverseSubtract;
    EXPECT_EQ((Float4{0.25f, -0.75f, 0.5f, -0.25f}),
              BlendOn(Device(), k_Source, k_Destination, blend));
}

TEST_P(Blending, TakesTheLargerWithMax)
{
    RenderTargetBlendState blend =
        Factors(BlendMode::One, BlendMode::One, BlendMode::One, BlendMode::One);
    blend.colorBlendOperation = BlendOp::Max;
    blend.alphaBlendOperation = BlendOp::Min;
    EXPECT_EQ((Float4{0.5f, 1.0f, 1.0f, 0.25f}), BlendOn(Device(), k_Source, k_Destination, blend));
}

TEST_P(Blending, CombinesTheBitsOfNormalizedIntegers)
{
    // Bit by bit what the operations give for source 0x33 and destination 0x55: the four pairs of
    // bits are in each half of the bytes.
    constexpr std::pair<BlendOp, int> k_Results[] = {
        {BlendOp::LogicalClear, 0x00},      {BlendOp::LogicalSet, 0xFF},
        {BlendOp::LogicalCopy, 0x33},       {BlendOp::LogicalCopyInverted, 0xCC},
        {BlendOp::LogicalNoop, 0x55},       {BlendOp::LogicalInvert, 0xAA},
        {BlendOp::LogicalAnd, 0x11},        {BlendOp::LogicalNand, 0xEE},
        {BlendOp::LogicalOr, 0x77},         {BlendOp::LogicalNor, 0x88},
        {BlendOp::LogicalXor, 0x66},        {BlendOp::LogicalEquivalence, 0x99},
        {BlendOp::LogicalAndReverse, 0x22}, {BlendOp::LogicalAndInverted, 0x44},
        {BlendOp::LogicalOrReverse, 0xBB},  {BlendOp::LogicalOrInverted, 0xDD},
    };
    constexpr float s = 0x33 / 255.0f;
    constexpr float d = 0x55 / 255.0f;
    const TargetPtr target = MakeTarget(16, 1);
    CompiledFrame frame = FrameOf({ClearPass(target, {d, d, d, d})}, target);
    PipelineState state = PlainState();
    for (RenderTargetBlendState& blend : state.targets)
    {
        blend = Factors(BlendMode::SrcAlpha, BlendMode::One, BlendMode::Zero, BlendMode::One);
    }
    float left = -1.0f;
    for (const auto& [op, result] : k_Results)
    {
        state.targets[0].colorBlendOperation = op;
        state.targets[0].alphaBlendOperation = op;
        frame.passes[0].commands.emplace_back(
            MakeColorDraw(frame, MakeQuad(left, -1, left + 0.125f, 1), {s, s, s, s}, state));
        left += 0.125f;
    }
    if (!DrawsUnlessItLacks("logicOp", Device(), frame))
    {
        GTEST_SKIP() << "the device reports no logicOp";
    }
    const Image image = Device().ReadBack(*target);
    for (int x = 0; x < 16; ++x)
    {
        const int result = k_Results[x].second;
        EXPECT_EQ((Rgba8{result, result, result, result}), Texel8(image, x, 0)) << x;
    }
}

TEST_P(Blending, BlendsAgainAfterALogicalOperation)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target, {0, 0, 0, 0})}, target);
    PipelineState state = PlainState();
    state.targets[0] = Factors(BlendMode::One, BlendMode::One, BlendMode::One, BlendMode::One);
    PipelineState logical = state;
    logical.targets[0].colorBlendOperation = BlendOp::LogicalSet;
    logical.targets[0].alphaBlendOperation = BlendOp::LogicalSet;
    logical.targets[0].writeMask = ColorWriteMask::Green;
    for (const PipelineState& one : {state, logical, state})
    {
        frame.passes[0].commands.emplace_back(
            MakeColorDraw(frame, MakeQuad(), {0.2f, 0.2f, 0.2f, 0.2f}, one)); // 51
    }
    if (!DrawsUnlessItLacks("logicOp", Device(), frame))
    {
        GTEST_SKIP() << "the device reports no logicOp";
    }
    EXPECT_EQ((Rgba8{102, 255, 102, 102}), Texel8(Device().ReadBack(*target), 0, 0));
}

TEST_P(Blending, MixesAsDrawingProgramsDoWhereTheDeviceCan)
{
    struct Case
    {
        BlendOp op;
        Rgba8 expected; ///< of source (1, 0, 0.2) and destination (0.4, 1, 1), both opaque
    };
    for (const Case& one : {Case{BlendOp::Multiply, {102, 0, 51, 255}},       // s * d
                            Case{BlendOp::Screen, {255, 255, 255, 255}},      // s + d - s * d
                            Case{BlendOp::Difference, {153, 255, 204, 255}}}) // |s - d|
    {
        const TargetPtr target = MakeTarget(1, 1);
        CompiledFrame frame = FrameOf({ClearPass(target, {0.4f, 1, 1, 1})}, target);
        PipelineState state = PlainState();
        state.targets[0].colorBlendOperation = one.op;
        state.targets[0].alphaBlendOperation = one.op;
        frame.passes[0].commands.emplace_back(
            MakeColorDraw(frame, MakeQuad(), {1, 0, 0.2f, 1}, state));
        if (!DrawsUnlessItLacks("VK_EXT_blend_operation_advanced", Device(), frame))
        {
            continue;
        }
        const Rgba8 actual = Texel8(Device().ReadBack(*target), 0, 0);
        for (std::size_t i = 0; i < actual.size(); ++i)
        {
            EXPECT_NEAR(one.expected.at(i), actual.at(i), 1) << static_cast<int>(one.op);
        }
    }
}

TEST_P(Blending, WritesTheMaskedChannelsOnly)
{
    RenderTargetBlendState blend;
    blend.writeMask = ColorWriteMask::Red | ColorWriteMask::Alpha;
    EXPECT_EQ((Float4{0.5f, 1.0f, 0.5f, 0.5f}), BlendOn(Device(), k_Source, k_Destination, blend));
    blend.writeMask = 0;
    EXPECT_EQ((Float4{0.25f, 1.0f, 0.5f, 0.25f}),
              BlendOn(Device(), k_Source, k_Destination, blend));
}

TEST_P(Blending, GivesEachTargetItsOwnState)
{
    const TargetPtr first = MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat, "first");
    const TargetPtr second = MakeTarget(1, 1, GraphicsFormat::R32_SFloat, "second");
    CompiledFrame frame = FrameOf({ClearPass(first, Color::white)}, first);
    frame.passes[0].barriers.push_back(
        {second, TextureUsage::Undefined, TextureUsage::ColorAttachment});
    frame.passes[0].colors.push_back({second, LoadOp::Clear, StoreOp::Store, Color::white});
    frame.finalBarriers.push_back(
        {second, TextureUsage::ColorAttachment, TextureUsage::CopySource});
    PipelineState state = PlainState();
    state.targets[1] = Factors(BlendMode::One, BlendMode::One, BlendMode::One, BlendMode::One);
    frame.passes[0].commands.emplace_back(MakeDraw(frame, TwoOutputPass(), MakeQuad(), state));
    Device().Execute(frame);
    EXPECT_EQ(0.5f, TexelFloat(Device().ReadBack(*first), 0, 0)[0]);
    EXPECT_EQ(1.25f, TexelFloat<1>(Device().ReadBack(*second), 0, 0)[0]);
}

TEST_P(Blending, KeepsATargetThatTheShaderDoesNotWrite)
{
    const TargetPtr first = MakeTarget(1, 1, GraphicsFormat::R8G8B8A8_UNorm, "first");
    const TargetPtr second = MakeTarget(1, 1, GraphicsFormat::R8G8B8A8_UNorm, "second");
    CompiledFrame frame = FrameOf({ClearPass(first, Color::black)}, second);
    frame.passes[0].barriers.push_back(
        {second, TextureUsage::Undefined, TextureUsage::ColorAttachment});
    frame.passes[0].colors.push_back({second, LoadOp::Clear, StoreOp::Store, Color::green});
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), Color::red));
    Device().Execute(frame);
    EXPECT_EQ((Rgba8{0, 255, 0, 255}), Texel8(Device().ReadBack(*second), 0, 0));
}

TEST_P(Blending, FollowsTheOutputsOfEachShaderOfAPass)
{
    const TargetPtr first = MakeTarget(2, 1, GraphicsFormat::R32_SFloat, "first");
    const TargetPtr second = MakeTarget(2, 1, GraphicsFormat::R32_SFloat, "second");
    CompiledFrame frame = FrameOf({ClearPass(first, Color::black)}, second);
    frame.passes[0].barriers.push_back(
        {second, TextureUsage::Undefined, TextureUsage::ColorAttachment});
    frame.passes[0].colors.push_back({second, LoadOp::Clear, StoreOp::Store, Color::white});
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(-1, -1, 0, 1), Color::red));
    frame.passes[0].commands.emplace_back(
        MakeDraw(frame, TwoOutputPass(), MakeQuad(0, -1, 1, 1), PlainState()));
    Device().Execute(frame);
    const Image image = Device().ReadBack(*second);
    EXPECT_EQ(1.0f, TexelFloat<1>(image, 0, 0)[0]);
    EXPECT_EQ(0.25f, TexelFloat<1>(image, 1, 0)[0]);
}

INSTANTIATE_TEST_SUITE_P(State, Blending, testing::Bool(),
                         [](const auto& which)
                         { return which.param ? "DynamicWhereOffered" : "Baked"; });

} // namespace limn::test
