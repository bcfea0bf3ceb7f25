#pragma once

#include "device/UniqueHandle.h"
#include "device/VulkanContext.h"

namespace limn::vulkan
{

/// The driver's cache of compiled pipelines, kept in a file of `folder` between runs.
class PipelineCacheFile
{
public:
    /// @param folder  made if absent; empty = the cache lives in memory only
    /// @throws VulkanError if the folder cannot be made. A file that is damaged or of another
    ///         driver is ignored, since it can be made anew.
    PipelineCacheFile(const VulkanContext& context, const std::filesystem::path& folder);
    ~PipelineCacheFile(); ///< writes the file whole or not at all
    PipelineCacheFile(const PipelineCacheFile&) = delete;
    PipelineCacheFile& operator=(const PipelineCacheFile&) = delete;

    VkPipelineCache get() const { return m_Cache.get(); }

private:
    void Save() const;

    const VulkanContext& m_Context;
    std::filesystem::path m_Path;
    UniquePipelineCache m_Cache;
};

/// `payload` with what it takes to recognise damage: a magic word, the length and a checksum.
std::vector<char> WrapCacheFile(const std::vector<char>& payload);

/// The payload again; empty if `file` is not whole.
std::vector<char> UnwrapCacheFile(const std::vector<char>& file);

} // namespace limn::vulkan
