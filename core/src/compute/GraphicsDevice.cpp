#include <limn/core/GraphicsDevice.h>

namespace limn
{

std::vector<std::byte> GraphicsDevice::ReadBackBuffer(const GraphicsBuffer& buffer)
{
    throw ContractError("this device runs no kernels, so buffer '" + buffer.name() +
                        "' has no contents to read back");
}

} // namespace limn
