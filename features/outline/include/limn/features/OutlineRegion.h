#pragma once

#include <limn/core/CommandBuffer.h>
#include <limn/core/RenderingData.h>
#include <limn/features/OutlinedObjects.h>
#include <optional>
#include <span>

namespace limn
{

/// The pixels that an outline can touch and those that it comes from: textures that a technique
/// owns are as large as this, so that its passes cost what the outline does, not what the picture
/// does. It may reach beyond the picture, since an object outside of it can outline into it.
struct OutlineRegion
{
    glm::ivec2 corner{0};  ///< top left, pixels from the picture's top left; may be negative
    glm::ivec2 size{0};    ///< pixels, multiples of 64, so that textures serve several frames
    glm::ivec2 picture{0}; ///< size of the picture, pixels
    /// Between which texels of such a texture objects can be: the first and, excluded, the last.
    glm::ivec2 objectsBegin{0};
    glm::ivec2 objectsEnd{0};

    /// A texture of this size, one sample a texel unless set otherwise.
    RenderTextureDescriptor Descriptor(GraphicsFormat format) const
    {
        RenderTextureDescriptor descriptor(size.x, size.y, format);
        descriptor.memoryless = RenderTextureMemoryless::Color; // no next frame reads it
        return descriptor;
    }
    /// What draws into such a texture in place of the camera's projection.
    glm::mat4 Projection(const glm::mat4& gpuProjection) const;
    /// The part that lies in the picture, for the viewport of what composites; its size is 0 if
    /// there is none.
    ViewportRect InPicture() const;
    /// Of Blitter::BlitTexture into that viewport from such a texture.
    glm::vec4 ScaleBias() const;
};

/// Where objects' outlines lie. An object with a point at or behind the camera has the whole
/// picture.
/// @param reach  how far an outline is away from its object at most, pixels
/// @return nothing if no outline can touch the picture
std::optional<OutlineRegion> FindOutlineRegion(std::span<const OutlinedObject> objects,
                                               const CameraData& camera, float reach);

/// The same for what lies between two points of the picture.
/// @param low   pixels from the picture's top left, may be infinite; above `high` where there is
///              nothing
std::optional<OutlineRegion> FindOutlineRegion(const glm::dvec2& low, const glm::dvec2& high,
                                               const glm::ivec2& picture, float reach);

/// Draws that follow go into a texture of the region, seen from the camera.
void SetRegionProjection(CommandBuffer& cmd, const OutlineRegion& region, const CameraData& camera);
/// And again as the camera sees them.
void SetCameraProjection(CommandBuffer& cmd, const CameraData& camera);

} // namespace limn
