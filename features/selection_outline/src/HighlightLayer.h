#pragma once

#include <limn/core/RenderingData.h>
#include <limn/features/OutlinedObjects.h>
#include <span>
#include <vector>

namespace limn
{

/// The objects that a second camera sees; it looks only at one layer, into which objects are moved
/// meanwhile.
class HighlightLayer
{
public:
    /// Moves the objects, culls, and moves them back.
    /// @throws ContractError if there is no scene to cull
    HighlightLayer(const RenderingData& renderingData, std::span<const OutlinedObject> objects,
                   int layer);

    const CullingResults& seen() const { return m_Seen; }
    bool wasMoved(const GameObject& object) const;

private:
    std::vector<const GameObject*> m_Moved; ///< sorted
    CullingResults m_Seen;
};

} // namespace limn
