#include "text/TextFile.h"

#include <fstream>
#include <iterator>

namespace limn
{

std::optional<std::string> ReadTextFile(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
    {
        return std::nullopt;
    }
    std::ifstream stream(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream)
    {
        return std::nullopt;
    }
    return text;
}

} // namespace limn
