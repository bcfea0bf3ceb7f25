#pragma once

#include <stdexcept>
#include <string>

namespace limn
{

/// The error that the machine or its driver cannot do what was asked: no usable device, out of
/// memory, device lost. It is no mistake of the scene or the program.
class VulkanError : public std::runtime_error
{
public:
    /// @param sentence  the complete message; call, result and object stay empty
    explicit VulkanError(const std::string& sentence);

    /// what() reads "vkCreateImage failed for 'Color': VK_ERROR_TOO_MANY_OBJECTS".
    VulkanError(std::string call, std::string result, std::string object);

    const std::string& call() const { return m_Call; }     ///< e.g. "vkCreateImage"
    const std::string& result() const { return m_Result; } ///< e.g. "VK_ERROR_DEVICE_LOST"
    /// Returns whether the device is lost. Every call of that device then fails; the program needs
    /// another device.
    bool isDeviceLost() const { return m_Result == "VK_ERROR_DEVICE_LOST"; }
    /// Returns the name of the affected object, or "".
    const std::string& object() const { return m_Object; }

private:
    std::string m_Call;
    std::string m_Result;
    std::string m_Object;
};

} // namespace limn
