#include "selection/SelectionScene.h"

#include <gmock/gmock.h>
#include <limn/editor_stub/SelectController.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

constexpr RenderingLayerMask k_Marked(1u << 8);

std::vector<std::string> Names(const std::vector<Selected>& selected)
{
    std::vector<std::string> names;
    for (const Selected& one : selected)
    {
        names.push_back(one.object->name);
    }
    return names;
}

/// 100 x 100 pixels, a metre each, seen straight on: the object at pixel (x, y) has its middle at
/// (x, 100 - y).
struct Desk : SelectionScene
{
    Desk()
    {
        camera.orthographic = true;
        camera.orthographicSize = 50.0f;
        camera.transform.localPosition = {50.0f, 50.0f, -10.0f};
        camera.farClipPlane = 100.0f;
        AddBox("A", 20, 20);
        AddBox("B", 50, 20);
        AddBox("C", 80, 20);
        AddBox("Hidden", 20, 20, 5.0f, 4.0f);
        AddBox("Corner", 95, 95);
        AddBox("Inactive", 20, 50).activeSelf = false;
        AddBox("Disabled", 50, 50).renderer->enabled = false;
        AddBox("Culled", 80, 50).layer = 5;
        camera.cullingMask = ~LayerMask::FromIndex(5);
        AddBox("Ground", 20, 80).layer = 6;
        AddBox("Under the ground", 20, 80, 5.0f, 4.0f);
        AddBox("Beyond the far plane", 50, 80, 96.0f);
        AddBox("Behind the camera", 80, 80, -20.0f);
        GameObject& sofa = Add("Sofa", nullptr, {0.0f, 0.0f, 0.0f});
        AddBox("Seat", 50, 65).transform.parent = &sofa.transform;
        GameObject& back = AddBox("Back", 60, 65);
        back.transform.parent = &sofa.transform;
        GameObject& pillow = AddBox("Pillow", 60, 65, 0.0f, 4.0f);
        pillow.transform.parent = &back.transform;
        pillow.transform.localPosition = {0.0f, 0.0f, -0.5f};
        pillow.transform.localScale = glm::vec3(0.4f);
    }

    /// A box of 10 x 10 pixels with its middle at this corner of pixels.
    GameObject& AddBox(const std::string& name, int x, int y, float z = 0.0f, float size = 10.0f)
    {
        return AddCube(name, {static_cast<float>(x), static_cast<float>(100 - y), z},
                       glm::vec3(size));
    }

    static SelectSettings Settings(SelectUnit unit = SelectUnit::Whole)
    {
        SelectSettings settings;
        settings.renderingLayers = k_Marked;
        settings.unit = unit;
        settings.selectableLayers = ~LayerMask::FromIndex(6);
        return settings;
    }

    /// The names of the objects whose renderers are marked.
    std::vector<std::string> Marked() const
    {
        std::vector<std::string> names;
        for (const auto& object : scene.objects())
        {
            if (object->renderer && object->renderer->renderingLayerMask.Intersects(k_Marked))
            {
                names.push_back(object->name);
            }
        }
        return names;
    }
};

struct Click
{
    int x = 0;
    int y = 0;
    bool isCtrl = false;
};

constexpr bool k_Ctrl = true;

struct Sequence
{
    const char* name;
    std::vector<Click> clicks;
    std::vector<std::string> selected;
    SelectUnit unit = SelectUnit::Whole;
};

void PrintTo(const Sequence& sequence, std::ostream* stream)
{
    *stream << sequence.name;
}

