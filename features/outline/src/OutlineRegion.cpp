#include <algorithm>
#include <cmath>
#include <limits>
#include <limn/core/CoreUtils.h>
#include <limn/features/OutlineRegion.h>

namespace limn
{

namespace
{

constexpr int k_SizeStep = 64; // pixels

struct Box
{
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};

    void Include(const glm::dvec2& point)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

/// Grows `box` by the corners of the object's bounds, pixels.
/// @return false if one is not in front of the camera
bool Include(Box& box, const GameObject& object, const glm::dmat4& viewProjection,
             const glm::dvec2& picture)
{
    const Bounds& bounds = object.renderer->mesh->bounds();
    const glm::dmat4 toClip = viewProjection * object.transform.worldMatrix();
    for (int i = 0; i < 8; ++i)
    {
        const glm::dvec3 side((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
        const glm::dvec3 corner = glm::dvec3(bounds.center) + side * glm::dvec3(bounds.extents);
        const glm::dvec4 clip = toClip * glm::dvec4(corner, 1.0);
        // Beyond the near plane z is greater than w.
        if (!(clip.w > 0.0 && clip.z <= clip.w))
        {
            return false;
        }
        box.Include(glm::dvec2(1.0 + clip.x / clip.w, 1.0 - clip.y / clip.w) * 0.5 * picture);
    }
    return true;
}

int RoundUp(int value)
{
    return (value + k_SizeStep - 1) / k_SizeStep * k_SizeStep;
}

} // namespace

void OutlineRegion::Allocate(RTHandle& handle, GraphicsFormat format, const char* name,
                             int samples) const
{
    RenderTextureDescriptor descriptor(size.x, size.y, format);
    descriptor.msaaSamples = samples;
    descriptor.memoryless = RenderTextureMemoryless::Color;
    RenderingUtils::ReAllocateIfNeeded(handle, descriptor, FilterMode::Point,
                                       TextureWrapMode::Clamp, name);
}

glm::mat4 OutlineRegion::Projection(const glm::mat4& gpuProjection) const
{
    const glm::dvec2 scale = glm::dvec2(picture) / glm::dvec2(size);
    const glm::dvec2 shift = (glm::dvec2(picture) - 2.0 * glm::dvec2(corner)) / glm::dvec2(size);
    glm::dmat4 place(1.0);
    place[0][0] = scale.x;
    place[1][1] = scale.y;
    place[3][0] = shift.x - 1.0;
    place[3][1] = 1.0 - shift.y;
    return glm::mat4(place * glm::dmat4(gpuProjection));
}

ViewportRect OutlineRegion::InPicture() const
{
    const glm::ivec2 low = glm::max(corner, glm::ivec2(0));
    const glm::ivec2 high = glm::max(glm::min(corner + size, picture), low);
    return {low.x, low.y, high.x - low.x, high.y - low.y};
}

glm::vec4 OutlineRegion::ScaleBias() const
{
    const ViewportRect rect = InPicture();
    const glm::vec2 whole(size);
    return {glm::vec2(rect.width, rect.height) / whole,
            glm::vec2(rect.x - corner.x, rect.y - corner.y) / whole};
}

std::optional<OutlineRegion> FindOutlineRegion(std::span<const OutlinedObject> objects,
                                               const CameraData& camera, float reach)
{
    const glm::ivec2 picture(camera.cameraTargetDescriptor.width,
                             camera.cameraTargetDescriptor.height);
    const glm::dmat4 viewProjection = camera.reversedViewProjection();
    Box box;
    for (const OutlinedObject& object : objects)
    {
        if (!Include(box, *object.item.object, viewProjection, picture))
        {
            const glm::dvec2 anywhere(std::numeric_limits<double>::infinity());
            return FindOutlineRegion(-anywhere, anywhere, picture, reach);
        }
    }
    return FindOutlineRegion(box.low, box.high, picture, reach);
}

std::optional<OutlineRegion> FindOutlineRegion(const glm::dvec2& low, const glm::dvec2& high,
                                               const glm::ivec2& picture, float reach)
{
    // No farther than across the picture; a pixel more for what is smoothed.
    const double farthest = picture.x + picture.y;
    const double margin = std::ceil(std::min(static_cast<double>(reach), farthest)) + 1.0;
    const glm::dvec2 border = glm::dvec2(picture) + margin;
    const glm::dvec2 from = glm::max(glm::floor(low) - margin, glm::dvec2(-margin));
    const glm::dvec2 to = glm::min(glm::ceil(high) + margin, border);
    const bool touches = low.x <= high.x && low.y <= high.y && from.x < picture.x &&
                         from.y < picture.y && to.x > 0.0 && to.y > 0.0;
    if (!touches)
    {
        return std::nullopt;
    }
    OutlineRegion region;
    region.corner = glm::ivec2(from);
    region.size = {RoundUp(static_cast<int>(to.x) - region.corner.x),
                   RoundUp(static_cast<int>(to.y) - region.corner.y)};
    region.picture = picture;
    // A texel more for what is rounded otherwise by the device.
    region.objectsBegin = glm::ivec2(glm::max(glm::floor(low) - 1.0, from)) - region.corner;
    region.objectsEnd = glm::ivec2(glm::min(glm::ceil(high) + 1.0, to)) - region.corner;
    return region;
}

void SetRegionProjection(CommandBuffer& cmd, const OutlineRegion& region, const CameraData& camera)
{
    RenderingUtils::SetViewAndProjectionMatrices(
        cmd, camera.viewMatrix, region.Projection(camera.gpuProjectionMatrix), false);
}

void SetCameraProjection(CommandBuffer& cmd, const CameraData& camera)
{
    RenderingUtils::SetViewAndProjectionMatrices(cmd, camera.viewMatrix, camera.gpuProjectionMatrix,
                                                 false);
}

} // namespace limn
