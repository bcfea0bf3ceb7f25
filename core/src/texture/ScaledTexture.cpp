#include "texture/ScaledTexture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limn/core/RenderTargetIdentifier.h>

namespace limn
{

namespace
{

glm::ivec2& ReferenceSize()
{
    static thread_local glm::ivec2 size(1);
    return size;
}

SamplerState SamplerWith(FilterMode filterMode, TextureWrapMode wrapMode)
{
    return {filterMode, wrapMode, wrapMode, wrapMode};
}

int Scaled(int size, float factor)
{
    constexpr double k_Most = 1 << 30;
    return static_cast<int>(std::min(std::round(double{factor} * size), k_Most));
}

/// The same but for the size.
bool MatchesButForSize(const RenderTexture& texture, RenderTextureDescriptor wanted,
                       const SamplerState& sampler, std::string_view name)
{
    wanted.width = texture.width();
    wanted.height = texture.height();
    const RenderTexture other("", wanted, sampler);
    return texture.descriptor() == other.descriptor() && texture.sampler() == sampler &&
           texture.name() == name;
}

} // namespace

void RTHandles::SetReferenceSize(int width, int height)
{
    if (width <= 0 || height <= 0)
    {
        throw ContractError("SetReferenceSize: " + std::to_string(width) + "x" +
                            std::to_string(height) + "; both must be greater than 0");
    }
    ReferenceSize() = {width, height};
}

ScaledTexture::ScaledTexture(RTHandles::ScaleFunc scale, const RenderTextureDescriptor& descriptor,
                             const SamplerState& sampler, std::string name)
    : m_Scale(std::move(scale)),
      m_Descriptor(descriptor),
      m_Sampler(sampler),
      m_Name(std::move(name))
{
    texture();
}

const std::shared_ptr<const RenderTexture>& ScaledTexture::texture()
{
    const glm::ivec2 camera = ReferenceSize();
    if (!m_Texture || m_CameraSize != camera)
    {
        const glm::ivec2 size = glm::max(m_Scale(camera), glm::ivec2(1));
        RenderTextureDescriptor descriptor = m_Descriptor;
        descriptor.width = size.x;
        descriptor.height = size.y;
        if (!m_Texture || m_Texture->width() != size.x || m_Texture->height() != size.y)
        {
            m_Texture = std::make_shared<const RenderTexture>(m_Name, descriptor, m_Sampler);
        }
        m_CameraSize = camera;
    }
    return m_Texture;
}

RTHandle RTHandles::Alloc(ScaleFunc scaleFunc, const RenderTextureDescriptor& descriptor,
                          FilterMode filterMode, TextureWrapMode wrapMode, std::string name)
{
    if (!scaleFunc)
    {
        throw ContractError("RTHandles::Alloc '" + name + "': the scale function is empty");
    }
    return RTHandle(std::make_shared<ScaledTexture>(
        std::move(scaleFunc), descriptor, SamplerWith(filterMode, wrapMode), std::move(name)));
}

RTHandle RTHandles::Alloc(const glm::vec2& scaleFactor, const RenderTextureDescriptor& descriptor,
                          FilterMode filterMode, TextureWrapMode wrapMode, std::string name)
{
    if (!(scaleFactor.x > 0.0f) || !(scaleFactor.y > 0.0f))
    {
        throw ContractError("RTHandles::Alloc '" + name + "': the scale factor is " +
                            std::to_string(scaleFactor.x) + ", " + std::to_string(scaleFactor.y) +
                            "; both must be greater than 0");
    }
    const auto scale = [scaleFactor](const glm::ivec2& size)
    {
        return glm::ivec2(Scaled(size.x, scaleFactor.x), Scaled(size.y, scaleFactor.y));
    };
    auto texture = std::make_shared<ScaledTexture>(
        scale, descriptor, SamplerWith(filterMode, wrapMode), std::move(name));
    texture->factor = scaleFactor;
    return RTHandle(std::move(texture));
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, const glm::vec2& scaleFactor,
                                        const RenderTextureDescriptor& descriptor,
                                        FilterMode filterMode, TextureWrapMode wrapMode,
                                        std::string_view name)
{
    if (handle.scaleFactor() == scaleFactor &&
        MatchesButForSize(*handle.rt(), descriptor, SamplerWith(filterMode, wrapMode), name))
    {
        return false;
    }
    handle = RTHandles::Alloc(scaleFactor, descriptor, filterMode, wrapMode, std::string(name));
    return true;
}

} // namespace limn
