#pragma once

#include "features/OutlineGpuReference.h"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limn/core/Camera.h>
#include <limn/core/Scene.h>

namespace limn::test
{

/// A camera's matrices in double.
struct SoftCamera
{
    SoftCamera(const Camera& camera, int pictureWidth, int pictureHeight)
        : width(pictureWidth),
          height(pictureHeight),
          isOrthographic(camera.orthographic),
          view(camera.viewMatrix()),
          projection(camera.gpuProjectionMatrix(static_cast<float>(pictureWidth) /
                                                static_cast<float>(pictureHeight)))
    {
    }

    int width;
    int height;
    bool isOrthographic;
    glm::dmat4 view;
    glm::dmat4 projection;
    glm::dvec2 move{0.0}; ///< of all that is drawn, in pixels
};

/// A pixel of a triangle: its depth, 1 near, and what each corner counts there, in space.
struct SoftPixel
{
    int x = 0;
    int y = 0;
    double depth = 0.0;
    glm::dvec3 weights{0.0};
};

/// The pixels whose centres lie in a triangle, seen from either side; all of it lies in front of
/// the camera.
/// @param clip  its corners
inline void ForEachPixel(const SoftCamera& camera, const glm::dvec4 (&clip)[3],
                         const std::function<void(const SoftPixel&)>& visit)
{
    glm::dvec2 corners[3];
    for (int i = 0; i < 3; ++i)
    {
        corners[i] = {(clip[i].x / clip[i].w * 0.5 + 0.5) * camera.width,
                      (0.5 - clip[i].y / clip[i].w * 0.5) * camera.height};
        corners[i] += camera.move;
    }
    const auto area = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
    {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const double whole = area(corners[0], corners[1], corners[2]);
    const glm::dvec2 size(camera.width, camera.height);
    const glm::dvec2 low = glm::clamp(
        glm::floor(glm::min(corners[0], glm::min(corners[1], corners[2]))), glm::dvec2(0.0), size);
    const glm::dvec2 high = glm::clamp(
        glm::ceil(glm::max(corners[0], glm::max(corners[1], corners[2]))), glm::dvec2(0.0), size);
    for (int y = static_cast<int>(low.y); y < high.y && whole != 0.0; ++y)
    {
        for (int x = static_cast<int>(low.x); x < high.x; ++x)
        {
            const glm::dvec2 center(x + 0.5, y + 0.5);
            const glm::dvec3 flat(area(center, corners[1], corners[2]) / whole,
                                  area(corners[0], center, corners[2]) / whole,
                                  area(corners[0], corners[1], center) / whole);
            if (flat.x < 0.0 || flat.y < 0.0 || flat.z < 0.0)
            {
                continue;
            }
            SoftPixel pixel{x, y, 0.0, {}};
            for (int i = 0; i < 3; ++i)
            {
                pixel.depth += flat[i] * clip[i].z / clip[i].w;
                pixel.weights[i] = flat[i] / clip[i].w;
            }
            pixel.weights /= pixel.weights.x + pixel.weights.y + pixel.weights.z;
            visit(pixel);
        }
    }
}

using SoftVertex = std::function<glm::dvec4(std::uint32_t vertex)>; ///< to clip space
using SoftVisit = std::function<void(const SoftPixel&, const std::uint32_t (&vertices)[3])>;

/// Every pixel of every triangle of an object.
/// @param hasBack  whether triangles that face away count as well
inline void ForEachPixel(const SoftCamera& camera, const GameObject& object,
                         const SoftVertex& vertexShader, bool hasBack, const SoftVisit& visit)
{
    const MeshData& data = object.renderer->mesh->data();
    for (std::size_t i = 0; i < data.triangles.size(); i += 3)
    {
        const std::uint32_t vertices[3] = {data.triangles[i], data.triangles[i + 1],
                                           data.triangles[i + 2]};
        const glm::dvec4 clip[3] = {vertexShader(vertices[0]), vertexShader(vertices[1]),
                                    vertexShader(vertices[2])};
        const glm::dvec2 ab = glm::dvec2(clip[1]) / clip[1].w - glm::dvec2(clip[0]) / clip[0].w;
        const glm::dvec2 ac = glm::dvec2(clip[2]) / clip[2].w - glm::dvec2(clip[0]) / clip[0].w;
        const bool isMirrored = glm::determinant(glm::dmat3(object.transform.worldMatrix())) < 0.0;
        const bool isFront = (ab.x * ac.y - ab.y * ac.x < 0.0) != isMirrored; // clockwise
        if (hasBack || isFront)
        {
            ForEachPixel(camera, clip, [&](const SoftPixel& pixel) { visit(pixel, vertices); });
        }
    }
}

/// Where the device draws an object's vertices.
inline SoftVertex AsItIs(const SoftCamera& camera, const GameObject& object)
{
    const glm::dmat4 toClip = camera.projection * camera.view * object.transform.worldMatrix();
    const MeshData& data = object.renderer->mesh->data();
    return [toClip, &data](std::uint32_t vertex)
    {
        return toClip * glm::dvec4(glm::dvec3(data.vertices[vertex]), 1.0);
    };
}

/// What is seen at each pixel.
struct SoftScene
{
    struct Seen
    {
        double depth = 0.0;
        const GameObject* object = nullptr; ///< null = the background
        glm::dvec3 weights{0.0};
        std::uint32_t vertices[3] = {0, 0, 0};
    };

    SoftScene(const SoftCamera& camera, const Scene& scene)
        : width(camera.width), seen(static_cast<std::size_t>(camera.width * camera.height))
    {
        for (const auto& object : scene.objects())
        {
            ForEachPixel(camera, *object, AsItIs(camera, *object), false,
                         [&](const SoftPixel& pixel, const std::uint32_t(&vertices)[3])
                         {
                             Seen& at = At(pixel.x, pixel.y);
                             if (pixel.depth > at.depth)
                             {
                                 at = {pixel.depth,
                                       object.get(),
                                       pixel.weights,
                                       {vertices[0], vertices[1], vertices[2]}};
                             }
                         });
        }
    }

    Seen& At(int x, int y) { return seen[static_cast<std::size_t>(y * width + x)]; }
    const Seen& At(int x, int y) const { return seen[static_cast<std::size_t>(y * width + x)]; }

    int width;
    std::vector<Seen> seen;
};

} // namespace limn::test
