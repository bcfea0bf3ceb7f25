#include "device/VulkanContext.h"

#include "device/Check.h"
#include "device/DeviceSelection.h"
#include "device/Translate.h"

namespace limn::vulkan
{

VulkanContext::VulkanContext(const VulkanDeviceOptions& options) : m_Instance(options.validation)
{
    ChoosePhysicalDevice(options.device);
    OptionalExtensions extensions = FindExtensions(m_PhysicalDevice);
    if (!options.optionalExtensions)
    {
        extensions = {.portability = extensions.portability};
    }
    ReadCapabilities();
    CreateDevice(extensions);
    LoadFunctions();
}

void VulkanContext::ChoosePhysicalDevice(const std::string& request)
{
    const std::vector<VkPhysicalDevice> devices = m_Instance.PhysicalDevices();
    std::vector<VulkanDeviceInfo> infos;
    for (VkPhysicalDevice device : devices)
    {
        infos.push_back(DescribeDevice(device));
    }
    DeviceChoice choice = ChooseDevice(infos, request);
    m_PhysicalDevice = devices[choice.index];
    m_DeviceName = infos[choice.index].name;
    m_ChoiceSentence = std::move(choice.sentence);
    m_QueueFamily = GraphicsQueueFamily(m_PhysicalDevice).value();
}

void VulkanContext::CreateDevice(const OptionalExtensions& extensions)
{
    FeatureChain offered{extensions};
    vkGetPhysicalDeviceFeatures2(m_PhysicalDevice, &offered.core);
    FeatureChain wanted{extensions};
    ChooseFeatures(offered, wanted);
    m_Capabilities.dynamicBlend =
        wanted.extendedState.extendedDynamicState3ColorBlendEquation == VK_TRUE;
    m_Capabilities.features = wanted.core.features;
    m_Capabilities.mirrorOnce = wanted.v12.samplerMirrorClampToEdge == VK_TRUE;
    m_Capabilities.conservative = extensions.conservative;
    if (wanted.advancedBlend.advancedBlendCoherentOperations == VK_TRUE)
    {
        m_Capabilities.advancedBlendTargets =
            ReadProperties<VkPhysicalDeviceBlendOperationAdvancedPropertiesEXT>(
                m_PhysicalDevice,
                VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BLEND_OPERATION_ADVANCED_PROPERTIES_EXT)
                .advancedBlendMaxColorAttachments;
    }
    m_Capabilities.mipLodBias = wanted.portability.samplerMipLodBias == VK_TRUE;
    m_Capabilities.comparisonSamplers = wanted.portability.mutableComparisonSamplers == VK_TRUE;
    FindMissing(wanted);

    const float priority = 1.0f;
    auto queue = Make<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueFamilyIndex = m_QueueFamily;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const std::vector<const char*> names = extensions.Names();
    auto info = Make<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.pNext = &wanted.core;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
    info.ppEnabledExtensionNames = names.data();
    VkDevice device = VK_NULL_HANDLE;
    Check(vkCreateDevice(m_PhysicalDevice, &info, nullptr, &device), "vkCreateDevice",
          m_DeviceName);
    m_Device.reset(device);
    vkGetDeviceQueue(device, m_QueueFamily, 0, &m_Queue);
}

void VulkanContext::ReadCapabilities()
{
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(m_PhysicalDevice, &properties);
    m_Capabilities.limits = properties.limits;
    m_Capabilities.timestampValidBits =
        QueueFamilies(m_PhysicalDevice)[m_QueueFamily].timestampValidBits;
}

void VulkanContext::FindMissing(FeatureChain& enabled)
{
    const auto subgroup = ReadProperties<VkPhysicalDeviceSubgroupProperties>(
        m_PhysicalDevice, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES);
    m_Capabilities.missingShaderFeatures = MissingShaderFeatures(
        enabled, m_Capabilities.limits, SubgroupOperations(subgroup, VK_SHADER_STAGE_FRAGMENT_BIT),
        SubgroupOperations(subgroup, VK_SHADER_STAGE_COMPUTE_BIT));
    for (const VkShaderStageFlagBits stage :
         {VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_GEOMETRY_BIT, VK_SHADER_STAGE_FRAGMENT_BIT,
          VK_SHADER_STAGE_COMPUTE_BIT})
    {
        m_Capabilities.missingCapabilities[stage] =
            MissingCapabilities(enabled, SubgroupOperations(subgroup, stage));
    }
}

bool VulkanContext::ReadsWithoutFormat(GraphicsFormat format) const
{
    auto more = Make<VkFormatProperties3>(VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_3);
    auto properties = Make<VkFormatProperties2>(VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_2);
    properties.pNext = &more;
    vkGetPhysicalDeviceFormatProperties2(m_PhysicalDevice, ToVkFormat(format), &properties);
    return (more.optimalTilingFeatures & VK_FORMAT_FEATURE_2_STORAGE_READ_WITHOUT_FORMAT_BIT) != 0;
}

void VulkanContext::LoadFunctions()
{
    const auto load = [&](auto& function, const char* name)
    {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
            vkGetDeviceProcAddr(device(), name));
    };
    // Names and labels help a person with a capture, and cost everybody else.
    std::uint32_t tools = 0;
    vkGetPhysicalDeviceToolProperties(m_PhysicalDevice, &tools, nullptr);
    if (m_Instance.hasDebugUtils() && tools > 0)
    {
        load(m_Functions.setObjectName, "vkSetDebugUtilsObjectNameEXT");
        load(m_Functions.beginLabel, "vkCmdBeginDebugUtilsLabelEXT");
        load(m_Functions.endLabel, "vkCmdEndDebugUtilsLabelEXT");
    }
    if (m_Capabilities.dynamicBlend)
    {
        load(m_Functions.setColorBlendEnable, "vkCmdSetColorBlendEnableEXT");
        load(m_Functions.setColorBlendEquation, "vkCmdSetColorBlendEquationEXT");
        load(m_Functions.setColorWriteMask, "vkCmdSetColorWriteMaskEXT");
    }
}

void VulkanContext::SetObjectName(VkObjectType type, std::uint64_t handle,
                                  const std::string& name) const
{
    if (m_Functions.setObjectName == nullptr)
    {
        return;
    }
    auto info =
        Make<VkDebugUtilsObjectNameInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT);
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = name.c_str();
    Check(m_Functions.setObjectName(device(), &info), "vkSetDebugUtilsObjectNameEXT", name);
}

} // namespace limn::vulkan
