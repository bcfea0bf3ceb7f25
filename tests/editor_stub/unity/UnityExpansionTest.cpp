#include "Mentions.h"
#include "unity/FilesOfProject.h"
#include "unity/UnityReader.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

using testing::HasSubstr;

std::string Change(std::int64_t target, const std::string& path, const std::string& value,
                   const std::string& reference = "{fileID: 0}")
{
    return "    - target: {fileID: " + std::to_string(target) +
           ", guid: x, type: 3}\n      propertyPath: " + path + "\n      value: " + value +
           "\n      objectReference: " + reference + "\n";
}

std::string NameOf(const UnityInstance& object)
{
    UnityNotes notes;
    std::string name;
    UnityReader(object, "", notes).Read("m_Name", name);
    return name;
}

// unity_project.md 2.3: the numbers of Workbench.prefab in the article's project.
TEST(UnityExpansion, GivesObjectsOfInstancesTheIdsThatUnityDoes)
{
    FilesOfProject files;
    files.Add("inner", "--- !u!1 &5676213065973766948\nGameObject:\n  m_Name: Jigsaw\n");
    files.Add("outer", InstanceText(7336795078047825314, "inner", ""));
    const auto expansion = files.Expand("outer");
    const UnityInstance* object = expansion->root().Find(3104244537775875718);
    ASSERT_NE(object, nullptr);
    EXPECT_EQ(NameOf(*object), "Jigsaw");
}

TEST(UnityExpansion, ChangesObjectsThroughTwoLevels)
{
    FilesOfProject files;
    files.Add("inner", ObjectText(5, "Inner"));
    files.Add("middle",
              ObjectText(7, "Middle") + InstanceText(64, "inner", Change(5, "m_Layer", "3")));
    // In middle's space Inner is 64 ^ 5.
    files.Add("outer", InstanceText(256, "middle",
                                    Change(64 ^ 5, "m_Layer", "6") +
                                        Change(64 ^ 50, "m_LocalPosition.y", "8")));
    const auto expansion = files.Expand("outer");
    const UnityInstance* object = expansion->root().Find(256 ^ 64 ^ 5);
    const UnityInstance* transform = expansion->root().Find(256 ^ 64 ^ 50);
    ASSERT_NE(object, nullptr);
    ASSERT_NE(transform, nullptr);
    UnityNotes notes;
    int layer = 0;
    UnityReader(*object, "", notes).Read("m_Layer", layer);
    EXPECT_EQ(layer, 6) << "the outermost one wins";
    glm::vec3 position(0.0f);
    UnityReader(*transform, "", notes).Read("m_LocalPosition", position);
    EXPECT_EQ(position, glm::vec3(1, 8, 3));
    EXPECT_EQ(UnityReader(*transform, "", notes).Reference("m_GameObject").object, object);
}

TEST(UnityExpansion, KnowsObjectsOfInstancesByTheirStrippedIds)
{
    FilesOfProject files;
    files.Add("inner", ObjectText(5, "Inner"));
    files.Add("scene", InstanceText(64, "inner", "") +
                           "--- !u!4 &999 stripped\nTransform:\n"
                           "  m_CorrespondingSourceObject: {fileID: 50, guid: inner, type: 3}\n"
                           "  m_PrefabInstance: {fileID: 64}\n" +
                           ObjectText(8, "Child", 999));
    const auto expansion = files.Expand("scene");
    UnityNotes notes;
    const UnityReader child(*expansion->root().Find(80), "", notes);
    const UnityInstance* father = child.Reference("m_Father").object;
    ASSERT_NE(father, nullptr);
    EXPECT_EQ(NameOf(*UnityReader(*father, "", notes).Reference("m_GameObject").object), "Inner");
}

TEST(UnityExpansion, LeavesOutWhatIsRemovedOrMissing)
{
    FilesOfProject files;
    files.Add("inner", ObjectText(5, "Inner"));
    files.Add("scene", InstanceText(64, "inner", "",
                                    "    m_RemovedGameObjects:\n    - {fileID: 5, guid: inner}\n") +
                           InstanceText(65, "gone", "") + InstanceText(66, "gone", ""));
    const auto expansion = files.Expand("scene");
    for (const UnityInstance* object : expansion->objects())
    {
        EXPECT_NE(object->classID, UnityClass::GameObject);
    }
    ASSERT_EQ(expansion->notes().size(), 1u);
    EXPECT_THAT(expansion->notes()[0].message, Mentions("guid gone", "not in the project"));
}

TEST(UnityExpansion, RefusesAPrefabThatHoldsItself)
{
    FilesOfProject files;
    files.Add("a", InstanceText(1, "b", ""));
    files.Add("b", InstanceText(2, "a", ""));
    EXPECT_THROW(files.Expand("a"), AssetError);
}

TEST(UnityReader, ReadsListsAsInstancesHaveMadeThem)
{
    FilesOfProject files;
    files.Add("inner",
              "--- !u!23 &5\nMeshRenderer:\n  m_Materials:\n"
              "  - {fileID: 1, guid: one, type: 2}\n  - {fileID: 2, guid: two, type: 2}\n");
    files.Add("scene", InstanceText(64, "inner",
                                    Change(5, "m_Materials.Array.data[1]", "",
                                           "{fileID: 3, guid: three, type: 2}") +
                                        Change(5, "m_CastShadows", "x")));
    const auto expansion = files.Expand("scene");
    UnityNotes notes;
    const UnityReader reader(*expansion->root().Find(64 ^ 5), "Cube/MeshRenderer", notes);
    EXPECT_EQ(reader.Count("m_Materials"), 2u);
    EXPECT_EQ(reader.Reference("m_Materials.Array.data[0]").asset.guid, "one");
    EXPECT_EQ(reader.Reference("m_Materials.Array.data[1]").asset.guid, "three");
    int mode = 1;
    reader.Read("m_CastShadows", mode);
    EXPECT_EQ(mode, 1);
    const auto said = notes.Finish("scene");
    ASSERT_EQ(said.size(), 1u);
    EXPECT_THAT(said[0].message,
                HasSubstr("Cube/MeshRenderer.m_CastShadows: 'x' is no whole number"));
}

} // namespace
} // namespace limn::test