const Sequence k_Sequences[] = {
    {"No click", {}, {}},
    {"One", {{20, 20}}, {"A"}},
    {"One, then another", {{20, 20}, {50, 20}}, {"B"}},
    {"The same again", {{20, 20}, {20, 20}}, {"A"}},
    {"One, then nothing", {{20, 20}, {35, 20}}, {}},
    {"Nothing", {{35, 20}}, {}},
    {"Ctrl on one", {{20, 20, k_Ctrl}}, {"A"}},
    {"Ctrl adds", {{80, 20}, {20, 20, k_Ctrl}, {50, 20, k_Ctrl}}, {"C", "A", "B"}},
    {"Ctrl takes away", {{20, 20}, {50, 20, k_Ctrl}, {20, 20, k_Ctrl}}, {"B"}},
    {"Ctrl takes the last away", {{20, 20}, {20, 20, k_Ctrl}}, {}},
    {"Ctrl adds again, at the end",
     {{20, 20}, {50, 20, k_Ctrl}, {20, 20, k_Ctrl}, {20, 20, k_Ctrl}},
     {"B", "A"}},
    {"Ctrl on nothing clears too", {{20, 20}, {50, 20, k_Ctrl}, {35, 20, k_Ctrl}}, {}},
    {"One of several", {{20, 20}, {50, 20, k_Ctrl}, {80, 20, k_Ctrl}, {50, 20}}, {"B"}},
    {"What hides another", {{20, 20}}, {"A"}},
    {"First pixel of a box", {{15, 15}}, {"A"}},
    {"Last pixel of a box", {{24, 24}}, {"A"}},
    {"Pixel before a box", {{14, 20}}, {}},
    {"Pixel behind a box", {{25, 20}}, {}},
    {"Pixel above a box", {{20, 14}}, {}},
    {"Pixel below a box", {{20, 25}}, {}},
    {"Last pixel of the picture", {{99, 99}}, {"Corner"}},
    {"First pixel of the picture", {{0, 0}}, {}},
    {"Inactive", {{20, 50}}, {}},
    {"Disabled", {{50, 50}}, {}},
    {"Outside of the culling mask", {{80, 50}}, {}},
    {"Beyond the far plane", {{50, 80}}, {}},
    {"Behind the camera", {{80, 80}}, {}},
    {"A layer that cannot be selected hides", {{20, 80}}, {}},
    {"Such a layer clears", {{50, 20}, {20, 80, k_Ctrl}}, {}},
    {"A part selects its whole", {{50, 65}}, {"Sofa"}},
    {"A part of a part as well", {{60, 65}}, {"Sofa"}},
    {"Ctrl on another part takes the whole away", {{50, 65}, {60, 65, k_Ctrl}}, {}},
    {"A part by itself", {{50, 65}}, {"Seat"}, SelectUnit::Part},
    {"Two parts", {{50, 65}, {60, 65, k_Ctrl}}, {"Seat", "Pillow"}, SelectUnit::Part},
};

class ClickSequences : public testing::TestWithParam<Sequence>
{
};

} // namespace

TEST_P(ClickSequences, SelectWhatTheySay)
{
    Desk desk;
    SelectController controller(desk.scene, Desk::Settings(GetParam().unit));
    for (const Click& click : GetParam().clicks)
    {
        GameObject* hit = controller.GetHitObj(desk.camera, 100, 100, click.x, click.y);
        controller.Click(hit, click.isCtrl, 0.0);
    }
    EXPECT_EQ(GetParam().selected, Names(controller.selected()));
}

INSTANTIATE_TEST_SUITE_P(SelectController, ClickSequences, testing::ValuesIn(k_Sequences));

TEST(SelectController, MarksTheSelectedWithAllBelowAndNoOther)
{
    Desk desk;
    SelectController controller(desk.scene, Desk::Settings());
    EXPECT_THAT(desk.Marked(), IsEmpty());
    controller.Click(desk.scene.Find("Sofa"), false, 0.0);
    EXPECT_THAT(desk.Marked(), ElementsAre("Seat", "Back", "Pillow"));
    controller.Click(desk.scene.Find("B"), true, 0.0);
    EXPECT_THAT(desk.Marked(), ElementsAre("B", "Seat", "Back", "Pillow"));
    controller.Click(desk.scene.Find("Pillow"), true, 0.0);
    controller.Click(desk.scene.Find("Sofa"), true, 0.0);
    EXPECT_THAT(desk.Marked(), ElementsAre("B", "Pillow"));
    controller.Click(nullptr, false, 0.0);
    EXPECT_THAT(desk.Marked(), IsEmpty());
}

