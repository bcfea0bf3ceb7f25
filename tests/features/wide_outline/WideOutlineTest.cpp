#include "features/wide_outline/WideOutlineScene.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <limn/core/RecordingDevice.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A disc of 20 pixels in the middle of a large picture, on a device that only remembers.
class WideOutlineFrame : public testing::Test
{
protected:
    std::unique_ptr<WideOutlineScene> Make(const WideOutlineSettings& settings = {})
    {
        auto scene = std::make_unique<WideOutlineScene>(m_Device, 1920, 1080, settings);
        scene->Add(DiscTriangles({960.0, 540.0}, 20.0));
        return scene;
    }

    /// "name WxH" of what each pass of the outline draws into.
    static std::vector<std::string> Targets(const RenderResult& result)
    {
        std::vector<std::string> targets;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            const std::string& name = pass.colors.front().texture->name();
            if (name.starts_with("_WideOutline"))
            {
                targets.push_back(name.substr(12) + " " + std::to_string(pass.width) + "x" +
                                  std::to_string(pass.height));
            }
        }
        return targets;
    }

    static std::string Notes(const RenderResult& result)
    {
        std::string notes;
        for (const std::string& note : result.report.notes)
        {
            notes += note + "\n";
        }
        return notes;
    }

    RecordingDevice m_Device;
};

TEST_F(WideOutlineFrame, TakesTwoPassesForANarrowLineInTexturesAsLargeAsTheLine)
{
    const auto scene = Make();
    scene->Set({7.0});
    const RenderResult result = scene->Render();
    // 40 pixels of disc, 8 on either side.
    EXPECT_THAT(Targets(result), ElementsAre("Mask 64x64", "Seeds 64x64", "Columns 64x64"));
    EXPECT_EQ(scene->feature->pass()->method(), WideOutlineMethod::Separable);
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(WideOutlineFrame, FloodsForAWideOneWithAPassForEachDoubling)
{
    const auto scene = Make();
    scene->Set({100.0});
    const RenderResult result = scene->Render();
    // 1, then 64, 32, ... 1: 127 pixels reach over 101.
    EXPECT_THAT(Targets(result),
                ElementsAre("Mask 256x256", "Seeds 256x256", "FloodA 256x256", "FloodB 256x256",
                            "FloodA 256x256", "FloodB 256x256", "FloodA 256x256", "FloodB 256x256",
                            "FloodA 256x256", "FloodB 256x256"));
    EXPECT_EQ(scene->feature->pass()->method(), WideOutlineMethod::JumpFlood);
}

TEST_F(WideOutlineFrame, CostsNothingWhereNothingIsSeenOfIt)
{
    const auto scene = Make();
    const auto expectNothing = [&](const char* reason)
    {
        const RenderResult result = scene->Render();
        EXPECT_THAT(Targets(result), IsEmpty()) << reason;
        EXPECT_THAT(Notes(result), HasSubstr(reason));
    };
    scene->Set({0.0});
    expectNothing("m_OutlineWidth is 0");
    scene->Set({8.0});
    scene->outline->m_OutlineColor.Override(Color::clear);
    expectNothing("m_OutlineColor has alpha 0");
    scene->outline->m_OutlineColor.Override(Color::white);
    EXPECT_THAT(Targets(scene->Render()), testing::Not(IsEmpty()));
    scene->scene.objects().front()->transform.localPosition.x = 1000.0f; // 20 pixels outside
    expectNothing("Wide Outline: it is not drawn");
    scene->Set({30.0});
    EXPECT_THAT(Targets(scene->Render()), testing::Not(IsEmpty()));
    scene->scene.objects().front()->layer = 5;
    scene->scene.objects().front()->activeSelf = false;
    expectNothing("Wide Outline: it is not drawn");
}

TEST_F(WideOutlineFrame, RefusesWhatIsNoNumber)
{
    const auto scene = Make();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    scene->outline->m_OutlineWidth.Override(nan);
    EXPECT_THROW(scene->Render(), ContractError);
    scene->Set({HUGE_VAL});
    EXPECT_NO_THROW(scene->Render()) << "the whole picture";
    scene->outline->m_Gap.Override(nan);
    EXPECT_THROW(scene->Render(), ContractError);
    scene->Set({3.0, OutlineSide::Outer, 1e9});
    EXPECT_NO_THROW(scene->Render());
    scene->Set({3.0});
    scene->outline->m_Falloff.Override(nan);
    EXPECT_THROW(scene->Render(), ContractError);
}

TEST_F(WideOutlineFrame, MakesItsTexturesOnce)
{
    for (const OutlineGrouping grouping : {OutlineGrouping::Together, OutlineGrouping::PerObject})
    {
        WideOutlineSettings settings;
        settings.m_Grouping = grouping;
        const auto scene = Make(settings);
        scene->Add(DiscTriangles({300.0, 500.0}, 70.0));
        scene->Set({8.0});
        const RenderResult first = scene->Render();
        const RenderResult second = scene->Render();
        ASSERT_EQ(first.frame->passes.size(), second.frame->passes.size());
        for (std::size_t i = 0; i < first.frame->passes.size(); ++i)
        {
            EXPECT_EQ(first.frame->passes[i].colors.front().texture,
                      second.frame->passes[i].colors.front().texture);
        }
    }
}

TEST(WideOutline, ReachesAsFarAsItsFarEnd)
{
    WideOutline outline;
    EXPECT_EQ(outline.reach(), 3.0f);
    outline.m_Gap.Override(2.0f);
    EXPECT_EQ(outline.reach(), 5.0f);
    outline.m_Side.Override(WideOutlineSide::Centred);
    EXPECT_EQ(outline.reach(), 3.5f);
    outline.m_Side.Override(WideOutlineSide::Inner);
    EXPECT_EQ(outline.reach(), 1.0f) << "what is smoothed";
    outline.m_OutlineWidth.Override(0.0f);
    EXPECT_EQ(outline.reach(), 0.0f);
}

} // namespace
} // namespace limn::test
