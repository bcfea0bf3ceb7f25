#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <volume/blending/VolumeScene.h>

namespace limn
{

namespace
{

constexpr float k_Edge = 1e-6f; ///< metres over which a volume fades
constexpr float k_Size = 1e4f;  ///< metres

/// A box 10 km long whose face stands at x = `face`, everything inside of it at x below; it sets
/// TestVolume.param from 3 to 7.
class StiffBlend : public testing::Test
{
protected:
    StiffBlend()
    {
        m_Base.priority = -1.0f;
        m_Scene.manager.Register(&m_Base);
        m_Box = MakeBox(7.0f);
        m_Scene.manager.Register(&m_Box);
        PutFaceAt(1.0f);
    }

    static Volume MakeBox(float value)
    {
        Volume box = test::GlobalVolume(test::ParamProfile(value));
        box.isGlobal = false;
        box.blendDistance = k_Edge;
        box.colliders = {BoxCollider{true, {}, glm::vec3(k_Size)}};
        return box;
    }

    void PutFaceAt(float face) { m_Box.position = {face - k_Size / 2.0f, 0.0f, 0.0f}; }

    float ParamAt(const glm::vec3& camera)
    {
        m_Scene.Update(camera);
        return m_Scene.Param();
    }
    float ParamAt(float x) { return ParamAt({x, 0.0f, 0.0f}); }

    test::VolumeScene m_Scene;
    Volume m_Base = test::GlobalVolume(test::ParamProfile(3.0f));
    Volume m_Box;
};

TEST_F(StiffBlend, FadesOverAMicrometreBesideTenKilometres)
{
    // Beside 1 m a float moves by 0.12 micrometres, beside 5 km by half a millimetre: distances
    // worked out from the box's middle in floats would be all or nothing.
    float x = 1.0f;
    float before = 7.0f;
    for (int step = 0; step < 12; ++step, x = std::nextafter(x, 2.0f))
    {
        const double distance = static_cast<double>(x) - 1.0;
        const double share = distance / static_cast<double>(k_Edge);
        const double expected = 3.0 + 4.0 * std::max(1.0 - share * share, 0.0);
        const float blended = ParamAt(x);
        EXPECT_NEAR(expected, static_cast<double>(blended), 1e-6) << step << " floats outside";
        EXPECT_LE(blended, before);
        before = blended;
    }
    EXPECT_EQ(3.0f, before);
    EXPECT_EQ(7.0f, ParamAt(std::nextafter(1.0f, 0.0f)));
}

TEST_F(StiffBlend, IsAllOrNothingWhereAFloatIsCoarserThanTheEdge)
{
    PutFaceAt(k_Size);
    const float beside = std::nextafter(k_Size, 2.0f * k_Size); // a millimetre further
    EXPECT_EQ(7.0f, ParamAt(k_Size));
    EXPECT_EQ(3.0f, ParamAt(beside));
    m_Box.blendDistance = 2.0f * (beside - k_Size);
    EXPECT_EQ(6.0f, ParamAt(beside)); // half way: a quarter less
}

TEST_F(StiffBlend, CrossedInOneFrameOvershootsNothingAndEndsExactly)
{
    for (const float step : {1e-7f, 1e-3f, 1.0f, 1e4f, 1e7f}) // metres a frame
    {
        for (const float start : {-2.0f, 0.0f, 0.5f})
        {
            for (int frame = 0; frame <= 32; ++frame)
            {
                const float x = 1.0f + (start + static_cast<float>(frame) / 8.0f) * step;
                const double outside =
                    std::max(static_cast<double>(x) - 1.0, 1.0 - static_cast<double>(k_Size + x));
                const float blended = ParamAt(x);
                EXPECT_TRUE(blended >= 3.0f && blended <= 7.0f) << blended << " at " << x;
                EXPECT_EQ(outside <= 0.0, blended == 7.0f) << blended << " at " << x;
                EXPECT_EQ(outside >= static_cast<double>(k_Edge), blended == 3.0f)
                    << blended << " at " << x;
            }
            EXPECT_EQ(7.0f, ParamAt(1.0f)) << "back inside";
        }
    }
}

TEST_F(StiffBlend, OfWideAndNarrowEdgesStaysBetweenTheirValues)
{
    Volume wide = MakeBox(100.0f);
    wide.blendDistance = k_Size;
    wide.weight = 0.5f;
    wide.priority = -0.5f; // below the narrow one
    m_Scene.manager.Register(&wide);
    EXPECT_EQ(7.0f, ParamAt(1.0f)) << "the narrow one wins inside";
    float before = 0.0f;
    for (int i = 0; i < 40; ++i) // right behind the narrow edge the wide one is at nearly half
    {
        const float x = 1.0f + static_cast<float>(i) * 1.2e-7f;
        const float blended = ParamAt(x);
        EXPECT_TRUE(blended >= 7.0f && blended <= 51.5f) << blended << " at " << x;
        EXPECT_GE(blended, before) << x;
        before = blended;
    }
    EXPECT_NEAR(51.5f, before, 0.01f);
    m_Scene.manager.Unregister(&wide);
}

TEST_F(StiffBlend, OfATurnedBoxIsAsExact)
{
    // Turned by 30 degrees about y, the face's middle is where the turned axis leaves the box.
    m_Box.rotation = glm::angleAxis(glm::radians(30.0f), glm::vec3(0, 1, 0));
    const glm::dquat turn = glm::normalize(glm::dquat(m_Box.rotation));
    const glm::dvec3 outwards = turn * glm::dvec3(1.0, 0.0, 0.0);
    m_Box.position = -glm::vec3(outwards * (k_Size / 2.0));
    const double offset = glm::dot(glm::dvec3(m_Box.position), outwards) + k_Size / 2.0;
    int between = 0;
    for (int i = -50; i <= 50; ++i) // the camera is near 0, where floats are fine enough
    {
        const glm::vec3 camera(outwards * (offset + i * 5e-8));
        const double distance = glm::dot(glm::dvec3(camera), outwards) - offset;
        const double share = std::max(distance, 0.0) / static_cast<double>(k_Edge);
        const float blended = ParamAt(camera);
        EXPECT_NEAR(3.0 + 4.0 * std::max(1.0 - share * share, 0.0), static_cast<double>(blended),
                    1e-5)
            << i;
        between += blended > 3.0f && blended < 7.0f ? 1 : 0;
    }
    EXPECT_GT(between, 10);
}

TEST_F(StiffBlend, TakesEdgesAndWeightsOfTheLeastFloats)
{
    const float least = std::numeric_limits<float>::denorm_min();
    m_Box.blendDistance = least;
    EXPECT_EQ(7.0f, ParamAt(1.0f));
    EXPECT_EQ(3.0f, ParamAt(std::nextafter(1.0f, 2.0f)));
    m_Box.weight = least; // 4 times that is lost beside 3
    EXPECT_EQ(3.0f, ParamAt(1.0f));
    m_Base.sharedProfile = test::ParamProfile(0.0f);
    EXPECT_EQ(7.0f * least, ParamAt(1.0f));
    m_Box.weight = std::nextafter(1.0f, 0.0f);
    EXPECT_LT(ParamAt(1.0f), 7.0f);
    m_Box.weight = std::nextafter(1.0f, 2.0f);
    EXPECT_EQ(7.0f, ParamAt(1.0f));
}

} // namespace

} // namespace limn
