#pragma once

#include <cstdint>
#include <limn/core/Transform.h>
#include <unordered_map>
#include <vector>

namespace limn
{

/// Returns the transform's own part of its world matrix.
glm::dmat4 LocalMatrix(const Transform& transform);

/// Computes the world matrices of many transforms: each parent is computed once, so that n of them
/// take O(n) however long their chains are. The matrices are valid while none of the transforms
/// changes.
class WorldMatrices
{
public:
    /// Returns the same as Transform::worldMatrix.
    /// @throws ContractError if the parents form a cycle
    glm::dmat4 Of(const Transform& transform);
    /// Returns the world matrix of the transform's parent.
    /// @pre it has a parent
    const glm::dmat4& OfParent(const Transform& transform);
    /// Returns the result of OfParent for a transform with this parent; null if it was not called
    /// for one.
    const glm::dmat4* FindParent(const Transform* parent) const
    {
        const auto found = m_Parents.find(parent);
        return found != m_Parents.end() && found->second.round == m_Round ? &found->second.world
                                                                          : nullptr;
    }
    /// Begins anew after transforms have changed; the memory stays.
    void Clear();

private:
    struct Parent
    {
        glm::dmat4 world{1.0};   ///< for the children
        std::uint64_t round = 0; ///< the round in which it was computed
    };
    std::unordered_map<const Transform*, Parent> m_Parents;
    std::uint64_t m_Round = 1;
    std::size_t m_Known = 0;                 ///< parents computed in this round
    std::vector<const Transform*> m_Climbed; ///< parents not known yet, the nearest first
};

} // namespace limn
