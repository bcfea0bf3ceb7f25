#include "Mentions.h"
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
    EXPECT_THAT(ChooseDevice(k_Devices, "").sentence,
                Mentions("2: 'Intel UHD'", "integrated GPU", "1.3.230", "1.0", "first"));
}

TEST(ChooseDevice, FallsBackToSoftware)
{
    const std::vector<VulkanDeviceInfo> devices = {k_Devices[1], k_Devices[0]};
    EXPECT_EQ(1u, ChooseDevice(devices, "").index);
    EXPECT_THAT(ChooseDevice(devices, "").sentence,
                Mentions("1: 'llvmpipe (LLVM 15)'", "software", "1.3.230", "1.0", "no usable GPU"));
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
    EXPECT_THAT(ChooseDevice(k_Devices, "geforce").sentence,
                Mentions("3: 'GeForce RTX'", "discrete GPU", "1.3.230", "1.0", "'geforce'"));
}

TEST(ChooseDevice, RefusesAnUnusableDeviceWithItsReasons)
{
    EXPECT_THAT(Refusal(k_Devices, "radeon"),
                Mentions("no usable", "'radeon'", "0: 'llvmpipe (LLVM 15)'", "usable",
                         "1: 'Old Radeon'", "1.2.0", "1.3", "2: 'Intel UHD'", "usable",
                         "3: 'GeForce RTX'", "usable"));
}

TEST(ChooseDevice, RefusesAPositionPastTheEnd)
{
    EXPECT_THAT(Refusal(k_Devices, "4"), Mentions("no usable", "'4'", "there are"));
}

TEST(ChooseDevice, SaysWhyNoDeviceIsUsable)
{
    EXPECT_THAT(Refusal({k_Devices[1]}, ""),
                Mentions("no usable", "0: 'Old Radeon'", "1.2.0", "1.3"));
}

TEST(ChooseDevice, SaysWhatToInstallWhereThereIsNone)
{
    EXPECT_THAT(Refusal({}, ""), Mentions("no Vulkan device", "no driver", "mesa-vulkan-drivers"));
}

} // namespace limn::test
