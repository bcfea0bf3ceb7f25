#include "commands/Commands.h"

#include "console/CacheFolder.h"

#include <limn/editor_stub/RunLimn.h>
#include <limn/features/Version.h>
#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>

namespace limn
{

namespace
{

/// A key of the report and its value, values in one column.
void Row(Console& console, const std::string& key, const std::string& value)
{
    constexpr std::size_t k_ValueColumn = 20;
    const std::size_t gap = key.size() < k_ValueColumn ? k_ValueColumn - key.size() : 1;
    console.Result(key + std::string(gap, ' ') + value);
}

void PrintDevices(Console& console)
{
    const std::vector<VulkanDeviceInfo> devices = EnumerateVulkanDevices();
    Row(console, "Vulkan devices", std::to_string(devices.size()));
    for (std::size_t i = 0; i < devices.size(); ++i)
    {
        const VulkanDeviceInfo& device = devices[i];
        Row(console, "  " + std::to_string(i),
            device.name + ", " + ToString(device.type) + ", Vulkan " + device.apiVersion +
                ", driver " + device.driverName + " " + device.driverInfo);
        Row(console, "",
            !device.isUsable()     ? "cannot be used:"
            : device.lacks.empty() ? "usable"
                                   : "usable; what it lacks, and what that costs:");
        for (const std::string& line : device.isUsable() ? device.lacks : device.problems)
        {
            Row(console, "", "- " + line);
        }
    }
}

/// Returns whether a device could be opened.
bool PrintChoice(const std::string& name, Console& console)
{
    VulkanDeviceOptions options;
    options.device = name;
    try
    {
        Row(console, "chosen device", VulkanDevice(options).ChoiceSentence());
    }
    catch (const VulkanError& error)
    {
        Row(console, "chosen device", std::string("none: ") + error.what());
        return false;
    }
    options.validation = true;
    try
    {
        const VulkanDevice device(options);
        Row(console, "validation layer", "present");
    }
    catch (const VulkanError& error)
    {
        Row(console, "validation layer", std::string("absent: ") + error.what());
    }
    return true;
}

std::string FolderText(const std::filesystem::path& folder)
{
    if (folder.empty())
    {
        return "none: neither XDG_CACHE_HOME nor HOME is set";
    }
    std::error_code error;
    std::uintmax_t bytes = 0;
    int files = 0;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    std::filesystem::recursive_directory_iterator entry(folder, options, error);
    for (; entry != std::filesystem::recursive_directory_iterator(); entry.increment(error))
    {
        std::error_code ignored;
        if (entry->is_regular_file(ignored))
        {
            bytes += entry->file_size(ignored);
            ++files;
        }
    }
    return folder.string() + ", " + std::to_string(files) + " files, " +
           std::to_string(bytes / 1024) + " KiB";
}

} // namespace

int RunDoctor(const std::string& device, Console& console)
{
    Row(console, "limn", LIMN_VERSION_TEXT);
    Row(console, "libraries", LIMN_LIBRARY_VERSIONS);
    Row(console, "cache folder", FolderText(DefaultCacheFolder()));
    bool isUsable = false;
    try
    {
        PrintDevices(console);
        isUsable = PrintChoice(device, console);
    }
    catch (const VulkanError& error)
    {
        Row(console, "Vulkan", std::string("cannot be used: ") + error.what());
    }
    return static_cast<int>(isUsable ? ExitCode::Done : ExitCode::MachineLacksIt);
}

} // namespace limn
