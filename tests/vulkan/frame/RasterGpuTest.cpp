#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

MeshPtr MakeTriangle(glm::vec3 a, glm::vec3 b, glm::vec3 c)
{
    MeshData data;
    data.vertices = {a, b, c};
    data.triangles = {0, 1, 2};
    return std::make_shared<Mesh>("triangle", std::move(data));
}

/// Covers the whole target; its corners follow each other clockwise on screen.
MeshPtr ClockwiseTriangle()
{
    return MakeTriangle({-1, -1, 0.5f}, {-1, 3, 0.5f}, {3, -1, 0.5f});
}

/// Draws one mesh in white on black and returns the red of the centre of a 4x4 target.
int CentreOf(const MeshPtr& mesh, const PipelineState& state)
{
    const TargetPtr target = MakeTarget(4, 4);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, mesh, Color::white, state));
    SharedDevice().Execute(frame);
    return Texel8(ReadRows(*target), 2, 2)[0];
}

/// The red of a 2x2 target, row by row, with one mesh drawn in white on black.
std::array<int, 4> DrawnTexels(const MeshPtr& mesh, const PipelineState& state)
{
    const TargetPtr target = MakeTarget(2, 2);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, mesh, Color::white, state));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    return {Texel8(image, 0, 0)[0], Texel8(image, 1, 0)[0], Texel8(image, 0, 1)[0],
            Texel8(image, 1, 1)[0]};
}

PipelineState Culling(CullMode cull, bool flipped = false)
{
    PipelineState state = PlainState();
    state.cull = cull;
    state.frontFaceFlipped = flipped;
    return state;
}

/// Unity's defaults: LessEqual, depth written.
PipelineState DepthState()
{
    PipelineState state;
    state.cull = CullMode::Off;
    return state;
}

/// Draws a red and a green quad at the given depths in this order; returns the centre.
Rgba8 DrawTwo(float redZ, float greenZ, const PipelineState& red, const PipelineState& green)
{
    const TargetPtr target = MakeTarget(2, 2);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    AddDepth(frame.passes[0], MakeDepth(2, 2));
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(-1, -1, 1, 1, redZ), Color::red, red));
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(-1, -1, 1, 1, greenZ), Color::green, green));
    SharedDevice().Execute(frame);
    return Texel8(ReadRows(*target), 1, 1);
}

} // namespace

using Rasterization = GpuTest;

TEST_F(Rasterization, PutsClipSpaceUpIntoTheFirstRow)
{
    const TargetPtr target = MakeTarget(4, 4);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    // The quarter x in [-1, 0], y in [0.5, 1]: left half of the first of four rows.
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(-1, 0.5f, 0, 1), Color::white));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    for (int i = 0; i < 16; ++i)
    {
        EXPECT_EQ(i < 2 ? 255 : 0, Texel8(image, i % 4, i / 4)[0]) << "texel " << i;
    }
}

TEST_F(Rasterization, MapsClipSpaceToTheViewport)
{
    const TargetPtr target = MakeTarget(4, 4);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(SetViewportCommand{{2, 0, 2, 2}});
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(-1, 0, 1, 1), Color::white));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    for (int i = 0; i < 16; ++i)
    {
        EXPECT_EQ(i == 2 || i == 3 ? 255 : 0, Texel8(image, i % 4, i / 4)[0]) << "texel " << i;
    }
}

TEST_F(Rasterization, TakesClockwiseFacesAsFront)
{
    EXPECT_EQ(255, CentreOf(ClockwiseTriangle(), Culling(CullMode::Back)));
    EXPECT_EQ(0, CentreOf(ClockwiseTriangle(), Culling(CullMode::Front)));
    EXPECT_EQ(255, CentreOf(ClockwiseTriangle(), Culling(CullMode::Off)));
}

