#include "report/figures/TimeLeft.h"
#include "report/figures/Numbers.h"

#include <gtest/gtest.h>
#include <limits>

namespace limn::test
{

namespace
{

using study::TimeLeft;

class TimeLeftTest : public testing::Test
{
protected:
    TimeLeft Make(std::size_t steps, double work)
    {
        return TimeLeft(steps, work, [this] { return m_Now; });
    }
    void Pass(int seconds) { m_Now += std::chrono::seconds(seconds); }

private:
    std::chrono::steady_clock::time_point m_Now;
};

TEST_F(TimeLeftTest, IsUnknownBeforeAnythingIsDone)
{
    TimeLeft left = Make(4, 4.0);
    Pass(10);
    EXPECT_FALSE(left.seconds());
    EXPECT_EQ("[....................]   0 %, 0 of 4: first", left.Line("first"));
}

TEST_F(TimeLeftTest, IsAtTheSpeedSoFarByWorkNotByStepCount)
{
    TimeLeft left = Make(3, 1.0 + 2.0 + 5.0);
    Pass(6);
    left.Add(1.0); // 6 s a unit, seven units left
    EXPECT_DOUBLE_EQ(42.0, left.seconds().value());
    Pass(6);
    left.Add(2.0); // 12 s for three units, five left
    EXPECT_DOUBLE_EQ(20.0, left.seconds().value());
    EXPECT_DOUBLE_EQ(0.375, left.done());
    EXPECT_EQ("[#######.............]  37 %, 2 of 3, 20 s left: cost/A", left.Line("cost/A"));
}

TEST_F(TimeLeftTest, IsNotShortenedByWhatAnEarlierRunDid)
{
    TimeLeft left = Make(100, 100.0);
    for (int i = 0; i < 90; ++i)
    {
        left.Skip(1.0);
    }
    EXPECT_FALSE(left.seconds());
    Pass(30);
    left.Add(1.0);
    EXPECT_DOUBLE_EQ(270.0, left.seconds().value());
    EXPECT_EQ("[##################..]  91 %, 91 of 100, 4 min 30 s left: x", left.Line("x"));
}

TEST_F(TimeLeftTest, EndsAtNothingLeft)
{
    TimeLeft left = Make(1, 2.0);
    Pass(5);
    left.Add(2.0);
    EXPECT_EQ("[####################] 100 %, 1 of 1, less than 1 s left: x", left.Line("x"));
    left.Add(2.0); // more than was said
    EXPECT_DOUBLE_EQ(1.0, left.done());
    EXPECT_DOUBLE_EQ(0.0, left.seconds().value());
    EXPECT_DOUBLE_EQ(1.0, Make(0, 0.0).done());
}

TEST(ReadableNumber, HasThreeSignificantDigits)
{
    using study::Readable;
    EXPECT_EQ("0", Readable(0.0));
    EXPECT_EQ("0.00312", Readable(0.0031234));
    EXPECT_EQ("0.1", Readable(0.1));
    EXPECT_EQ("0.123", Readable(0.1234));
    EXPECT_EQ("14.7", Readable(14.66));
    EXPECT_EQ("-1.5", Readable(-1.5));
    EXPECT_EQ("8", Readable(8.0));
    EXPECT_EQ("100", Readable(99.96));
    EXPECT_EQ("12346", Readable(12345.6));
    EXPECT_EQ("3.1e-05", Readable(3.14e-5));
    EXPECT_EQ("1.0e+10", Readable(1e10));
    EXPECT_EQ("NaN", Readable(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ("-infinite", Readable(-std::numeric_limits<double>::infinity()));
}

TEST(ExactNumber, ReadsBackAsTheSame)
{
    for (const double value : {0.1, 1.0 / 3.0, 2.5e-300, 1.7976931348623157e308, -0.0, 1e-7})
    {
        EXPECT_EQ(value, std::stod(study::Exact(value))) << study::Exact(value);
    }
    EXPECT_EQ("nan", study::Exact(-std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ("-inf", study::Exact(-std::numeric_limits<double>::infinity()));
}

TEST(DurationText, HasTheTwoLargestUnits)
{
    EXPECT_EQ("less than 1 s", study::Duration(0.9));
    EXPECT_EQ("1 s", study::Duration(1.0));
    EXPECT_EQ("1 min", study::Duration(60.0));
    EXPECT_EQ("1 min 20 s", study::Duration(79.6));
    EXPECT_EQ("2 h 3 min", study::Duration(2 * 3600 + 3 * 60 + 29));
    EXPECT_EQ("1 h", study::Duration(3601));
    EXPECT_EQ("less than 1 s", study::Duration(std::numeric_limits<double>::quiet_NaN()));
}

} // namespace

} // namespace limn::test
