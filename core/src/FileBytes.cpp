#include "FileBytes.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <limn/shaderlab/Diagnostic.h>
#include <memory>
#include <string>
#include <system_error>
#include <unistd.h>

namespace limn
{

namespace
{

struct FileCloser
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

[[noreturn]] void Fail(const std::filesystem::path& path, const char* verb, std::error_code reason)
{
    throw AssetError(path.string(), {}, std::string("cannot be ") + verb + ": " + reason.message());
}

std::error_code LastError()
{
    return {errno, std::generic_category()};
}

std::filesystem::path TemporaryBeside(const std::filesystem::path& path)
{
    static std::atomic<unsigned> count{0};
    std::filesystem::path temporary = path;
    temporary += ".tmp-" + std::to_string(getpid()) + "-" + std::to_string(++count);
    return temporary;
}

std::error_code WriteNew(const std::filesystem::path& path, const std::vector<std::byte>& bytes)
{
    File file(std::fopen(path.c_str(), "wbx"));
    if (!file)
    {
        return LastError();
    }
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    const std::error_code reason = written ? std::error_code{} : LastError();
    // The last bytes go out when the file is closed, so a full disk may show only then.
    const bool closed = std::fclose(file.release()) == 0;
    return written && !closed ? LastError() : reason;
}

} // namespace

std::vector<std::byte> ReadFileBytes(const std::filesystem::path& path)
{
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file)
    {
        Fail(path, "read", LastError());
    }
    std::vector<std::byte> bytes;
    std::vector<std::byte> chunk(std::size_t{1} << 16);
    while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get()))
    {
        bytes.insert(bytes.end(), chunk.begin(),
                     chunk.begin() + static_cast<std::ptrdiff_t>(count));
    }
    if (std::ferror(file.get()) != 0)
    {
        Fail(path, "read", LastError());
    }
    return bytes;
}

void WriteFileAtomically(const std::filesystem::path& path, const std::vector<std::byte>& bytes)
{
    const std::filesystem::path temporary = TemporaryBeside(path);
    std::error_code failure = WriteNew(temporary, bytes);
    if (!failure)
    {
        std::filesystem::rename(temporary, path, failure);
    }
    if (failure)
    {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        Fail(path, "written", failure);
    }
}

} // namespace limn
