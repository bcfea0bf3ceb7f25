#include "shadows/ShadowCascades.h"

#include "shadows/ShadowConstants.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limn/base/Diagnostic.h>
#include <limn/core/Camera.h>
#include <string>

namespace limn
{

namespace
{

/// Texels around the ball: the widest filter reaches 3.5 far, and snapping moves it by half a one.
constexpr int k_BorderTexels = 4;

struct Ball
{
    glm::dvec3 center{0.0};
    double radius = 0.0;
};

/// The corners at which the camera's picture begins and ends, in view space.
struct Frustum
{
    std::array<glm::dvec3, 4> near;
    std::array<glm::dvec3, 4> far;
};

Frustum FrustumOf(const Camera& camera, float aspect)
{
    const glm::dmat4 toView = glm::inverse(camera.projectionMatrixFor(aspect));
    Frustum frustum;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
        const double x = (corner & 1) != 0 ? 1.0 : -1.0;
        const double y = (corner & 2) != 0 ? 1.0 : -1.0;
        const glm::dvec4 nearCorner = toView * glm::dvec4(x, y, -1.0, 1.0);
        const glm::dvec4 farCorner = toView * glm::dvec4(x, y, 1.0, 1.0);
        frustum.near[corner] = glm::dvec3(nearCorner) / nearCorner.w;
        frustum.far[corner] = glm::dvec3(farCorner) / farCorner.w;
    }
    return frustum;
}

glm::dvec3 Middle(const std::array<glm::dvec3, 4>& corners)
{
    return (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0;
}

double FarthestFrom(const glm::dvec3& center, const std::array<glm::dvec3, 4>& corners)
{
    double most = 0.0;
    for (const glm::dvec3& corner : corners)
    {
        most = std::max(most, glm::distance(center, corner));
    }
    return most;
}

/// The smallest ball around a part of the frustum whose centre is on the frustum's axis.
/// @param begin, end  shares of the way from the near to the far plane
Ball BallAround(const Frustum& frustum, double begin, double end)
{
    std::array<glm::dvec3, 4> near;
    std::array<glm::dvec3, 4> far;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
        near[corner] = glm::mix(frustum.near[corner], frustum.far[corner], begin);
        far[corner] = glm::mix(frustum.near[corner], frustum.far[corner], end);
    }
    const glm::dvec3 from = Middle(near);
    const glm::dvec3 to = Middle(far);
    const double a = FarthestFrom(from, near);
    const double b = FarthestFrom(to, far);
    const double length = glm::distance(from, to);
    const double share =
        std::clamp((length * length + b * b - a * a) / (2.0 * length * length), 0.0, 1.0);
    const glm::dvec3 center = glm::mix(from, to, share);
    // Up to a share of itself that rounding does not change.
    const double radius = std::max(FarthestFrom(center, near), FarthestFrom(center, far));
    const double step = std::exp2(std::ceil(std::log2(radius)) - 12.0);
    return {center, std::ceil(radius / step) * step};
}

std::array<double, k_MostCascades + 1> Splits(const ShadowSettings& settings)
{
    const glm::dvec3 split(SplitOf(settings));
    std::array<double, k_MostCascades + 1> splits{0.0, split.x, split.y, split.z, 1.0};
    splits[static_cast<std::size_t>(settings.shadowCascadeCount)] = 1.0;
    return splits;
}

/// World to the axes of a light: right, up, against it.
glm::dmat3 LightAxes(const glm::dvec3& direction)
{
    const glm::dvec3 forward = glm::normalize(direction);
    const glm::dvec3 vertical =
        std::abs(forward.y) < 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 right = glm::normalize(glm::cross(vertical, forward));
    return glm::transpose(glm::dmat3(right, glm::cross(forward, right), -forward));
}

void Expect(bool isValid, const char* what, const char* range)
{
    if (!isValid)
    {
        throw ContractError(std::string("ShadowSettings: ") + what + " must be " + range);
    }
}

bool Rise(std::initializer_list<float> shares)
{
    return *shares.begin() > 0.0f && *(shares.end() - 1) < 1.0f &&
           std::ranges::adjacent_find(shares, std::greater_equal<>()) == shares.end();
}

} // namespace

glm::dmat4 ShadowCascade::Projection(bool usesReversedZBuffer) const
{
    const double depth = farthest - nearest;
    glm::dmat4 projection(1.0);
    projection[0][0] = projection[1][1] = 1.0 / halfSize;
    projection[2][2] = (usesReversedZBuffer ? 1.0 : -1.0) / depth;
    projection[3][2] = (usesReversedZBuffer ? farthest : -nearest) / depth;
    return projection;
}

