#include "Mentions.h"

using limn::test::Mentions;
using testing::Not;

TEST(Mentions, MatchesPartsInTheirOrder)
{
    const std::string text = "a.yaml:3:5: 'width' is 300; it must be at most 64";
    EXPECT_THAT(text, Mentions("a.yaml:3:5", "'width'", "300", "64"));
    EXPECT_THAT(text, Not(Mentions("300", "'width'"))); // another order
    EXPECT_THAT(text, Not(Mentions("300", "300")));     // it stands there once
    EXPECT_THAT(text, Not(Mentions("'width'", "65")));
}
