#include "record/Arguments.h"

namespace limn
{

BufferRange ArgumentsRange(const char* call, std::shared_ptr<const GraphicsBuffer> buffer,
                           std::int64_t offset, std::uint32_t count)
{
    const std::string subject(call);
    if (!buffer)
    {
        throw ContractError(subject + " needs a buffer with its arguments, but it is null");
    }
    if (!buffer->Has(GraphicsBuffer::Target::IndirectArguments))
    {
        throw ContractError(subject + ": buffer '" + buffer->name() +
                            "' is not made with GraphicsBuffer::Target::IndirectArguments");
    }
    const std::uint32_t size = count * static_cast<std::uint32_t>(sizeof(std::uint32_t));
    if (offset < 0 || offset % 4 != 0 || static_cast<std::uint64_t>(offset) + size > buffer->size())
    {
        throw ContractError(subject + ": arguments of " + std::to_string(size) + " bytes at " +
                            std::to_string(offset) + " of buffer '" + buffer->name() +
                            "', which has " + std::to_string(buffer->size()) +
                            "; they begin at a multiple of 4 and end in the buffer");
    }
    return {std::move(buffer), static_cast<std::uint32_t>(offset), size};
}

} // namespace limn
