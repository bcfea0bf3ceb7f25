#include "device/VulkanInstance.h"

#include "device/Check.h"
#include <array>
#include <cstdlib>

namespace limn::vulkan
{

namespace
{

constexpr const char* k_ValidationLayer = "VK_LAYER_KHRONOS_validation";

/// Runs inside the driver: nothing may be thrown through it.
VKAPI_ATTR VkBool32 VKAPI_CALL OnMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                         VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data,
                                         void* user) noexcept
try
{
    const bool isError = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    static_cast<ValidationLog*>(user)->Add(
        {isError ? Severity::Error : Severity::Warning,
         data->pMessageIdName == nullptr ? "" : data->pMessageIdName,
         data->pMessage == nullptr ? "" : data->pMessage});
    return VK_FALSE;
}
catch (...)
{
    return VK_FALSE; // out of memory: the message is lost, the program is not
}

VkDebugUtilsMessengerCreateInfoEXT MessengerInfo(ValidationLog& log)
{
    auto info = Make<VkDebugUtilsMessengerCreateInfoEXT>(
        VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                           VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    // Not GENERAL: there the loader talks about drivers of absent hardware.
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = OnMessage;
    info.pUserData = &log;
    return info;
}

bool HasLayer(const char* name)
{
    std::vector<VkLayerProperties> layers;
    Check(FillList(layers, vkEnumerateInstanceLayerProperties),
          "vkEnumerateInstanceLayerProperties");
    return Contains(layers, &VkLayerProperties::layerName, name);
}

bool HasInstanceExtension(const char* name, const char* layer)
{
    std::vector<VkExtensionProperties> extensions;
    const auto fill = [&](std::uint32_t* count, VkExtensionProperties* list)
    {
        return vkEnumerateInstanceExtensionProperties(layer, count, list);
    };
    Check(FillList(extensions, fill), "vkEnumerateInstanceExtensionProperties");
    return Contains(extensions, &VkExtensionProperties::extensionName, name);
}

std::uint32_t LoaderVersion()
{
    std::uint32_t version = VK_API_VERSION_1_0;
    Check(vkEnumerateInstanceVersion(&version), "vkEnumerateInstanceVersion");
    return version;
}

std::string NoDriverSentence()
{
    std::string sentence = "no Vulkan device: the loader found no driver";
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
    {
        if (const char* value = std::getenv(name))
        {
            sentence += std::string(" (") + name + " is set to '" + value + "')";
        }
    }
    return sentence + "; install mesa-vulkan-drivers for the software one";
}

} // namespace

void ValidationLog::Add(ValidationMessage message)
{
    const std::lock_guard lock{m_Mutex};
    m_Messages.push_back(std::move(message));
}

std::vector<ValidationMessage> ValidationLog::messages() const
{
    const std::lock_guard lock{m_Mutex};
    return m_Messages;
}

NoDriverError::NoDriverError() : VulkanError(NoDriverSentence()) {}

VulkanInstance::VulkanInstance(bool validation)
{
    if (LoaderVersion() < VK_API_VERSION_1_3)
    {
        throw VulkanError("the Vulkan loader is older than 1.3; update libvulkan1");
    }
    if (validation && !HasLayer(k_ValidationLayer))
    {
        throw VulkanError(std::string("validation is asked for, but the layer ") +
                          k_ValidationLayer + " is not installed; install vulkan-validationlayers");
    }
    m_DebugUtils =
        HasInstanceExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME, nullptr) ||
        (validation && HasInstanceExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME, k_ValidationLayer));
    Create(validation);
    if (validation)
    {
        CreateMessenger();
    }
}

VulkanInstance::~VulkanInstance()
{
    if (m_Messenger != VK_NULL_HANDLE)
    {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(get(), "vkDestroyDebugUtilsMessengerEXT"));
        destroy(get(), m_Messenger, nullptr);
    }
}

void VulkanInstance::Create(bool validation)
{
    auto application = Make<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.pApplicationName = "limn";
    application.pEngineName = "limn";
    application.apiVersion = VK_API_VERSION_1_3;

    constexpr std::array enabled = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    auto features = Make<VkValidationFeaturesEXT>(VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT);
    features.enabledValidationFeatureCount = static_cast<std::uint32_t>(enabled.size());
    features.pEnabledValidationFeatures = enabled.data();
    VkDebugUtilsMessengerCreateInfoEXT messenger = MessengerInfo(m_Log);
    messenger.pNext = &features;

    auto info = Make<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    std::vector<const char*> extensions;
    if (m_DebugUtils)
    {
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    }
    // Without it a loader hides the devices that are layers over another API, as on macOS.
    if (HasInstanceExtension(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME, nullptr))
    {
        extensions.push_back(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
        info.flags |= VK_INSTANCE_CREATE_ENUMERATE_PORTABILITY_BIT_KHR;
    }
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    if (validation)
    {
        info.pNext = &messenger;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &k_ValidationLayer;
    }
    VkInstance instance = VK_NULL_HANDLE;
    const VkResult result = vkCreateInstance(&info, nullptr, &instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
    {
        throw NoDriverError();
    }
    Check(result, "vkCreateInstance");
    m_Instance.reset(instance);
}

void VulkanInstance::CreateMessenger()
{
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(get(), "vkCreateDebugUtilsMessengerEXT"));
    const VkDebugUtilsMessengerCreateInfoEXT info = MessengerInfo(m_Log);
    Check(create(get(), &info, nullptr, &m_Messenger), "vkCreateDebugUtilsMessengerEXT");
}

std::vector<VkPhysicalDevice> VulkanInstance::PhysicalDevices() const
{
    std::vector<VkPhysicalDevice> devices;
    const VkResult result = FillList(devices, [&](std::uint32_t* count, VkPhysicalDevice* list)
                                     { return vkEnumeratePhysicalDevices(get(), count, list); });
    // Some loaders report a driver without a device as a failure to initialise.
    if (result == VK_ERROR_INITIALIZATION_FAILED)
    {
        return {};
    }
    Check(result, "vkEnumeratePhysicalDevices");
    return devices;
}

} // namespace limn::vulkan
