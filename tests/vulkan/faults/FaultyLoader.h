#pragma once

#include <map>
#include <string>
#include <vector>
#include <vulkan/vulkan.h>

/// The test program has Vulkan entry points of its own, which the dynamic linker prefers to the
/// loader's: limn calls them, and they hand on to the loader, layers and driver. On request they
/// fail one call instead, as a driver might, without handing it on. They know every call of limn's
/// that can fail, and count what is made and destroyed.
namespace limn::test::faulty_loader
{

/// The `number`-th call of those that may return `result` does so: counted from 1, and from the
/// fault before on.
struct Fault
{
    int number = 0;
    VkResult result = VK_SUCCESS;
};
/// Lets calls fail from now on, one after the other. VK_ERROR_DEVICE_LOST stays until that device
/// is destroyed, as a lost device does.
void FailCalls(std::vector<Fault> faults);
inline void FailCall(int number, VkResult result)
{
    FailCalls({{number, result}});
}
/// Every call of one function fails from now on, but the first `spared`.
void FailFunction(const std::string& name, VkResult result, int spared = 0);
/// Nothing fails any more.
void FailNothing();

/// A call that failed, and with what.
struct Failed
{
    std::string function;
    VkResult result = VK_SUCCESS;
};
/// Returns the calls that failed since failing was asked for, each of FailFunction's among them.
const std::vector<Failed>& FailedCalls();
/// Returns the function that failed first; "" if none has yet.
std::string FailedFunction();
/// Returns the functions of all calls since failing was asked for that may return this.
std::vector<std::string> CallsThatMay(VkResult result);

/// How many objects there are, by kind; kinds without any are left out.
std::map<std::string, int> LiveObjects();

/// Devices say from now on that they bind at most so many bytes of a storage buffer; 0 = what is
/// true.
void LimitStorageBuffers(std::uint32_t bytes);
/// The same of a uniform buffer.
void LimitUniformBuffers(std::uint32_t bytes);
/// The most bytes of a storage buffer bound since LimitStorageBuffers.
VkDeviceSize LargestStorageBuffer();

/// Returns how many types of memory the device has that was made last.
std::uint32_t MemoryTypeCount();

/// Devices say from now on whether a tool watches them, for which limn names objects and passes:
/// the validation layer says so of itself to an older entry point only.
void SetTool(bool isThere);

/// Whether the entry point of this name is the test program's.
bool Covers(const std::string& function);

} // namespace limn::test::faulty_loader
