#include "unity/UnityTree.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

/// A text and what was read of it.
class UnityTreeOf
{
public:
    explicit UnityTreeOf(std::string text) : m_Text(std::move(text)), m_Tree(m_Text, "a.prefab", 11)
    {
    }
    UnityNode operator[](std::string_view key) const { return m_Tree.root()[key]; }
    UnityNode root() const { return m_Tree.root(); }

private:
    std::string m_Text;
    UnityTree m_Tree;
};

std::vector<std::string> TextsOf(const UnityNode& list)
{
    std::vector<std::string> texts;
    for (const UnityNode item : list)
    {
        texts.emplace_back(item.text());
    }
    return texts;
}

std::string ProblemOf(const std::string& text)
{
    try
    {
        UnityTree(text, "a.prefab", 11);
        return "";
    }
    catch (const AssetError& error)
    {
        return error.what();
    }
}

TEST(UnityTree, HasMapsListsAndTextAsUnityWritesThem)
{
    const UnityTreeOf tree("GameObject:\n"
                           "  m_Component:\n"
                           "  - component: {fileID: -5577581547855358672}\n"
                           "  - component: {fileID: 2, guid: 0123, type: 3}\n"
                           "  m_Name: \n"
                           "  near clip plane: 0.3\n"
                           "  m_Layer: 6\n"
                           "  layers:\n"
                           "  - Default\n"
                           "  - \n"
                           "  - Water\n"
                           "  empty: []\n");
    const UnityNode object = tree["GameObject"];
    EXPECT_EQ(object["near clip plane"].text(), "0.3");
    EXPECT_EQ(object["m_Layer"].line(), 17);
    EXPECT_TRUE(object["m_Name"]);
    EXPECT_EQ(object["m_Name"].text(), "");
    EXPECT_FALSE(object["m_Tag"]);
    EXPECT_TRUE(object["empty"].isList());
    EXPECT_THAT(TextsOf(object["layers"]), ElementsAre("Default", "", "Water"));
    std::vector<std::string> ids;
    for (const UnityNode item : object["m_Component"])
    {
        ids.emplace_back(item["component"]["fileID"].text());
    }
    EXPECT_THAT(ids, ElementsAre("-5577581547855358672", "2"));
}

TEST(UnityTree, FoldsLinesThatGoOn)
{
    const UnityTreeOf tree("a: {fileID: 1, guid: ab,\n"
                           "    type: 3}\n"
                           "plain: one\n"
                           "  two\n"
                           "quoted: \"x \\u00e9\\n \\\n"
                           "    y\"\n"
                           "single: 'it''s'\n"
                           "last: 1\n");
    EXPECT_EQ(tree["a"]["type"].text(), "3");
    EXPECT_EQ(tree["plain"].text(), "one two");
    EXPECT_EQ(tree["quoted"].text(), "x \xC3\xA9\n y");
    EXPECT_EQ(tree["single"].text(), "it's");
    EXPECT_EQ(tree["last"].text(), "1");
    EXPECT_EQ(tree["last"].line(), 18);
}

TEST(UnityTree, TakesTheLastOfEqualKeysAndKeepsAll)
{
    const UnityTreeOf tree("m_TexEnvs:\n"
                           "  data:\n"
                           "    first:\n"
                           "      name: _A\n"
                           "  data:\n"
                           "    first:\n"
                           "      name: _B\n");
    EXPECT_EQ(tree["m_TexEnvs"]["data"]["first"]["name"].text(), "_B");
    int count = 0;
    for ([[maybe_unused]] const UnityNode entry : tree["m_TexEnvs"])
    {
        ++count;
    }
    EXPECT_EQ(count, 2);
}

TEST(UnityTree, LeavesTextsThatLookLikeOtherThingsAsTheyAre)
{
    const UnityTreeOf tree("a: 1e3\nb: on\nc: 0123\nd: x:y #z\ne: -\r\nf: \"\xE6\xA3\xB1\"\n");
    EXPECT_EQ(tree["a"].text(), "1e3");
    EXPECT_EQ(tree["b"].text(), "on");
    EXPECT_EQ(tree["c"].text(), "0123");
    EXPECT_EQ(tree["d"].text(), "x:y #z");
    EXPECT_EQ(tree["e"].text(), "-");
    EXPECT_EQ(tree["f"].text(), "\xE6\xA3\xB1");
}

TEST(UnityTree, SaysWhereItIsBroken)
{
    EXPECT_THAT(ProblemOf("a: 1\nnonsense\n"), HasSubstr("a.prefab:12:1: error: 'key: value'"));
    EXPECT_THAT(ProblemOf("a: {b: 1\nc: 2\n"), HasSubstr("a.prefab:11"));
    EXPECT_THAT(ProblemOf("a: \"b\n"), HasSubstr("the quotes do not end"));
    EXPECT_THAT(ProblemOf("a:\n  b: 1\n   c: 2\n"), HasSubstr("a.prefab:13"));
    EXPECT_THAT(ProblemOf("a: " + std::string(200, '[')), HasSubstr("error"));
    std::string deep;
    for (int i = 0; i < 200; ++i)
    {
        deep += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
    }
    EXPECT_THAT(ProblemOf(deep), HasSubstr("nested deeper than 64"));
}

} // namespace
} // namespace limn::test
