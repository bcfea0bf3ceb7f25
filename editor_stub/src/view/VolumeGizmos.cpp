#include "view/VolumeGizmos.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <optional>
#include <variant>

namespace limn
{

namespace
{

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb k_VolumeColor{40, 220, 90};
constexpr Rgb k_TriggerColor{230, 40, 200};
constexpr int k_Dash = 6; ///< pixels
constexpr int k_ContourPoints = 96;
constexpr double k_HalfCross = 0.25; ///< metres

/// Draws lines in world space into a picture, two pixels wide.
struct LineDrawer
{
    Image& picture;
    glm::dmat4 clipFromWorld;
    int drawn = 0; ///< pixels so far, so that dashes go on from one short line to the next

    void Draw(const glm::dvec3& from, const glm::dvec3& to, const Rgb& color, bool isDashed = false)
    {
        glm::dvec4 a = clipFromWorld * glm::dvec4(from, 1.0);
        glm::dvec4 b = clipFromWorld * glm::dvec4(to, 1.0);
        if (!std::isfinite(glm::dot(a, a) + glm::dot(b, b)))
        {
            return;
        }
        // A line is kept where x, y and -z lie between -w and w: left, right, bottom, top, near.
        for (const glm::dvec4 plane : std::initializer_list<glm::dvec4>{
                 {1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}, {0, 0, 1, 1}})
        {
            const double sideOfA = glm::dot(plane, a);
            const double sideOfB = glm::dot(plane, b);
            if (sideOfA <= 0.0 && sideOfB <= 0.0)
            {
                return;
            }
            const glm::dvec4 cut = glm::mix(a, b, sideOfA / (sideOfA - sideOfB));
            a = sideOfA < 0.0 ? cut : a;
            b = sideOfB < 0.0 ? cut : b;
        }
        if (a.w > 0.0 && b.w > 0.0)
        {
            DrawPixels(ToPixels(a), ToPixels(b), color, isDashed);
        }
    }

private:
    glm::dvec2 ToPixels(const glm::dvec4& clip) const
    {
        return {(0.5 + 0.5 * clip.x / clip.w) * picture.width,
                (0.5 - 0.5 * clip.y / clip.w) * picture.height};
    }

    void DrawPixels(const glm::dvec2& from, const glm::dvec2& to, const Rgb& color, bool isDashed)
    {
        const glm::dvec2 way = to - from;
        const bool isSteep = std::abs(way.y) > std::abs(way.x);
        const int steps =
            std::max(1, static_cast<int>(std::ceil(std::max(std::abs(way.x), std::abs(way.y)))));
        for (int step = 0; step <= steps; ++step, ++drawn)
        {
            const glm::dvec2 place = from + way * (static_cast<double>(step) / steps);
            if (!isDashed || (drawn / k_Dash) % 2 == 0)
            {
                const int x = static_cast<int>(std::floor(place.x));
                const int y = static_cast<int>(std::floor(place.y));
                Set(x, y, color);
                Set(x + (isSteep ? 1 : 0), y + (isSteep ? 0 : 1), color);
            }
        }
    }

    void Set(int x, int y, const Rgb& color)
    {
        if (x < 0 || y < 0 || x >= picture.width || y >= picture.height)
        {
            return;
        }
        const std::size_t texel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
            static_cast<std::size_t>(x);
        for (std::size_t i = 0; i < 3; ++i)
        {
            picture.texels[4 * texel + i] = static_cast<std::byte>(color[i]);
        }
    }
};

/// One collider of a volume, whatever its shape.
struct ColliderOutline
{
    const Volume& volume;
    const Collider& collider;

    bool isEnabled() const
    {
        return std::visit([](const auto& shape) { return shape.enabled; }, collider);
    }

    /// Draws where three planes through the middle cut the surface `distance` metres outside.
    void DrawContours(double distance, bool isDashed, LineDrawer& lines) const
    {
        const glm::dquat turn(volume.rotation);
        for (int axis = 0; axis < 3; ++axis)
        {
            std::optional<glm::dvec3> last;
            for (int i = 0; i <= k_ContourPoints; ++i)
            {
                const double angle = 2.0 * std::numbers::pi * i / k_ContourPoints;
                glm::dvec3 direction(0.0);
                direction[(axis + 1) % 3] = std::cos(angle);
                direction[(axis + 2) % 3] = std::sin(angle);
                const glm::dvec3 point = SurfacePoint(turn * direction, distance);
                if (last)
                {
                    lines.Draw(*last, point, k_VolumeColor, isDashed);
                }
                last = point;
            }
        }
    }

