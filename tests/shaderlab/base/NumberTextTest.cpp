#include <gtest/gtest.h>
#include <limn/base/NumberText.h>

namespace limn
{

namespace
{

TEST(NumberText, IsAsShortAsAPersonWouldWriteIt)
{
    EXPECT_EQ(NumberText(3.0), "3");
    EXPECT_EQ(NumberText(0.0), "0");
    EXPECT_EQ(NumberText(-0.25), "-0.25");
    EXPECT_EQ(NumberText(static_cast<double>(0.1f)), "0.1");
    EXPECT_EQ(NumberText(0.1), "0.1");
    EXPECT_EQ(NumberText(100000.0), "100000");
    EXPECT_EQ(NumberText(1e20), "1e+20");
}

TEST(NumberText, ANounBehindACountIsSingularForOneOnly)
{
    EXPECT_EQ(CountText(0, "sample"), "0 samples");
    EXPECT_EQ(CountText(1, "sample"), "1 sample");
    EXPECT_EQ(CountText(2, "sample"), "2 samples");
}

} // namespace

} // namespace limn
