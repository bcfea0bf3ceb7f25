#include "scene/RendererTable.h"

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
            rows.swap(m_Lists.back());
            m_Lists.pop_back();
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
