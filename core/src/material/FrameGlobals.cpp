#include "material/FrameGlobals.h"

#include <algorithm>
#include <cstring>

namespace limn
{

namespace
{

/// Returns whether shaders can see no difference between two values: 0 and -0 differ.
struct AreSame
{
    template <typename Value>
    requires std::is_trivially_copyable_v<Value>
    bool operator()(const Value& a, const Value& b) const
    {
        return std::memcmp(&a, &b, sizeof(Value)) == 0;
    }
    template <typename Element>
    bool operator()(const PropertyArray<Element>& a, const PropertyArray<Element>& b) const
    {
        return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), *this);
    }
    bool operator()(const std::shared_ptr<const Texture>& a,
                    const std::shared_ptr<const Texture>& b) const
    {
        return a == b;
    }
    template <typename A, typename B>
    bool operator()(const A&, const B&) const
    {
        return false;
    }
};

} // namespace

FrameGlobals::Place FrameGlobals::PlaceOf(ShaderPropertyId id)
{
    m_Places.resize(std::max<std::size_t>(m_Places.size(), id.value + 1));
    Place& place = m_Places[id.value];
    if (place == 0)
    {
        m_Entries.push_back({id, {}, 0});
        m_Versions.push_back(0);
        place = static_cast<Place>(m_Entries.size());
    }
    return place - 1;
}

void FrameGlobals::Set(Place place, const ShaderPropertyValue& value)
{
    Entry& entry = m_Entries[place];
    if (entry.version == 0 || !std::visit(AreSame(), entry.value, value))
    {
        entry.value = value;
        entry.version = ++m_LastVersion;
    }
    m_Versions[place] = entry.version;
    m_HasBuffers = m_HasBuffers || std::holds_alternative<BufferRange>(value);
}

void FrameGlobals::Swap(Place place, std::optional<ShaderPropertyValue>& other)
{
    Entry& entry = m_Entries[place];
    std::optional<ShaderPropertyValue> now;
    if (m_Versions[place] != 0)
    {
        now = std::move(entry.value);
    }
    entry.version = ++m_LastVersion;
    m_Versions[place] = other ? entry.version : 0;
    entry.value = other ? std::move(*other) : ShaderPropertyValue();
    other = std::move(now);
}

void FrameGlobals::Clear()
{
    for (Entry& entry : m_Entries)
    {
        if (std::holds_alternative<std::shared_ptr<const Texture>>(entry.value) ||
            std::holds_alternative<BufferRange>(entry.value))
        {
            entry.value = 0.0f;
            entry.version = 0;
        }
    }
    std::ranges::fill(m_Versions, 0);
    m_HasBuffers = false;
}

} // namespace limn
