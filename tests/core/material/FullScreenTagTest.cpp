#include "scene/TestScene.h"

#include <gmock/gmock.h>

#include "Mentions.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

std::shared_ptr<const Shader> ShaderWithTag(const std::string& tag)
{
    return test::ShaderOf("Shader \"T\" { SubShader {\nPass { Tags { " + tag + " } } } }");
}

const FullScreenTag& TagOf(const std::string& value)
{
    static std::vector<std::shared_ptr<const Shader>> shaders; // keep what is pointed at
    shaders.push_back(ShaderWithTag("\"LimnFullScreen\" = \"" + value + "\""));
    return *shaders.back()->fullScreenTag(0);
}

std::vector<std::string> NamesOf(const std::vector<ShaderPropertyId>& ids)
{
    std::vector<std::string> names;
    for (const ShaderPropertyId id : ids)
    {
        names.push_back(id.name());
    }
    return names;
}

} // namespace

TEST(FullScreenTagTest, IsReadWordByWord)
{
    EXPECT_EQ(nullptr, ShaderWithTag("\"LightMode\" = \"Any\"")->fullScreenTag(0));
    const FullScreenTag& plain = TagOf("True");
    EXPECT_TRUE(plain.zeroes.empty());
    EXPECT_FALSE(plain.copied);
    const FullScreenTag& zero = TagOf("0.5 0 1 0.25 where _A or _B or _C is 0");
    EXPECT_EQ((Color{0.5f, 0.0f, 1.0f, 0.25f}), zero.output);
    EXPECT_THAT(NamesOf(zero.zeroes), ElementsAre("_A", "_B", "_C"));
    EXPECT_FALSE(zero.reach);
    EXPECT_FALSE(zero.reachProperty);
    EXPECT_EQ(2.5f, TagOf("0 0 0 0 where _A is 0 within 2.5 texels").reach);
    EXPECT_EQ("_W", TagOf("0 0 0 0 where _A is 0 within _W texels").reachProperty->name());
    EXPECT_EQ("_BlitTexture", TagOf("_BlitTexture with alpha 1").copied->name());
}

TEST(FullScreenTagTest, IsAnErrorWhereItSaysSomethingElse)
{
    for (const std::string value :
         {"", "true", "False", "0 0 0 where _A is 0", "0 0 0 1 where _A is 1", "0 0 0 1 where _A",
          "0 0 0 1 where _A or is 0", "0 0 0 1 where _A is 0 within texels",
          "0 0 0 1 where _A is 0 within -1 texels", "0 0 0 1 where _A is 0 within 3",
          "0 0 0 1 where _A is 0 within 3 texels or so", "_A with alpha 0", "_A"})
    {
        try
        {
            ShaderWithTag("\"LimnFullScreen\" = \"" + value + "\"");
            ADD_FAILURE() << value << " is taken";
        }
        catch (const AssetError& error)
        {
            EXPECT_THAT(ToString(error.diagnostics().at(0)),
                        test::Mentions("test.shader:2:15", "LimnFullScreen", "'" + value + "'",
                                       "no promise", "True", "within 3 texels",
                                       "_BlitTexture with alpha"));
        }
    }
}

TEST(FullScreenTagTest, OfAMeshSaysThatItsVerticesStayWhereTheyAre)
{
    EXPECT_TRUE(ShaderWithTag("\"LimnWithinMesh\" = \"True\"")->staysWithinMesh(0));
    EXPECT_FALSE(ShaderWithTag("\"LimnWithinMesh\" = \"No\"")->staysWithinMesh(0));
    EXPECT_FALSE(ShaderWithTag("")->staysWithinMesh(0));
}

} // namespace limn
