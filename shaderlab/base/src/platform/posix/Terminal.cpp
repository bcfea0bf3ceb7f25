#include <limn/base/Terminal.h>

#include <limn/base/ParseWhole.h>
#include <limn/base/WriteFile.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{

namespace
{

/// -1 for a stream that is none of the process's own.
int DescriptorOf(const std::ostream& stream)
{
    return &stream == &std::cout ? STDOUT_FILENO : &stream == &std::cerr ? STDERR_FILENO : -1;
}

/// Returns the value of a variable, or "" if it is not set.
std::string_view Variable(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// Returns the number that a variable is, or 0 if it is no positive number.
std::size_t NumberOf(const char* variable)
{
    constexpr std::size_t k_Most = 100000;
    const std::size_t number = ParseWhole<std::size_t>(Variable(variable)).value_or(0);
    return number <= k_Most ? number : 0;
}

/// Returns zeros if the stream leads to no terminal, or its terminal does not tell its size.
winsize SizeOf(const std::ostream& stream)
{
    winsize size{};
    return ioctl(DescriptorOf(stream), TIOCGWINSZ, &size) == 0 ? size : winsize{};
}

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

/// Returns the first number that is not 0.
std::size_t FirstOf(std::size_t first, std::size_t second, std::size_t third)
{
    return first > 0 ? first : second > 0 ? second : third;
}

} // namespace

bool isTerminal(const std::ostream& stream)
{
    return isatty(DescriptorOf(stream)) == 1;
}

std::size_t TerminalWidth(const std::ostream& stream)
{
    return FirstOf(NumberOf("COLUMNS"), SizeOf(stream).ws_col, 80);
}

std::size_t TerminalHeight(const std::ostream& stream)
{
    return FirstOf(NumberOf("LINES"), SizeOf(stream).ws_row, 24);
}

bool isDumbTerminal()
{
    return Variable("TERM") == "dumb";
}

bool usesColor(ColorMode mode, const std::ostream& stream)
{
    return mode == ColorMode::Always || (mode == ColorMode::Auto && isTerminal(stream) &&
                                         Variable("NO_COLOR").empty() && !isDumbTerminal());
}

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
    // The pager lv shows colours with -c.
    const std::string script = "export LESS=\"${LESS-FRX}\" LV=\"${LV--c}\"; " + command;
    std::FILE* const pager = popen(script.c_str(), "we");
    if (!pager)
    {
        return false;
    }
    const WithoutSignal pipe(SIGPIPE);
    const WithoutSignal interrupt(SIGINT);
    const WithoutSignal quit(SIGQUIT);
    static_cast<void>(WriteToDescriptor(fileno(pager), text)); // fails once the reader has left
    const int status = pclose(pager);
    constexpr int k_NoSuchProgram = 127;
    return !(WIFEXITED(status) && WEXITSTATUS(status) == k_NoSuchProgram);
}

} // namespace limn
