#include "memory/UploadCommands.h"

namespace limn::vulkan
{

void UploadCommands::Reset()
{
    m_IsBegun = false;
    m_Staging.Reset();
}

VkCommandBuffer UploadCommands::commands()
{
    if (!m_IsBegun)
    {
        m_Commands.Begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT);
        m_IsBegun = true;
    }
    return m_Commands.handle();
}

VkCommandBuffer UploadCommands::End()
{
    if (!m_IsBegun)
    {
        return VK_NULL_HANDLE;
    }
    m_Commands.End();
    return m_Commands.handle();
}

} // namespace limn::vulkan
