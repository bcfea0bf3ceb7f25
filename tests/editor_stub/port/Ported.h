#pragma once

#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"

#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace limn::test
{

/// What `limn port` made, in the folder out.
struct Ported
{
    CommandRun run;
    std::string header;
    std::string source;
    std::string report;
};

inline Ported Port(const std::vector<std::string>& files, const std::string& feature)
{
    std::vector<std::string> arguments{"port"};
    arguments.insert(arguments.end(), files.begin(), files.end());
    arguments.insert(arguments.end(), {"-o", "out"});
    Ported ported;
    ported.run = RunCommand(arguments);
    EXPECT_EQ(0, ported.run.exitCode) << ported.run.err;
    ported.header = ReadText("out/" + feature + ".h");
    ported.source = ReadText("out/" + feature + ".cpp");
    ported.report = ReadText("out/PORTING.md");
    return ported;
}

/// One of limn's own C# files.
inline std::string Sample(const std::string& name)
{
    return SourcePath("tests/editor_stub/data/port/" + name);
}

inline void ExpectAll(const std::string& text, const std::vector<std::string>& parts)
{
    for (const std::string& part : parts)
    {
        EXPECT_THAT(text, testing::HasSubstr(part));
    }
}

} // namespace limn::test
