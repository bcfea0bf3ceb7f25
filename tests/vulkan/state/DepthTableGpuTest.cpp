#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

namespace limn::test
{

namespace
{

/// A mesh drawn with a state into a texel of its own.
struct Cell
{
    MeshPtr mesh;
    PipelineState state;
};

struct CellResult
{
    bool drawn = false;
    float depth = 0.0f;
};

/// Draws each cell in white over black and depth 0.5, 4x4 texels each; returns its (1, 1).
std::vector<CellResult> DrawCells(const std::vector<Cell>& cells)
{
    constexpr int size = 4;
    const auto count = static_cast<int>(cells.size());
    const TargetPtr target = MakeTarget(count * size, size);
    const TargetPtr depth = MakeDepth(count * size, size);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.finalBarriers.push_back(
        {depth, TextureUsage::DepthStencilAttachment, TextureUsage::CopySource});
    AddDepth(frame.passes[0], depth);
    frame.passes[0].depth->clearDepth = 0.5f;
    for (int i = 0; i < count; ++i)
    {
        const Cell& cell = cells.at(static_cast<std::size_t>(i));
        frame.passes[0].commands.emplace_back(SetViewportCommand{{i * size, 0, size, size}});
        frame.passes[0].commands.emplace_back(
            MakeColorDraw(frame, cell.mesh, Color::white, cell.state));
    }
    SharedDevice().Execute(frame);
    const Image color = ReadRows(*target);
    const Image depths = ReadRows(*depth);
    std::vector<CellResult> results;
    for (int i = 0; i < count; ++i)
    {
        const int x = i * size + 1;
        results.push_back({Texel8(color, x, 1)[0] == 255, TexelFloat<1>(depths, x, 1)[0]});
    }
    return results;
}

PipelineState DepthState(CompareFunction zTest, bool zWrite)
{
    PipelineState state;
    state.cull = CullMode::Off;
    state.zTest = zTest;
    state.zWrite = zWrite;
    return state;
}

/// Whether what is so much nearer (-1), as far (0) or farther (1) than the stored depth is drawn.
bool PassesAt(CompareFunction zTest, int distance)
{
    switch (zTest)
    {
    case CompareFunction::Never:
        return false;
    case CompareFunction::Less:
        return distance < 0;
    case CompareFunction::Equal:
        return distance == 0;
    case CompareFunction::LessEqual:
        return distance <= 0;
    case CompareFunction::Greater:
        return distance > 0;
    case CompareFunction::NotEqual:
        return distance != 0;
    case CompareFunction::GreaterEqual:
        return distance >= 0;
    default:
        return true;
    }
}

MeshPtr Plane(float zLeft, float zRight)
{
    MeshData data;
    data.vertices = {{-1, -1, zLeft}, {-1, 1, zLeft}, {1, 1, zRight}, {1, -1, zRight}};
    data.triangles = {0, 1, 2, 0, 2, 3};
    return std::make_shared<Mesh>("plane", std::move(data));
}

} // namespace

using DepthTable = GpuTest;

TEST_F(DepthTable, ReadsEveryZTestByDistanceUnderReversedZ)
{
    std::vector<Cell> cells;
    for (int i = 0; i < 9 * 2 * 3; ++i) // compare, ZWrite, distance
    {
        const float z = 0.5f - 0.25f * static_cast<float>(i % 3 - 1);
        cells.push_back({MakeQuad(-1, -1, 1, 1, z),
                         DepthState(static_cast<CompareFunction>(i / 6), i / 3 % 2 == 1)});
    }
    const std::vector<CellResult> results = DrawCells(cells);
    for (int i = 0; i < 9 * 2 * 3; ++i)
    {
        const PipelineState& state = cells.at(static_cast<std::size_t>(i)).state;
        const CellResult& result = results.at(static_cast<std::size_t>(i));
        const int distance = i % 3 - 1;
        const bool passes = PassesAt(state.zTest, distance);
        const bool writes = passes && state.zWrite && state.zTest != CompareFunction::Disabled;
        const float z = 0.5f - 0.25f * static_cast<float>(distance);
        SCOPED_TRACE("ZTest " + std::to_string(i / 6) + ", ZWrite " + std::to_string(i / 3 % 2) +
                     ", distance " + std::to_string(distance));
        EXPECT_EQ(passes, result.drawn);
        EXPECT_EQ(writes ? z : 0.5f, result.depth);
    }
}

TEST_F(DepthTable, MovesDepthByFactorTimesSlopePlusUnitsAwayFromTheCamera)
{
    // Of 32-bit float depth one unit is 2^-24 where the primitive's largest z is in [0.5, 1); the
    // slope is in depth per texel. Texel (1, 1) has its centre at 3/8 of the way.
    struct Slope
    {
        float left, right;
        double slope;
    };
    std::vector<Cell> cells;
    std::vector<double> expected;
    for (const Slope& plane : {Slope{0.625f, 0.625f, 0.0}, Slope{0.5625f, 0.8125f, 1.0 / 16.0},
                               Slope{0.8125f, 0.5625f, 1.0 / 16.0}})
    {
        for (const float factor : {-2.0f, -1.0f, 0.0f, 0.5f, 1.0f})
        {
            for (const float units : {-1000.0f, -1.0f, 0.0f, 1.0f, 1000.0f})
            {
                PipelineState state = DepthState(CompareFunction::Always, true);
                state.offsetFactor = factor;
                state.offsetUnits = units;
                cells.push_back({Plane(plane.left, plane.right), state});
                const double z = static_cast<double>(plane.left) +
                                 static_cast<double>(plane.right - plane.left) * 3.0 / 8.0;
                expected.push_back(z - static_cast<double>(factor) * plane.slope -
                                   static_cast<double>(units) * 0x1p-24);
            }
        }
    }
    const std::vector<CellResult> results = DrawCells(cells);
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
        EXPECT_NEAR(expected.at(i), static_cast<double>(results.at(i).depth), 0x1p-23)
            << "plane " << i / 25 << ", Offset " << cells.at(i).state.offsetFactor << ", "
            << cells.at(i).state.offsetUnits;
    }
}

