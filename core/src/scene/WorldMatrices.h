#pragma once

#include <limn/core/Transform.h>
#include <unordered_map>
#include <vector>

namespace limn
{

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

private:
    std::unordered_map<const Transform*, glm::dmat4> m_Parents; ///< of the world, for the children
    std::vector<const Transform*> m_Climbed; ///< parents not known yet, the nearest first
};

} // namespace limn
