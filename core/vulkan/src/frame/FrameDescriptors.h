#pragma once

#include "submit/DeviceResources.h"
#include "submit/FrameSlot.h"
#include <memory_resource>

namespace limn::vulkan
{

/// Consecutive instances of a draw whose per-draw elements lie in one piece of the frame's.
struct InstanceRun
{
    std::size_t piece = 0;
    std::uint32_t first = 0; ///< its element's index in the piece
    std::uint32_t count = 0;
    std::uint32_t base = 0; ///< the draw's first instance
};

/// Holds what FrameDescriptors put together, frame by frame in the same memory.
struct DescriptorLists
{
    using SetKey = std::tuple<const DrawBindings*, VkDescriptorSetLayout, bool, std::size_t>;

    SetContent content;                                        ///< of the set that is being made
    std::array<std::vector<VkDescriptorBufferInfo>, 2> pieces; ///< of perDraw and of objects
    std::pmr::unsynchronized_pool_resource memory;
    std::pmr::map<SetKey, VkDescriptorSet> sets{&memory};
};

/// The descriptor sets of one frame; draws of equal bindings and layout share one. Per-draw data
/// beyond what the device binds at once are bound in pieces.
class FrameDescriptors
{
public:
    /// Writes the frame's uniform and per-draw data to the slot's recording. @lifetime keeps
    /// `frame` and `lists` by reference
    FrameDescriptors(const VulkanContext& context, DeviceResources& resources, FrameSlot& slot,
                     const CompiledFrame& frame, DescriptorLists& lists);

    /// The longest run that begins with the draw's instance `skipped`, counted from 0. All
    /// instances are one run where the shader reads no per-draw data.
    InstanceRun RunFrom(const DrawCommand& draw, std::uint32_t skipped) const;

    /// @param piece  of the per-draw data
    /// @throws ContractError naming what the shader reads and the draw does not bind
    /// @param number  of the frame's submission, which uses the draw's textures
    VkDescriptorSet Get(const DrawCommand& draw, const ProgramObjects& pass, std::size_t piece,
                        std::uint64_t number);
    VkDescriptorSet Get(const DispatchCommand& dispatch, const ProgramObjects& kernel,
                        std::uint64_t number);
    /// What no set binds: the device's own, with what was set until now.
    VkBuffer Use(const std::shared_ptr<const GraphicsBuffer>& buffer, std::uint64_t number);

private:
    void Use(const DrawBindings& bindings, std::uint64_t number);
    /// Where a draw has objects: brings their buffer up to date, before any pass.
    void UseObjects(std::uint64_t number);
    void AddPieces(VkBuffer buffer, VkDeviceSize offset, std::size_t count,
                   std::vector<VkDescriptorBufferInfo>& pieces) const;
    void RequireInstances(const DrawCommand& draw) const;
    VkDescriptorSet Create(const PropertyLayout& layout, const DrawBindings& bindings,
                           VkDescriptorSetLayout setLayout,
                           const std::vector<VkDescriptorBufferInfo>& pieces, std::size_t piece,
                           std::uint64_t number);

    DeviceResources& m_Resources;
    FrameSlot& m_Slot;
    const CompiledFrame& m_Frame;
    DescriptorLists& m_Lists;
    const FrameData* m_Data = nullptr;
    std::uint32_t m_PieceElements; ///< of per-draw data, the last piece apart
};

} // namespace limn::vulkan