    /// Draws the twelve edges and returns true if the collider is a box.
    bool DrawBoxEdges(LineDrawer& lines) const
    {
        const auto* box = std::get_if<BoxCollider>(&collider);
        for (int corner = 0; box && corner < 8; ++corner)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                if (((corner >> axis) & 1) == 0)
                {
                    lines.Draw(Corner(*box, corner), Corner(*box, corner | (1 << axis)),
                               k_VolumeColor);
                }
            }
        }
        return box != nullptr;
    }

private:
    glm::dvec3 ToWorld(const glm::dvec3& local) const
    {
        return glm::dvec3(volume.position) +
               glm::dquat(volume.rotation) * (glm::dvec3(volume.scale) * local);
    }

    glm::dvec3 Corner(const BoxCollider& box, int corner) const
    {
        const glm::dvec3 side((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                              (corner & 4) != 0 ? 0.5 : -0.5);
        return ToWorld(glm::dvec3(box.center) + side * glm::dvec3(box.size));
    }

    glm::dvec3 Middle() const
    {
        if (const auto* mesh = std::get_if<MeshCollider>(&collider))
        {
            const auto& vertices = mesh->mesh().data().vertices;
            glm::dvec3 sum(0.0);
            for (const auto& vertex : vertices)
            {
                sum += glm::dvec3(vertex) / static_cast<double>(vertices.size());
            }
            return ToWorld(sum);
        }
        return std::visit(
            [&](const auto& shape)
            {
                if constexpr (requires { shape.center; })
                {
                    return ToWorld(glm::dvec3(shape.center));
                }
                return glm::dvec3(0.0);
            },
            collider);
    }

    double DistanceTo(const glm::dvec3& point) const
    {
        const glm::vec3 rounded(point);
        const glm::dvec3 closest = std::visit(
            [&](const auto& shape)
            { return shape.ClosestPoint(rounded, volume.position, volume.rotation, volume.scale); },
            collider);
        return glm::length(closest - glm::dvec3(rounded));
    }

    /// Returns where a ray from the middle leaves what lies within `distance` of the collider. The
    /// shapes are convex, so that it does so once.
    glm::dvec3 SurfacePoint(const glm::dvec3& direction, double distance) const
    {
        const glm::dvec3 middle = Middle();
        double inside = 0.0;
        double outside = 1.0;
        while (outside < 1e9 && DistanceTo(middle + direction * outside) <= distance)
        {
            inside = outside;
            outside *= 2.0;
        }
        for (int i = 0; i < 40; ++i)
        {
            const double half = 0.5 * (inside + outside);
            (DistanceTo(middle + direction * half) <= distance ? inside : outside) = half;
        }
        return middle + direction * inside;
    }
};

} // namespace

int DrawVolumes(Image& picture, const Camera& camera, std::span<const Volume> volumes)
{
    const float aspect = static_cast<float>(picture.width) / static_cast<float>(picture.height);
    LineDrawer lines{picture, glm::dmat4(camera.cullingMatrix(aspect))};
    int count = 0;
    for (const Volume& volume : volumes)
    {
        for (const Collider& collider : volume.colliders)
        {
            const ColliderOutline shape{volume, collider};
            if (volume.isGlobal || !volume.enabled || !shape.isEnabled())
            {
                continue;
            }
            ++count;
            if (!shape.DrawBoxEdges(lines))
            {
                shape.DrawContours(0.0, false, lines);
            }
            if (volume.blendDistance > 0.0f)
            {
                shape.DrawContours(static_cast<double>(volume.blendDistance), true, lines);
            }
        }
    }
    for (int axis = 0; camera.volumeTrigger && axis < 3; ++axis)
    {
        glm::dvec3 half(0.0);
        half[axis] = k_HalfCross;
        const glm::dvec3 trigger(*camera.volumeTrigger);
        lines.Draw(trigger - half, trigger + half, k_TriggerColor);
    }
    return count;
}

} // namespace limn