glm::ivec2 ShadowMapSize(const ShadowSettings& settings)
{
    const int side = settings.mainLightShadowmapResolution;
    return {side, settings.shadowCascadeCount == 2 ? side / 2 : side};
}

double ShadowDistance(const Camera& camera, const ShadowSettings& settings)
{
    return static_cast<double>(std::min(settings.shadowDistance, camera.farClipPlane));
}

ShadowCascades MakeShadowCascades(const Camera& camera, float aspect,
                                  const glm::dvec3& lightDirection, const ShadowSettings& settings)
{
    ShadowCascades cascades;
    const double near = static_cast<double>(camera.nearClipPlane);
    const double depth = static_cast<double>(camera.farClipPlane) - near;
    const double distance = ShadowDistance(camera, settings);
    if (!(distance > near))
    {
        return cascades;
    }
    const Frustum frustum = FrustumOf(camera, aspect);
    const glm::dmat4 toWorld = glm::inverse(camera.viewMatrix());
    const glm::dmat3 axes = LightAxes(lightDirection);
    const auto splits = Splits(settings);
    const int tile =
        settings.mainLightShadowmapResolution / (settings.shadowCascadeCount == 1 ? 1 : 2);
    for (int i = 0; i < settings.shadowCascadeCount; ++i)
    {
        const auto place = static_cast<std::size_t>(i);
        // The first begins at the near plane, which an orthographic camera may have behind it.
        const double begin = i == 0 ? 0.0 : std::max(splits[place] * distance - near, 0.0) / depth;
        const double end = std::max(splits[place + 1] * distance - near, 0.0) / depth;
        const Ball ball = BallAround(frustum, begin, std::max(end, begin + 1e-9));
        ShadowCascade cascade;
        cascade.center = glm::dvec3(toWorld * glm::dvec4(ball.center, 1.0));
        cascade.radius = ball.radius;
        cascade.tile = {i % 2 * tile, i / 2 * tile, tile, tile};
        cascade.halfSize = ball.radius * tile / (tile - 2 * k_BorderTexels);
        const double texel = cascade.TexelSize();
        glm::dvec3 origin = axes * cascade.center;
        origin.x = std::round(origin.x / texel) * texel;
        origin.y = std::round(origin.y / texel) * texel;
        cascade.view = glm::dmat4(axes);
        cascade.view[3] = glm::dvec4(-origin, 1.0);
        cascade.farthest = ball.radius * 1.01;
        cascade.nearest = -cascade.farthest;
        cascades.push_back(cascade);
    }
    return cascades;
}

void ExpectValid(const ShadowSettings& s)
{
    Expect(s.mainLightShadowmapResolution >= 64 && s.mainLightShadowmapResolution <= 8192,
           "mainLightShadowmapResolution", "64...8192");
    Expect(s.additionalLightsShadowmapResolution >= 64 &&
               s.additionalLightsShadowmapResolution <= 8192,
           "additionalLightsShadowmapResolution", "64...8192");
    const auto isTier = [](int texels)
    {
        return texels >= 16 && texels <= 8192;
    };
    Expect(isTier(s.additionalLightsShadowResolutionTierLow) &&
               isTier(s.additionalLightsShadowResolutionTierMedium) &&
               isTier(s.additionalLightsShadowResolutionTierHigh),
           "additionalLightsShadowResolutionTier", "16...8192");
    Expect(s.shadowDistance >= 0.0f && std::isfinite(s.shadowDistance), "shadowDistance",
           "0 or more");
    Expect(s.shadowCascadeCount >= 1 && s.shadowCascadeCount <= k_MostCascades,
           "shadowCascadeCount", "1...4");
    const char* const shares = "between 0 and 1, each above the one before";
    // Splits of other counts have no effect.
    Expect(s.shadowCascadeCount != 2 || Rise({s.cascade2Split}), "cascade2Split", shares);
    Expect(s.shadowCascadeCount != 3 || Rise({s.cascade3Split.x, s.cascade3Split.y}),
           "cascade3Split", shares);
    Expect(s.shadowCascadeCount != 4 ||
               Rise({s.cascade4Split.x, s.cascade4Split.y, s.cascade4Split.z}),
           "cascade4Split", shares);
    Expect(s.cascadeBorder >= 0.0f && s.cascadeBorder <= 1.0f, "cascadeBorder", "0...1");
    Expect(s.shadowDepthBias >= 0.0f && s.shadowDepthBias <= 10.0f, "shadowDepthBias", "0...10");
    Expect(s.shadowNormalBias >= 0.0f && s.shadowNormalBias <= 10.0f, "shadowNormalBias", "0...10");
}

} // namespace limn
