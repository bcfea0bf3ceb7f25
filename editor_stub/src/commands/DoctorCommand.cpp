#include "commands/Commands.h"

#include "console/CacheFolder.h"
#include "console/Json.h"
#include "console/Texts.h"

#include <limn/features/Version.h>
#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>

namespace limn
{

namespace
{

struct CacheFacts
{
    std::filesystem::path folder; ///< "" if there is none
    std::uintmax_t bytes = 0;
    int files = 0;
};

struct VulkanFacts
{
    std::vector<VulkanDeviceInfo> devices;
    std::string problem;  ///< why Vulkan cannot be used at all; the rest is then not known
    std::string choice;   ///< a sentence about the device that draws; "" if none does
    std::string noChoice; ///< why no device draws
    std::string noLayer;  ///< why there is no validation layer; "" if there is one
};

CacheFacts FindCache()
{
    CacheFacts facts{DefaultCacheFolder()};
    if (facts.folder.empty())
    {
        return facts;
    }
    std::error_code error;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    std::filesystem::recursive_directory_iterator entry(facts.folder, options, error);
    for (; entry != std::filesystem::recursive_directory_iterator(); entry.increment(error))
    {
        std::error_code ignored;
        if (entry->is_regular_file(ignored))
        {
            facts.bytes += entry->file_size(ignored);
            ++facts.files;
        }
    }
    return facts;
}

/// Returns what Vulkan lacks to try something; "" for nothing.
template <typename Try>
std::string ProblemOf(const Try& attempt)
{
    try
    {
        attempt();
        return "";
    }
    catch (const VulkanError& error)
    {
        return error.what();
    }
}

/// Opens the device, without and with the validation layer.
VulkanFacts FindVulkan(const std::string& device)
{
    VulkanFacts facts;
    facts.problem = ProblemOf([&] { facts.devices = EnumerateVulkanDevices(); });
    const auto open = [&](bool validation)
    {
        return VulkanDevice({device, validation, {}}).ChoiceSentence();
    };
    if (facts.problem.empty())
    {
        facts.noChoice = ProblemOf([&] { facts.choice = open(false); });
    }
    if (!facts.choice.empty())
    {
        facts.noLayer = ProblemOf([&] { open(true); });
    }
    return facts;
}

/// Returns a line with a key and its value; the values of all lines begin at one column.
std::string Row(const std::string& key, const std::string& value)
{
    constexpr std::size_t k_ValueColumn = 20;
    const std::size_t gap = key.size() < k_ValueColumn ? k_ValueColumn - key.size() : 1;
    return key + std::string(gap, ' ') + OneLine(value) + "\n";
}

std::string CacheText(const CacheFacts& facts)
{
    return facts.folder.empty() ? "none: neither XDG_CACHE_HOME nor HOME is set"
                                : facts.folder.string() + ", " + std::to_string(facts.files) +
                                      " files, " + std::to_string(facts.bytes / 1024) + " KiB";
}

std::string DeviceText(const VulkanDeviceInfo& device, std::size_t index)
{
    std::string text =
        Row("  " + std::to_string(index), device.name + ", " + ToString(device.type) + ", Vulkan " +
                                              device.apiVersion + ", driver " + device.driverName +
                                              " " + device.driverInfo);
    text += Row("", !device.isUsable()     ? "cannot be used:"
                    : device.lacks.empty() ? "usable"
                                           : "usable; what it lacks, and what that costs:");
    for (const std::string& line : device.isUsable() ? device.lacks : device.problems)
    {
        text += Row("", "- " + line);
    }
    return text;
}

std::string VulkanText(const VulkanFacts& facts)
{
    if (!facts.problem.empty())
    {
        return Row("Vulkan", "cannot be used: " + facts.problem);
    }
    std::string text = Row("Vulkan devices", std::to_string(facts.devices.size()));
    for (std::size_t i = 0; i < facts.devices.size(); ++i)
    {
        text += DeviceText(facts.devices[i], i);
    }
    if (facts.choice.empty())
    {
        return text + Row("chosen device", "none: " + facts.noChoice);
    }
    return text + Row("chosen device", facts.choice) +
           Row("validation layer", facts.noLayer.empty() ? "present" : "absent: " + facts.noLayer);
}

Json DeviceJson(const VulkanDeviceInfo& device)
{
    return {{"name", device.name},
            {"type", ToString(device.type)},
            {"apiVersion", device.apiVersion},
            {"driver", device.driverName + " " + device.driverInfo},
            {"usable", device.isUsable()},
            {"problems", device.problems},
            {"lacks", device.lacks}};
}

/// Returns the versions of libraries by their names: {"libpng": "1.6.39"}.
Json LibrariesJson()
{
    Json json = Json::object();
    for (const std::string& library : SplitText(LIMN_LIBRARY_VERSIONS, ','))
    {
        const std::string text(Trim(library));
        const std::size_t blank = text.find(' ');
        json[text.substr(0, blank)] = text.substr(blank + 1);
    }
    return json;
}

Json FactsJson(const CacheFacts& cache, const VulkanFacts& vulkan)
{
    const bool hasLayer = !vulkan.choice.empty() && vulkan.noLayer.empty();
    return {{"limn", LIMN_VERSION_TEXT},
            {"libraries", LibrariesJson()},
            {"cache",
             {{"folder", TextOrNull(cache.folder.string())},
              {"files", cache.files},
              {"bytes", cache.bytes}}},
            {"devices", JsonList(vulkan.devices, DeviceJson)},
            {"chosenDevice", TextOrNull(vulkan.choice)},
            {"whyNoDevice", TextOrNull(vulkan.problem.empty() ? vulkan.noChoice : vulkan.problem)},
            {"validationLayer", hasLayer}};
}

} // namespace

ExitCode RunDoctor(const std::string& device, bool wantsJson, Console& console)
{
    const CacheFacts cache = FindCache();
    const VulkanFacts vulkan = FindVulkan(device);
    wantsJson
        ? console.Data(JsonText(FactsJson(cache, vulkan)))
        : console.Results(Row("limn", LIMN_VERSION_TEXT) + Row("libraries", LIMN_LIBRARY_VERSIONS) +
                          Row("cache folder", CacheText(cache)) + VulkanText(vulkan));
    return vulkan.choice.empty() ? ExitCode::MachineLacksIt : ExitCode::Done;
}

ExitCode RunVersion(bool wantsJson, Console& console)
{
    const Json json{{"limn", LIMN_VERSION_TEXT}, {"libraries", LibrariesJson()}};
    wantsJson ? console.Data(JsonText(json)) : console.Result("limn " LIMN_VERSION_TEXT);
    return ExitCode::Done;
}

} // namespace limn
