#include <limn/shaderlab/WriteFile.h>

#include <limn/shaderlab/Diagnostic.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <unistd.h>

namespace limn
{

namespace
{

struct FileCloser
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};

std::error_code LastError()
{
    return {errno, std::generic_category()};
}

std::filesystem::path TemporaryBeside(const std::filesystem::path& path)
{
    static std::atomic<unsigned> s_Count{0};
    std::filesystem::path temporary = path;
    temporary += ".tmp-" + std::to_string(getpid()) + "-" + std::to_string(++s_Count);
    return temporary;
}

std::error_code WriteNew(const std::filesystem::path& path, std::string_view bytes)
{
    std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path.c_str(), "wbx"));
    if (!file)
    {
        return LastError();
    }
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
    {
        return LastError();
    }
    // The last bytes go out when the file is closed, so a full disk may show only then.
    return std::fclose(file.release()) == 0 ? std::error_code{} : LastError();
}

/// Removes a file when it goes, unless it has been moved away.
struct TemporaryFile
{
    std::filesystem::path path;

    explicit TemporaryFile(std::filesystem::path p) : path(std::move(p)) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};

std::error_code Replace(const std::filesystem::path& path, const std::filesystem::path& by)
{
    std::error_code failure;
    const std::filesystem::file_status old = std::filesystem::status(path, failure);
    if (std::filesystem::is_regular_file(old))
    {
        std::filesystem::permissions(by, old.permissions(), failure);
    }
    std::filesystem::rename(by, path, failure);
    return failure;
}

} // namespace

std::error_code TryWriteFile(const std::filesystem::path& path, std::string_view bytes,
                             const std::function<void()>& beforeReplace)
{
    const TemporaryFile temporary(TemporaryBeside(path));
    if (const std::error_code failure = WriteNew(temporary.path, bytes))
    {
        return failure;
    }
    if (beforeReplace)
    {
        beforeReplace();
    }
    return Replace(path, temporary.path);
}

void WriteFile(const std::filesystem::path& path, std::string_view bytes,
               const std::function<void()>& beforeReplace)
{
    if (const std::error_code failure = TryWriteFile(path, bytes, beforeReplace))
    {
        throw AssetError(path.string(), {}, "cannot be written: " + failure.message());
    }
}

} // namespace limn
