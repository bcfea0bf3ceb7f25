#pragma once

#include "Paths.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limn/editor_stub/RunLimn.h>
#include <optional>
#include <poll.h>
#include <pty.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>
#include <utmp.h>
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

    Terminal Without(const std::string& variable) const
    {
        Terminal changed = *this;
        changed.m_Variables.emplace_back(variable, std::nullopt);
        return changed;
    }

    /// @param exitCode  receives the exit code; may be null
    std::string Run(std::vector<std::string> args, int* exitCode = nullptr) const
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
        int end = -1; // the program's; with it open here, too, nothing written to it is lost
        if (openpty(&terminal, &end, nullptr, nullptr, &size) != 0)
        {
            throw std::runtime_error("there is no terminal to be had");
        }
        const pid_t child = fork();
        if (child == 0)
        {
            close(terminal);
            login_tty(end);
            setenv("TERM", "xterm", 1);
            unsetenv("NO_COLOR");
            setenv("LIMN_PAGER", "cat", 1); // none
            for (const auto& [name, value] : m_Variables)
            {
                value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
            }
            execv(program.c_str(), words.data());
            _exit(127);
        }
        int status = 0;
        std::string text = ReadUntilItEnds(child, terminal, end, status);
        if (exitCode)
        {
            *exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        }
        close(end);
        close(terminal);
        std::erase(text, '\r'); // a terminal's line ends with both
        return text;
    }

private:
    /// What the child writes. When it has ended a mark is written behind that, so that what a
    /// terminal hands on late is not missed.
    static std::string ReadUntilItEnds(pid_t child, int terminal, int end, int& status)
    {
        constexpr char k_Mark = '\x1f';
        constexpr int k_Patience = 10; // milliseconds
        std::string text;
        bool isRunning = true;
        while (!text.ends_with(k_Mark))
        {
            if (isRunning && waitpid(child, &status, WNOHANG) == child)
            {
                isRunning = false;
                if (write(end, &k_Mark, 1) != 1)
                {
                    throw std::runtime_error("the terminal takes nothing");
                }
            }
            pollfd ready{terminal, POLLIN, 0};
            char bytes[4096];
            if (poll(&ready, 1, k_Patience) > 0)
            {
                const ssize_t count = read(terminal, bytes, sizeof(bytes));
                text.append(bytes, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
            }
        }
        text.pop_back();
        return text;
    }

    unsigned short m_Columns;
    std::vector<std::pair<std::string, std::optional<std::string>>> m_Variables;
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

/// Returns the lines of a text, without their ends.
inline std::vector<std::string> LinesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

inline std::string ReadText(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

} // namespace limn::test
