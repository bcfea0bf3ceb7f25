#pragma once

#include "device/DeviceFeatures.h"
#include "device/VulkanInstance.h"
#include <limn/core/GraphicsFormat.h>
#include <map>

namespace limn::vulkan
{

/// The abilities of the device beyond what limn requires, and its limits.
struct DeviceCapabilities
{
    bool dynamicBlend = false;           ///< the blend part of VK_EXT_extended_dynamic_state3
    VkPhysicalDeviceFeatures features{}; ///< those that are enabled
    bool conservative = false;           ///< VK_EXT_conservative_rasterization
    /// The number of targets at once; coherent VK_EXT_blend_operation_advanced.
    std::uint32_t advancedBlendTargets = 0;
    bool mirrorOnce = false;
    std::uint32_t timestampValidBits = 0; ///< 0 = nothing can be timed
    VkPhysicalDeviceLimits limits{};
    std::vector<std::string> missingShaderFeatures; ///< see MissingShaderFeatures
    std::map<VkShaderStageFlagBits, std::vector<MissingCapability>> missingCapabilities;
    /// A feature of samplers; not every device with VK_KHR_portability_subset has it.
    bool mipLodBias = false;
    bool comparisonSamplers = false; ///< likewise
};

/// The entry points of extensions; null if the extension is absent.
struct ExtensionFunctions
{
    PFN_vkSetDebugUtilsObjectNameEXT setObjectName = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT beginLabel = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT endLabel = nullptr;
    PFN_vkCmdSetColorBlendEnableEXT setColorBlendEnable = nullptr;
    PFN_vkCmdSetColorBlendEquationEXT setColorBlendEquation = nullptr;
    PFN_vkCmdSetColorWriteMaskEXT setColorWriteMask = nullptr;
};

/// The instance, the chosen physical device, the logical device and its only queue.
class VulkanContext
{
public:
    explicit VulkanContext(const VulkanDeviceOptions& options);

    VkDevice device() const { return m_Device.get(); }
    VkPhysicalDevice physicalDevice() const { return m_PhysicalDevice; }
    VkQueue queue() const { return m_Queue; }
    std::uint32_t queueFamily() const { return m_QueueFamily; }
    const DeviceCapabilities& capabilities() const { return m_Capabilities; }
    const ExtensionFunctions& functions() const { return m_Functions; }
    const VulkanInstance& instance() const { return m_Instance; }
    const std::string& deviceName() const { return m_DeviceName; }
    const std::string& choiceSentence() const { return m_ChoiceSentence; }

    /// Returns whether kernels may read writable textures of this format without declaring the
    /// format.
    bool ReadsWithoutFormat(GraphicsFormat format) const;

    /// Sets the name that captures and validation messages show.
    template <typename T>
    void SetName(VkObjectType type, T handle, const std::string& name) const
    {
        SetObjectName(type, reinterpret_cast<std::uint64_t>(handle), name);
    }

private:
    struct DestroyDevice
    {
        void operator()(VkDevice device) const { vkDestroyDevice(device, nullptr); }
    };

    void ChoosePhysicalDevice(const std::string& request);
    void CreateDevice(const OptionalExtensions& extensions);
    void ReadCapabilities();
    void FindMissing(FeatureChain& enabled);
    void LoadFunctions();
    void SetObjectName(VkObjectType type, std::uint64_t handle, const std::string& name) const;

    VulkanInstance m_Instance;
    VkPhysicalDevice m_PhysicalDevice = VK_NULL_HANDLE;
    std::string m_DeviceName;
    std::string m_ChoiceSentence;
    std::uint32_t m_QueueFamily = 0;
    DeviceCapabilities m_Capabilities;
    ExtensionFunctions m_Functions;
    std::unique_ptr<VkDevice_T, DestroyDevice> m_Device;
    VkQueue m_Queue = VK_NULL_HANDLE;
};

} // namespace limn::vulkan
