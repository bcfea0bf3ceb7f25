#include "Mentions.h"
#include "Problems.h"

#include <gmock/gmock.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

using test::Mentions;
using test::Texts;
using testing::ElementsAre;
using testing::IsEmpty;

struct Camera
{
    float fieldOfView = 60.0f;
    int layer = 0;
    std::uint32_t mask = 1;
    bool orthographic = false;
    std::string name = "camera";
    glm::vec3 position{0.0f};
    glm::vec2 size{0.0f};
    Color background = Color::black;
};

struct Reading
{
    explicit Reading(const std::string& text) : root(ParseYaml(text, "x.yaml").front()) {}

    YamlMapReader Map() { return {root, "camera", diagnostics}; }
    std::vector<std::string> problems() const { return Texts(diagnostics.diagnostics()); }

    YamlNode root;
    AssetDiagnostics diagnostics{"x.yaml"};
};

TEST(YamlMapReader, SetsWhatTheFileHasAndLeavesTheRest)
{
    Reading reading("fieldOfView: 45\nlayer: 6\nmask: 4294967295\northographic: true\n"
                    "position: [1, 2, 3]\nsize: {x: 4, y: 5}\nbackground: '#FFFFFF'\n");
    Camera camera;
    YamlMapReader map = reading.Map();
    EXPECT_TRUE(map.Read("fieldOfView", camera.fieldOfView, {1, 179}));
    EXPECT_TRUE(map.Read("layer", camera.layer, {0, 31}));
    EXPECT_TRUE(map.Read("mask", camera.mask));
    EXPECT_TRUE(map.Read("orthographic", camera.orthographic));
    EXPECT_TRUE(map.Read("position", camera.position));
    EXPECT_TRUE(map.Read("size", camera.size));
    EXPECT_TRUE(map.Read("background", camera.background));
    EXPECT_FALSE(map.Read("name", camera.name));
    map.Finish();
    EXPECT_THAT(reading.problems(), IsEmpty());
    EXPECT_EQ(camera.fieldOfView, 45.0f);
    EXPECT_EQ(camera.layer, 6);
    EXPECT_EQ(camera.mask, 0xFFFFFFFFu);
    EXPECT_TRUE(camera.orthographic);
    EXPECT_EQ(camera.position, glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(camera.size, glm::vec2(4.0f, 5.0f));
    EXPECT_EQ(camera.background, Color::white);
    EXPECT_EQ(camera.name, "camera");
}

TEST(YamlMapReader, KeepsTheOldValueAndNamesTheKeyWhereTheNewOneIsBad)
{
    Reading reading("fieldOfView: 200\nmask: -1\n");
    Camera camera;
    YamlMapReader map = reading.Map();
    EXPECT_FALSE(map.Read("fieldOfView", camera.fieldOfView, {1, 179}));
    EXPECT_FALSE(map.Read("mask", camera.mask));
    EXPECT_EQ(camera.fieldOfView, 60.0f);
    EXPECT_EQ(camera.mask, 1u);
    EXPECT_THAT(reading.problems(),
                ElementsAre(Mentions("1:14: camera.fieldOfView", "200", "outside", "[1, 179]"),
                            Mentions("2:7: camera.mask", "-1", "outside", "[0, 4294967295]")));
}

TEST(YamlMapReader, ReportsEveryUnknownKeyWithTheNearestKnownOne)
{
    Reading reading("fieldOfVew: 45\nname: x\nzzz: 1\n");
    Camera camera;
    YamlMapReader map = reading.Map();
    map.Read("fieldOfView", camera.fieldOfView);
    map.Read("name", camera.name);
    map.Finish();
    EXPECT_THAT(reading.problems(),
                ElementsAre(Mentions("1:1: camera", "unknown key", "'fieldOfVew'", "'fieldOfView'"),
                            Mentions("3:1: camera", "unknown key", "'zzz'", "fieldOfView, name")));
}

TEST(YamlMapReader, FindsASerialisedNameUnderBothSpellings)
{
    Camera camera;
    for (const char* text : {"m_FieldOfView: 45\n", "fieldOfView: 45\n"})
    {
        Reading reading(text);
        YamlMapReader map = reading.Map();
        EXPECT_TRUE(map.Read("m_FieldOfView", camera.fieldOfView));
        map.Finish();
        EXPECT_THAT(reading.problems(), IsEmpty());
    }
}

TEST(YamlMapReader, SuggestsInTheSpellingOfTheWriter)
{
    Camera camera;
    Reading reading("m_FeldOfView: 45\nfeldOfView: 45\n");
    YamlMapReader map = reading.Map();
    map.Read("m_FieldOfView", camera.fieldOfView);
    map.Finish();
    EXPECT_THAT(
        reading.problems(),
        ElementsAre(Mentions("1:1: camera", "unknown key", "'m_FeldOfView'", "'m_FieldOfView'"),
                    Mentions("2:1: camera", "unknown key", "'feldOfView'", "'fieldOfView'")));
}

TEST(YamlMapReader, RefusesBothSpellingsOfOneKeyAtOnce)
{
    Camera camera;
    Reading reading("fieldOfView: 45\nm_FieldOfView: 50\n");
    YamlMapReader map = reading.Map();
    map.Read("m_FieldOfView", camera.fieldOfView);
    map.Find("m_FieldOfView");
    map.Finish();
    EXPECT_THAT(reading.problems(), ElementsAre(Mentions("2:1: camera", "'m_FieldOfView'",
                                                         "same key", "'fieldOfView'", "1:1")));
}

TEST(YamlMapReader, ReportsARequiredKeyThatIsMissing)
{
    Reading reading("name: x\n");
    YamlMapReader map = reading.Map();
    EXPECT_EQ(map.Require("m_Mesh"), nullptr);
    EXPECT_NE(map.Require("name"), nullptr);
    EXPECT_THAT(reading.problems(), ElementsAre("1:1: camera: key 'mesh' is missing"));
}

TEST(YamlMapReader, TakesNothingForAnEmptyMap)
{
    Reading reading("camera:\nother: 1\n");
    YamlMapReader map(*reading.root.Find("camera"), "camera", reading.diagnostics);
    EXPECT_EQ(map.Find("name"), nullptr);
    map.Finish();
    EXPECT_THAT(reading.problems(), IsEmpty());
}

TEST(YamlMapReader, RefusesWhatIsNoMap)
{
    Reading reading("- 1\n");
    YamlMapReader map = reading.Map();
    EXPECT_EQ(map.Require("name"), nullptr);
    map.Finish();
    EXPECT_THAT(reading.problems(), ElementsAre(Mentions("1:1: camera", "sequence", "map")));
}

TEST(PlainSpelling, DropsUnitysPrefixAndTheCapitalLetterBehindIt)
{
    EXPECT_EQ(PlainSpelling("m_OutlineWidth"), "outlineWidth");
    EXPECT_EQ(PlainSpelling("m_X"), "x");
    EXPECT_EQ(PlainSpelling("threshold"), "threshold");
    EXPECT_EQ(PlainSpelling("Threshold"), "Threshold");
    EXPECT_EQ(PlainSpelling("m_"), "m_");
}

TEST(AssetDiagnostics, ThrowsItsErrorsInTheOrderOfTheFileAndKeepsTheNotes)
{
    AssetDiagnostics diagnostics("x.yaml");
    diagnostics.Note({1, 1}, "note");
    diagnostics.ThrowIfErrors();
    diagnostics.Error({7, 5}, "late");
    diagnostics.Error({2, 9}, "early");
    EXPECT_THAT(test::Problems([&] { diagnostics.ThrowIfErrors(); }),
                ElementsAre("2:9: early", "7:5: late"));
    EXPECT_THAT(Texts(diagnostics.notes()), ElementsAre("1:1: note"));
}

} // namespace

} // namespace limn
