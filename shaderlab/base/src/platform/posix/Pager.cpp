#include <limn/base/Pager.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace limn
{

namespace
{

/// Leaves a signal without effect as long as it lives.
class WithoutSignal
{
public:
    explicit WithoutSignal(int signal) : m_Signal(signal), m_Before(std::signal(signal, SIG_IGN)) {}
    ~WithoutSignal() { std::signal(m_Signal, m_Before); }
    WithoutSignal(const WithoutSignal&) = delete;
    WithoutSignal& operator=(const WithoutSignal&) = delete;

private:
    int m_Signal;
    void (*m_Before)(int);
};

/// Returns the environment of this process, and in addition what a pager needs.
std::vector<char*> PagerVariables()
{
    static char s_Less[] = "LESS=FRX";
    static char s_Lv[] = "LV=-c"; // lv shows colours with it
    std::vector<char*> variables;
    for (char** variable = environ; *variable; ++variable)
    {
        variables.push_back(*variable);
    }
    if (!std::getenv("LESS"))
    {
        variables.push_back(s_Less);
    }
    if (!std::getenv("LV"))
    {
        variables.push_back(s_Lv);
    }
    variables.push_back(nullptr);
    return variables;
}

/// Starts the command in a shell with `input` as its standard input. Returns -1 if that fails.
pid_t StartPager(const std::string& command, int input)
{
    std::string script = command;
    char shell[] = "/bin/sh";
    char option[] = "-c";
    char* words[] = {shell, option, script.data(), nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    std::vector<char*> variables = PagerVariables();
    pid_t child = -1;
    const int error = posix_spawn(&child, shell, &actions, nullptr, words, variables.data());
    posix_spawn_file_actions_destroy(&actions);
    return error == 0 ? child : -1;
}

void WriteAll(int file, std::string_view text)
{
    while (!text.empty())
    {
        const ssize_t count = write(file, text.data(), text.size());
        if (count < 0 && errno != EINTR)
        {
            return; // the reader has left
        }
        text.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
}

} // namespace

std::string PagerCommand()
{
    const char* own = std::getenv("LIMN_PAGER");
    const char* usual = own ? own : std::getenv("PAGER");
    // Many containers have no less, and nobody asked for it there.
    const std::string command = usual ? usual : "command -v less >/dev/null || exec cat; less";
    return command == "cat" ? "" : command;
}

bool ShowInPager(const std::string& command, std::string_view text)
{
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0)
    {
        return false;
    }
    const pid_t child = StartPager(command, ends[0]);
    close(ends[0]);
    int status = 0;
    if (child > 0)
    {
        const WithoutSignal pipe(SIGPIPE);
        const WithoutSignal interrupt(SIGINT);
        const WithoutSignal quit(SIGQUIT);
        WriteAll(ends[1], text);
        close(ends[1]);
        while (waitpid(child, &status, 0) == -1 && errno == EINTR)
        {
        }
    }
    else
    {
        close(ends[1]);
    }
    constexpr int k_NoSuchProgram = 127;
    return child > 0 && !(WIFEXITED(status) && WEXITSTATUS(status) == k_NoSuchProgram);
}

} // namespace limn
