#include "assets/GltfBufferFiles.h"

#include <charconv>
#include <limn/base/ReadFile.h>
#include <nlohmann/json.hpp>
#include <string_view>

namespace limn
{

namespace
{

/// "my%20mesh.bin" → "my mesh.bin"
std::string DecodeUri(std::string_view uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i)
    {
        const std::string_view digits = uri[i] == '%' ? uri.substr(i + 1, 2) : "";
        unsigned char decoded = 0;
        const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), decoded, 16);
        const bool isCode = digits.size() == 2 && end.ptr == digits.data() + 2;
        text += isCode ? static_cast<char>(decoded) : uri[i];
        i += isCode ? 2 : 0;
    }
    return text;
}

} // namespace

std::set<std::filesystem::path> GltfBufferFiles(const std::filesystem::path& path)
{
    std::set<std::filesystem::path> files;
    const auto json =
        nlohmann::json::parse(TryReadFile(path, k_MaxDataBytes).bytes, nullptr, false);
    if (!json.is_object() || !json.contains("buffers") || !json["buffers"].is_array())
    {
        return files;
    }
    for (const nlohmann::json& buffer : json["buffers"])
    {
        const bool hasUri =
            buffer.is_object() && buffer.contains("uri") && buffer["uri"].is_string();
        const std::string uri = hasUri ? buffer["uri"].get<std::string>() : std::string();
        if (!uri.empty() && !uri.starts_with("data:"))
        {
            files.insert((path.parent_path() / DecodeUri(uri)).lexically_normal());
        }
    }
    return files;
}

} // namespace limn
