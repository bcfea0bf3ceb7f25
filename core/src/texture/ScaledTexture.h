#pragma once

#include <limn/core/RTHandle.h>

namespace limn
{

/// Times the factor, rounded.
/// @param call, name  for messages: "RTHandles::Alloc 'X'"
/// @throws ContractError for a factor that is not positive
RTHandles::ScaleFunc ScaleBy(const glm::vec2& factor, const char* call, std::string_view name);
/// @throws ContractError if it is empty
RTHandles::ScaleFunc ScaleBy(RTHandles::ScaleFunc function, const char* call,
                             std::string_view name);

/// Returns what a handle's texture is made of: with depthBufferBits a depth without a colour.
inline RenderTextureDescriptor DescriptorOfHandle(RenderTextureDescriptor descriptor)
{
    if (descriptor.depthBufferBits != 0)
    {
        descriptor.graphicsFormat = GraphicsFormat::None;
    }
    return descriptor;
}

/// What the arguments of ReAllocateIfNeeded make of a descriptor, and of a texture's sampler.
RenderTextureDescriptor WithArguments(RenderTextureDescriptor descriptor,
                                      const ReAllocateArguments& arguments);
SamplerState SamplerWith(const RenderTextureDescriptor& descriptor,
                         const ReAllocateArguments& arguments);

/// A texture whose size is worked out from the camera's.
class ScaledTexture
{
public:
    /// @throws ContractError as RenderTexture does, of the size for the camera now
    ScaledTexture(RTHandles::ScaleFunc scale, const RenderTextureDescriptor& descriptor,
                  const SamplerState& sampler, std::string name);

    /// Of the size for the camera now.
    const std::shared_ptr<const RenderTexture>& texture();

    glm::ivec2 SizeFor(const glm::ivec2& camera) const;

    glm::vec2 factor{0.0f}; ///< that it was made with; 0 for one of a function

private:
    RTHandles::ScaleFunc m_Scale;
    RenderTextureDescriptor m_Descriptor;
    SamplerState m_Sampler;
    std::string m_Name;
    glm::ivec2 m_CameraSize{0}; ///< that m_Texture was made for
    std::shared_ptr<const RenderTexture> m_Texture;
};

} // namespace limn
