#pragma once

#include "submit/FrameSlot.h"
#include <memory_resource>

namespace limn::vulkan
{

/// Consecutive instances of a draw whose per-draw elements lie in one piece of the frame's data.
struct InstanceRun
{
    std::size_t piece = 0;
    std::uint32_t first = 0; ///< the index of the first instance's element in the piece
    std::uint32_t count = 0;
    std::uint32_t base = 0; ///< the draw's first instance
};

/// Holds the lists of FrameDescriptors, which every frame builds in the same memory.
struct DescriptorLists
{
    using SetKey = std::tuple<const DrawBindings*, VkDescriptorSetLayout, bool, std::size_t>;

    SetContent content; ///< the content of the set that is being made
    /// The pieces of perDraw and of objects.
    std::array<std::vector<VkDescriptorBufferInfo>, 2> pieces;
    std::pmr::unsynchronized_pool_resource memory;
    std::pmr::map<SetKey, VkDescriptorSet> sets{&memory};
};

/// The descriptor sets of one frame; draws with equal bindings and layout share one. If there are
/// more per-draw data than the device binds at once, they are bound in pieces.
class FrameDescriptors
{
public:
    /// Writes the frame's uniform and per-draw data to the slot's recording.
    /// @lifetime keeps `frame` and `lists` by reference
    /// @param number  the number of the frame's submission
    FrameDescriptors(const VulkanContext& context, DeviceResources& resources, FrameSlot& slot,
                     const CompiledFrame& frame, DescriptorLists& lists, std::uint64_t number);

    /// Returns the longest run that begins with the draw's instance `skipped`, counted from 0. All
    /// instances are one run if the shader reads no per-draw data.
    InstanceRun RunFrom(const DrawCommand& draw, std::uint32_t skipped) const;

    /// @param piece  the piece of the per-draw data
    /// @throws ContractError with the name of what the shader reads and the draw does not bind
    VkDescriptorSet Get(const DrawCommand& draw, const ProgramObjects& pass, std::size_t piece);
    VkDescriptorSet Get(const DispatchCommand& dispatch, const ProgramObjects& kernel);
    /// Returns the device's buffer for a GraphicsBuffer that no set binds, with the data set until
    /// now.
    VkBuffer Use(const std::shared_ptr<const GraphicsBuffer>& buffer);

private:
    VkDescriptorSet Get(const PropertyLayout& layout, const DrawBindings& bindings,
                        const ProgramObjects& program, bool readsObjects, std::size_t piece);
    void Use(const DrawBindings& bindings);
    /// Updates the buffer of the objects, if a draw has any, before all passes.
    void UseObjects();
    void AddPieces(VkBuffer buffer, VkDeviceSize offset, std::size_t count,
                   std::vector<VkDescriptorBufferInfo>& pieces) const;
    void RequireInstances(const DrawCommand& draw) const;
    VkDescriptorSet Create(const PropertyLayout& layout, const DrawBindings& bindings,
                           VkDescriptorSetLayout setLayout,
                           const std::vector<VkDescriptorBufferInfo>& pieces, std::size_t piece);

    DeviceResources& m_Resources;
    FrameSlot& m_Slot;
    const CompiledFrame& m_Frame;
    DescriptorLists& m_Lists;
    std::uint64_t m_Number;
    const FrameData* m_Data = nullptr;
    std::uint32_t m_PieceElements; ///< elements of per-draw data per piece, except the last one
};

} // namespace limn::vulkan
