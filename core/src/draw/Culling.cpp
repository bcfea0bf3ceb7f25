#include "draw/PerDraw.h"
#include "material/RequireFinite.h"
#include "scene/WorldMatrices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <limn/core/Camera.h>
#include <limn/core/Culling.h>
#include <tuple>

namespace limn
{

namespace
{

/// The six planes of a clip matrix, pointing inwards (not normalised).
std::array<glm::vec4, 6> FrustumPlanes(const glm::mat4& viewProjection)
{
    const auto row = [&](int i)
    {
        return glm::vec4(viewProjection[0][i], viewProjection[1][i], viewProjection[2][i],
                         viewProjection[3][i]);
    };
    return {row(3) + row(0), row(3) - row(0), row(3) + row(1),
            row(3) - row(1), row(2),          row(3) - row(2)};
}

/// @param center  of the result
Bounds TransformBounds(const Bounds& bounds, const glm::mat4& matrix, const glm::vec3& center)
{
    Bounds result;
    result.center = center;
    for (int axis = 0; axis < 3; ++axis)
    {
        result.extents += glm::abs(glm::vec3(matrix[axis])) * bounds.extents[axis];
    }
    return result;
}

/// False only if the box is wholly outside one plane; not-a-number counts as inside, so that
/// nothing disappears silently.
bool TouchesFrustum(const Bounds& bounds, const std::array<glm::vec4, 6>& planes)
{
    for (const glm::vec4& plane : planes)
    {
        const glm::vec3 normal(plane);
        const float reach = glm::dot(glm::abs(normal), bounds.extents);
        if (glm::dot(normal, bounds.center) + plane.w + reach < 0.0f)
        {
            return false;
        }
    }
    return true;
}

void AppendItems(const GameObject& object, const glm::dvec3& boundsCenter, CullingResults& results)
{
    const MeshRenderer& renderer = *object.renderer;
    for (std::size_t i = 0; i < renderer.sharedMaterials.size(); ++i)
    {
        const std::shared_ptr<const Material>& material = renderer.sharedMaterials[i];
        if (!material)
        {
            continue; // an empty material slot draws nothing, as in Unity's builds
        }
        RendererItem item;
        item.object = &object;
        item.material = material;
        item.materialIndex = static_cast<int>(i);
        item.subMesh = std::min(static_cast<int>(i), renderer.mesh->subMeshCount() - 1);
        item.filter = {material->renderQueue(), object.layer, renderer.renderingLayerMask,
                       material->shader().get()};
        item.perDraw = results.perDraw.size() - 1;
        item.boundsCenter = boundsCenter;
        results.items.push_back(std::move(item));
    }
}

/// Distance to the camera with everything that is no number at the far end: comparisons of NaN
/// would leave the order undefined.
float SortDistance(const glm::dvec3& center, const SortingSettings& sorting)
{
    const glm::vec3 offset(center - sorting.cameraPosition);
    const float distance = sorting.distanceMetric == DistanceMetric::Perspective
                               ? glm::length(offset)
                               : glm::dot(offset, sorting.cameraForward);
    return std::isfinite(distance) ? distance : std::numeric_limits<float>::max();
}

/// Equal for distances within the same eighth of an octave.
int Quantise(float distance)
{
    if (!(distance > 1e-3f))
    {
        return std::numeric_limits<int>::min();
    }
    return static_cast<int>(std::floor(8.0f * std::log2(distance)));
}

} // namespace

CullingResults Cull(const Scene& scene, const Camera& camera, float aspect)
{
    const glm::dvec3 origin = camera.renderOrigin();
    const auto planes = FrustumPlanes(glm::mat4(glm::dmat4(camera.gpuProjectionMatrix(aspect)) *
                                                RelativeTo(origin, camera.viewMatrix())));
    WorldMatrices worldMatrices;
    CullingResults results;
    for (const auto& object : scene.objects())
    {
        if (!object->activeSelf || !object->renderer || !object->renderer->enabled ||
            !object->renderer->mesh)
        {
            continue;
        }
        ++results.rendererCount;
        if (!LayerMask::FromIndex(object->layer).Intersects(camera.cullingMask))
        {
            ++results.outsideCullingMask;
            continue;
        }
        const glm::dmat4 localToWorld = worldMatrices.Of(object->transform);
        const Bounds& local = object->renderer->mesh->bounds();
        const glm::dvec3 center(localToWorld * glm::dvec4(local.center, 1.0));
        const glm::mat4 rounded(localToWorld);
        if (!isFinite(rounded))
        {
            results.beyondFloat.push_back(object.get());
        }
        if (!TouchesFrustum(TransformBounds(local, rounded, glm::vec3(center - origin)), planes))
        {
            ++results.outsideFrustum;
            continue;
        }
        results.perDraw.push_back(
            MakePerDrawData(localToWorld, object->renderer->renderingLayerMask, origin));
        AppendItems(*object, center, results);
    }
    return results;
}

void Sort(const std::vector<RendererItem>& items, const SortingSettings& sorting,
          std::vector<int>& indices)
{
    struct Key
    {
        int queue = 0;
        float backToFront = 0.0f;
        int materialIndex = 0;
        int frontToBack = 0;
        std::tuple<std::uint64_t, std::uint64_t, std::uint64_t> state;

        auto tie() const { return std::tie(queue, backToFront, materialIndex, frontToBack, state); }
    };
    const SortingCriteria criteria = sorting.criteria;
    std::vector<Key> keys(items.size());
    for (const int index : indices)
    {
        const RendererItem& item = items[static_cast<std::size_t>(index)];
        Key& key = keys[static_cast<std::size_t>(index)];
        const float distance = SortDistance(item.boundsCenter, sorting);
        key.queue = criteria & SortingCriteria::RenderQueue ? item.filter.renderQueue : 0;
        if (criteria & SortingCriteria::BackToFront)
        {
            key.backToFront = -distance;
            key.materialIndex = item.materialIndex;
        }
        key.frontToBack = criteria & SortingCriteria::QuantizedFrontToBack ? Quantise(distance) : 0;
        if (criteria & SortingCriteria::OptimizeStateChanges)
        {
            key.state = {item.material->shader()->id(), item.material->id(),
                         item.object->renderer->mesh->id()};
        }
    }
    std::stable_sort(indices.begin(), indices.end(),
                     [&](int a, int b) {
                         return keys[static_cast<std::size_t>(a)].tie() <
                                keys[static_cast<std::size_t>(b)].tie();
                     });
}

} // namespace limn
