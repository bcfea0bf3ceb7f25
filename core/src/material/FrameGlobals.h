#pragma once

#include <functional>
#include <limn/core/MaterialPropertyBlock.h>
#include <optional>

namespace limn
{

/// The shader properties that command buffers have made global in a frame. A property keeps its
/// place from frame to frame, so that a reader looks for it only once.
class FrameGlobals
{
public:
    using Place = std::uint32_t;

    /// Returns the place of a property, which is made if there is none.
    Place PlaceOf(ShaderPropertyId id);

    /// Returns the value, or null if this frame has not set it. The pointer is valid until a place
    /// is made.
    const ShaderPropertyValue* At(Place place) const
    {
        return m_Versions[place] != 0 ? &m_Entries[place].value : nullptr;
    }
    /// Returns a number that stays as long as At gives the same value, also in later frames; 0 =
    /// this frame has not set it.
    std::uint64_t VersionAt(Place place) const { return m_Versions[place]; }
    const ShaderPropertyValue* Find(ShaderPropertyId id) const
    {
        const bool isKnown = id.value < m_Places.size() && m_Places[id.value] != 0;
        return isKnown ? At(m_Places[id.value] - 1) : nullptr;
    }

    /// @pre the value is finite
    void Set(Place place, const ShaderPropertyValue& value);
    void Set(ShaderPropertyId id, const ShaderPropertyValue& value) { Set(PlaceOf(id), value); }
    /// Exchanges the value with another one; none = it is not set.
    void Swap(Place place, std::optional<ShaderPropertyValue>& other);
    /// Begins a frame, in which nothing is set. It releases textures and buffers.
    void Clear();

    bool hasBuffers() const { return m_HasBuffers; } ///< returns whether one was set since Clear

    /// Calls `function` with the name and value of each property that is set.
    template <typename Function>
    void ForEach(const Function& function) const
    {
        for (Place place = 0; place < m_Entries.size(); ++place)
        {
            if (const ShaderPropertyValue* value = At(place))
            {
                function(m_Entries[place].id, *value);
            }
        }
    }

private:
    struct Entry
    {
        ShaderPropertyId id;
        ShaderPropertyValue value; ///< the last one, of whichever frame
        std::uint64_t version = 0; ///< of the value; 0 = there was none yet
    };
    std::vector<Entry> m_Entries;
    std::vector<std::uint64_t> m_Versions; ///< what VersionAt returns, side by side
    std::uint64_t m_LastVersion = 0;
    std::vector<Place> m_Places; ///< by the number of the name, plus one; 0 = it has none
    bool m_HasBuffers = false;
};

/// The values that Shader::SetGlobalFloat and its like have set in the process; any thread may use
/// it.
namespace ShaderGlobals
{

/// Returns a number that grows with every change; 0 = there was none.
std::uint64_t version();
void ForEach(const std::function<void(ShaderPropertyId, const ShaderPropertyValue&)>& function);

} // namespace ShaderGlobals

} // namespace limn
