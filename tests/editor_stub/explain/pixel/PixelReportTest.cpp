#include "explain/pixel/PixelHistory.h"

#include <gtest/gtest.h>
#include <limits>

namespace limn::test
{

namespace
{

PixelHistory SampleHistory()
{
    PixelHistory history;
    history.x = 3;
    history.y = 4;
    history.width = 64;
    history.height = 48;
    history.color = {0.5f, 0.25f, 0.0f, 1.0f};
    history.written = {188, 137, 0};

    PixelEvent clear;
    clear.fate = PixelFate::Cleared;
    clear.pass = "Opaque";
    clear.colors.push_back({"_Color", 3, 4, 64, 48, {}, {0.0f, 0.0f, 0.0f, 1.0f}});
    clear.depth = PixelValue{"_Depth", 3, 4, 64, 48, {}, {0.0f}};
    history.events.push_back(clear);

    PixelEvent draw;
    draw.pass = "Opaque";
    draw.objects = {"Chair"};
    draw.mesh = "Box";
    draw.material = "oak";
    draw.shader = "Lit";
    draw.shaderPassName = "Forward";
    draw.colors.push_back(
        {"_Color", 3, 4, 64, 48, {0.0f, 0.0f, 0.0f, 1.0f}, {0.5f, 0.25f, 0.0f, 1.0f}});
    draw.depth = PixelValue{"_Depth", 3, 4, 64, 48, {0.0f}, {0.0f}};
    draw.stencil = PixelValue{"_Depth", 3, 4, 64, 48, {0.0f}, {7.0f}};
    history.events.push_back(draw);

    PixelEvent behind = draw;
    behind.fate = PixelFate::Depth;
    behind.objects = {"A", "B", "C", "D", "E"};
    behind.material = "";
    behind.shaderPass = 2;
    behind.shaderPassName = "";
    behind.reason = "it is behind the surface that is there";
    behind.colors[0].before = behind.colors[0].after;
    behind.stencil = std::nullopt;
    history.events.push_back(behind);

    PixelEvent half;
    half.pass = "Mask";
    half.shader = "Mask";
    half.isRun = false;
    half.colors.push_back({"_Mask", 1, 2, 32, 24, {}, {1.0f}});
    history.events.push_back(half);

    history.filtered = {{"Chair", "Mask", FilterVerdict::LayerMaskMiss},
                        {"Floor", "Mask", FilterVerdict::LayerMaskMiss},
                        {"Chair", "Glass", FilterVerdict::QueueOutOfRange}};
    history.absent = {{"Ghost", "inactive", true}, {"Far", "inactive", false}};
    history.uncovered = {"Table", "Lamp"};
    history.uncoveredDraws = {{"Line", "Stroke", "Composite", 1}, {"Dots", "Dot", "", 3}};
    history.elsewhere = {{"Shadow", "_Shadow", "256x256"}};
    history.notes = {"a feature lacks something", "a feature lacks something"};
    return history;
}

} // namespace

TEST(PixelReport, TellsInOrderWhatIsDoneAndWhatIsRejected)
{
    EXPECT_EQ("pixel 3,4 of 64x48 is #bc8900, linear (0.5, 0.25, 0, 1)\n"
              "done there, in this order:\n"
              "  1 Opaque clears\n"
              "    _Color (0, 0, 0, 1)\n"
              "    depth 0\n"
              "  2 Opaque draws Chair: material oak, Lit 'Forward'\n"
              "    _Color (0, 0, 0, 1) → (0.5, 0.25, 0, 1)\n"
              "    stencil 0 → 7\n"
              "  4 Mask draws without a mesh: Mask, pass 0\n"
              "    _Mask at 1,2 of 32x24 1\n"
              "    the device does not run this draw, because the picture is the same without it\n"
              "rejected there:\n"
              "  3 Opaque draws A, B, C, D and 1 more: Lit, pass 2\n"
              "    it is behind the surface that is there\n"
              "left out there by a filter:\n"
              "  Mask leaves out Chair, Floor: layer mask\n"
              "  Glass leaves out Chair: render queue\n"
              "would be there, but no pass draws it:\n"
              "  Ghost: inactive\n"
              "odd:\n"
              "  a feature lacks something\n"
              "2 objects do not cover the pixel, nor does 1 draw of Line, nor do 3 draws of "
              "Dots; 1 object is drawn nowhere; 1 target is of another layout than the picture: "
              "-v names them\n",
              PixelText(SampleHistory(), false));
}

TEST(PixelReport, NamesWhatIsElsewhereWhereMoreIsAskedFor)
{
    const std::string text = PixelText(SampleHistory(), true);
    EXPECT_EQ("drawn, but not over the pixel:\n"
              "  Table\n"
              "  Lamp\n"
              "  1 draw of Line: Stroke 'Composite'\n"
              "  3 draws of Dots: Dot\n"
              "drawn nowhere, and not at the pixel:\n"
              "  Far: inactive\n"
              "targets that are of another layout than the picture:\n"
              "  Shadow: _Shadow 256x256\n",
              text.substr(text.find("drawn, but")));
}

TEST(PixelValue, IsNotChangedWhereItIsNoNumberBeforeAndAfter)
{
    const float none = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE((PixelValue{"T", 0, 0, 1, 1, {none, 1}, {none, 1}}.isChanged()));
    EXPECT_TRUE((PixelValue{"T", 0, 0, 1, 1, {none, 1}, {none, 2}}.isChanged()));
    EXPECT_TRUE((PixelValue{"T", 0, 0, 1, 1, {0}, {none}}.isChanged()));
    EXPECT_TRUE((PixelValue{"T", 0, 0, 1, 1, {}, {0}}.isChanged()));
}

TEST(PixelReport, SaysThatNoObjectIsThere)
{
    PixelHistory history = SampleHistory();
    history.events.resize(1);
    const std::string text = PixelText(history, false);
    EXPECT_NE(std::string::npos, text.find("\nno object is drawn there\n"));
    EXPECT_EQ(std::string::npos, PixelText(SampleHistory(), false).find("no object"));
}

TEST(PixelReport, HasEverythingAsJson)
{
    const Json json = PixelJson(SampleHistory());
    EXPECT_EQ("#bc8900", json["written"]);
    EXPECT_EQ((std::vector<float>{0.5f, 0.25f, 0.0f, 1.0f}),
              json["color"].get<std::vector<float>>());
    ASSERT_EQ(4u, json["events"].size());
    const Json& draw = json["events"][1];
    EXPECT_EQ("drawn", draw["fate"]);
    EXPECT_TRUE(draw["reason"].is_null());
    EXPECT_EQ("Chair", draw["objects"][0]);
    EXPECT_EQ("oak", draw["material"]);
    EXPECT_EQ("Forward", draw["shaderPassName"]);
    EXPECT_EQ(7.0, draw["stencil"]["after"][0]);
    const Json& behind = json["events"][2];
    EXPECT_EQ("depth", behind["fate"]);
    EXPECT_EQ("it is behind the surface that is there", behind["reason"]);
    EXPECT_EQ(5u, behind["objects"].size());
    EXPECT_TRUE(behind["material"].is_null());
    EXPECT_TRUE(behind["stencil"].is_null());
    const Json& mask = json["events"][3];
    EXPECT_FALSE(mask["run"].get<bool>());
    EXPECT_TRUE(mask["colors"][0]["before"].is_null());
    EXPECT_EQ(32, mask["colors"][0]["width"]);
    EXPECT_EQ("layer mask", json["filtered"][0]["rule"]);
    EXPECT_TRUE(json["absent"][0]["here"].get<bool>());
    EXPECT_FALSE(json["absent"][1]["here"].get<bool>());
    EXPECT_EQ("Lamp", json["uncovered"][1]);
    EXPECT_EQ(3, json["uncoveredDraws"][1]["count"]);
    EXPECT_EQ("_Shadow", json["elsewhere"][0]["texture"]);
    EXPECT_EQ(2u, json["notes"].size());
}

} // namespace limn::test
