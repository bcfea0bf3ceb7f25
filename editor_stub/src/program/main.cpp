#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fcntl.h>
#include <iostream>
#include <limn/editor_stub/RunLimn.h>
#include <new>
#include <unistd.h>
#include <vector>

namespace
{

/// Takes the numbers of standard streams that are closed, or the next files to be opened would have
/// them and get what is printed. Opened the wrong way round, they fail as closed ones do.
void TakeClosedStreams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    {
        if (fcntl(stream, F_GETFD) < 0)
        {
            static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
        }
    }
}

std::terminate_handler s_Terminate = nullptr; ///< what it was before

/// The handler says that memory ran out where nobody could catch it: some libraries promise not to
/// throw, and throw then. It must not ask for memory itself.
[[noreturn]] void EndProgram()
{
    try
    {
        if (std::current_exception())
        {
            throw;
        }
    }
    catch (const std::bad_alloc&)
    {
        std::fputs("error: there is not enough memory\n", stderr);
        std::_Exit(static_cast<int>(limn::ExitCode::MachineLacksIt));
    }
    catch (...)
    {
        // as without this
    }
    s_Terminate();
    std::abort();
}

} // namespace

int main(int argc, char** argv)
{
    s_Terminate = std::set_terminate(EndProgram);
    TakeClosedStreams();
    std::signal(SIGXFSZ, SIG_IGN); // what is larger than a file may be is an error with a name
    const std::vector<std::string> args(argv + (argc > 0 ? 1 : 0), argv + argc);
    return limn::RunLimn(args, std::cout, std::cerr);
}
