#include "scene/RendererTable.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace limn
{

std::vector<std::uint32_t> SpareRows::Take(std::size_t size)
{
    std::vector<std::uint32_t> rows;
    {
        const std::scoped_lock lock(m_Mutex);
        if (!m_Lists.empty())
        {
            // The smallest that has room, or else the largest.
            const auto order = [size](const auto& list)
            {
                const std::size_t room = list.capacity();
                return room >= size ? room - size : std::numeric_limits<std::size_t>::max() - room;
            };
            rows.swap(*std::ranges::min_element(m_Lists, {}, order));
            std::erase_if(m_Lists, [](const auto& list) { return list.capacity() == 0; });
        }
    }
    rows.resize(size);
    return rows;
}

void SpareRows::Give(std::vector<std::uint32_t> rows) noexcept
{
    const std::scoped_lock lock(m_Mutex);
    if (rows.capacity() > 0 && m_Lists.size() < k_Most)
    {
        m_Lists.reserve(k_Most);
        m_Lists.push_back(std::move(rows));
    }
}

} // namespace limn
