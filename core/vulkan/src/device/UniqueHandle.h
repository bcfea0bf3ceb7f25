#pragma once

#include "device/Check.h"

#include <utility>

namespace limn::vulkan
{

/// Owns one Vulkan object of a device. A moved-from handle is empty.
template <typename T, void (*Destroy)(VkDevice, T, const VkAllocationCallbacks*)>
class UniqueHandle
{
public:
    UniqueHandle() = default;
    UniqueHandle(VkDevice device, T handle) : m_Device(device), m_Handle(handle) {}
    /// Makes the object.
    /// @param call  the name of `create`, for the error
    /// @param name  the name of the object, likewise
    /// @throws VulkanError
    template <typename Info>
    UniqueHandle(VkDevice device,
                 VkResult (*create)(VkDevice, const Info*, const VkAllocationCallbacks*, T*),
                 const Info& info, const char* call, const std::string& name = {})
        : m_Device(device)
    {
        Check(create(device, &info, nullptr, &m_Handle), call, name);
    }
    UniqueHandle(UniqueHandle&& other) noexcept
        : m_Device(other.m_Device), m_Handle(std::exchange(other.m_Handle, VK_NULL_HANDLE))
    {
    }
    UniqueHandle& operator=(UniqueHandle&& other) noexcept
    {
        std::swap(m_Device, other.m_Device);
        std::swap(m_Handle, other.m_Handle);
        return *this;
    }
    ~UniqueHandle()
    {
        if (m_Handle != VK_NULL_HANDLE)
        {
            Destroy(m_Device, m_Handle, nullptr);
        }
    }

    T get() const { return m_Handle; }
    explicit operator bool() const { return m_Handle != VK_NULL_HANDLE; }

private:
    VkDevice m_Device = VK_NULL_HANDLE;
    T m_Handle = VK_NULL_HANDLE;
};

using UniqueBuffer = UniqueHandle<VkBuffer, vkDestroyBuffer>;
using UniqueCommandPool = UniqueHandle<VkCommandPool, vkDestroyCommandPool>;
using UniqueDescriptorPool = UniqueHandle<VkDescriptorPool, vkDestroyDescriptorPool>;
using UniqueImage = UniqueHandle<VkImage, vkDestroyImage>;
using UniqueImageView = UniqueHandle<VkImageView, vkDestroyImageView>;
using UniqueMemory = UniqueHandle<VkDeviceMemory, vkFreeMemory>;
using UniquePipeline = UniqueHandle<VkPipeline, vkDestroyPipeline>;
using UniquePipelineCache = UniqueHandle<VkPipelineCache, vkDestroyPipelineCache>;
using UniquePipelineLayout = UniqueHandle<VkPipelineLayout, vkDestroyPipelineLayout>;
using UniqueQueryPool = UniqueHandle<VkQueryPool, vkDestroyQueryPool>;
using UniqueSampler = UniqueHandle<VkSampler, vkDestroySampler>;
using UniqueSemaphore = UniqueHandle<VkSemaphore, vkDestroySemaphore>;
using UniqueSetLayout = UniqueHandle<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using UniqueShaderModule = UniqueHandle<VkShaderModule, vkDestroyShaderModule>;

} // namespace limn::vulkan
