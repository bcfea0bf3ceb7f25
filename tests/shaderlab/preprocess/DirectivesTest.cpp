#include "preprocess/GlslangIncluder.h"

#include <gtest/gtest.h>

namespace limn
{
namespace
{

// What stands behind the text keeps its number.
TEST(TranslateDirectives, KeepsTheCountOfLinesWhereTheLastOneGoesOn)
{
    EXPECT_EQ("a  b  c\n\n", TranslateDirectives("a \\\nb \\\nc"));
    EXPECT_EQ("a\n", TranslateDirectives("a"));
    EXPECT_EQ("a\n", TranslateDirectives("a\n"));
}

} // namespace
} // namespace limn
