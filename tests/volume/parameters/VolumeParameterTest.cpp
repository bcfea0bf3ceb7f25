#include "Mentions.h"
#include "TestComponents.h"

#include <core/ThrownMessage.h>
#include <gtest/gtest.h>

namespace limn
{

namespace
{

template <typename Parameter, typename T>
T InterpOf(const T& from, const T& to, float t)
{
    Parameter result{nullptr, "result", from};
    result.Interp(from, to, t);
    return result.value();
}

TEST(BoolParameter, SwitchesAsSoonAsTheFactorIsAboveZero)
{
    EXPECT_FALSE(InterpOf<BoolParameter>(false, true, -0.5f));
    EXPECT_FALSE(InterpOf<BoolParameter>(false, true, 0.0f));
    EXPECT_TRUE(InterpOf<BoolParameter>(false, true, 0.0001f));
    EXPECT_TRUE(InterpOf<BoolParameter>(false, true, 1.0f));
    EXPECT_FALSE(InterpOf<BoolParameter>(true, false, 0.25f));
}

TEST(IntParameter, RoundsABlendTowardZero)
{
    EXPECT_EQ(InterpOf<IntParameter>(0, 10, 0.99f), 9);
    EXPECT_EQ(InterpOf<IntParameter>(0, -10, 0.99f), -9);
    EXPECT_EQ(InterpOf<IntParameter>(-5, 5, 0.25f), -2); // -2.5
    EXPECT_EQ(InterpOf<IntParameter>(0, 10, 1.0f), 10);
    EXPECT_EQ(InterpOf<IntParameter>(3, 10, 0.0f), 3);
    EXPECT_EQ(InterpOf<IntParameter>(0, 10, 2.0f), 20);
}

TEST(IntParameter, StaysAtTheGreatestAndTheLeastNumberWhereABlendLeavesThem)
{
    EXPECT_EQ(InterpOf<IntParameter>(0, 2147483647, 4.0f), 2147483647);
    EXPECT_EQ(InterpOf<IntParameter>(0, -2147483647 - 1, 4.0f), -2147483647 - 1);
    EXPECT_EQ(InterpOf<IntParameter>(-2147483647 - 1, 2147483647, 0.5f), 0);
}

TEST(FloatParameter, BlendsLinearlyAndBeyondTheEnds)
{
    EXPECT_EQ(InterpOf<FloatParameter>(2.0f, 10.0f, 0.0f), 2.0f);
    EXPECT_EQ(InterpOf<FloatParameter>(2.0f, 10.0f, 0.25f), 4.0f);
    EXPECT_EQ(InterpOf<FloatParameter>(2.0f, 10.0f, 1.0f), 10.0f);
    EXPECT_EQ(InterpOf<FloatParameter>(2.0f, 10.0f, 1.5f), 14.0f);
    EXPECT_EQ(InterpOf<FloatParameter>(2.0f, 10.0f, -0.5f), -2.0f);
}

TEST(ColorParameter, BlendsEveryChannelWithAlpha)
{
    const Color from{0.0f, 1.0f, 0.5f, 1.0f};
    const Color to{1.0f, 0.0f, 4.5f, 0.0f};
    EXPECT_EQ(InterpOf<ColorParameter>(from, to, 0.25f), (Color{0.25f, 0.75f, 1.5f, 0.75f}));
    EXPECT_EQ(InterpOf<ColorParameter>(from, to, 0.0f), from);
    EXPECT_EQ(InterpOf<ColorParameter>(from, to, 1.0f), to);
}

TEST(ClampedFloatParameter, ClampsInSetValue)
{
    ClampedFloatParameter width{nullptr, "width", 3.0f, 1.0f, 10.0f};
    width.SetValue(14.0f);
    EXPECT_EQ(width.value(), 10.0f);
    width.SetValue(0.0f);
    EXPECT_EQ(width.value(), 1.0f);
    width.SetValue(4.5f);
    EXPECT_EQ(width.value(), 4.5f);
    EXPECT_FALSE(width.overrideState());
}

TEST(ClampedFloatParameter, ClampsNeitherInItsConstructorNorInOverrideNorInABlend)
{
    ClampedFloatParameter width{nullptr, "width", 12.0f, 1.0f, 10.0f};
    EXPECT_EQ(width.value(), 12.0f);

    width.Override(-4.0f);
    EXPECT_EQ(width.value(), -4.0f);
    EXPECT_TRUE(width.overrideState());

    width.Interp(0.0f, 20.0f, 1.0f);
    EXPECT_EQ(width.value(), 20.0f);
}

TEST(ClampedFloatParameter, RefusesLimitsInTheWrongOrder)
{
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [] { ClampedFloatParameter(nullptr, "width", 3.0f, 10.0f, 1.0f); }),
                test::Mentions("'width'", "[10, 1]", "first limit"));
}

TEST(VolumeParameter, CopiesAValueAsItIsAndLeavesTheOverrideState)
{
    ClampedFloatParameter width{nullptr, "width", 3.0f, 1.0f, 10.0f};
    FloatParameter source{nullptr, "source", 99.0f, true};
    width.SetValue(source);
    EXPECT_EQ(width.value(), 99.0f);
    EXPECT_FALSE(width.overrideState());
}

TEST(VolumeParameter, BlendsThroughTheBaseClassOntoItself)
{
    FloatParameter state{nullptr, "state", 2.0f};
    FloatParameter target{nullptr, "target", 10.0f, true};
    VolumeParameter& base = state;
    base.Interp(state, target, 0.25f);
    EXPECT_EQ(state.value(), 4.0f);
    EXPECT_FALSE(state.overrideState());
}

TEST(VolumeParameter, RefusesToBlendWithAnotherTypeOfValue)
{
    FloatParameter number{nullptr, "number", 0.0f};
    BoolParameter flag{nullptr, "flag", true};
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { number.SetValue(flag); }),
                test::Mentions("'number'", "Float", "'flag'", "Bool"));
}

TEST(VolumeParameter, DescribesItselfForPeople)
{
    const test::ScreenSpaceOutline outline;
    EXPECT_EQ(outline.m_OutlineWidth.name(), "m_OutlineWidth");
    EXPECT_EQ(outline.m_OutlineWidth.typeName(), "ClampedFloat");
    EXPECT_EQ(outline.m_OutlineWidth.range(), (ValueRange{1.0, 10.0}));
    EXPECT_EQ(outline.m_OutlineWidth.ValueText(), "3");
    EXPECT_EQ(outline.m_Enable.ValueText(), "false");
    EXPECT_EQ(outline.m_Enable.range(), std::nullopt);
    EXPECT_EQ(outline.m_OutlineColor.ValueText(), "{r: 1, g: 1, b: 1, a: 1}");
    EXPECT_EQ((IntParameter{nullptr, "i", -7}.ValueText()), "-7");
    EXPECT_EQ((FloatParameter{nullptr, "f", 0.49606514f}.ValueText()), "0.49606514");
}

} // namespace

} // namespace limn
