#pragma once

#include <limn/core/GraphicsBuffer.h>

namespace limn
{

/// Where an indirect command has its arguments.
/// @param call   whose they are, for messages
/// @param count  of uint
/// @throws ContractError if the buffer is null or made for something else, or they do not lie in it
///         at a multiple of 4 bytes
BufferRange ArgumentsRange(const char* call, std::shared_ptr<const GraphicsBuffer> buffer,
                           std::int64_t offset, std::uint32_t count);

} // namespace limn
