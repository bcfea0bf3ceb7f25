#include <limn/core/GraphicsBuffer.h>

#include "support/UniqueId.h"

#include <algorithm>
#include <cstring>
#include <limn/base/NumberText.h>
#include <limn/core/FrameCommands.h>
#include <limn/core/GraphicsDevice.h>
#include <utility>

namespace limn
{

namespace
{

using Target = GraphicsBuffer::Target;

constexpr int k_MostStride = 2048; // Direct3D's

[[noreturn]] void Fail(const std::string& message)
{
    throw ContractError("GraphicsBuffer: " + message);
}

/// Fails with the buffer's name in front, if it was given one.
[[noreturn]] void Fail(const GraphicsBuffer& buffer, const std::string& message)
{
    static const std::string k_Type = "GraphicsBuffer";
    const bool isNamed = !buffer.name().empty() && buffer.name() != k_Type;
    throw ContractError(k_Type + (isNamed ? " '" + buffer.name() + "'" : "") + ": " + message);
}

/// Returns the names of the targets to which limn binds no buffer.
std::string NameOf(Target target)
{
    constexpr std::pair<Target, const char*> k_Names[] = {
        {Target::Vertex, "Vertex"},
        {Target::Index, "Index"},
        {Target::CopySource, "CopySource"},
        {Target::CopyDestination, "CopyDestination"}};
    std::string names;
    for (const auto& [one, name] : k_Names)
    {
        const bool isIn = (static_cast<int>(target) & static_cast<int>(one)) != 0;
        names += isIn ? (names.empty() ? "" : " | ") + std::string(name) : "";
    }
    return names.empty() ? std::to_string(static_cast<int>(target)) : names;
}

void Expect(const GraphicsBuffer& buffer)
{
    constexpr Target k_Bound = Target::Structured | Target::Raw | Target::Append | Target::Counter |
                               Target::IndirectArguments | Target::Constant;
    if (!buffer.Has(k_Bound))
    {
        Fail("a buffer with the target " + NameOf(buffer.target()) +
             " cannot be bound to a shader; limn supports Structured, Raw, Append, Counter, "
             "IndirectArguments and Constant");
    }
    if (buffer.count() < 1 || buffer.stride() < 1)
    {
        Fail("the count is " + std::to_string(buffer.count()) + " and the stride is " +
             std::to_string(buffer.stride()) + "; both must be greater than 0");
    }
    const bool hasElements = buffer.Has(Target::Structured | Target::Append | Target::Counter |
                                        Target::IndirectArguments);
    if (hasElements && (buffer.stride() % 4 != 0 || buffer.stride() > k_MostStride))
    {
        Fail("the stride is " + std::to_string(buffer.stride()) +
             " bytes; for structured elements it must be a multiple of 4 up to " +
             std::to_string(k_MostStride));
    }
    if (buffer.Has(Target::Raw) && buffer.stride() != 4)
    {
        Fail("the stride of a raw buffer must be 4 bytes, but it is " +
             std::to_string(buffer.stride()));
    }
}

Target TargetOf(ComputeBufferType type)
{
    switch (type)
    {
    case ComputeBufferType::Raw:
        return Target::Raw;
    case ComputeBufferType::Append:
        return Target::Append;
    case ComputeBufferType::Counter:
        return Target::Counter;
    case ComputeBufferType::Constant:
        return Target::Constant;
    case ComputeBufferType::IndirectArguments:
        return Target::IndirectArguments;
    case ComputeBufferType::Default:
    case ComputeBufferType::Structured:
        break;
    }
    return Target::Structured;
}

} // namespace

GraphicsBuffer::GraphicsBuffer(Target target, int count, int stride)
    : m_Id(NextUniqueId()), m_Target(target), m_Count(count), m_Stride(stride)
{
    Expect(*this);
    m_Bytes.resize(hasCounter() ? counterOffset() + sizeof(std::uint32_t) : size());
}

std::size_t GraphicsBuffer::counterOffset() const
{
    return (size() + k_UniformAlignment - 1) / k_UniformAlignment * k_UniformAlignment;
}

void GraphicsBuffer::ExpectPart(int from, int to, int count, std::size_t available)
{
    const std::string text = "SetData: the count is " + std::to_string(count) +
                             ", the first element of the data is " + std::to_string(from) +
                             ", that of the buffer is " + std::to_string(to);
    if (from < 0 || to < 0 || count < 0)
    {
        Fail(text + "; none of these may be negative");
    }
    if (static_cast<std::size_t>(from) + static_cast<std::size_t>(count) > available)
    {
        Fail(text + "; the data has only " + CountText(available, "element"));
    }
}

void GraphicsBuffer::Set(const Part& part)
{
    const auto& [bytes, offset] = part;
    if (offset > size() || bytes.size() > size() - offset)
    {
        Fail(*this, "SetData writes " + CountText(bytes.size(), "byte") + " from byte " +
                        std::to_string(offset) + " on; the buffer has " +
                        CountText(size(), "byte"));
    }
    Put(bytes, offset);
}

void GraphicsBuffer::SetCounterValue(std::uint32_t counterValue)
{
    if (!hasCounter())
    {
        Fail(*this,
             "SetCounterValue: the buffer has no counter; give it the target Append or Counter");
    }
    Put(std::as_bytes(std::span(&counterValue, 1)), counterOffset());
}

void GraphicsBuffer::Put(std::span<const std::byte> bytes, std::size_t offset)
{
    if (m_IsReleased)
    {
        Fail(*this, "the buffer is released; make another one");
    }
    if (bytes.empty())
    {
        return;
    }
    std::memcpy(m_Bytes.data() + offset, bytes.data(), bytes.size());
    const std::size_t end = offset + bytes.size();
    std::erase_if(m_Changes, [&](const Change& change)
                  { return change.offset >= offset && change.offset + change.size <= end; });
    m_Changes.push_back({++m_Version, offset, bytes.size()});
}

void GraphicsBuffer::GetBytes(GraphicsDevice& device, std::span<std::byte> bytes) const
{
    if (bytes.size() > size())
    {
        Fail("'" + m_Name + "': GetData reads " + std::to_string(bytes.size()) +
             " bytes; the buffer has " + std::to_string(size()));
    }
    const std::vector<std::byte> all = device.ReadBackBuffer(*this);
    std::copy_n(all.begin(), bytes.size(), bytes.begin());
}

std::uint32_t GraphicsBuffer::GetCounterValue(GraphicsDevice& device) const
{
    if (!hasCounter())
    {
        Fail("'" + m_Name +
             "': GetCounterValue: the buffer has no counter; give it the target Append or Counter");
    }
    std::uint32_t value = 0;
    std::memcpy(&value, device.ReadBackBuffer(*this).data() + counterOffset(), sizeof(value));
    return value;
}

void GraphicsBuffer::Release()
{
    m_IsReleased = true;
    m_Bytes = {};
    m_Changes.clear();
}

ComputeBuffer::ComputeBuffer(int count, int stride, ComputeBufferType type)
    : GraphicsBuffer(TargetOf(type), count, stride)
{
    SetName("ComputeBuffer");
}

} // namespace limn
