#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/CurrentCamera.h>
#include <limn/core/Debug.h>
#include <limn/core/RenderingData.h>
#include <stdexcept>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

/// Takes what is logged as long as it lives.
class LogTaker
{
public:
    LogTaker()
    {
        s_Taken.clear();
        SetLogSink([](const LogMessage& message) { s_Taken.push_back(message); });
    }
    ~LogTaker() { SetLogSink(nullptr); }
    LogTaker(const LogTaker&) = delete;
    LogTaker& operator=(const LogTaker&) = delete;

    static std::vector<std::string> texts()
    {
        std::vector<std::string> result;
        for (const LogMessage& message : s_Taken)
        {
            result.push_back(message.text);
        }
        return result;
    }
    static const LogMessage& last() { return s_Taken.back(); }

private:
    static inline std::vector<LogMessage> s_Taken;
};

} // namespace

TEST(Debug, WritesValuesAsCSharpDoes)
{
    const LogTaker taker;
    Debug::Log("text");
    Debug::Log(std::string("a string"));
    Debug::Log(3);
    Debug::Log(0.1f);
    Debug::Log(true);
    Debug::Log(Vector2(1.0f, 2.5f));
    Debug::Log(Color(1.0f, 0.5f, 0.0f));
    EXPECT_THAT(LogTaker::texts(), ElementsAre("text", "a string", "3", "0.1", "True",
                                               "(1.00, 2.50)", "RGBA(1.000, 0.500, 0.000, 1.000)"));
}

TEST(Debug, PutsValuesIntoAFormat)
{
    const LogTaker taker;
    Debug::LogFormat("{0} of {1}, {{as it is}}", 1, "two");
    Debug::LogWarningFormat("{0:F2} {0:0.0} {0}", 1.25);
    EXPECT_THAT(LogTaker::texts(), ElementsAre("1 of two, {as it is}", "1.25 1.2 1.25"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { Debug::LogFormat("{1}", 0); }),
                test::Mentions("LogFormat '{1}'", "no value {1}", "1 value,"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { Debug::LogFormat("{0", 0); }),
                test::Mentions("LogFormat '{0'", "not closed", "twice"));
}

TEST(Debug, TellsKindsApart)
{
    const LogTaker taker;
    Debug::LogWarning("w", 1);
    EXPECT_EQ(LogTaker::last().type, LogType::Warning);
    Debug::LogErrorFormat("e");
    EXPECT_EQ(LogTaker::last().type, LogType::Error);
    Debug::LogException(std::runtime_error("x"));
    EXPECT_EQ(LogTaker::last().type, LogType::Exception);
    EXPECT_EQ(LogTaker::last().text, "x");
    Debug::Assert(true, "no");
    EXPECT_EQ(LogTaker::last().text, "x");
    Debug::Assert(false, "yes");
    EXPECT_EQ(LogTaker::last().type, LogType::Assert);
    EXPECT_EQ(LogTaker::last().text, "yes");
}

TEST(Debug, IsNotedWhereACameraIsRendered)
{
    const LogTaker taker;
    RenderReport report;
    RenderingData data;
    data.report = &report;
    Debug::Log("before");
    EXPECT_FALSE(LogTaker::last().isNoted);
    {
        const CurrentCamera camera(data);
        EXPECT_EQ(CurrentCamera::renderingData(), &data);
        Debug::Log("within");
        EXPECT_TRUE(LogTaker::last().isNoted);
    }
    EXPECT_EQ(CurrentCamera::renderingData(), nullptr);
    Debug::Log("behind");
    EXPECT_THAT(report.notes, ElementsAre("within"));
    EXPECT_THAT(LogTaker::texts(), ElementsAre("before", "within", "behind"));
}

TEST(Debug, GoesToStderrWhereNobodyListens)
{
    testing::internal::CaptureStderr();
    Debug::LogWarning("look out");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: look out\n");
}

} // namespace limn