TEST_F(Rasterization, TakesCounterClockwiseFacesAsBack)
{
    const MeshPtr mesh = MakeTriangle({-1, -1, 0.5f}, {3, -1, 0.5f}, {-1, 3, 0.5f});
    EXPECT_EQ(0, CentreOf(mesh, Culling(CullMode::Back)));
    EXPECT_EQ(255, CentreOf(mesh, Culling(CullMode::Front)));
}

TEST_F(Rasterization, SwapsFacesForAMirroredTransform)
{
    EXPECT_EQ(0, CentreOf(ClockwiseTriangle(), Culling(CullMode::Back, true)));
    EXPECT_EQ(255, CentreOf(ClockwiseTriangle(), Culling(CullMode::Front, true)));
}

TEST_F(Rasterization, LetsTheNearerQuadWinInBothOrders)
{
    // Clip z is 1 near, 0 far.
    EXPECT_EQ(k_Red, DrawTwo(0.75f, 0.25f, DepthState(), DepthState()));
    EXPECT_EQ(k_Green, DrawTwo(0.25f, 0.75f, DepthState(), DepthState()));
}

TEST_F(Rasterization, ReadsCompareFunctionsAsUnityDoes)
{
    PipelineState green = DepthState();
    green.zTest = CompareFunction::Greater;
    EXPECT_EQ(k_Green, DrawTwo(0.75f, 0.25f, DepthState(), green)) << "farther passes Greater";
    EXPECT_EQ(k_Red, DrawTwo(0.25f, 0.75f, DepthState(), green));
    green.zTest = CompareFunction::Equal;
    EXPECT_EQ(k_Green, DrawTwo(0.5f, 0.5f, DepthState(), green));
    green.zTest = CompareFunction::Less;
    EXPECT_EQ(k_Red, DrawTwo(0.5f, 0.5f, DepthState(), green));
    green.zTest = CompareFunction::Disabled;
    EXPECT_EQ(k_Green, DrawTwo(0.75f, 0.25f, DepthState(), green));
}

TEST_F(Rasterization, KeepsTheDepthWhereZWriteIsOff)
{
    PipelineState red = DepthState();
    red.zWrite = false;
    EXPECT_EQ(k_Green, DrawTwo(0.75f, 0.25f, red, DepthState()));
}

TEST_F(Rasterization, DoesNotWriteDepthWhereTheTestIsDisabled)
{
    PipelineState red = DepthState();
    red.zTest = CompareFunction::Disabled;
    EXPECT_EQ(k_Green, DrawTwo(0.75f, 0.25f, red, DepthState()));
}

TEST_F(Rasterization, WritesDepthWhereTheTestAlwaysPasses)
{
    PipelineState red = DepthState();
    red.zTest = CompareFunction::Always;
    EXPECT_EQ(k_Red, DrawTwo(0.75f, 0.25f, red, DepthState()));
}

TEST_F(Rasterization, MovesAPositiveOffsetAway)
{
    PipelineState green = DepthState();
    green.offsetUnits = 100.0f;
    EXPECT_EQ(k_Red, DrawTwo(0.5f, 0.5f, DepthState(), green));
    green.offsetUnits = -100.0f;
    green.zTest = CompareFunction::Less;
    EXPECT_EQ(k_Green, DrawTwo(0.5f, 0.5f, DepthState(), green));
}

TEST_F(Rasterization, ScalesTheOffsetFactorWithTheSlope)
{
    MeshData data; // z goes from 0.2 at the left to 0.8 at the right
    data.vertices = {{-1, -1, 0.2f}, {-1, 1, 0.2f}, {1, 1, 0.8f}, {1, -1, 0.8f}};
    data.triangles = {0, 1, 2, 0, 2, 3};
    const auto sloped = std::make_shared<Mesh>("sloped", std::move(data));
    const auto draw = [&](float factor)
    {
        const TargetPtr target = MakeTarget(4, 4);
        CompiledFrame frame = FrameOf({ClearPass(target)}, target);
        AddDepth(frame.passes[0], MakeDepth(4, 4));
        PipelineState offset = DepthState();
        offset.zTest = CompareFunction::Less;
        offset.offsetFactor = factor;
        frame.passes[0].commands.emplace_back(
            MakeColorDraw(frame, sloped, Color::red, DepthState()));
        frame.passes[0].commands.emplace_back(MakeColorDraw(frame, sloped, Color::green, offset));
        SharedDevice().Execute(frame);
        return Texel8(ReadRows(*target), 2, 2);
    };
    EXPECT_EQ(k_Green, draw(-1.0f)) << "nearer";
    EXPECT_EQ(k_Red, draw(1.0f)) << "farther";
}

