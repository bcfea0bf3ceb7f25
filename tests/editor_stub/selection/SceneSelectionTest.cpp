#include "selection/SceneSelection.h"
#include "Mentions.h"
#include "SceneFolder.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <limn/features/SelectionOutlineRendererFeature.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = SelectionStep::Kind;

/// 100 x 100 pixels, a metre each, (0, 0) in the middle.
constexpr const char* k_Camera =
    "size: [100, 100]\n"
    "camera: {orthographic: true, orthographicSize: 50, position: [0, 0, -100]}\n"
    "layers: {6: Wall}\n"
    "renderingLayers: {8: Selected, 9: Hovered}\n";
constexpr const char* k_Features = "renderer:\n"
                                   "  features:\n"
                                   "    - type: ScreenSpaceOutlineRenderFeature\n"
                                   "      m_LayerMask: [Default]\n"
                                   "      m_RenderingLayerMask: Selected\n";
constexpr const char* k_Objects =
    "materials:\n"
    "  glow: {renderQueue: 3000}\n"
    "objects:\n"
    "  - name: Sofa\n"
    "    renderingLayerMask: [Default, Selected]\n"
    "    children:\n"
    "      - {name: Seat, mesh: cube, scale: 10}\n"
    "      - {name: Back, mesh: cube, scale: 10, position: [0, 10, 0]}\n"
    "  - {name: Floor Lamp, mesh: cube, scale: 10, position: [30, 0, 0]}\n"
    "  - {name: Glow, mesh: cube, scale: 10, position: [30, 0, -20], material: glow}\n"
    "  - {name: Desk Lamp, mesh: cube, scale: 10, position: [-30, 0, 0]}\n"
    "  - {name: 'A, B', mesh: cube, scale: 10, position: [0, -30, 0]}\n"
    "  - {name: Twin, mesh: cube, scale: 10, position: [-30, -30, 0]}\n"
    "  - {name: Twin, mesh: cube, scale: 10, position: [30, -30, 0]}\n"
    "  - {name: Tiles, mesh: cube, scale: 10, position: [0, 40, 0], layer: Wall}\n"
    "  - {name: Turning, mesh: cube, scale: [40, 2, 2], position: [-30, 30, 0],\n"
    "     turn: [0, 0, 90]}\n";

class SceneSelection : public testing::Test
{
protected:
    std::vector<std::string> Select(const std::vector<SelectionStep>& steps)
    {
        ApplySelection(asset, steps);
        std::vector<std::string> names;
        for (const Selected& one : asset.selected)
        {
            names.push_back(one.object->name);
        }
        return names;
    }

    std::vector<std::string> ProblemsOf(const std::vector<SelectionStep>& steps)
    {
        return Problems([&] { ApplySelection(asset, steps); });
    }

    bool IsMarked(const std::string& name)
    {
        return asset.scene.Find(name)->renderer->renderingLayerMask.Intersects(
            RenderingLayerMask::FromIndex(8));
    }

    SceneFolder folder;
    SceneAsset asset = folder.Load(std::string(k_Camera) + k_Features + k_Objects);
};

} // namespace

TEST_F(SceneSelection, TakesNamesInTheirOrder)
{
    EXPECT_THAT(Select({{Kind::Select, "Floor Lamp,Sofa"}}), ElementsAre("Floor Lamp", "Sofa"));
    EXPECT_TRUE(IsMarked("Seat"));
    EXPECT_TRUE(IsMarked("Floor Lamp"));
    EXPECT_FALSE(IsMarked("Desk Lamp"));
    EXPECT_THAT(Select({{Kind::Select, " Desk Lamp , Seat "}}), ElementsAre("Desk Lamp", "Seat"));
    EXPECT_FALSE(IsMarked("Back"));
    EXPECT_THAT(Select({{Kind::Select, "Twin"}}), ElementsAre("Twin", "Twin"));
    EXPECT_THAT(Select({{Kind::Select, "A, B"}}), ElementsAre("A, B"));
}

TEST_F(SceneSelection, OfNoNameIsEmpty)
{
    EXPECT_TRUE(IsMarked("Seat"));
    EXPECT_THAT(Select({{Kind::Select, ""}}), IsEmpty());
    EXPECT_FALSE(IsMarked("Seat"));
}

TEST_F(SceneSelection, WithoutStepsStaysTheScenes)
{
    EXPECT_THAT(Select({}), IsEmpty());
    EXPECT_TRUE(IsMarked("Seat"));
}

TEST_F(SceneSelection, DoesItsStepsInOrder)
{
    // The sofa is what the scene itself selects.
    EXPECT_THAT(Select({{Kind::CtrlClick, "80,50"}}), ElementsAre("Sofa", "Floor Lamp"));
    EXPECT_THAT(Select({{Kind::Click, "20,50"}, {Kind::CtrlClick, "50,40"}}),
                ElementsAre("Desk Lamp", "Sofa"));
    EXPECT_THAT(
        Select({{Kind::Click, "20,50"}, {Kind::Select, "Twin"}, {Kind::CtrlClick, "20,80"}}),
        ElementsAre("Twin"));
    EXPECT_THAT(Select({{Kind::Click, "0,0"}}), IsEmpty());
}

TEST_F(SceneSelection, ClicksThroughQueuesThatNoFeatureOutlines)
{
    EXPECT_THAT(Select({{Kind::Click, "80,50"}}), ElementsAre("Floor Lamp"));
}

