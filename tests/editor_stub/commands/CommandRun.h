#pragma once

#include "Paths.h"
#include "TemporaryFolder.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <limn/editor_stub/RunLimn.h>
#include <pty.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
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

/// All that `limn`, a process of its own, writes to a terminal, in lines that end with '\n'.
class Terminal
{
public:
    explicit Terminal(unsigned short columns) : m_Columns(columns) {}

    Terminal With(const std::string& variable, const std::string& value) const
    {
        Terminal changed = *this;
        changed.m_Variables.emplace_back(variable, value);
        return changed;
    }

    std::string Run(std::vector<std::string> args) const
    {
        args.insert(args.begin(), "limn");
        std::vector<char*> words;
        for (std::string& arg : args)
        {
            words.push_back(arg.data());
        }
        words.push_back(nullptr);
        const std::string program = LimnExecutable();
        winsize size{24, m_Columns, 0, 0};
        int terminal = -1;
        const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
        if (child == 0)
        {
            setenv("TERM", "xterm", 1);
            unsetenv("NO_COLOR");
            for (const auto& [name, value] : m_Variables)
            {
                setenv(name.c_str(), value.c_str(), 1);
            }
            execv(program.c_str(), words.data());
            _exit(127);
        }
        std::string text;
        char bytes[4096];
        for (ssize_t count = read(terminal, bytes, sizeof(bytes)); count > 0;
             count = read(terminal, bytes, sizeof(bytes)))
        {
            text.append(bytes, static_cast<std::size_t>(count));
        }
        waitpid(child, nullptr, 0);
        close(terminal);
        std::erase(text, '\r'); // a terminal's line ends with both
        return text;
    }

private:
    unsigned short m_Columns;
    std::vector<std::pair<std::string, std::string>> m_Variables;
};

/// What a shell command writes to a pipe.
inline std::string RunInPipe(const std::string& command)
{
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    char bytes[4096];
    for (std::size_t count = fread(bytes, 1, sizeof(bytes), pipe); count > 0;
         count = fread(bytes, 1, sizeof(bytes), pipe))
    {
        text.append(bytes, count);
    }
    pclose(pipe);
    return text;
}

inline std::string ReadText(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

} // namespace limn::test
