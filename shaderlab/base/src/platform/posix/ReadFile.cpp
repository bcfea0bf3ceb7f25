#include <limn/base/ReadFile.h>

#include "platform/posix/FileDescriptor.h"

#include <limn/base/Diagnostic.h>

#include <algorithm>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>

namespace limn
{

namespace
{

/// @throws std::system_error for what the machine lacks: the file may be as good as any
std::string ReadProblem(const std::filesystem::path& path, int error)
{
    if (error == EMFILE || error == ENFILE || error == ENOMEM)
    {
        throw std::system_error(error, std::generic_category(), path.string() + " cannot be read");
    }
    return error == ENOENT  ? "there is no such file"
           : error == ELOOP ? "this is a link that leads back to itself"
                            : "the file cannot be read: " + std::generic_category().message(error);
}

/// "" for a regular file.
std::string KindProblem(const struct stat& status)
{
    const char* kind = S_ISDIR(status.st_mode)    ? "a folder"
                       : S_ISFIFO(status.st_mode) ? "a named pipe"
                       : S_ISSOCK(status.st_mode) ? "a socket"
                       : S_ISREG(status.st_mode)  ? nullptr
                                                  : "a device";
    return kind ? std::string("this is ") + kind + "; a file is expected" : std::string();
}

std::string SizeText(std::uintmax_t bytes)
{
    const std::uintmax_t mebibytes = bytes >> 20;
    return std::to_string(bytes) +
           (mebibytes << 20 == bytes ? " (" + std::to_string(mebibytes) + " MiB)" : "");
}

/// Reads until the end, whatever size the file said to have: it may grow, and those in /proc say 0.
FileContent ReadAll(int descriptor, const std::filesystem::path& path, std::uintmax_t expected,
                    std::uintmax_t limit)
{
    FileContent content;
    for (std::size_t size = 0;;)
    {
        const std::uintmax_t room = std::max<std::uintmax_t>(expected, size) + 4096;
        content.bytes.resize(static_cast<std::size_t>(std::min(room, limit + 1)));
        const ssize_t count =
            read(descriptor, content.bytes.data() + size, content.bytes.size() - size);
        if (count < 0 && errno != EINTR)
        {
            return {{}, ReadProblem(path, errno)};
        }
        size += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
        if (count == 0)
        {
            content.bytes.resize(size);
            return content;
        }
        if (size > limit)
        {
            return {{},
                    "the file has more than " + SizeText(limit) + " bytes, the most that are read"};
        }
    }
}

} // namespace

FileContent TryReadFile(const std::filesystem::path& path, std::uintmax_t limit)
{
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0)
    {
        return {{}, ReadProblem(path, errno)};
    }
    if (std::string problem = KindProblem(status); !problem.empty())
    {
        return {{}, std::move(problem)};
    }
    // Should a pipe take the file's place meanwhile, opening it must not wait for a writer.
    const FileDescriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!file.isOpen() || fstat(file.get(), &status) != 0)
    {
        return {{}, ReadProblem(path, errno)};
    }
    if (std::string problem = KindProblem(status); !problem.empty())
    {
        return {{}, std::move(problem)};
    }
    const auto size = static_cast<std::uintmax_t>(status.st_size);
    if (size > limit)
    {
        return {{},
                "the file has " + std::to_string(size) + " bytes; at most " + SizeText(limit) +
                    " are read"};
    }
    return ReadAll(file.get(), path, size, limit);
}

std::string ReadFile(const std::filesystem::path& path, std::uintmax_t limit)
{
    FileContent content = TryReadFile(path, limit);
    if (!content.isRead())
    {
        throw AssetError(path.generic_string(), {}, std::move(content.problem));
    }
    return std::move(content.bytes);
}

} // namespace limn
