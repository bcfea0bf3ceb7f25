#include <limn/volume/YamlNode.h>

#include <fstream>

namespace limn
{

namespace
{

constexpr std::uintmax_t k_MaxBytes = std::uintmax_t{64} * 1024 * 1024;

} // namespace

std::string ReadYamlText(const std::filesystem::path& path)
{
    const std::string file = path.generic_string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
    {
        throw AssetError(file, {}, "there is no such file");
    }
    if (std::filesystem::is_directory(status))
    {
        throw AssetError(file, {}, "is a folder; a YAML file is expected");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > k_MaxBytes)
    {
        throw AssetError(file, {},
                         "has " + std::to_string(size) + " bytes; at most " +
                             std::to_string(k_MaxBytes) + " (64 MiB) are read");
    }
    std::ifstream stream(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(error ? 0 : size), '\0');
    if (error || !stream || !stream.read(text.data(), static_cast<std::streamsize>(size)))
    {
        throw AssetError(file, {}, "cannot be read; check that it is a file you may read");
    }
    return text;
}

std::vector<YamlNode> LoadYamlFile(const std::filesystem::path& path)
{
    return ParseYaml(ReadYamlText(path), path.generic_string());
}

} // namespace limn
