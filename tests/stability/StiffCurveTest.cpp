#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <limn/volume/AnimationCurve.h>
#include <limn/volume/CurveParameters.h>
#include <volume/blending/VolumeScene.h>

namespace limn
{

namespace
{

constexpr float k_Vertical = std::numeric_limits<float>::infinity();
constexpr std::array<double, 7> k_TimeSteps{1e-6, 1e-3, 1.0 / 60.0, 1.0, 61.0, 3600.0, 86400.0};

/// A volume whose value follows a curve, at weight 0.25 above one that sets 8.
class StiffCurve : public testing::Test
{
protected:
    StiffCurve()
    {
        m_Base.priority = -1.0f;
        m_Animated.weight = 0.25f;
        m_Scene.manager.Register(&m_Base);
        m_Scene.manager.Register(&m_Animated);
    }

    float FrameAt(const AnimationCurve& curve, float time)
    {
        m_Profile->TryGet<test::TestVolume>()->param.Override(curve.Evaluate(time));
        m_Scene.Update();
        return m_Scene.Param();
    }

    /// Calls visit(time) for frames of each length, from a second before 0 on.
    template <typename Visit>
    static void ForEachFrame(Visit&& visit)
    {
        for (const double step : k_TimeSteps)
        {
            for (int frame = 0; frame < 300; ++frame)
            {
                visit(static_cast<float>(-1.0 + frame * step));
            }
        }
    }

    test::VolumeScene m_Scene;
    std::shared_ptr<VolumeProfile> m_Profile = test::ParamProfile(0.0f);
    Volume m_Base = test::GlobalVolume(test::ParamProfile(8.0f));
    Volume m_Animated = test::GlobalVolume(m_Profile);
};

TEST_F(StiffCurve, WithVerticalTangentsIsAtOneOfItsKeysInEveryFrame)
{
    const AnimationCurve curve({{0.0f, 0.0f, 0.0f, k_Vertical},
                                {1e-6f, 4.0f, k_Vertical, -k_Vertical},
                                {2.0f, -4.0f, k_Vertical, k_Vertical},
                                {7200.0f, 0.0f, -k_Vertical, 0.0f}});
    const auto expected = [](float time)
    {
        return time < 1e-6f ? 6.0f : time < 2.0f ? 7.0f : time < 7200.0f ? 5.0f : 6.0f;
    };
    ForEachFrame([&](float time) { EXPECT_EQ(expected(time), FrameAt(curve, time)) << time; });
    for (const float key : {1e-6f, 2.0f, 7200.0f}) // a float before, on and behind each
    {
        for (const float time : {std::nextafter(key, 0.0f), key, std::nextafter(key, 1e9f)})
        {
            EXPECT_EQ(expected(time), FrameAt(curve, time)) << time;
        }
    }
}

TEST_F(StiffCurve, RepeatedForADayIsInPhase)
{
    AnimationCurve square({{0.0f, 0.0f, 0.0f, k_Vertical},
                           {0.5f, 8.0f, k_Vertical, k_Vertical},
                           {1.0f, 0.0f, k_Vertical, 0.0f}});
    square.SetPostWrapMode(WrapMode::Loop);
    for (int half = 3; half < 2 * 86400; half += 997) // every other half second is at 8
    {
        const float time = 0.5f * static_cast<float>(half);
        EXPECT_EQ(half % 2 == 0 ? 6.0f : 8.0f, FrameAt(square, time)) << time;
        EXPECT_EQ(half % 2 == 0 ? 8.0f : 6.0f, FrameAt(square, std::nextafter(time, 0.0f))) << time;
    }
}

TEST_F(StiffCurve, WithKeysAMicrosecondApartLeavesTheirValuesNowhere)
{
    // No slope at the keys: between two of them a cubic stays between their values.
    const AnimationCurve curve({{0.0f, 0.0f}, {1e-6f, 8.0f}, {2e-6f, -8.0f}, {1.0f, 4.0f}});
    for (int i = -10; i < 400; ++i)
    {
        const float value = curve.Evaluate(static_cast<float>(i) * 1e-8f);
        EXPECT_TRUE(value >= -8.0f && value <= 8.0f) << i;
    }
    for (const Keyframe& key : curve.keys())
    {
        EXPECT_EQ(key.value, curve.Evaluate(key.time));
    }
    ForEachFrame(
        [&](float time)
        {
            const float blended = FrameAt(curve, time);
            EXPECT_TRUE(blended >= 4.0f && blended <= 8.0f) << time;
            EXPECT_TRUE(time < 1.0f || blended == 7.0f) << time;
        });
}

TEST_F(StiffCurve, OfAnySlopeIsFiniteAndExactAtItsKeys)
{
    for (const float slope : {1e7f, 1e30f, -3.4e38f, 1e-45f})
    {
        for (const float distance : {1e-6f, 1e-4f, 1.0f, 86400.0f})
        {
            const AnimationCurve curve({{0.0f, 1.0f, 0.0f, slope}, {distance, 2.0f, slope, 0.0f}});
            EXPECT_EQ(1.0f, curve.Evaluate(0.0f));
            EXPECT_EQ(2.0f, curve.Evaluate(distance));
            for (int i = 0; i <= 64; ++i)
            {
                const float value = curve.Evaluate(distance * static_cast<float>(i) / 64.0f);
                EXPECT_FALSE(std::isnan(value)) << slope << " over " << distance << " at " << i;
            }
        }
    }
}

TEST_F(StiffCurve, BlendedWithAnotherJumpsWhereEitherDoes)
{
    const AnimationCurve steps({{0.0f, 0.0f, 0.0f, k_Vertical}, {1.0f, 8.0f, k_Vertical, 0.0f}});
    const AnimationCurve later({{0.5f, 4.0f, 0.0f, k_Vertical}, {1.5f, 6.0f, k_Vertical, 0.0f}});
    for (const float t : {1e-30f, 0.25f, std::nextafter(1.0f, 0.0f)})
    {
        AnimationCurveParameter blended{nullptr, "x", steps};
        blended.Interp(steps, later, t);
        for (int i = -8; i < 32; ++i)
        {
            const float time = static_cast<float>(i) / 16.0f;
            FloatParameter expected{nullptr, "y", 0.0f};
            expected.Interp(steps.Evaluate(time), later.Evaluate(time), t);
            EXPECT_EQ(expected.value(), blended.value().Evaluate(time)) << time << " with " << t;
        }
    }
}

} // namespace

} // namespace limn
