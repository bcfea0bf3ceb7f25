#include "descriptors/DescriptorCache.h"

namespace limn::vulkan
{

std::size_t DescriptorCache::Hash::operator()(const std::vector<std::uint64_t>& key) const
{
    std::uint64_t hash = 0;
    for (const std::uint64_t number : key)
    {
        hash = (hash ^ number) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 32U;
    }
    return hash;
}

void DescriptorCache::Begin(std::uint64_t destroyed)
{
    constexpr std::size_t k_Spare = 64;
    if (destroyed != m_Destroyed || m_Sets.size() > 2 * m_Used + k_Spare)
    {
        m_Sets.clear();
        m_Allocator.Reset();
        m_Destroyed = destroyed;
    }
    ++m_Frame;
    m_Used = 0;
}

VkDescriptorSet DescriptorCache::Get(SetContent& content)
{
    const auto found = m_Sets.find(content.key());
    Entry& entry = found != m_Sets.end() ? found->second : m_Sets[content.key()];
    if (entry.set == VK_NULL_HANDLE)
    {
        entry.set = m_Allocator.Allocate(content.layout());
        content.WriteTo(m_Device, entry.set);
        ++m_WriteCount;
    }
    m_Used += entry.frame != m_Frame ? 1 : 0;
    entry.frame = m_Frame;
    return entry.set;
}

} // namespace limn::vulkan
