#include "Problems.h"

#include "TemporaryFolder.h"
#include <gmock/gmock.h>
#include <limn/volume/UnityAsset.h>

namespace limn
{

namespace
{

using test::Problems;
using testing::ElementsAre;

/// A renderer asset with one feature, as Unity saves it, cut down.
constexpr std::string_view k_Renderer = "%YAML 1.1\n"
                                        "%TAG !u! tag:unity3d.com,2011:\n"
                                        "--- !u!114 &-5577581547855358672\n"
                                        "MonoBehaviour:\n"
                                        "  m_Name: Screem Space Outline\n"
                                        "  m_EditorClassIdentifier: \n"
                                        "  m_Active: 1\n"
                                        "  m_Settings:\n"
                                        "    m_RenderPassEvent: 500\n"
                                        "    m_LayerMask:\n"
                                        "      serializedVersion: 2\n"
                                        "      m_Bits: 64\n"
                                        "--- !u!114 &11400000\n"
                                        "MonoBehaviour:\n"
                                        "  m_Name: \n"
                                        "  m_RendererFeatures:\n"
                                        "  - {fileID: -5577581547855358672}\n"
                                        "  m_RendererFeatureMap: 30d54e2e227398b2\n"
                                        "--- !u!78 &1\n"
                                        "TagManager:\n"
                                        "  layers:\n"
                                        "  - Default\n"
                                        "  - \n";

UnityAsset Read(std::string_view text)
{
    return UnityAsset(std::string(text), "R.asset");
}

constexpr const char* k_NotAnObject =
    "this document is no Unity object; one begins like '--- !u!114 "
    "&11400000' and has one map, 'MonoBehaviour:'";

TEST(UnityAsset, GivesEveryObjectWithItsIdsAndName)
{
    const UnityAsset asset = Read(k_Renderer);
    EXPECT_EQ(asset.file(), "R.asset");
    ASSERT_EQ(asset.headers().size(), 3u);
    EXPECT_EQ(asset.headers()[0].line, 3);
    const UnityObject feature = asset.Read(asset.headers()[0]);
    EXPECT_EQ(feature.fileID, -5577581547855358672);
    EXPECT_EQ(feature.classID, 114);
    EXPECT_EQ(feature.typeName, "MonoBehaviour");
    EXPECT_EQ(feature.name, "Screem Space Outline");
    EXPECT_EQ(feature.location, (SourceLocation{4, 1}));
    EXPECT_EQ(asset.Read(asset.headers()[1]).name, "");
    const UnityObject tags = asset.Read(asset.headers()[2]);
    EXPECT_EQ(tags.typeName, "TagManager");
    EXPECT_EQ(tags.classID, 78);
    EXPECT_EQ(tags.fields.Find("layers")->items().size(), 2u);
    EXPECT_EQ(tags.fields.Find("layers")->location(), (SourceLocation{22, 3}));
}

TEST(UnityAsset, FollowsReferencesBetweenItsObjects)
{
    const UnityAsset asset = Read(k_Renderer);
    const std::optional<UnityObject> renderer = asset.FindWithField("m_RendererFeatures");
    ASSERT_TRUE(renderer);
    EXPECT_EQ(renderer->fileID, 11400000);
    const YamlNode& reference = renderer->fields.Find("m_RendererFeatures")->items()[0];
    ASSERT_EQ(ReadFileID(reference), -5577581547855358672);
    const std::optional<UnityObject> feature = asset.Find(*ReadFileID(reference));
    ASSERT_TRUE(feature);
    const YamlNode* mask = feature->fields.Find("m_Settings")->Find("m_LayerMask");
    EXPECT_EQ(mask->Find("m_Bits")->scalar(), "64");
}

TEST(UnityAsset, GivesNothingForWhatItDoesNotHave)
{
    const UnityAsset asset = Read(k_Renderer);
    EXPECT_FALSE(asset.Find(5));
    EXPECT_EQ(asset.FindHeader(5), nullptr);
    EXPECT_FALSE(asset.FindWithField("components"));
    EXPECT_FALSE(asset.FindWithField("m_Bits")); // not a field of the object itself
    EXPECT_FALSE(asset.FindWithField("layers")); // not a MonoBehaviour's
    EXPECT_EQ(ReadFileID(YamlNode()), std::nullopt);
    EXPECT_EQ(ReadFileID(ParseYaml("{fileID: x}", "R.asset").front()), std::nullopt);
}

TEST(UnityAsset, IsToldByTheLinesItsObjectsBeginWith)
{
    EXPECT_TRUE(IsUnityAsset(k_Renderer));
    EXPECT_TRUE(IsUnityAsset("--- !u!1 &2\nGameObject: {}\n"));
    EXPECT_FALSE(IsUnityAsset("MonoBehaviour:\n  m_Name: x\n"));
    EXPECT_FALSE(IsUnityAsset("a: |\n  --- !u!1 &2\n"));
}

/// A scene as Unity saves it, cut down: an object, a prefab's instance and what stands for the
/// prefab's own transform.
constexpr std::string_view k_UnityScene =
    "%YAML 1.1\n"
    "%TAG !u! tag:unity3d.com,2011:\n"
    "--- !u!1 &100\n"
    "GameObject:\n"
    "  m_Component:\n"
    "  - component: {fileID: 102}\n"
    "  m_Name: 'Hammer: 2'\n"
    "--- !u!4 &101 stripped\n"
    "Transform:\n"
    "  m_CorrespondingSourceObject: {fileID: -8679921383154817045,"
    " guid: 0a,\n"
    "    type: 3}\n"
    "  m_PrefabInstance: {fileID: 300}\n"
    "--- !u!4 &102\n"
    "Transform:\n"
    "  m_Father: {fileID: 101}\n"
    "--- !u!1001 &300\n"
    "PrefabInstance:\n"
    "  m_Modification:\n"
    "    m_Modifications: []\n"
    "--- !u!1660057539 &9223372036854775807\n"
    "SceneRoots:\n"
    "  m_Roots:\n"
    "  - {fileID: 300}\n";

void ExpectUnityScene(const UnityAsset& asset)
{
    ASSERT_EQ(asset.headers().size(), 5u);
    for (const UnityHeader& header : asset.headers())
    {
        EXPECT_EQ(header.isStripped, header.fileID == 101) << header.fileID;
    }
    const std::optional<UnityObject> stripped = asset.Find(101);
    ASSERT_TRUE(stripped);
    EXPECT_EQ(stripped->classID, 4);
    EXPECT_EQ(stripped->typeName, "Transform");
    EXPECT_EQ(ReadFileID(*stripped->fields.Find("m_CorrespondingSourceObject")),
              -8679921383154817045);
    EXPECT_EQ(ReadFileID(*stripped->fields.Find("m_PrefabInstance")), 300);
    EXPECT_EQ(ReadFileID(*asset.Find(102)->fields.Find("m_Father")), 101);
    EXPECT_EQ(asset.Find(100)->name, "Hammer: 2");
    const std::optional<UnityObject> roots = asset.Find(9223372036854775807);
    ASSERT_TRUE(roots);
    EXPECT_EQ(roots->classID, 1660057539);
    EXPECT_EQ(roots->location, (SourceLocation{21, 1}));
    EXPECT_EQ(ReadFileID(roots->fields.Find("m_Roots")->items()[0]), 300);
}

TEST(UnityAsset, ReadsAScene)
{
    ExpectUnityScene(Read(k_UnityScene));
}

TEST(UnityAsset, ReadsAFileWithWindowsLineEndsAndAByteOrderMark)
{
    std::string text = "\xEF\xBB\xBF";
    for (const char c : k_UnityScene)
    {
        text += c == '\n' ? "\r\n" : std::string(1, c);
    }
    ExpectUnityScene(Read(text));
}

TEST(UnityAsset, ParsesOnlyTheBodiesThatItIsAskedFor)
{
    const UnityAsset asset = Read("--- !u!114 &1\nMonoBehaviour:\n  m_Name: [\n"
                                  "--- !u!114 &2\nMonoBehaviour:\n  m_Name: good\n  wanted: 1\n"
                                  "--- !u!114 &3\nMonoBehaviour:\n  a: 1\n  a: 2\n  b: {\n");
    EXPECT_EQ(asset.Find(2)->name, "good");
    EXPECT_EQ(asset.FindWithField("wanted")->fileID, 2);
    EXPECT_THAT(Problems([&] { asset.Find(1); }),
                ElementsAre("3:11: this is not valid YAML: the '[' here is not closed by a ']'"));
    EXPECT_THAT(Problems([&] { asset.Find(3); }),
                ElementsAre("11:3: duplicate key 'a'; it is already at 10:3",
                            "12:6: this is not valid YAML: the '{' here is not closed by a '}'"));
}

/// 40 000 bodies of 1 KiB that no YAML parser takes: what looks at each body once or at no body is
/// done at once, what looks at all bodies for every object is not in an hour.
TEST(UnityAsset, FindsEachOfManyObjectsWithoutALookAtTheOthers)
{
    constexpr int count = 40'000;
    const std::string broken = "MonoBehaviour: [" + std::string(1024, ',') + "\n";
    std::string text;
    for (int i = 1; i <= count; ++i)
    {
        text += "--- !u!114 &" + std::to_string(i * 7919) + "\n" + broken;
    }
    const UnityAsset asset = Read(text);
    ASSERT_EQ(asset.headers().size(), static_cast<std::size_t>(count));
    int found = 0;
    for (int i = 1; i <= count; ++i)
    {
        const UnityHeader* header = asset.FindHeader(i * 7919);
        found += header && header->line == 2 * i - 1 ? 1 : 0;
    }
    EXPECT_EQ(found, count);
    EXPECT_FALSE(asset.FindWithField("components"));
}

TEST(UnityAsset, RefusesEveryDocumentThatDoesNotBeginAsAnObject)
{
    EXPECT_THAT(
        Problems(
            []
            {
                Read("%TAG !u! tag:unity3d.com,2011:\n"
                     "--- !u!114\n"
                     "MonoBehaviour: {}\n"
                     "--- !u!1x &2\n"
                     "--- !u!1 &99999999999999999999\n"
                     "--- !u!1 &3 striped\n"
                     "--- !u!1 &4 stripped too\n"
                     "---\n"
                     "plain: {}\n");
            }),
        ElementsAre("2:1: " + std::string(k_NotAnObject), "4:1: " + std::string(k_NotAnObject),
                    "5:1: " + std::string(k_NotAnObject), "6:1: " + std::string(k_NotAnObject),
                    "7:1: " + std::string(k_NotAnObject), "8:1: " + std::string(k_NotAnObject)));
}

TEST(UnityAsset, RefusesABodyThatIsNotOneMapWhenAskedForIt)
{
    const UnityAsset asset = Read("# a comment\n"
                                  "--- !u!114 &3\n"
                                  "MonoBehaviour: text\n"
                                  "--- !u!114 &4\n"
                                  "A: {}\n"
                                  "B: {}\n"
                                  "--- !u!114 &5\n"
                                  "--- !u!114 &6");
    const auto problems = [&asset](std::int64_t fileID)
    {
        return Problems([&] { asset.Find(fileID); });
    };
    EXPECT_THAT(problems(3), ElementsAre("2:1: " + std::string(k_NotAnObject)));
    EXPECT_THAT(problems(4), ElementsAre("4:1: " + std::string(k_NotAnObject)));
    EXPECT_THAT(problems(5), ElementsAre("7:1: " + std::string(k_NotAnObject)));
    EXPECT_THAT(problems(6), ElementsAre("8:1: " + std::string(k_NotAnObject)));
}

TEST(UnityAsset, RefusesTwoObjectsWithOneId)
{
    EXPECT_THAT(Problems(
                    []
                    {
                        Read("%TAG !u! tag:unity3d.com,2011:\n"
                             "--- !u!114 &7\nMonoBehaviour: {}\n"
                             "--- !u!114 &7\nMonoBehaviour: {}\n");
                    }),
                ElementsAre("4:1: duplicate fileID 7; it is already at 2:1"));
}

TEST(UnityAsset, LoadsFromAFile)
{
    const test::TemporaryFolder folder;
    EXPECT_EQ(LoadUnityAsset(folder.Write("R.asset", k_Renderer)).headers().size(), 3u);
    const auto plain = folder.Write("plain.asset", "a: {}\nb: {}\n");
    EXPECT_THAT(Problems([&] { LoadUnityAsset(plain); }),
                ElementsAre("1:1: " + std::string(k_NotAnObject)));
    EXPECT_THAT(
        Problems([] { Read("# nothing\n"); }),
        ElementsAre("the file holds no Unity object; one begins like '--- !u!114 &11400000'"));
}

} // namespace

} // namespace limn
