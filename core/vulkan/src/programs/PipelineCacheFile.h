#pragma once

#include "device/UniqueHandle.h"
#include "device/VulkanContext.h"

namespace limn::vulkan
{

/// The driver's cache of compiled pipelines, kept in a file of `folder` between runs.
class PipelineCacheFile
{
public:
    /// @param folder  is made if absent; empty = the cache is only in memory
    /// @throws VulkanError if the folder cannot be made. A file that is damaged or of another
    ///     driver is ignored, because it can be made again.
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

/// Returns `payload` with a magic word, its length and a checksum, so that damage can be
/// recognised.
std::vector<char> WrapCacheFile(const std::vector<char>& payload);

/// Returns the payload of a file, or an empty list if `file` is not whole.
std::vector<char> UnwrapCacheFile(const std::vector<char>& file);

} // namespace limn::vulkan
