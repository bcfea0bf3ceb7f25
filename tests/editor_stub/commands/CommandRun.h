#pragma once

#include "TemporaryFolder.h"

#include <fstream>
#include <iterator>
#include <limn/editor_stub/RunLimn.h>
#include <sstream>
#include <vector>

namespace limn::test
{

/// What a run of the command line gave.
struct CommandRun
{
    int exitCode = -1;
    std::string out;
    std::string err;
};

/// Runs `limn` inside this process, with a cache folder that is the process's own.
inline CommandRun RunCommand(const std::vector<std::string>& args)
{
    static const TemporaryFolder cache;
    setenv("XDG_CACHE_HOME", (cache / "").c_str(), 1);
    std::ostringstream out;
    std::ostringstream err;
    const int exitCode = RunLimn(args, out, err);
    return {exitCode, out.str(), err.str()};
}

inline std::string ReadText(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

} // namespace limn::test
