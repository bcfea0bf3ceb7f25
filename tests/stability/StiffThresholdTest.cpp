#include "Mentions.h"

#include <cmath>
#include <core/scene/TestScene.h>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/Judge.h>
#include <limn/features/OutlineComponent.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <volume/blending/VolumeScene.h>

namespace limn
{

namespace
{

constexpr float k_LeastFloat = std::numeric_limits<float>::denorm_min();

class PlainOutline : public OutlineComponent
{
};

/// Why an outline of this width and alpha is not drawn.
std::string WhyNot(float width, float alpha)
{
    PlainOutline outline;
    outline.m_Enable.Override(true);
    outline.m_OutlineWidth.Override(width);
    outline.m_OutlineColor.Override({1.0f, 1.0f, 1.0f, alpha});
    return WhyInactive(&outline, "Outline");
}

TEST(StiffThreshold, OfWidthAndAlphaIsZeroItself)
{
    for (const float size : {k_LeastFloat, std::numeric_limits<float>::min(), 1e-30f, 3.0f, 1e4f})
    {
        EXPECT_EQ("", WhyNot(size, 1.0f)) << size;
        EXPECT_EQ("", WhyNot(3.0f, size)) << size;
    }
    for (const float none : {0.0f, -0.0f, -k_LeastFloat, -1.0f})
    {
        EXPECT_EQ("Outline.m_OutlineWidth is 0", WhyNot(none, 1.0f)) << none;
        EXPECT_EQ("Outline.m_OutlineColor has alpha 0", WhyNot(3.0f, none)) << none;
    }
}

TEST(StiffThreshold, OfAVolumesWeightIsZeroItself)
{
    VolumeComponentRegistry registry;
    registry.Register<PlainOutline>("PlainOutline");
    VolumeManager manager(registry);
    VolumeStack stack = manager.CreateStack();
    auto off = std::make_shared<VolumeProfile>();
    off->Add<PlainOutline>().m_OutlineWidth.Override(0.0f);
    auto on = std::make_shared<VolumeProfile>();
    on->Add<PlainOutline>().m_Enable.Override(true);
    on->TryGet<PlainOutline>()->m_OutlineWidth.Override(3.0f);
    const Volume base = test::GlobalVolume(off, -1.0f);
    Volume volume = test::GlobalVolume(on);
    manager.Register(&base);
    manager.Register(&volume);
    const auto why = [&](float weight)
    {
        volume.weight = weight;
        manager.Update(stack, glm::vec3(0.0f), test::k_DefaultLayer);
        return WhyInactive(stack.GetComponent<PlainOutline>(), "Outline");
    };
    EXPECT_EQ("", why(k_LeastFloat)) << "a width of three times that";
    EXPECT_EQ("", why(1.0f));
    EXPECT_THAT(why(0.0f), test::Mentions("no volume", "Outline.m_Enable", "default"));
}

TEST(StiffThreshold, OfALimitIsTheLimitItself)
{
    ScreenSpaceOutline outline; // widths from 1 to 10
    const auto set = [&outline](float width)
    {
        outline.m_OutlineWidth.SetValue(width);
        return outline.m_OutlineWidth.value();
    };
    EXPECT_EQ(1.0f, set(std::nextafter(1.0f, 0.0f)));
    EXPECT_EQ(std::nextafter(1.0f, 2.0f), set(std::nextafter(1.0f, 2.0f)));
    EXPECT_EQ(10.0f, set(std::nextafter(10.0f, 11.0f)));
    EXPECT_EQ(std::nextafter(10.0f, 9.0f), set(std::nextafter(10.0f, 9.0f)));
    EXPECT_EQ(1.0f, set(-k_LeastFloat));
}

TEST(StiffThreshold, OfQueueRangesIsOneQueue)
{
    const auto shader = test::ShaderWithModes({"A"});
    DrawingSettings drawing;
    drawing.shaderTagIds = {ShaderTagId("A")};
    for (const RenderQueueRange& range :
         {RenderQueueRange::all, RenderQueueRange::opaque, RenderQueueRange::transparent,
          RenderQueueRange(2450, 2450), RenderQueueRange(0, 0), RenderQueueRange(5000, 5000)})
    {
        for (const int end : {range.lowerBound(), range.upperBound()})
        {
            for (const int queue : {end - 1, end, end + 1})
            {
                const FilterItem item{queue, 0, RenderingLayerMask(1), shader.get()};
                const bool isIn = queue >= range.lowerBound() && queue <= range.upperBound();
                EXPECT_EQ(isIn ? FilterVerdict::Drawn : FilterVerdict::QueueOutOfRange,
                          Judge(item, FilteringSettings(range), drawing))
                    << queue;
            }
        }
    }
}

/// Whether a camera at the origin keeps a cube that ends at z along its view.
class StiffCulling : public testing::Test
{
protected:
    bool Sees(float center, float size)
    {
        Scene scene;
        GameObject& cube = test::AddCube(scene, "cube", {0, 0, center}, {m_Material});
        cube.transform.localScale = glm::vec3(size);
        return !Cull(scene, m_Camera, 1.0f).items.empty();
    }

    const std::shared_ptr<const Material> m_Material =
        std::make_shared<Material>(test::ShaderWithModes({"A"}));
    Camera m_Camera;
};

TEST_F(StiffCulling, AtTheNearPlaneIsRightButForFourFloats)
{
    for (const float near : {1e-3f, 0.3f, 1.0f, 100.0f})
    {
        for (const float ratio : {1e2f, 1e5f, 1e9f})
        {
            m_Camera.nearClipPlane = near;
            m_Camera.farClipPlane = near * ratio;
            bool wasSeen = false;
            for (int ulp = -12; ulp <= 12; ++ulp)
            {
                // A cube of twice the middle's distance to the camera's end: it ends at `end`, and
                // the middle and half its size are exact.
                const float end = near * (1.0f + static_cast<float>(ulp) * 0x1p-23f);
                const bool isSeen = Sees(end / 2.0f, end);
                EXPECT_TRUE(ulp > -5 || !isSeen) << near << " x " << ratio << ", " << ulp;
                EXPECT_TRUE(ulp < 5 || isSeen) << near << " x " << ratio << ", " << ulp;
                EXPECT_TRUE(isSeen || !wasSeen) << "seen, then not: " << ulp;
                wasSeen = isSeen;
            }
        }
    }
}

TEST_F(StiffCulling, AtTheFarPlaneIsRightButForRounding)
{
    for (const float far : {10.0f, 1e4f, 1e8f})
    {
        m_Camera.nearClipPlane = 1.0f;
        m_Camera.farClipPlane = far;
        for (const int ulp : {-16, -12, -8, 8, 12, 16})
        {
            const float begin = far * (1.0f + static_cast<float>(ulp) * 0x1p-23f);
            EXPECT_EQ(ulp < 0, Sees(begin + 0.5f * begin, begin)) << far << ", " << ulp;
        }
    }
}

} // namespace

} // namespace limn
