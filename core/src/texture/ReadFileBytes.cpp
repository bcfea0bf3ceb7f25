#include "texture/ReadFileBytes.h"

#include <cerrno>
#include <cstdio>
#include <limn/shaderlab/Diagnostic.h>
#include <memory>
#include <system_error>

namespace limn
{

namespace
{

struct FileCloser
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void FailToRead(const std::filesystem::path& path)
{
    throw AssetError(path.string(), {},
                     "cannot be read: " + std::generic_category().message(errno));
}

} // namespace

std::vector<std::byte> ReadFileBytes(const std::filesystem::path& path)
{
    const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path.c_str(), "rb"));
    if (!file)
    {
        FailToRead(path);
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
        FailToRead(path);
    }
    return bytes;
}

} // namespace limn
