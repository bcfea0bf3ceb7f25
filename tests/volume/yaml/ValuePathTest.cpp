#include "Mentions.h"
#include "Problems.h"

#include <gmock/gmock.h>
#include <limn/volume/ProfileEdit.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;

} // namespace

TEST(ValuePath, BeginsWithTheLongestNameThatThereIs)
{
    const std::vector<std::string_view> names{"My", "My.Outline", "Other"};
    const ValuePath path = ValuePath::Split("My.Outline.settings.width", names);
    EXPECT_EQ("My.Outline", path.name);
    EXPECT_THAT(path.keys, ElementsAre("settings", "width"));
    EXPECT_EQ("My", ValuePath::Split("My.Outlin.width", names).name);
}

TEST(ValuePath, OfAnUnknownNameHasThePartBeforeTheFirstDot)
{
    const ValuePath path =
        ValuePath::Split("Outline.settings.filter.layers", {"Outlin", "Outline.x.y"});
    EXPECT_EQ("Outline", path.name);
    EXPECT_EQ("settings.filter.layers", path.KeysText());
}

TEST(ValuePath, IsNotANameAlone)
{
    EXPECT_EQ("b", ValuePath::Split("a.b", {"a.b"}).KeysText());
    EXPECT_THROW(ValuePath::Split("a", {"a"}), ContractError);
}

TEST(ValuePath, StandsInAFileAsMapsInMaps)
{
    const ValuePath path = ValuePath::Split("a.b.c", {});
    const YamlNode map = path.AsMap(ParseTypedValue("[1, 2]", "x"));
    ASSERT_NE(nullptr, map.Find("b"));
    ASSERT_NE(nullptr, map.Find("b")->Find("c"));
    EXPECT_EQ(2u, map.Find("b")->Find("c")->items().size());
}

TEST(ValueAssignment, EndsItsPathAtTheFirstEqualsSign)
{
    const ValueAssignment assignment = ValueAssignment::Parse("a.b=c=d", "x");
    EXPECT_EQ("a.b", assignment.path);
    EXPECT_EQ("c=d", assignment.value);
    EXPECT_EQ("", ValueAssignment::Parse("a.b=", "x").value);
}

TEST(ValueAssignment, KnowsSignsInFrontOfTheEqualsSign)
{
    for (const char sign : {'+', '-', '*'})
    {
        const std::string text = std::string("a.b") + sign + "=2";
        const ValueAssignment assignment = ValueAssignment::Parse(text, "x");
        EXPECT_EQ("a.b", assignment.path);
        EXPECT_EQ(sign, assignment.sign);
        EXPECT_EQ(text, assignment.Text());
    }
    EXPECT_EQ('=', ValueAssignment::Parse("a.b=+2", "x").sign);
}

TEST(ValueAssignment, RefusesATextOfAnotherForm)
{
    for (const char* text : {"", "a=1", "a.b", ".b=1", "a.=1", "a=b.c"})
    {
        EXPECT_THAT(Problems([text] { ValueAssignment::Parse(text, text); }),
                    ElementsAre(Mentions("NAME.path=value", "ScreenSpaceOutline.m_OutlineWidth=4")))
            << text;
    }
}

TEST(ParseTypedValue, NeedsNoQuotesForAColourAndForNothing)
{
    EXPECT_EQ("#00ff00", ParseTypedValue("#00ff00", "x").scalar());
    EXPECT_TRUE(ParseTypedValue("", "x").isQuoted());
    EXPECT_TRUE(ParseTypedValue("{a: 1}", "x").isMap());
}

} // namespace limn::test
