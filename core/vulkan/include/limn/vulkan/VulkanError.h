#pragma once

#include <stdexcept>
#include <string>

namespace limn
{

/// The machine or its driver cannot do what was asked: no usable device, out of memory, device
/// lost. Nothing the scene or the program did wrong.
class VulkanError : public std::runtime_error
{
public:
    /// @param sentence  complete; call, result and object stay empty
    explicit VulkanError(const std::string& sentence);

    /// what() reads "vkCreateImage failed for 'Color': VK_ERROR_TOO_MANY_OBJECTS".
    VulkanError(std::string call, std::string result, std::string object);

    const std::string& call() const { return m_Call; }     ///< e.g. "vkCreateImage"
    const std::string& result() const { return m_Result; } ///< e.g. "VK_ERROR_DEVICE_LOST"
    /// Then every call of that device fails: only another device helps.
    bool isDeviceLost() const { return m_Result == "VK_ERROR_DEVICE_LOST"; }
    const std::string& object() const { return m_Object; } ///< name of what was worked on, or ""

private:
    std::string m_Call;
    std::string m_Result;
    std::string m_Object;
};

} // namespace limn
