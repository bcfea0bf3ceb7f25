#include "programs/PipelineCacheFile.h"

#include "device/Check.h"
#include <algorithm>
#include <cstring>
#include <limn/base/HashContent.h>
#include <limn/base/ReadFile.h>
#include <limn/base/WriteFile.h>

namespace limn::vulkan
{

namespace
{

struct FileHeader
{
    char magic[8];
    std::uint64_t size;
    std::uint64_t checksum;
};
constexpr char k_Magic[8] = {'L', 'I', 'M', 'N', 'P', 'C', '0', '1'};

/// One file a device and driver: Vulkan's pipelineCacheUUID changes with both.
std::string FileName(VkPhysicalDevice device)
{
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    constexpr const char* k_Digits = "0123456789abcdef";
    std::string name = "pipelines-";
    for (const std::uint8_t byte : properties.pipelineCacheUUID)
    {
        name += k_Digits[byte >> 4];
        name += k_Digits[byte & 15];
    }
    return name + ".bin";
}

/// Drivers are not obliged to survive another device's data.
bool IsOfThisDevice(const std::vector<char>& payload, VkPhysicalDevice device)
{
    VkPipelineCacheHeaderVersionOne header{};
    if (payload.size() < sizeof(header))
    {
        return false;
    }
    std::memcpy(&header, payload.data(), sizeof(header));
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    return header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           header.vendorID == properties.vendorID && header.deviceID == properties.deviceID &&
           std::memcmp(header.pipelineCacheUUID, properties.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

} // namespace

std::vector<char> WrapCacheFile(const std::vector<char>& payload)
{
    FileHeader header{};
    std::memcpy(header.magic, k_Magic, sizeof(k_Magic));
    header.size = payload.size();
    header.checksum = HashContent({payload.data(), payload.size()});
    std::vector<char> file(sizeof(header) + payload.size());
    std::memcpy(file.data(), &header, sizeof(header));
    std::copy(payload.begin(), payload.end(), file.begin() + sizeof(header));
    return file;
}

std::vector<char> UnwrapCacheFile(const std::vector<char>& file)
{
    FileHeader header{};
    if (file.size() < sizeof(header))
    {
        return {};
    }
    std::memcpy(&header, file.data(), sizeof(header));
    const char* payload = file.data() + sizeof(header);
    const std::size_t size = file.size() - sizeof(header);
    if (std::memcmp(header.magic, k_Magic, sizeof(k_Magic)) != 0 || header.size != size ||
        header.checksum != HashContent({payload, size}))
    {
        return {};
    }
    return {payload, payload + size};
}

PipelineCacheFile::PipelineCacheFile(const VulkanContext& context,
                                     const std::filesystem::path& folder)
    : m_Context(context)
{
    std::vector<char> payload;
    if (!folder.empty())
    {
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        if (error)
        {
            throw VulkanError("the pipeline cache folder '" + folder.string() +
                              "' cannot be made: " + error.message());
        }
        m_Path = folder / FileName(context.physicalDevice());
        const std::string file = TryReadFile(m_Path, k_MaxDataBytes).bytes;
        payload = UnwrapCacheFile({file.begin(), file.end()});
        if (!IsOfThisDevice(payload, context.physicalDevice()))
        {
            payload.clear();
        }
    }
    auto info = Make<VkPipelineCacheCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO);
    info.initialDataSize = payload.size();
    info.pInitialData = payload.data();
    m_Cache = UniquePipelineCache{context.device(), vkCreatePipelineCache, info,
                                  "vkCreatePipelineCache", m_Path.string()};
}

PipelineCacheFile::~PipelineCacheFile()
{
    if (m_Path.empty())
    {
        return;
    }
    try
    {
        Save();
    }
    catch (const std::exception&)
    {
        // A full disk costs the next run some compiling, and must not end this one.
    }
}

void PipelineCacheFile::Save() const
{
    std::size_t size = 0;
    Check(vkGetPipelineCacheData(m_Context.device(), m_Cache.get(), &size, nullptr),
          "vkGetPipelineCacheData");
    std::vector<char> payload(size);
    Check(vkGetPipelineCacheData(m_Context.device(), m_Cache.get(), &size, payload.data()),
          "vkGetPipelineCacheData");
    payload.resize(size);
    const std::vector<char> file = WrapCacheFile(payload);

    // Best effort: without the file the next run compiles again.
    std::error_code failure;
    if (std::filesystem::is_symlink(m_Path, failure)) // nothing of limn's, and not to be followed
    {
        std::filesystem::remove(m_Path, failure);
    }
    failure = TryWriteFile(m_Path, {file.data(), file.size()});
}

} // namespace limn::vulkan
