#include "descriptors/FrameData.h"

#include <cstring>
#include <limn/core/DrawError.h>

namespace limn::vulkan
{

namespace
{

std::size_t InstanceCount(const CompiledFrame& frame)
{
    return frame.instances.empty() ? frame.perDraw.size() : frame.instances.size();
}

void Copy(std::byte* target, std::span<const std::byte> bytes)
{
    if (!bytes.empty())
    {
        std::memcpy(target, bytes.data(), bytes.size());
    }
}

} // namespace

FrameData::FrameData(const CompiledFrame& frame, LinearMemory& memory, std::uint32_t pieceElements,
                     const VkPhysicalDeviceLimits& limits)
    : m_CountsInstances(frame.instances.empty()), m_PieceElements(pieceElements)
{
    const std::size_t instances = InstanceCount(frame);
    if (instances > limits.maxStorageBufferRange / sizeof(std::uint32_t))
    {
        throw ContractError("the frame draws " + std::to_string(instances) +
                            " instances; the device takes at most " +
                            std::to_string(limits.maxStorageBufferRange / sizeof(std::uint32_t)));
    }
    m_Uniforms = Allocate(frame.uniformData.size(), memory);
    m_PerDraw = Allocate(frame.perDraw.size() * sizeof(PerDrawData), memory);
    m_Instances = Allocate(instances * sizeof(std::uint32_t), memory);
    Write(frame);
}

FrameData::Place FrameData::Allocate(std::size_t size, LinearMemory& memory)
{
    if (size == 0)
    {
        return {};
    }
    const UploadedBytes bytes = memory.Allocate(size);
    return {{bytes.buffer, bytes.offset, size}, bytes.mapped};
}

bool FrameData::isInOnePiece(const CompiledFrame& frame) const
{
    return frame.perDraw.size() <= m_PieceElements &&
           (!frame.objects || frame.objects->count() <= m_PieceElements);
}

bool FrameData::Fits(const CompiledFrame& frame) const
{
    return frame.uniformData.size() == m_Uniforms.info.range &&
           frame.perDraw.size() * sizeof(PerDrawData) == m_PerDraw.info.range &&
           InstanceCount(frame) * sizeof(std::uint32_t) == m_Instances.info.range &&
           frame.instances.empty() == m_CountsInstances && isInOnePiece(frame);
}

void FrameData::Write(const CompiledFrame& frame)
{
    Copy(m_Uniforms.mapped, frame.uniformData);
    Copy(m_PerDraw.mapped, std::as_bytes(std::span{frame.perDraw}));
    if (isInOnePiece(frame) && !frame.instances.empty())
    {
        Copy(m_Instances.mapped, std::as_bytes(std::span{frame.instances}));
        return;
    }
    auto* const target = reinterpret_cast<std::uint32_t*>(m_Instances.mapped);
    for (std::uint32_t i = 0; i < InstanceCount(frame); ++i)
    {
        target[i] = frame.Element(i) % m_PieceElements;
    }
}

} // namespace limn::vulkan
