#pragma once

#include "Paths.h"
#include "commands/CommandRun.h"
#include "vulkan/GpuTestDevice.h"

#include <chrono>
#include <functional>
#include <limn/core/Image.h>
#include <signal.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace limn::test
{

/// `limn watch` of s.scene.yaml as a process of its own. Everything waits for what should happen,
/// at most 20 s.
class WatchTest : public GpuTest
{
protected:
    void TearDown() override
    {
        if (m_Child > 0)
        {
            kill(m_Child, SIGKILL);
            waitpid(m_Child, nullptr, 0);
        }
        GpuTest::TearDown();
    }

    std::string Path(const std::string& name) const { return (folder / name).string(); }

    void Start()
    {
        Start("'" + Path("s.scene.yaml") + "' --cache-dir '" + Path("cache") + "' -o '" +
              Path("out.png") + "'");
    }

    void Start(const std::string& arguments) { Start(arguments, "> '" + Path("out") + "'"); }

    void Start(const std::string& arguments, const std::string& out)
    {
        const std::string command = "exec '" + LimnExecutable() + "' watch " + arguments + " " +
                                    out + " 2> '" + Path("err") + "'";
        m_Child = fork();
        if (m_Child == 0)
        {
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
    }

    static bool WaitFor(const std::function<bool()>& isDone)
    {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        bool done = isDone();
        while (!done && std::chrono::steady_clock::now() < end)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            done = isDone();
        }
        return done;
    }

    /// The exit code after a signal; -1 if the process did not end by itself.
    int Stop(int signal)
    {
        kill(m_Child, signal);
        return End();
    }

    /// The exit code of a process that ends by itself; -1 if it does not.
    int End()
    {
        int status = 0;
        const bool isOver = WaitFor([&] { return waitpid(m_Child, &status, WNOHANG) == m_Child; });
        m_Child = isOver ? 0 : m_Child;
        return isOver && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    TemporaryFolder folder;

private:
    pid_t m_Child = 0;
};

} // namespace limn::test
