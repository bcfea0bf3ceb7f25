#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include <span>

namespace limn::test
{

namespace
{

constexpr std::array<int, 6> k_References = {0, 1, 127, 171, 254, 255};
constexpr std::array<int, 4> k_ReadMasks = {0, 15, 240, 255};
constexpr std::array<int, 4> k_WriteMasks = {0, 15, 224, 255};
constexpr std::array<int, 6> k_Stored = {0, 1, 18, 242, 254, 255};

// What the stencil unit does, written from its equation with Unity's words and no look at limn.

/// (reference & readMask) compare (stored & readMask).
bool Passes(CompareFunction compare, int reference, int stored)
{
    switch (compare)
    {
    case CompareFunction::Never:
        return false;
    case CompareFunction::Less:
        return reference < stored;
    case CompareFunction::Equal:
        return reference == stored;
    case CompareFunction::LessEqual:
        return reference <= stored;
    case CompareFunction::Greater:
        return reference > stored;
    case CompareFunction::NotEqual:
        return reference != stored;
    case CompareFunction::GreaterEqual:
        return reference >= stored;
    default:
        return true;
    }
}

int Operate(StencilOp op, int stored, int reference)
{
    switch (op)
    {
    case StencilOp::Keep:
        return stored;
    case StencilOp::Zero:
        return 0;
    case StencilOp::Replace:
        return reference;
    case StencilOp::IncrementSaturate:
        return stored == 255 ? 255 : stored + 1;
    case StencilOp::DecrementSaturate:
        return stored == 0 ? 0 : stored - 1;
    case StencilOp::Invert:
        return 255 - stored;
    case StencilOp::IncrementWrap:
        return (stored + 1) % 256;
    case StencilOp::DecrementWrap:
        return (stored + 255) % 256;
    }
    return -1;
}

struct Outcome
{
    int stencil = 0;
    bool drawn = false;

    bool operator==(const Outcome&) const = default;
};

Outcome Predict(const PipelineState& state, int stored, bool backFace, bool depthPasses)
{
    const StencilFace& face = backFace ? state.stencilBack : state.stencilFront;
    const int mask = state.stencilReadMask;
    const bool passes = Passes(face.compare, state.stencilReference & mask, stored & mask);
    const StencilOp afterTest = depthPasses ? face.pass : face.zFail;
    const int result = Operate(passes ? afterTest : face.fail, stored, state.stencilReference);
    const int writes = state.stencilWriteMask;
    return {(stored & ~writes) | (result & writes), passes && depthPasses};
}

// One state is drawn over one cell: a row for each stored value; in the columns a front face that
// passes the depth test, one that fails it, and the same as back faces.

constexpr int k_CellWidth = 4;
constexpr int k_CellHeight = static_cast<int>(k_Stored.size());
constexpr std::size_t k_CellsPerRow = 96;
constexpr std::size_t k_CellRows = 64;
constexpr std::size_t k_CellsPerFrame = k_CellsPerRow * k_CellRows;

bool IsBackFace(int column)
{
    return column >= 2;
}
bool PassesDepth(int column)
{
    return column % 2 == 0;
}

/// The depth buffer holds 0.5; nearer is larger.
MeshPtr CellMesh()
{
    MeshData data;
    for (int column = 0; column < k_CellWidth; ++column)
    {
        const float left = -1.0f + 0.5f * static_cast<float>(column);
        const float right = left + 0.5f;
        const float z = PassesDepth(column) ? 0.75f : 0.25f;
        const auto first = static_cast<std::uint32_t>(data.vertices.size());
        data.vertices.insert(data.vertices.end(),
                             {{left, -1, z}, {left, 1, z}, {right, 1, z}, {right, -1, z}});
        for (const std::uint32_t corner : IsBackFace(column)
                                              ? std::array<std::uint32_t, 6>{0, 2, 1, 0, 3, 2}
                                              : std::array<std::uint32_t, 6>{0, 1, 2, 0, 2, 3})
        {
            data.triangles.push_back(first + corner);
        }
    }
    return std::make_shared<Mesh>("cell", std::move(data));
}

/// What a frame of cells left behind.
struct CellImages
{
    Image color;
    Image depth;
    Image stencil;

