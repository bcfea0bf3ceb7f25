#include <limn/base/PrepareProcess.h>

#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace limn
{

void PrepareProcess()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    {
        if (fcntl(stream, F_GETFD) < 0)
        {
            // Opened the wrong way round, it fails as a closed one does.
            static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
        }
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace limn