TEST_F(Rasterization, DrawsWhatIsNearerThanTheNearPlaneWhereZClipIsOff)
{
    PipelineState state = PlainState();
    EXPECT_EQ(0, CentreOf(MakeQuad(-1, -1, 1, 1, 1.5f), state));
    state.zClip = false;
    EXPECT_EQ(255, CentreOf(MakeQuad(-1, -1, 1, 1, 1.5f), state));
}

TEST_F(Rasterization, IgnoresDepthAndStencilStatesWithoutADepthTarget)
{
    PipelineState state = DepthState();
    state.zTest = CompareFunction::Never;
    state.stencilEnabled = true;
    state.stencilFront.compare = CompareFunction::Never;
    state.stencilBack.compare = CompareFunction::Never;
    EXPECT_EQ(255, CentreOf(MakeQuad(), state));
}

TEST_F(Rasterization, DrawsWithoutAMeshByVertexId)
{
    const PassPtr pass = CompilePass(R"(
        float4 vert(uint id : SV_VertexID) : SV_POSITION
        {
            return float4(id == 1 ? 3 : -1, id == 2 ? -3 : 1, 0.5, 1);
        }
        float4 frag() : SV_Target { return float4(0, 1, 0, 1); })");
    const TargetPtr target = MakeTarget(3, 3);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    DrawCommand draw = MakeDraw(frame, pass, nullptr);
    draw.vertexCount = 3;
    frame.passes[0].commands.emplace_back(draw);
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    EXPECT_EQ(k_Green, Texel8(image, 0, 0));
    EXPECT_EQ(k_Green, Texel8(image, 2, 2));
}

TEST_F(Rasterization, DrawsOneSubMeshOnly)
{
    MeshData data;
    data.vertices = {{-1, -1, 0.5f}, {-1, 1, 0.5f}, {0, 1, 0.5f},
                     {0, -1, 0.5f},  {1, 1, 0.5f},  {1, -1, 0.5f}};
    data.triangles = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    data.subMeshes = {{0, 6}, {6, 6}};
    const auto mesh = std::make_shared<Mesh>("halves", std::move(data));
    const TargetPtr target = MakeTarget(2, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    DrawCommand draw = MakeColorDraw(frame, mesh, Color::white);
    draw.subMesh = 1;
    frame.passes[0].commands.emplace_back(draw);
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    EXPECT_EQ(0, Texel8(image, 0, 0)[0]);
    EXPECT_EQ(255, Texel8(image, 1, 0)[0]);
}

TEST_F(Rasterization, CoversEveryTexelItTouchesWhereConservativeAndTheDeviceCan)
{
    // Around the corner that four texels share, away from their centres at +-0.5.
    const MeshPtr triangle =
        MakeTriangle({-0.1f, -0.1f, 0.5f}, {0, 0.1f, 0.5f}, {0.1f, -0.1f, 0.5f});
    EXPECT_EQ((std::array{0, 0, 0, 0}), DrawnTexels(triangle, PlainState()));
    PipelineState state = PlainState();
    state.conservative = true;
    try
    {
        EXPECT_EQ((std::array{255, 255, 255, 255}), DrawnTexels(triangle, state));
    }
    catch (const ContractError& error)
    {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("the device lacks VK_EXT_conservative_rasterization"));
    }
}

} // namespace limn::test
