#include <limn/base/Terminal.h>

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

} // namespace

bool isTerminal(const std::ostream& stream)
{
    return isatty(DescriptorOf(stream)) == 1;
}

std::size_t TerminalWidth(const std::ostream& stream)
{
    winsize size{};
    const bool isKnown = ioctl(DescriptorOf(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return isKnown ? size.ws_col : 80;
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
