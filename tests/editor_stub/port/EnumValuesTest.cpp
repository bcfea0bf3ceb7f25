#include "port/PortExpression.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

using Values = std::vector<std::optional<std::int64_t>>;

Values ValuesOf(const std::string& text)
{
    CSharpFile file;
    file.path = "a.cs";
    file.text = text;
    ParseCSharp(file);
    return EnumValues(file.classes.at(0));
}

} // namespace

TEST(EnumValues, CountOnFromWhatIsWritten)
{
    EXPECT_EQ((Values{0, 1, 5, 6}), ValuesOf("enum E { A, B, C = 5, D }"));
}

TEST(EnumValues, AreComputedAsCSharpDoes)
{
    EXPECT_EQ(
        (Values{12, 2, 13, -1, 1, 16, 7}),
        ValuesOf("enum E { A = 3 << 1 + 1, B = 0b10, C = A | B - 1, D = ~0, E = C & 3 ^ A >> 4, "
                 "F = 0x1_0, G = (2 + 5) * 1 }"));
}

TEST(EnumValues, WrapAsTheirTypeDoes)
{
    EXPECT_EQ((Values{-2147483648}), ValuesOf("enum E { A = 1 << 31 }"));
    EXPECT_EQ((Values{2147483648, 4294967295}), ValuesOf("enum E : uint { A = 1 << 31, B = ~0u }"));
}

TEST(EnumValues, AreUnknownWhereOthersAreNamed)
{
    EXPECT_EQ((Values{1, std::nullopt, std::nullopt, 3}),
              ValuesOf("enum E { A = 1, B = (int)Other.X, C, D = 3 }"));
}

TEST(EnumValues, MayHaveAnyNumberOfSigns)
{
    EXPECT_EQ((Values{1, 4, 4}), ValuesOf("enum E { A = " + std::string(100'000, '-') +
                                          "1, B = -~3, C = ~-~-4 + 2 }"));
}

} // namespace limn::test
