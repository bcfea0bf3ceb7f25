#include "tokens/Tokens.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn
{
namespace
{

using testing::ElementsAre;

std::vector<std::string> TokenTexts(std::string_view source)
{
    std::vector<std::string> texts;
    for (const HlslToken& token : TokenizeHlsl(source))
    {
        texts.emplace_back(token.text);
    }
    return texts;
}

TEST(HlslTokens, KeepANumberWhole)
{
    EXPECT_THAT(
        TokenTexts("1 0x1Fu 1.5f .5 .5h 2.e3 1e-3+1E+4-5"),
        ElementsAre("1", "0x1Fu", "1.5f", ".5", ".5h", "2.e3", "1e-3", "+", "1E+4", "-", "5"));
    EXPECT_THAT(TokenTexts(".5"), ElementsAre(".5"));
}

TEST(HlslTokens, TakeADotBehindAWordForAMember)
{
    EXPECT_THAT(TokenTexts("v.x a.b1 m[0].y"),
                ElementsAre("v", ".", "x", "a", ".", "b1", "m", "[", "0", "]", ".", "y"));
}

TEST(HlslTokens, KeepOperatorsOfSeveralCharactersWhole)
{
    EXPECT_THAT(TokenTexts("a<=b&&c!=d<<2;i++"),
                ElementsAre("a", "<=", "b", "&&", "c", "!=", "d", "<<", "2", ";", "i", "++"));
}

} // namespace
} // namespace limn
