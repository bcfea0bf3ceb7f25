#pragma once

#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>
#include <memory>
#include <mutex>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// The error that the machine has no Vulkan driver at all.
class NoDriverError : public VulkanError
{
public:
    NoDriverError();
};

/// The messages of the validation layer. Add may be called on any thread, as the driver chooses.
class ValidationLog
{
public:
    void Add(ValidationMessage message);
    std::vector<ValidationMessage> messages() const;

private:
    mutable std::mutex m_Mutex;
    std::vector<ValidationMessage> m_Messages;
};

/// The Vulkan 1.3 instance with its debug messenger.
class VulkanInstance
{
public:
    /// @throws NoDriverError
    /// @throws VulkanError if the loader is older than 1.3, or the validation layer is requested
    ///     but not installed
    explicit VulkanInstance(bool validation);
    ~VulkanInstance();
    VulkanInstance(const VulkanInstance&) = delete;
    VulkanInstance& operator=(const VulkanInstance&) = delete;

    VkInstance get() const { return m_Instance.get(); }
    bool hasDebugUtils() const { return m_DebugUtils; }
    const ValidationLog& log() const { return m_Log; }
    std::vector<VkPhysicalDevice> PhysicalDevices() const;

private:
    struct DestroyInstance
    {
        void operator()(VkInstance instance) const { vkDestroyInstance(instance, nullptr); }
    };

    void Create(bool validation);
    void CreateMessenger();

    ValidationLog m_Log;
    bool m_DebugUtils = false;
    std::unique_ptr<VkInstance_T, DestroyInstance> m_Instance;
    VkDebugUtilsMessengerEXT m_Messenger = VK_NULL_HANDLE;
};

} // namespace limn::vulkan