TEST_F(SceneSelection, ClicksAtTheirTime)
{
    // A bar that lies down at 0 s and stands at 1 s.
    EXPECT_THAT(Select({{Kind::Click, "35,20"}}), ElementsAre("Turning"));
    EXPECT_THAT(Select({{Kind::Click, "35,20@1"}}), IsEmpty());
    EXPECT_THAT(Select({{Kind::Click, "20,50"}, {Kind::CtrlClick, "20,35@1"}}),
                ElementsAre("Desk Lamp", "Turning"));
    EXPECT_EQ(0.0, asset.selected[0].time);
    EXPECT_EQ(1.0, asset.selected[1].time);
}

TEST_F(SceneSelection, SaysWhyAClickSelectsNothing)
{
    Select({{Kind::Click, "0,0"}, {Kind::CtrlClick, "50,10"}});
    ASSERT_EQ(2u, asset.notes.size());
    EXPECT_THAT(ToString(asset.notes[0]),
                Mentions("--click 0,0:", "note", "no object", "nothing is selected"));
    EXPECT_THAT(ToString(asset.notes[1]), Mentions("--ctrl-click 50,10:", "note", "'Tiles'", "Wall",
                                                   "layer mask", "nothing is selected"));
}

TEST_F(SceneSelection, NamesWhatAnUnknownNameMayMean)
{
    EXPECT_THAT(ProblemsOf({{Kind::Select, "Sfoa"}}),
                ElementsAre(HasSubstr("unknown object 'Sfoa'; did you mean 'Sofa'?")));
    EXPECT_THAT(ProblemsOf({{Kind::Select, "Sofa,lamp,Bakc"}}),
                ElementsAre(HasSubstr("unknown object 'lamp' (known: Floor Lamp, Desk Lamp)"),
                            HasSubstr("unknown object 'Bakc'; did you mean 'Back'?")));
    EXPECT_THAT(ProblemsOf({{Kind::Select, "Wardrobe"}}),
                ElementsAre(HasSubstr("'Wardrobe' (known: Sofa, Floor Lamp, Glow, Desk Lamp, ")));
    EXPECT_THAT(ProblemsOf({{Kind::Select, "Sofa,"}}), ElementsAre(HasSubstr("unknown object ''")));
    EXPECT_TRUE(IsMarked("Seat")) << "nothing is selected if a name is wrong";
}

TEST_F(SceneSelection, RefusesPixelsOutsideOfThePicture)
{
    for (const char* click : {"100,0", "0,100", "-1,5", "5,-1"})
    {
        EXPECT_THAT(ProblemsOf({{Kind::Click, click}}),
                    ElementsAre(Mentions("outside", "100x100", "99,99")));
    }
}

TEST_F(SceneSelection, NeedsAFeatureThatShowsIt)
{
    const auto problem = Mentions("no feature", "rendering layer");
    asset = folder.Load(std::string(k_Camera) + k_Objects);
    EXPECT_THAT(ProblemsOf({{Kind::Select, ""}}), ElementsAre(problem));
    asset = folder.Load(std::string(k_Camera) +
                        "renderer: {features: [{type: ScreenSpaceOutlineRenderFeature}]}\n" +
                        k_Objects);
    EXPECT_THAT(ProblemsOf({{Kind::Click, "1,1"}}), ElementsAre(problem));
}

TEST_F(SceneSelection, ReachesEveryFeature)
{
    asset = folder.Load(std::string(k_Camera) + k_Features +
                        "    - type: ScreenSpaceOutlineRenderFeature\n"
                        "      m_LayerMask: [Wall]\n"
                        "      m_RenderQueueRange: All\n"
                        "      m_RenderingLayerMask: Hovered\n" +
                        k_Objects);
    EXPECT_THAT(Select({{Kind::Click, "50,10"}, {Kind::CtrlClick, "80,50"}}),
                ElementsAre("Tiles", "Glow"));
    EXPECT_EQ(RenderingLayerMask(0x301u), asset.scene.Find("Glow")->renderer->renderingLayerMask);
}

TEST(ClickText, IsAPixelAndATime)
{
    const auto click = ParseClick("12,34@1.5");
    ASSERT_TRUE(click);
    EXPECT_EQ(12, click->x);
    EXPECT_EQ(34, click->y);
    EXPECT_EQ(1.5, click->time);
    EXPECT_EQ(0.0, ParseClick("12,34")->time);
    for (const char* text : {"", "12", "12,", ",34", "1 2,34", "12,34@", "12,34@x", "12@3,4",
                             "12,34,5", "1.5,2", "12,34@nan", "99999999999,0"})
    {
        EXPECT_FALSE(ParseClick(text)) << text;
    }
}

TEST(SelectionOptions, ThatAreNoClickAreRefused)
{
    const CommandRun run = RunCommand({"render", "s", "-o", "o", "--click", "12"});
    EXPECT_EQ(2, run.exitCode);
    EXPECT_THAT(run.err, Mentions("--click:", "'12'", "no pixel", "X,Y"));
}

TEST(SceneSelectionTimes, ReachTheFeatureThatColoursByThem)
{
    SceneFolder folder;
    SceneAsset asset = folder.Load(std::string(k_Camera) +
                                   "renderer:\n"
                                   "  features:\n"
                                   "    - type: SelectionOutlineRendererFeature\n"
                                   "      m_RenderingLayerMask: Selected\n" +
                                   k_Objects);
    ApplySelection(asset, std::vector<SelectionStep>{{Kind::Select, "Desk Lamp"},
                                                     {Kind::CtrlClick, "80,50@2.5"}});
    const auto& feature =
        dynamic_cast<SelectionOutlineRendererFeature&>(*asset.renderer.features.at(0));
    const auto& times = *feature.settings().startTimes;
    EXPECT_EQ(times.size(), 2u);
    EXPECT_EQ(times.at(&asset.scene.Find("Desk Lamp")->transform), 0.0);
    EXPECT_EQ(times.at(&asset.scene.Find("Glow")->transform), 2.5);
}

} // namespace limn::test
