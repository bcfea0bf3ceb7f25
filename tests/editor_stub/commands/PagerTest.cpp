#include "commands/CommandRun.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

const std::vector<std::string> k_Long{"schema", "profile"};
const std::vector<std::string> k_Short{"inspect", "Vignette"};

/// A pager that marks each line that goes through it.
constexpr const char* k_Marks = "sed 's/^/> /'";

} // namespace

TEST(APager, ShowsWhatIsLongerThanTheTerminal)
{
    const Terminal terminal = Terminal(200).With("LIMN_PAGER", k_Marks);
    EXPECT_THAT(terminal.Run(k_Long), testing::StartsWith("> {\n>   \"$schema\": "));
    EXPECT_THAT(terminal.Run(k_Long), testing::EndsWith("\n> }\n"));
    EXPECT_THAT(terminal.Run(k_Short), testing::StartsWith("  Vignette\n"));
    EXPECT_THAT(terminal.Run({"help", "render"}), testing::StartsWith("> Draw a scene"));
    EXPECT_THAT(terminal.Run({}), testing::StartsWith("> limn renders scenes"));
}

TEST(APager, CountsTheLinesThatTheTerminalHas)
{
    const Terminal terminal = Terminal(200).With("LIMN_PAGER", k_Marks);
    EXPECT_THAT(terminal.With("LINES", "3").Run(k_Short), testing::StartsWith(">   Vignette\n"));
    EXPECT_THAT(terminal.With("LINES", "99999").Run(k_Long), testing::StartsWith("{\n"));
}

TEST(APager, IsThePersonsOwn)
{
    const Terminal terminal = Terminal(200).With("PAGER", k_Marks);
    EXPECT_THAT(terminal.Without("LIMN_PAGER").Run(k_Long), testing::StartsWith("> {\n"));
    EXPECT_THAT(terminal.With("LIMN_PAGER", "").Run(k_Long), testing::StartsWith("{\n"));
    EXPECT_THAT(terminal.With("LIMN_PAGER", "cat").Run(k_Long), testing::StartsWith("{\n"));
}

TEST(APager, IsToldToEndByItselfAndToKeepColours)
{
    const Terminal terminal = Terminal(200).With("LIMN_PAGER", "cat >/dev/null; echo $LESS $LV");
    EXPECT_EQ("FRX -c\n", terminal.Without("LESS").Without("LV").Run(k_Long));
    EXPECT_EQ("-S -a\n", terminal.With("LESS", "-S").With("LV", "-a").Run(k_Long));
}

TEST(APager, MayBeLeftEarly)
{
    int exitCode = -1;
    const std::string shown =
        Terminal(200).With("LIMN_PAGER", "head -n 1").Run({"schema", "scene"}, &exitCode);
    EXPECT_EQ("{\n", shown);
    EXPECT_EQ(0, exitCode);
    EXPECT_EQ("", Terminal(200).With("LIMN_PAGER", "true").Run({"schema", "scene"}, &exitCode));
    EXPECT_EQ(0, exitCode);
}

TEST(APager, ThatIsMissingIsReportedAndDoneWithout)
{
    int exitCode = -1;
    const std::string shown =
        Terminal(200).With("LIMN_PAGER", "no-such-pager").Run(k_Long, &exitCode);
    EXPECT_THAT(shown, testing::HasSubstr("no-such-pager"));
    EXPECT_THAT(shown, testing::EndsWith("\n}\n"));
    EXPECT_EQ(0, exitCode);
}

TEST(APager, IsNotForPipesAndDumbTerminals)
{
    const std::string command = "LIMN_PAGER='sed s/^/x/' '" + LimnExecutable() + "' schema profile";
    EXPECT_THAT(RunInPipe(command), testing::StartsWith("{\n"));
    const Terminal terminal = Terminal(200).With("LIMN_PAGER", k_Marks);
    EXPECT_THAT(terminal.With("TERM", "dumb").Run(k_Long), testing::StartsWith("{\n"));
}

TEST(APager, IsNotForPeopleAndVerbsThatWantNone)
{
    const Terminal terminal = Terminal(200).With("LIMN_PAGER", k_Marks);
    EXPECT_THAT(terminal.Run({"schema", "profile", "--no-pager"}), testing::StartsWith("{\n"));
    EXPECT_THAT(terminal.With("LINES", "2").Run({"completion", "bash"}),
                testing::Not(testing::StartsWith(">")));
}

TEST(APager, ComesBeforeTheErrorThatEndsTheVerb)
{
    int exitCode = -1;
    const std::string shown = Terminal(200)
                                  .With("LIMN_PAGER", k_Marks)
                                  .With("LINES", "2")
                                  .Run({"doctor", "--device", "no such device"}, &exitCode);
    EXPECT_THAT(shown, testing::StartsWith("> limn "));
    EXPECT_EQ(3, exitCode);
}

} // namespace limn::test
