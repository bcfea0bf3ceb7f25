#pragma once

#include "frame/ArticleScene.h"

#include <array>
#include <span>

namespace limn::benchmarks
{

/// What decides on the draws of the hand-written frame, in arrays of exactly what each step needs.
/// Each frame it does what limn does: it looks for objects that have moved, culls, filters, sorts
/// and writes indices.
class HandWrittenScene
{
public:
    explicit HandWrittenScene(const ArticleNumbers& numbers);

    /// As ArticleScene::Move.
    void Move(Movement what, int step);
    void Update();

    /// Writes what has changed since `then`, a number that it was given by version().
    void WriteObjects(std::span<PerDrawData> target, std::uint64_t then) const;

    std::uint64_t version() const { return m_Version; } ///< counts updates
    bool isCameraMoved() const { return m_Camera.x != 0.0f; }
    const std::vector<ArticleGroup>& groups() const { return m_Groups; }      ///< that are in sight
    const std::vector<std::uint32_t>& instances() const { return m_Indices; } ///< of their objects

private:
    static constexpr std::size_t k_Planes = 6;

    void FindMoved();
    void Cull();
    void Sort();
    void PlaceBox(std::size_t object);
    std::array<glm::vec4, k_Planes> Planes() const;
    /// Returns where objects of a group are counted, the outlined ones first.
    std::size_t BucketOf(std::uint32_t object) const
    {
        return 2 * std::size_t{m_GroupOf[object]} + (m_IsOutlined[object] != 0 ? 0 : 1);
    }

    std::vector<Transform> m_Transforms; ///< anyone may change them
    std::vector<Transform> m_Known;      ///< as they were in the last frame
    std::vector<PerDrawData> m_PerDraw;
    std::vector<std::uint64_t> m_Changed; ///< the version that moved each
    std::vector<Bounds> m_Boxes;          ///< of their meshes
    std::array<std::vector<float>, 3> m_Center;
    std::array<std::vector<float>, 3> m_Extent;
    std::vector<std::uint16_t> m_Queue;
    std::vector<std::uint8_t> m_Layer;
    std::vector<std::uint32_t> m_RenderingLayers;
    std::vector<std::uint32_t> m_GroupOf;
    std::vector<std::uint8_t> m_IsOutlined; ///< by the filter, in this frame
    std::vector<ArticleGroup> m_AllGroups;
    std::vector<ArticleGroup> m_Groups;
    std::vector<std::uint32_t> m_Visible;
    std::vector<std::uint32_t> m_Places;
    std::vector<std::uint32_t> m_Indices;
    glm::vec3 m_Camera;
    float m_Aspect;
    std::uint64_t m_Version = 0;
};

} // namespace limn::benchmarks
