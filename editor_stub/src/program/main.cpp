#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limn/base/PrepareProcess.h>
#include <limn/editor_stub/RunLimn.h>
#include <new>
#include <vector>

namespace
{

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
    limn::PrepareProcess();
    const std::vector<std::string> args(argv + (argc > 0 ? 1 : 0), argv + argc);
    return limn::RunLimn(args, std::cout, std::cerr);
}
