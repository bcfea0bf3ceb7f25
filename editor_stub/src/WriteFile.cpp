#include "WriteFile.h"

#include <cerrno>
#include <fstream>
#include <limn/shaderlab/Diagnostic.h>
#include <system_error>
#include <unistd.h>

namespace limn
{

void WriteFile(const std::filesystem::path& path, std::string_view content)
{
    const std::filesystem::path temporary = path.string() + ".tmp-" + std::to_string(getpid());
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    std::error_code failure;
    if (stream.fail())
    {
        failure = {errno != 0 ? errno : EIO, std::generic_category()};
    }
    else
    {
        std::filesystem::rename(temporary, path, failure);
    }
    if (failure)
    {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw AssetError(path.string(), {}, "cannot be written: " + failure.message());
    }
}

} // namespace limn
