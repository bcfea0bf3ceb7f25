#pragma once

#include <limn/core/RTHandle.h>

namespace limn
{

/// Returns a function that multiplies by the factor and rounds.
/// @param call, name  for messages: "RTHandles::Alloc 'X'"
/// @throws ContractError for a factor that is not positive
RTHandles::ScaleFunc ScaleBy(const glm::vec2& factor, const char* call, std::string_view name);
/// @throws ContractError if the function is empty
RTHandles::ScaleFunc ScaleBy(RTHandles::ScaleFunc function, const char* call,
                             std::string_view name);

inline SamplerState SamplerWith(FilterMode filterMode, TextureWrapMode wrapMode)
{
    return {filterMode, wrapMode, wrapMode, wrapMode};
}

/// Makes a texture of the pipeline's own, which nobody sees after the frame, unless the handle has
/// such a one already.
/// @param depthBuffer  the depth that the colour brings along; null = none
void AllocateTransient(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                       const char* name, FilterMode filterMode,
                       const std::shared_ptr<const RenderTexture>& depthBuffer = nullptr);

/// Returns the descriptor of a handle's texture: with depthBufferBits a depth without a colour.
inline RenderTextureDescriptor DescriptorOfHandle(RenderTextureDescriptor descriptor)
{
    if (descriptor.depthBufferBits != 0)
    {
        descriptor.graphicsFormat = GraphicsFormat::None;
    }
    return descriptor;
}

/// Return a descriptor, and a texture's sampler, with the arguments of ReAllocateIfNeeded.
RenderTextureDescriptor WithArguments(RenderTextureDescriptor descriptor,
                                      const ReAllocateArguments& arguments);
SamplerState SamplerWith(const RenderTextureDescriptor& descriptor,
                         const ReAllocateArguments& arguments);

/// A texture whose size is computed from the camera's.
class ScaledTexture
{
public:
    /// @throws ContractError as RenderTexture does for the size for the current camera
    ScaledTexture(RTHandles::ScaleFunc scale, const RenderTextureDescriptor& descriptor,
                  const SamplerState& sampler, std::string name);

    /// Returns the texture in the size for the current camera.
    const std::shared_ptr<const RenderTexture>& texture();

    glm::ivec2 SizeFor(const glm::ivec2& camera) const;

    glm::vec2 factor{0.0f}; ///< the factor it was made with; 0 if it was made with a function

private:
    RTHandles::ScaleFunc m_Scale;
    RenderTextureDescriptor m_Descriptor;
    SamplerState m_Sampler;
    std::string m_Name;
    glm::ivec2 m_CameraSize{0}; ///< the camera's size for which m_Texture was made
    std::shared_ptr<const RenderTexture> m_Texture;
};

} // namespace limn
