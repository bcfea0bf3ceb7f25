#include "port/PortLiteral.h"

#include "port/csharp/CSharpTokens.h"

#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

std::optional<std::string> TextIn(const std::string& csharp)
{
    const CSharpTokens tokens = TokenizeCSharp(csharp, "a.cs");
    return PlainText({tokens.tokens.data(), tokens.tokens.size() - 1});
}

} // namespace

TEST(PlainText, IsThatOfOneStringWhichCppWritesAlike)
{
    EXPECT_EQ("a \\\"b\\\"", TextIn(R"("a \"b\"")"));
    EXPECT_EQ("why?\\?", TextIn("\"why?"
                                "?\"")); // two in a row began a character of old C++
    EXPECT_EQ(std::nullopt, TextIn(R"("\u0041")"));
    EXPECT_EQ(std::nullopt, TextIn(R"(@"a")"));
    EXPECT_EQ("ab?\\?c", TextIn("\"a\" + \"b?\" + \"?c\""));
    EXPECT_EQ(std::nullopt, TextIn(R"("a" + b)"));
    EXPECT_EQ(std::nullopt, TextIn(R"("a" + )"));
    EXPECT_EQ(std::nullopt, TextIn("1"));
}

TEST(NewArguments, AreThoseOfTheBracket)
{
    const std::string csharp = "new T<int, int>(a, F(b, c)) { d = 1 }";
    const CSharpTokens tokens = TokenizeCSharp(csharp, "a.cs");
    const auto arguments = NewArguments({tokens.tokens.data(), tokens.tokens.size() - 1});
    ASSERT_TRUE(arguments);
    ASSERT_EQ(2u, arguments->size());
    EXPECT_EQ("a", arguments->at(0)[0].text);
    EXPECT_EQ("F", arguments->at(1)[0].text);
    EXPECT_FALSE(NewArguments({tokens.tokens.data() + 1, 3}));
}

} // namespace limn::test
