#pragma once

#include <limn/core/CommandBuffer.h>
#include <limn/core/RTHandle.h>
#include <limn/features/OutlinedObjects.h>
#include <optional>
#include <span>

namespace limn
{

/// The pixels that an outline can touch, and those of its objects. A technique's own textures have
/// this size, so that the cost of its passes depends on the size of the outline and not on that of
/// the picture. The region may reach beyond the picture, because an object outside of it can have
/// an outline in it.
struct OutlineRegion
{
    glm::ivec2 corner{0};  ///< top left, pixels from the picture's top left; may be negative
    glm::ivec2 size{0};    ///< pixels, multiples of 64, so that textures serve several frames
    glm::ivec2 picture{0}; ///< size of the picture, pixels
    /// The texels of such a texture in which objects can be: the first one, and the one behind the
    /// last.
    glm::ivec2 objectsBegin{0};
    glm::ivec2 objectsEnd{0};

    /// Makes a texture of this size, which no next frame reads, unless the handle has it already.
    void Allocate(RTHandle& handle, GraphicsFormat format, const char* name, int samples = 1) const;
    /// Returns the projection with which to draw into such a texture in place of the camera's.
    glm::mat4 Projection(const glm::mat4& gpuProjection) const;
    /// Returns the part that lies in the picture, which is the viewport for compositing; its size
    /// is 0 if there is none.
    ViewportRect InPicture() const;
    /// Returns the scale and bias for Blitter::BlitTexture from such a texture into that viewport.
    glm::vec4 ScaleBias() const;
};

/// Returns the region of the objects' outlines. It is the whole picture if a point of an object is
/// at or behind the camera.
/// @param reach  the greatest distance of an outline from its object, in pixels
/// @return nullopt if no outline can touch the picture
std::optional<OutlineRegion> FindOutlineRegion(std::span<const OutlinedObject> objects,
                                               const CameraData& camera, float reach);

/// Returns the region of the outlines of everything between two points of the picture.
/// @param low   pixels from the picture's top left; may be infinite, and is greater than `high` if
///     there is nothing
std::optional<OutlineRegion> FindOutlineRegion(const glm::dvec2& low, const glm::dvec2& high,
                                               const glm::ivec2& picture, float reach);

/// Makes the following draws go into a texture of the region, as the camera sees it.
void SetRegionProjection(CommandBuffer& cmd, const OutlineRegion& region, const CameraData& camera);
/// Restores the camera's projection for the following draws.
void SetCameraProjection(CommandBuffer& cmd, const CameraData& camera);

} // namespace limn