TEST(SelectController, LeavesOtherRenderingLayersAlone)
{
    Desk desk;
    RenderingLayerMask& mask = desk.scene.Find("A")->renderer->renderingLayerMask;
    mask = RenderingLayerMask(0b101u);
    SelectController controller(desk.scene, Desk::Settings());
    controller.Click(desk.scene.Find("A"), false, 0.0);
    EXPECT_EQ(RenderingLayerMask(0b101u) | k_Marked, mask);
    controller.Click(nullptr, false, 0.0);
    EXPECT_EQ(RenderingLayerMask(0b101u), mask);
}

TEST(SelectController, BeginsWithWhatTheSceneMarks)
{
    Desk desk;
    for (const char* name : {"B", "Seat", "Back", "Pillow"})
    {
        desk.scene.Find(name)->renderer->renderingLayerMask = k_Marked;
    }
    SelectController controller(desk.scene, Desk::Settings());
    EXPECT_THAT(Names(controller.selected()), ElementsAre("B", "Sofa"));
    controller.Click(desk.scene.Find("A"), true, 3.0);
    EXPECT_THAT(Names(controller.selected()), ElementsAre("B", "Sofa", "A"));
    EXPECT_EQ(0.0, controller.selected()[1].time);
}

TEST(SelectController, BeginsWithThePartsOfWholesThatTheSceneMarks)
{
    Desk desk;
    desk.scene.Find("Back")->renderer->renderingLayerMask = k_Marked;
    desk.scene.Find("Pillow")->renderer->renderingLayerMask = k_Marked;
    const Transform room; // of no object
    desk.scene.Find("Sofa")->transform.parent = &room;
    desk.scene.Find("C")->renderer->renderingLayerMask = k_Marked;
    desk.scene.Find("C")->transform.parent = &room;
    SelectController controller(desk.scene, Desk::Settings());
    EXPECT_THAT(Names(controller.selected()), ElementsAre("C", "Back"));
}

// The article enables and disables a component; the time is taken where it is enabled.
TEST(SelectController, RemembersSinceWhenAnObjectIsSelected)
{
    Desk desk;
    GameObject* const a = desk.scene.Find("A");
    GameObject* const b = desk.scene.Find("B");
    SelectController controller(desk.scene, Desk::Settings());
    controller.Click(a, false, 1.0);
    controller.Click(b, true, 2.5);
    EXPECT_THAT(controller.selected(), ElementsAre(Selected{a, 1.0}, Selected{b, 2.5}));
    controller.Click(a, false, 4.0); // was selected all the time
    EXPECT_THAT(controller.selected(), ElementsAre(Selected{a, 1.0}));
    controller.Click(b, true, 5.0); // was not
    controller.Click(a, true, 6.0);
    controller.Click(a, true, 7.0);
    EXPECT_THAT(controller.selected(), ElementsAre(Selected{b, 5.0}, Selected{a, 7.0}));
}

TEST(SelectController, SelectsAListEachOnce)
{
    Desk desk;
    GameObject* const a = desk.scene.Find("A");
    GameObject* const b = desk.scene.Find("B");
    SelectController controller(desk.scene, Desk::Settings());
    controller.Click(b, false, 1.0);
    controller.Select(std::vector{a, b, a}, 2.0);
    EXPECT_THAT(controller.selected(), ElementsAre(Selected{a, 2.0}, Selected{b, 1.0}));
    EXPECT_THAT(desk.Marked(), ElementsAre("A", "B"));
    controller.Select({}, 3.0);
    EXPECT_THAT(controller.selected(), IsEmpty());
    EXPECT_THAT(desk.Marked(), IsEmpty());
}

TEST(SelectController, RefusesPixelsOutsideOfThePicture)
{
    Desk desk;
    SelectController controller(desk.scene, Desk::Settings());
    EXPECT_THROW(controller.GetHitObj(desk.camera, 100, 100, 100, 5), ContractError);
}

} // namespace limn::test
