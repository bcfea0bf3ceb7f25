#include "Problems.h"

#include <core/TemporaryFolder.h>
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
    return ReadUnityAsset(ParseYaml(text, "R.asset"), "R.asset");
}

TEST(UnityAsset, GivesEveryObjectWithItsIdsAndName)
{
    const UnityAsset asset = Read(k_Renderer);
    EXPECT_EQ(asset.file, "R.asset");
    ASSERT_EQ(asset.objects.size(), 3u);
    const UnityObject& feature = asset.objects[0];
    EXPECT_EQ(feature.fileID, -5577581547855358672);
    EXPECT_EQ(feature.classID, 114);
    EXPECT_TRUE(feature.isMonoBehaviour());
    EXPECT_EQ(feature.typeName, "MonoBehaviour");
    EXPECT_EQ(feature.name, "Screem Space Outline");
    EXPECT_EQ(feature.location, (SourceLocation{4, 1}));
    EXPECT_EQ(asset.objects[1].name, "");
    EXPECT_EQ(asset.objects[2].typeName, "TagManager");
    EXPECT_FALSE(asset.objects[2].isMonoBehaviour());
    EXPECT_EQ(asset.objects[2].fields.Find("layers")->items().size(), 2u);
}

TEST(UnityAsset, FollowsReferencesBetweenItsObjects)
{
    const UnityAsset asset = Read(k_Renderer);
    const UnityObject* renderer = asset.FindWithField("m_RendererFeatures");
    ASSERT_NE(renderer, nullptr);
    EXPECT_EQ(renderer->fileID, 11400000);
    const YamlNode& reference = renderer->fields.Find("m_RendererFeatures")->items()[0];
    ASSERT_EQ(ReadFileID(reference), -5577581547855358672);
    const UnityObject* feature = asset.Find(*ReadFileID(reference));
    ASSERT_NE(feature, nullptr);
    const YamlNode* mask = feature->fields.Find("m_Settings")->Find("m_LayerMask");
    EXPECT_EQ(mask->Find("m_Bits")->scalar(), "64");
}

TEST(UnityAsset, GivesNothingForWhatItDoesNotHave)
{
    const UnityAsset asset = Read(k_Renderer);
    EXPECT_EQ(asset.Find(5), nullptr);
    EXPECT_EQ(asset.FindWithField("components"), nullptr);
    EXPECT_EQ(asset.FindWithField("layers"), nullptr); // not a MonoBehaviour's
    EXPECT_EQ(ReadFileID(YamlNode()), std::nullopt);
    EXPECT_EQ(ReadFileID(ParseYaml("{fileID: x}", "R.asset").front()), std::nullopt);
}

TEST(UnityAsset, IsToldByItsTags)
{
    EXPECT_TRUE(IsUnityAsset(ParseYaml(k_Renderer, "R.asset")));
    EXPECT_FALSE(IsUnityAsset(ParseYaml("MonoBehaviour:\n  m_Name: x\n", "R.asset")));
}

TEST(UnityAsset, RefusesEveryDocumentThatIsNoObject)
{
    const std::string message = "this document is no Unity object; one begins like '--- !u!114 "
                                "&11400000' and has one map, 'MonoBehaviour:'";
    EXPECT_THAT(Problems(
                    []
                    {
                        Read("%TAG !u! tag:unity3d.com,2011:\n"
                             "--- !u!114\n"
                             "MonoBehaviour: {}\n"
                             "--- !u!1x &2\n"
                             "GameObject: {}\n"
                             "--- !u!114 &3\n"
                             "MonoBehaviour: text\n"
                             "--- !u!114 &4\n"
                             "A: {}\n"
                             "B: {}\n"
                             "---\n"
                             "plain: {}\n");
                    }),
                ElementsAre("2:5: " + message, "4:5: " + message, "6:5: " + message,
                            "8:5: " + message, "12:1: " + message));
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
                ElementsAre("5:1: duplicate fileID 7; it is already at 3:1"));
}

TEST(UnityAsset, LoadsFromAFile)
{
    const test::TemporaryFolder folder;
    EXPECT_EQ(LoadUnityAsset(folder.Write("R.asset", k_Renderer)).objects.size(), 3u);
    const auto plain = folder.Write("plain.asset", "a: {}\n");
    EXPECT_THAT(Problems([&] { LoadUnityAsset(plain); }),
                ElementsAre("1:1: this document is no Unity object; one begins like '--- !u!114 "
                            "&11400000' and has one map, 'MonoBehaviour:'"));
}

} // namespace

} // namespace limn
