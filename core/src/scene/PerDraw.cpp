#include "scene/PerDraw.h"

#include "material/PropertyValues.h"

#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace limn
{

namespace
{

/// All zero where there is none (a scale of zero), which leaves normals zero instead of infinite.
glm::mat4 InverseOrZero(const glm::dmat4& matrix)
{
    const glm::mat4 inverse(glm::inverse(matrix));
    return isFinite(inverse) ? inverse : glm::mat4(0.0f);
}

} // namespace

PerDrawData MakePerDrawData(const glm::dmat4& localToWorld, RenderingLayerMask renderingLayers,
                            const glm::dvec3& origin)
{
    const glm::mat4 rounded(localToWorld);
    const glm::mat4 inverse = InverseOrZero(localToWorld);
    const glm::vec3 place(glm::dvec3(localToWorld[3]) - origin);
    PerDrawData data{};
    std::memcpy(data.objectToWorld, glm::value_ptr(rounded), sizeof data.objectToWorld);
    std::memcpy(data.worldToObject, glm::value_ptr(inverse), sizeof data.worldToObject);
    std::memcpy(data.worldTransformParams, glm::value_ptr(place), sizeof place);
    data.worldTransformParams[3] = glm::determinant(glm::dmat3(localToWorld)) < 0.0 ? -1.0f : 1.0f;
    data.renderingLayer[0] = renderingLayers.bits;
    return data;
}

glm::dmat4 RelativeTo(const glm::dvec3& origin, const glm::dmat4& view)
{
    glm::dmat4 relative = view;
    const glm::dvec3 w(view[0].w, view[1].w, view[2].w);
    relative[3] += glm::dvec4(glm::dmat3(view) * origin, glm::dot(w, origin));
    return relative;
}

} // namespace limn
