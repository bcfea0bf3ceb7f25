#pragma once

#include <map>
#include <string>
#include <vulkan/vulkan.h>

/// The test program has Vulkan entry points of its own, which the dynamic linker prefers to the
/// loader's: limn calls them, and they hand on to the loader, layers and driver. On request they
/// fail one call instead, as a driver might, without handing it on. They know every call of limn's
/// that can fail, and count what is made and destroyed.
namespace limn::test::faulty_loader
{

/// From now on the `number`-th call that may fail with `result` does so; counted from 1.
/// VK_ERROR_DEVICE_LOST stays until that device is destroyed, as a lost device does.
void FailCall(int number, VkResult result);
/// Every call of one function fails from now on, but the first `spared`.
void FailFunction(const std::string& name, VkResult result, int spared = 0);
/// Nothing fails any more.
void FailNothing();

/// The function that failed first since failing was asked for; "" if none has yet.
const std::string& FailedFunction();

/// How many objects there are, by kind; kinds without any are left out.
std::map<std::string, int> LiveObjects();

/// Devices say from now on that they bind at most so many bytes of a storage buffer; 0 = what is
/// true.
void LimitStorageBuffers(std::uint32_t bytes);
/// The same of a uniform buffer.
void LimitUniformBuffers(std::uint32_t bytes);
/// The most bytes of a storage buffer bound since LimitStorageBuffers.
VkDeviceSize LargestStorageBuffer();

/// Whether the entry point of this name is the test program's.
bool Covers(const std::string& function);

} // namespace limn::test::faulty_loader
