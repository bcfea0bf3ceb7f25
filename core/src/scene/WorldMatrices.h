#pragma once

#include <limn/core/Transform.h>
#include <unordered_map>
#include <vector>

namespace limn
{

/// The transform's own part of its world matrix.
glm::dmat4 LocalMatrix(const Transform& transform);

/// World matrices of many transforms: each parent is worked out once, so that n of them take O(n)
/// however long their chains are. Valid while none of them changes.
class WorldMatrices
{
public:
    /// The same as Transform::worldMatrix.
    /// @throws ContractError if the parents form a circle
    glm::dmat4 Of(const Transform& transform);
    /// @pre it has a parent
    const glm::dmat4& OfParent(const Transform& transform);
    /// What OfParent gave for a transform with this parent; null if it was not asked.
    const glm::dmat4* FindParent(const Transform* parent) const
    {
        const auto found = m_Parents.find(parent);
        return found != m_Parents.end() ? &found->second : nullptr;
    }
    /// A change has been made.
    void Clear() { m_Parents.clear(); }

private:
    std::unordered_map<const Transform*, glm::dmat4> m_Parents; ///< of the world, for the children
    std::vector<const Transform*> m_Climbed; ///< parents not known yet, the nearest first
};

} // namespace limn
