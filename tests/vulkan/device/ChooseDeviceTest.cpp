#include "core/ThrownMessage.h"
#include <device/DeviceSelection.h>
#include <limn/vulkan/VulkanError.h>

namespace limn::test
{

namespace
{

using vulkan::ChooseDevice;

VulkanDeviceInfo MakeInfo(std::string name, VulkanDeviceType type,
                          std::vector<std::string> problems = {})
{
    return {std::move(name), type, "1.3.230", "driver", "1.0", 8, std::move(problems)};
}

const std::vector<VulkanDeviceInfo> k_Devices = {
    MakeInfo("llvmpipe (LLVM 15)", VulkanDeviceType::Software),
    MakeInfo("Old Radeon", VulkanDeviceType::DiscreteGpu,
             {"it supports Vulkan 1.2.0, but limn needs 1.3"}),
    MakeInfo("Intel UHD", VulkanDeviceType::IntegratedGpu),
    MakeInfo("GeForce RTX", VulkanDeviceType::DiscreteGpu)};

std::string Refusal(const std::vector<VulkanDeviceInfo>& devices, std::string_view request)
{
    return ThrownMessage<VulkanError>([&] { ChooseDevice(devices, request); });
}

} // namespace

TEST(ChooseDevice, TakesTheFirstUsableGpuByDefault)
{
    EXPECT_EQ(2u, ChooseDevice(k_Devices, "").index);
    EXPECT_EQ("drawing on 2: 'Intel UHD' (integrated GPU), Vulkan 1.3.230, driver 1.0: the first "
              "usable GPU",
              ChooseDevice(k_Devices, "").sentence);
}

TEST(ChooseDevice, FallsBackToSoftware)
{
    const std::vector<VulkanDeviceInfo> devices = {k_Devices[1], k_Devices[0]};
    EXPECT_EQ(1u, ChooseDevice(devices, "").index);
    EXPECT_EQ("drawing on 1: 'llvmpipe (LLVM 15)' (software), Vulkan 1.3.230, driver 1.0: no "
              "usable GPU, so the software device",
              ChooseDevice(devices, "").sentence);
}

TEST(ChooseDevice, TakesSoftwareWhereAskedFor)
{
    EXPECT_EQ(0u, ChooseDevice(k_Devices, "software").index);
}

TEST(ChooseDevice, TakesAPosition)
{
    EXPECT_EQ(3u, ChooseDevice(k_Devices, "3").index);
}

TEST(ChooseDevice, TakesPartOfANameInAnyCase)
{
    EXPECT_EQ(3u, ChooseDevice(k_Devices, "geforce").index);
    EXPECT_EQ("drawing on 3: 'GeForce RTX' (discrete GPU), Vulkan 1.3.230, driver 1.0: 'geforce' "
              "was asked for",
              ChooseDevice(k_Devices, "geforce").sentence);
}

TEST(ChooseDevice, RefusesAnUnusableDeviceWithItsReasons)
{
    const std::string expected = "no usable Vulkan device is 'radeon'; there are:\n"
                                 "  0: 'llvmpipe (LLVM 15)' (software): usable\n"
                                 "  1: 'Old Radeon' (discrete GPU)\n"
                                 "    it supports Vulkan 1.2.0, but limn needs 1.3\n"
                                 "  2: 'Intel UHD' (integrated GPU): usable\n"
                                 "  3: 'GeForce RTX' (discrete GPU): usable";
    EXPECT_EQ(expected, Refusal(k_Devices, "radeon"));
}

TEST(ChooseDevice, RefusesAPositionPastTheEnd)
{
    EXPECT_EQ(0u, Refusal(k_Devices, "4").find("no usable Vulkan device is '4'; there are:"));
}

TEST(ChooseDevice, SaysWhyNoDeviceIsUsable)
{
    EXPECT_EQ("no usable Vulkan device:\n"
              "  0: 'Old Radeon' (discrete GPU)\n"
              "    it supports Vulkan 1.2.0, but limn needs 1.3",
              Refusal({k_Devices[1]}, ""));
}

TEST(ChooseDevice, SaysWhatToInstallWhereThereIsNone)
{
    const std::string message = Refusal({}, "");
    EXPECT_EQ(0u, message.find("no Vulkan device: the loader found no driver"));
    EXPECT_NE(std::string::npos,
              message.find("; install mesa-vulkan-drivers for the software one"));
}

} // namespace limn::test
