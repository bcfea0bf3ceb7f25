#include <limn/base/Terminal.h>

#include <charconv>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <sys/ioctl.h>
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

bool isVariableSet(const char* name)
{
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
}

/// Returns the number that a variable is, or 0 if it is no positive number.
std::size_t NumberOf(const char* variable)
{
    constexpr std::size_t k_Most = 100000;
    const char* value = std::getenv(variable);
    const std::string_view text = value ? value : "";
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && number <= k_Most ? number
                                                                                        : 0;
}

/// Returns zeros if the stream leads to no terminal, or its terminal does not tell its size.
winsize SizeOf(const std::ostream& stream)
{
    winsize size{};
    return ioctl(DescriptorOf(stream), TIOCGWINSZ, &size) == 0 ? size : winsize{};
}

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
    const char* terminal = std::getenv("TERM");
    return terminal != nullptr && std::string_view(terminal) == "dumb";
}

bool usesColor(ColorMode mode, const std::ostream& stream)
{
    return mode == ColorMode::Always || (mode == ColorMode::Auto && isTerminal(stream) &&
                                         !isVariableSet("NO_COLOR") && !isDumbTerminal());
}

} // namespace limn
