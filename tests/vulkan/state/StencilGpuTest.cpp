#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "Mentions.h"
#include "core/ThrownMessage.h"

namespace limn::test
{

namespace
{

/// Writes `reference` to the stencil where it draws.
PipelineState Marking(int reference)
{
    PipelineState state = PlainState();
    state.stencilEnabled = true;
    state.stencilReference = reference;
    state.stencilFront.pass = StencilOp::Replace;
    state.stencilBack.pass = StencilOp::Replace;
    return state;
}

/// Draws where the stencil compares so with `reference`.
PipelineState Testing(CompareFunction compare, int reference)
{
    PipelineState state = PlainState();
    state.stencilEnabled = true;
    state.stencilReference = reference;
    state.stencilFront.compare = compare;
    state.stencilBack.compare = compare;
    return state;
}

/// Draws black over the left half of a 2x1 target with `mark`, then white over all with `test`.
std::array<bool, 2> IsWhite(const PipelineState& mark, const PipelineState& test)
{
    const TargetPtr target = MakeTarget(2, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    AddDepth(frame.passes[0], MakeDepth(2, 1, true));
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(-1, -1, 0, 1), Color::black, mark));
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), Color::white, test));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    return {Texel8(image, 0, 0)[0] == 255, Texel8(image, 1, 0)[0] == 255};
}

/// One texel of stencil `stored` after a draw with the state.
int StencilAfter(const PipelineState& state, int stored)
{
    const TargetPtr target = MakeTarget(1, 1);
    const TargetPtr depth = MakeDepth(1, 1, true);
    CompiledFrame frame = FrameOf({ClearPass(target)}, depth);
    AddDepth(frame.passes[0], depth);
    frame.passes[0].depth->clearStencil = stored;
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), Color::white, state));
    SharedDevice().Execute(frame);
    return std::to_integer<int>(SharedDevice().ReadBackStencil(*depth).texels.at(0));
}

/// Whether a draw that compares so gets through the mask onto the stored value.
bool GetsThrough(CompareFunction compare, int reference, int readMask, int stored)
{
    PipelineState state = Testing(compare, reference);
    state.stencilReadMask = readMask;
    state.stencilFront.pass = StencilOp::Invert;
    return StencilAfter(state, stored) == 255 - stored;
}

using Halves = std::array<bool, 2>;
constexpr Halves k_Left = {true, false};
constexpr Halves k_Right = {false, true};

} // namespace

using Stencil = GpuTest;

TEST_F(Stencil, LetsADrawThroughWhereTheMarkIs)
{
    EXPECT_EQ(k_Left, IsWhite(Marking(5), Testing(CompareFunction::Equal, 5)));
    EXPECT_EQ(k_Right, IsWhite(Marking(5), Testing(CompareFunction::NotEqual, 5)));
}

TEST_F(Stencil, ComparesTheReferenceWithTheStoredValue)
{
    // Reference 3 against 5 on the left and 0 on the right; not turned as depth compares are.
    EXPECT_EQ(k_Left, IsWhite(Marking(5), Testing(CompareFunction::Less, 3)));
    EXPECT_EQ(k_Right, IsWhite(Marking(5), Testing(CompareFunction::Greater, 3)));
}

TEST_F(Stencil, ReadsThroughTheReadMask)
{
    PipelineState test = Testing(CompareFunction::Equal, 0xF1);
    test.stencilReadMask = 0x0F;
    EXPECT_EQ(k_Left, IsWhite(Marking(0xA1), test));
}

TEST_F(Stencil, WritesThroughTheWriteMask)
{
    PipelineState mark = Marking(0xFF);
    mark.stencilWriteMask = 0x0C;
    EXPECT_EQ(k_Left, IsWhite(mark, Testing(CompareFunction::Equal, 0x0C)));
}

TEST_F(Stencil, DoesWhatEachOperationSays)
{
    struct Case
    {
        StencilOp op;
        int result; ///< from the cleared 0
    };
    for (const Case& step :
         {Case{StencilOp::IncrementSaturate, 1}, Case{StencilOp::IncrementWrap, 1},
          Case{StencilOp::DecrementSaturate, 0}, Case{StencilOp::DecrementWrap, 255},
          Case{StencilOp::Invert, 255}, Case{StencilOp::Replace, 7}, Case{StencilOp::Keep, 0},
          Case{StencilOp::Zero, 0}})
    {
        PipelineState mark = Marking(7);
        mark.stencilFront.pass = step.op;
        mark.stencilBack.pass = step.op;
        EXPECT_TRUE(IsWhite(mark, Testing(CompareFunction::Equal, step.result))[0])
            << "operation " << static_cast<int>(step.op);
    }
}