TEST_F(DepthTable, ClampsDepthWhereZClipIsOffAndCutsWhereItIsOn)
{
    struct Case
    {
        float z;
        bool zClip;
        bool drawn;
        float depth;
    };
    const std::vector<Case> cases = {
        {1.5f, true, false, 0.5f},  {1.0f, true, true, 1.0f},   {0.0f, true, true, 0.0f},
        {-0.5f, true, false, 0.5f}, {1.5f, false, true, 1.0f},  {1.0f, false, true, 1.0f},
        {0.0f, false, true, 0.0f},  {-0.5f, false, true, 0.0f},
    };
    std::vector<Cell> cells;
    for (const Case& one : cases)
    {
        PipelineState state = DepthState(CompareFunction::Always, true);
        state.zClip = one.zClip;
        cells.push_back({MakeQuad(-1, -1, 1, 1, one.z), state});
    }
    const std::vector<CellResult> results = DrawCells(cells);
    for (std::size_t i = 0; i < cases.size(); ++i)
    {
        SCOPED_TRACE("z " + std::to_string(cases.at(i).z) +
                     (cases.at(i).zClip ? ", ZClip True" : ", ZClip False"));
        EXPECT_EQ(cases.at(i).drawn, results.at(i).drawn);
        EXPECT_EQ(cases.at(i).depth, results.at(i).depth);
    }
}

TEST_F(DepthTable, CullsByWindingCullModeAndMirroring)
{
    MeshData data;
    data.vertices = {{-1, -1, 0.5f}, {3, -1, 0.5f}, {-1, 3, 0.5f}};
    data.triangles = {0, 1, 2};
    const auto counterClockwise = std::make_shared<Mesh>("ccw", std::move(data));
    std::vector<Cell> cells;
    for (int i = 0; i < 3 * 2 * 2; ++i)
    {
        PipelineState state = DepthState(CompareFunction::Always, true);
        state.cull = static_cast<CullMode>(i / 4);
        state.frontFaceFlipped = i % 2 == 1;
        cells.push_back({i / 2 % 2 == 0 ? MakeQuad() : counterClockwise, state});
    }
    const std::vector<CellResult> results = DrawCells(cells);
    for (int i = 0; i < 3 * 2 * 2; ++i)
    {
        const auto cull = static_cast<CullMode>(i / 4);
        const bool clockwise = i / 2 % 2 == 0;
        const bool mirrored = i % 2 == 1;
        const bool isFront = clockwise != mirrored;
        const bool drawn = cull == CullMode::Off || (cull == CullMode::Back) == isFront;
        EXPECT_EQ(drawn, results.at(static_cast<std::size_t>(i)).drawn)
            << "Cull " << i / 4 << (clockwise ? ", clockwise" : ", counter-clockwise")
            << (mirrored ? ", mirrored" : "");
    }
}

} // namespace limn::test