    Outcome At(std::size_t cell, int column, int row) const
    {
        const int x = static_cast<int>(cell % k_CellsPerRow) * k_CellWidth + column;
        const int y = static_cast<int>(cell / k_CellsPerRow) * k_CellHeight + row;
        const auto index = static_cast<std::size_t>(y * stencil.width + x);
        const bool drawn = Texel8(color, x, y)[0] == 255;
        const float z = TexelFloat<1>(depth, x, y)[0];
        EXPECT_EQ(drawn ? 0.75f : 0.5f, z) << "depth is written where colour is";
        return {std::to_integer<int>(stencil.texels.at(index)), drawn};
    }
};

/// Draws each state over a cell of its own; at most k_CellsPerFrame.
CellImages DrawCells(std::span<const PipelineState> states)
{
    const auto rows = static_cast<int>((states.size() + k_CellsPerRow - 1) / k_CellsPerRow);
    const int width = static_cast<int>(k_CellsPerRow) * k_CellWidth;
    const TargetPtr target = MakeTarget(width, rows * k_CellHeight);
    const TargetPtr depth = MakeDepth(width, rows * k_CellHeight, true);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.finalBarriers.push_back(
        {depth, TextureUsage::DepthStencilAttachment, TextureUsage::CopySource});
    CompiledRenderPass& pass = frame.passes[0];
    AddDepth(pass, depth);
    pass.depth->clearDepth = 0.5f;
    for (int y = 0; y < rows * k_CellHeight; ++y)
    {
        const int stored = k_Stored.at(static_cast<std::size_t>(y % k_CellHeight));
        pass.commands.emplace_back(SetViewportCommand{{0, y, width, 1}});
        pass.commands.emplace_back(ClearCommand{ClearFlag::Stencil, {}, 1.0f, stored});
    }
    const DrawCommand draw = MakeColorDraw(frame, CellMesh(), Color::white);
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        const int x = static_cast<int>(i % k_CellsPerRow) * k_CellWidth;
        const int y = static_cast<int>(i / k_CellsPerRow) * k_CellHeight;
        pass.commands.emplace_back(SetViewportCommand{{x, y, k_CellWidth, k_CellHeight}});
        pass.commands.emplace_back(WithState(frame, draw, states[i]));
    }
    SharedDevice().Execute(frame);
    return {ReadRows(*target), ReadRows(*depth), ReadStencilRows(*depth)};
}

std::string Describe(const PipelineState& state, int stored, bool back, bool depthPasses)
{
    const StencilFace& face = back ? state.stencilBack : state.stencilFront;
    return "Ref " + std::to_string(state.stencilReference) + " ReadMask " +
           std::to_string(state.stencilReadMask) + " WriteMask " +
           std::to_string(state.stencilWriteMask) + " Comp " +
           std::to_string(static_cast<int>(face.compare)) + " Pass " +
           std::to_string(static_cast<int>(face.pass)) + " Fail " +
           std::to_string(static_cast<int>(face.fail)) + " ZFail " +
           std::to_string(static_cast<int>(face.zFail)) + ", stored " + std::to_string(stored) +
           (back ? ", back" : ", front") + (depthPasses ? "" : ", behind");
}

/// Draws all states and compares every outcome; returns how many there were.
std::size_t ExpectAsPredicted(std::span<const PipelineState> states)
{
    std::size_t checked = 0;
    for (std::size_t first = 0; first < states.size(); first += k_CellsPerFrame)
    {
        const auto some = states.subspan(first, std::min(k_CellsPerFrame, states.size() - first));
        const CellImages images = DrawCells(some);
        for (std::size_t cell = 0; cell < some.size(); ++cell)
        {
            for (int i = 0; i < k_CellWidth * k_CellHeight; ++i)
            {
                const int column = i % k_CellWidth;
                const int row = i / k_CellWidth;
                const int stored = k_Stored.at(static_cast<std::size_t>(row));
                const bool back = IsBackFace(column);
                const Outcome expected = Predict(some[cell], stored, back, PassesDepth(column));
                const Outcome actual = images.At(cell, column, row);
                if (expected != actual && !testing::Test::HasNonfatalFailure())
                {
                    ADD_FAILURE() << Describe(some[cell], stored, back, PassesDepth(column))
                                  << ": stencil " << actual.stencil << " for " << expected.stencil
                                  << ", drawn " << actual.drawn << " for " << expected.drawn;
                }
                ++checked;
            }
        }
    }
    return checked;
}

/// The depth test is LessEqual, depth is written.
PipelineState StencilState(CompareFunction compare, StencilOp pass, StencilOp fail, StencilOp zFail)
{
    PipelineState state;
    state.cull = CullMode::Off;
    state.stencilEnabled = true;
    state.stencilFront = {compare, pass, fail, zFail};
    state.stencilBack = state.stencilFront;
    return state;
}

StencilOp OpAt(int index)
{
    return static_cast<StencilOp>(index % 8);
}
CompareFunction CompareAt(int index)
{
    return static_cast<CompareFunction>(index % 8 + 1);
}

/// Compare and operations of both faces, by two numbers. Over all pairs each slot of each face
/// meets each operation with each compare function, while all six slots of a state differ as far
/// as eight operations allow: a mix-up of slots or faces cannot hide.
PipelineState StateAt(int compare, int op)
{
    PipelineState state = StencilState(CompareAt(compare), OpAt(op), OpAt(op + 3), OpAt(op + 5));
    state.stencilBack = {CompareAt(compare + 3), OpAt(op + 1), OpAt(op + 6), OpAt(op + 2)};
    return state;
}

} // namespace

using StencilTable = GpuTest;

TEST_F(StencilTable, AgreesWithTheEquationForEveryCompareOperationReferenceMaskAndStoredValue)
{
    std::vector<PipelineState> states;
    for (int i = 0; i < 8 * 8; ++i)
    {
        PipelineState state = StateAt(i / 8, i % 8);
        for (const int readMask : k_ReadMasks)
        {
            for (const int writeMask : k_WriteMasks)
            {
                for (const int reference : k_References)
                {
                    state.stencilReadMask = readMask;
                    state.stencilWriteMask = writeMask;
                    state.stencilReference = reference;
                    states.push_back(state);
                }
            }
        }
    }
    // 8 compares x 8 operations x 4 read masks x 4 write masks x 6 references, each with 6 stored
    // values x 2 faces x nearer and farther.
    EXPECT_EQ(147456u, ExpectAsPredicted(states));
}

TEST_F(StencilTable, KeepsTheOperationsOfPassFailAndZFailApart)
{
    // Each state carries two of the 512 triples: i in front, i + 256 at the back.
    std::vector<PipelineState> states;
    for (int i = 0; i < 8 * 8 * 4; ++i)
    {
        PipelineState state =
            StencilState(CompareFunction::Equal, OpAt(i), OpAt(i / 8), OpAt(i / 64));
        state.stencilBack.zFail = OpAt(i / 64 + 4);
        state.stencilReference = 18;
        states.push_back(state);
    }
    EXPECT_EQ(6144u, ExpectAsPredicted(states));
}

} // namespace limn::test
