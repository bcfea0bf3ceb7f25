#pragma once

#include "memory/LinearMemory.h"
#include <limn/core/CompiledFrame.h>

namespace limn::vulkan
{

/// The place of the bytes that a frame gives to its shaders. Another frame can write its bytes to
/// the same place.
class FrameData
{
public:
    /// Allocates the places and writes them.
    /// @param pieceElements  the number of elements per piece in which per-draw data are bound;
    ///     instances count from the beginning of their piece
    /// @throws ContractError if the frame draws more instances than `limits` has
    FrameData(const CompiledFrame& frame, LinearMemory& memory, std::uint32_t pieceElements,
              const VkPhysicalDeviceLimits& limits);

    /// Returns whether the frame has the same number of bytes, and its per-draw data are in one
    /// piece.
    bool Fits(const CompiledFrame& frame) const;
    /// @pre Fits()
    void Write(const CompiledFrame& frame);

    const VkDescriptorBufferInfo& uniforms() const { return m_Uniforms.info; }
    const VkDescriptorBufferInfo& perDraw() const { return m_PerDraw.info; }
    const VkDescriptorBufferInfo& instances() const { return m_Instances.info; }

private:
    struct Place
    {
        VkDescriptorBufferInfo info{}; ///< empty = there are none
        std::byte* mapped = nullptr;
    };

    static Place Allocate(std::size_t size, LinearMemory& memory);
    bool isInOnePiece(const CompiledFrame& frame) const;

    Place m_Uniforms;
    Place m_PerDraw;
    Place m_Instances;
    bool m_CountsInstances = false; ///< CompiledFrame::instances is empty
    std::uint32_t m_PieceElements;
};

} // namespace limn::vulkan
