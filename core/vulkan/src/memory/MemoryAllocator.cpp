#include "memory/MemoryAllocator.h"

#include "device/Check.h"
#include <algorithm>
#include <limn/vulkan/VulkanError.h>
#include <numeric>

namespace limn::vulkan
{

namespace
{

constexpr VkDeviceSize k_BlockBytes = VkDeviceSize{16} << 20;
constexpr int k_FramesKeptEmpty = 8;

/// Returns the wanted properties of the memory, the best first.
std::vector<VkMemoryPropertyFlags> WishesFor(MemoryUse use)
{
    constexpr VkMemoryPropertyFlags visible =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    switch (use)
    {
    case MemoryUse::Upload:
    case MemoryUse::Staging:
        return {visible};
    case MemoryUse::ReadBack:
        return {visible | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, visible};
    case MemoryUse::Transient:
        return {VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
    case MemoryUse::Gpu:
        break;
    }
    return {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
}

bool isMapped(MemoryUse use)
{
    return use == MemoryUse::Upload || use == MemoryUse::Staging || use == MemoryUse::ReadBack;
}

} // namespace

struct MemoryAllocation::Block
{
    UniqueMemory memory;
    std::byte* mapped = nullptr;
    VkDeviceSize size = 0;
    std::uint32_t type = 0;
    MemoryUse use = MemoryUse::Gpu;
    MemoryContent content = MemoryContent::Buffers;
    RangeAllocator ranges{0};
    int framesEmpty = 0; ///< at a stretch

    bool isEmpty() const { return ranges.usedBytes() == 0; }
    bool isOfKind(std::uint32_t itsType, MemoryUse itsUse, MemoryContent itsContent) const
    {
        return type == itsType && use == itsUse && content == itsContent;
    }
};

MemoryAllocation::~MemoryAllocation()
{
    if (m_Allocator != nullptr)
    {
        m_Allocator->Return(*m_Block, m_Offset, m_Size);
    }
}

void MemoryAllocation::Swap(MemoryAllocation& other) noexcept
{
    std::swap(m_Allocator, other.m_Allocator);
    std::swap(m_Block, other.m_Block);
    std::swap(m_Offset, other.m_Offset);
    std::swap(m_Size, other.m_Size);
}

VkDeviceMemory MemoryAllocation::memory() const
{
    return m_Block->memory.get();
}

std::byte* MemoryAllocation::mapped() const
{
    return m_Block->mapped == nullptr ? nullptr : m_Block->mapped + m_Offset;
}

MemoryAllocator::MemoryAllocator(VkDevice device, VkPhysicalDevice physicalDevice)
    : m_Device(device)
{
    vkGetPhysicalDeviceMemoryProperties(physicalDevice, &m_Properties);
}

MemoryAllocator::~MemoryAllocator() = default;

MemoryAllocation MemoryAllocator::Allocate(const VkMemoryRequirements& needs, MemoryUse use,
                                           MemoryContent content, const std::string& name)
{
    MemoryAllocation result;
    const auto take = [&](Block& block)
    {
        const auto offset = block.ranges.Allocate(needs.size, needs.alignment);
        if (offset)
        {
            result.m_Allocator = this;
            result.m_Block = &block;
            result.m_Offset = *offset;
            result.m_Size = needs.size;
            block.framesEmpty = 0;
        }
        return offset.has_value();
    };
    const std::vector<std::uint32_t> types = MemoryTypes(needs.memoryTypeBits, use);
    for (const std::uint32_t type : types)
    {
        for (const auto& block : m_Blocks)
        {
            if (block->isOfKind(type, use, content) && take(*block))
            {
                return result;
            }
        }
        // A resource that would fill half a block gets one of its own size.
        const VkDeviceSize size = needs.size > k_BlockBytes / 2 ? needs.size : k_BlockBytes;
        if (UniqueMemory memory = TryAllocate(size, type, name))
        {
            take(NewBlock(std::move(memory), size, type, use, content, name));
            return result;
        }
    }
    if (types.empty())
    {
        throw VulkanError("the device has no kind of memory that fits '" + name + "'");
    }
    throw VulkanError("vkAllocateMemory", ResultName(VK_ERROR_OUT_OF_DEVICE_MEMORY), name);
}

void MemoryAllocator::Sweep()
{
    std::erase_if(m_Blocks, [](const auto& block)
                  { return block->isEmpty() && ++block->framesEmpty > k_FramesKeptEmpty; });
}

VkDeviceSize MemoryAllocator::allocatedBytes() const
{
    return std::accumulate(m_Blocks.begin(), m_Blocks.end(), VkDeviceSize{0},
                           [](VkDeviceSize sum, const auto& block) { return sum + block->size; });
}

VkDeviceSize MemoryAllocator::usedBytes() const
{
    return std::accumulate(m_Blocks.begin(), m_Blocks.end(), VkDeviceSize{0},
                           [](VkDeviceSize sum, const auto& block)
                           { return sum + block->ranges.usedBytes(); });
}

/// The best first.
std::vector<std::uint32_t> MemoryAllocator::MemoryTypes(std::uint32_t allowed, MemoryUse use) const
{
    std::vector<std::uint32_t> types;
    for (const VkMemoryPropertyFlags flags : WishesFor(use))
    {
        for (std::uint32_t i = 0; i < m_Properties.memoryTypeCount; ++i)
        {
            const VkMemoryPropertyFlags has = m_Properties.memoryTypes[i].propertyFlags;
            const bool isOpen = // that kind asks for a feature
                (has & VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD) == 0;
            if (isOpen && (allowed & (1U << i)) != 0 && (has & flags) == flags &&
                std::ranges::find(types, i) == types.end())
            {
                types.push_back(i);
            }
        }
    }
    return types;
}

UniqueMemory MemoryAllocator::TryAllocate(VkDeviceSize size, std::uint32_t type,
                                          const std::string& name)
{
    auto info = Make<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.allocationSize = size;
    info.memoryTypeIndex = type;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkResult result = vkAllocateMemory(m_Device, &info, nullptr, &memory);
    const auto isKept = [&](const auto& block)
    {
        return block->type == type && block->isEmpty();
    };
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY && std::erase_if(m_Blocks, isKept) > 0)
    {
        result = vkAllocateMemory(m_Device, &info, nullptr, &memory);
    }
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY)
    {
        return {};
    }
    Check(result, "vkAllocateMemory", name);
    return {m_Device, memory};
}

MemoryAllocator::Block& MemoryAllocator::NewBlock(UniqueMemory memory, VkDeviceSize size,
                                                  std::uint32_t type, MemoryUse use,
                                                  MemoryContent content, const std::string& name)
{
    void* mapped = nullptr;
    if (isMapped(use))
    {
        Check(vkMapMemory(m_Device, memory.get(), 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory",
              name);
    }
    m_Blocks.push_back(
        std::make_unique<Block>(Block{std::move(memory), static_cast<std::byte*>(mapped), size,
                                      type, use, content, RangeAllocator{size}}));
    return *m_Blocks.back();
}

void MemoryAllocator::Return(Block& block, VkDeviceSize offset, VkDeviceSize size) noexcept
{
    block.ranges.Free(offset, size);
    m_Returned += block.use == MemoryUse::Staging || block.use == MemoryUse::ReadBack ? 0 : 1;
}

Buffer::Buffer(VkDevice device, MemoryAllocator& allocator, VkDeviceSize bytes,
               VkBufferUsageFlags usage, MemoryUse use, const std::string& name)
    : size(bytes)
{
    auto info = Make<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = bytes;
    info.usage = usage;
    handle = UniqueBuffer{device, vkCreateBuffer, info, "vkCreateBuffer", name};
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device, handle.get(), &needs);
    memory = allocator.Allocate(needs, use, MemoryContent::Buffers, name);
    Check(vkBindBufferMemory(device, handle.get(), memory.memory(), memory.offset()),
          "vkBindBufferMemory", name);
}

} // namespace limn::vulkan
