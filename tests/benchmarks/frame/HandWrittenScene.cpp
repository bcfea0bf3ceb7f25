#include "frame/HandWrittenScene.h"

#include "scene/PerDraw.h"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace limn::benchmarks
{

HandWrittenScene::HandWrittenScene(const ArticleNumbers& numbers)
    : m_AllGroups(numbers.groups),
      m_Camera(0.0f, 0.0f, -k_CameraDistance),
      m_Aspect(static_cast<float>(numbers.width) / static_cast<float>(numbers.height))
{
    const std::size_t count = numbers.objects.size();
    m_Known.resize(count);
    m_PerDraw.resize(count);
    m_Changed.resize(count);
    m_IsOutlined.resize(count);
    m_Places.resize(2 * m_AllGroups.size());
    for (std::vector<float>& values : m_Center)
    {
        values.resize(count);
    }
    for (std::vector<float>& values : m_Extent)
    {
        values.resize(count);
    }
    for (const ArticleObject& object : numbers.objects)
    {
        m_Transforms.push_back(object.transform);
        m_Boxes.push_back(m_AllGroups[object.group].mesh->bounds());
        m_Queue.push_back(2000);
        m_Layer.push_back(0);
        m_RenderingLayers.push_back(object.renderingLayers.bits);
        m_GroupOf.push_back(static_cast<std::uint32_t>(object.group));
        m_Known[m_Transforms.size() - 1].localScale = glm::vec3(0.0f); // it has not been seen
    }
}

void HandWrittenScene::Move(Movement what, int step)
{
    const float place = step % 2 != 0 ? k_Step : 0.0f;
    if (what == Movement::Camera)
    {
        m_Camera.x = place;
    }
    for (std::size_t i = 0; i < MovedCount(what, m_Transforms.size()); ++i)
    {
        m_Transforms[i].localPosition.z = place;
    }
}

void HandWrittenScene::Update()
{
    ++m_Version;
    FindMoved();
    Cull();
    Sort();
}

void HandWrittenScene::FindMoved()
{
    for (std::size_t i = 0; i < m_Transforms.size(); ++i)
    {
        const Transform& now = m_Transforms[i];
        Transform& known = m_Known[i];
        if (now.localPosition != known.localPosition || now.localRotation != known.localRotation ||
            now.localScale != known.localScale)
        {
            known = now;
            m_PerDraw[i] = MakePerDrawData(
                now.worldMatrix(), RenderingLayerMask{m_RenderingLayers[i]}, glm::dvec3(0.0));
            m_Changed[i] = m_Version;
            PlaceBox(i);
        }
    }
}

void HandWrittenScene::PlaceBox(std::size_t object)
{
    const float* world = m_PerDraw[object].objectToWorld;
    const Bounds& box = m_Boxes[object];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        float center = world[12 + axis];
        float extent = 0.0f;
        for (int column = 0; column < 3; ++column)
        {
            const float factor = world[4 * static_cast<std::size_t>(column) + axis];
            center += factor * box.center[column];
            extent += std::abs(factor) * box.extents[column];
        }
        m_Center[axis][object] = center;
        m_Extent[axis][object] = extent;
    }
}

std::array<glm::vec4, HandWrittenScene::k_Planes> HandWrittenScene::Planes() const
{
    const float f = 1.0f / std::tan(k_CameraFieldOfView * 0.5f * 3.14159265f / 180.0f);
    const float a = f / m_Aspect;
    std::array<glm::vec4, k_Planes> planes = {{{a, 0, 1, 0},
                                               {-a, 0, 1, 0},
                                               {0, f, 1, 0},
                                               {0, -f, 1, 0},
                                               {0, 0, 1, -0.3f},
                                               {0, 0, -1, 1000}}};
    for (glm::vec4& plane : planes)
    {
        plane.w -= glm::dot(glm::vec3(plane), m_Camera);
    }
    return planes;
}

void HandWrittenScene::Cull()
{
    const auto planes = Planes();
    const std::size_t count = m_Transforms.size();
    m_Visible.resize(count);
    std::size_t visible = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        bool inside = true;
        for (const glm::vec4& plane : planes)
        {
            float depth = plane.w;
            for (int axis = 0; axis < 3; ++axis)
            {
                depth += plane[axis] * m_Center[static_cast<std::size_t>(axis)][i] +
                         std::abs(plane[axis]) * m_Extent[static_cast<std::size_t>(axis)][i];
            }
            inside &= depth >= 0.0f;
        }
        inside &= m_Queue[i] <= 2500;
        m_IsOutlined[i] = ((0xFFFFFFFFu >> m_Layer[i]) & 1u) != 0 &&
                          (m_RenderingLayers[i] & k_OutlinedLayers.bits) != 0;
        m_Visible[visible] = static_cast<std::uint32_t>(i);
        visible += inside;
    }
    m_Visible.resize(visible);
}

/// Counts the objects of each bucket, which is all that sorting by state needs.
void HandWrittenScene::Sort()
{
    std::ranges::fill(m_Places, 0u);
    for (const std::uint32_t object : m_Visible)
    {
        ++m_Places[BucketOf(object)];
    }
    m_Groups.clear();
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < m_AllGroups.size(); ++i)
    {
        const std::uint32_t outlined = m_Places[2 * i];
        const std::uint32_t count = outlined + m_Places[2 * i + 1];
        if (count > 0)
        {
            m_Groups.push_back(m_AllGroups[i]);
            m_Groups.back().first = next;
            m_Groups.back().count = count;
            m_Groups.back().outlined = outlined;
        }
        m_Places[2 * i] = next;
        m_Places[2 * i + 1] = next + outlined;
        next += count;
    }
    m_Indices.resize(m_Visible.size());
    for (const std::uint32_t object : m_Visible)
    {
        m_Indices[m_Places[BucketOf(object)]++] = object;
    }
}

void HandWrittenScene::WriteObjects(std::span<PerDrawData> target, std::uint64_t then) const
{
    for (std::size_t i = 0; i < m_PerDraw.size(); ++i)
    {
        if (m_Changed[i] > then)
        {
            std::memcpy(&target[i], &m_PerDraw[i], sizeof(PerDrawData));
        }
    }
}

} // namespace limn::benchmarks