TEST_F(Stencil, TreatsFrontAndBackFacesApart)
{
    PipelineState mark = Marking(1);
    mark.stencilBack.pass = StencilOp::Keep;
    EXPECT_EQ(k_Left, IsWhite(mark, Testing(CompareFunction::Equal, 1))) << "quads face the viewer";
    mark = Marking(1);
    mark.stencilFront.pass = StencilOp::Keep;
    EXPECT_EQ((Halves{false, false}), IsWhite(mark, Testing(CompareFunction::Equal, 1)));
}

TEST_F(Stencil, RunsZFailWhereTheDepthTestFails)
{
    PipelineState mark = Marking(9);
    mark.zTest = CompareFunction::Never;
    mark.stencilFront.zFail = StencilOp::IncrementSaturate;
    EXPECT_EQ(k_Left, IsWhite(mark, Testing(CompareFunction::Equal, 1)));
}

TEST_F(Stencil, IsClearedByTheClearCommand)
{
    const TargetPtr target = MakeTarget(2, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    AddDepth(frame.passes[0], MakeDepth(2, 1, true));
    frame.passes[0].depth->clearStencil = 3;
    frame.passes[0].commands.emplace_back(SetViewportCommand{{1, 0, 1, 1}});
    frame.passes[0].commands.emplace_back(ClearCommand{ClearFlag::Stencil, {}, 1.0f, 4});
    frame.passes[0].commands.emplace_back(SetViewportCommand{{0, 0, 2, 1}});
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(), Color::white, Testing(CompareFunction::Equal, 4)));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    EXPECT_EQ(0, Texel8(image, 0, 0)[0]);
    EXPECT_EQ(255, Texel8(image, 1, 0)[0]);
}

TEST_F(Stencil, FollowsTheArticlesExampleOf171Through15On18)
{
    // 171 & 15 = 11 and 18 & 15 = 2.
    EXPECT_FALSE(GetsThrough(CompareFunction::Equal, 171, 15, 18));
    EXPECT_TRUE(GetsThrough(CompareFunction::Greater, 171, 15, 18));
}

TEST_F(Stencil, FollowsTheArticlesExampleOf171Through240On242)
{
    // 171 & 240 = 160 and 242 & 240 = 240.
    EXPECT_FALSE(GetsThrough(CompareFunction::Equal, 171, 240, 242));
    EXPECT_FALSE(GetsThrough(CompareFunction::Greater, 171, 240, 242));
    EXPECT_TRUE(GetsThrough(CompareFunction::LessEqual, 171, 240, 242));
}

TEST_F(Stencil, AddsOneUnderWriteMask11100000AndStoresTheThreeHighBitsOfTheSum)
{
    // The article's open question: 1 or 0010 0000? The sum is stored + 1; of it the mask lets the
    // high three bits through, the low five stay as they were.
    PipelineState state = Marking(0);
    state.stencilWriteMask = 0b1110'0000;
    state.stencilFront.pass = StencilOp::IncrementSaturate;
    EXPECT_EQ(0b0000'0000, StencilAfter(state, 0b0000'0000)) << "0 + 1: bit 0 is not written";
    EXPECT_EQ(0b0010'0000, StencilAfter(state, 0b0010'0000));
    EXPECT_EQ(0b0011'1111, StencilAfter(state, 0b0001'1111)) << "the carry gets through";
    EXPECT_EQ(0b0101'1111, StencilAfter(state, 0b0011'1111));
    EXPECT_EQ(0b1110'0000, StencilAfter(state, 0b1110'0000));
    EXPECT_EQ(0b1111'1111, StencilAfter(state, 0b1111'1111)) << "saturated at 255";
    state.stencilFront.pass = StencilOp::IncrementWrap;
    EXPECT_EQ(0b0001'1111, StencilAfter(state, 0b1111'1111)) << "256 wraps to 0, masked";
}

TEST_F(Stencil, NeverRunsZFailWithoutADepthTest)
{
    PipelineState state = Marking(9);
    state.stencilFront.zFail = StencilOp::Zero;
    state.zTest = CompareFunction::Never;
    EXPECT_EQ(0, StencilAfter(state, 5));
    state.zTest = CompareFunction::Disabled;
    EXPECT_EQ(9, StencilAfter(state, 5));
}

TEST_F(Stencil, OperatesOnTheWholeValueWhateverTheReadMask)
{
    PipelineState state = Marking(0b1010'1010);
    state.stencilReadMask = 0b0000'1111;
    EXPECT_EQ(0b1010'1010, StencilAfter(state, 0b0101'0101)) << "Replace";
    state.stencilFront.pass = StencilOp::Invert;
    EXPECT_EQ(0b1010'1010, StencilAfter(state, 0b0101'0101)) << "Invert";
}

TEST_F(Stencil, CannotBeReadBackFromATextureWithoutOne)
{
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [] { SharedDevice().ReadBackStencil(*MakeDepth(1, 1, false)); }),
                Mentions("'depth'", "no stencil", "is D32_SFloat,", "D32_SFloat_S8_UInt"));
}

} // namespace limn::test
