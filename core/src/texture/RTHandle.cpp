#include "texture/ScaledTexture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limn/base/Diagnostic.h>
#include <limn/base/NumberText.h>
#include <limn/core/RenderTargetIdentifier.h>
#include <utility>

namespace limn
{

namespace
{

struct Reference
{
    glm::ivec2 size{1};
    glm::ivec2 previous{1};
};

Reference& SizeOfThread()
{
    static thread_local Reference reference;
    return reference;
}

int Scaled(int size, float factor)
{
    constexpr double k_Most = 1 << 30;
    return static_cast<int>(std::min(std::round(double{factor} * size), k_Most));
}

bool Matches(const RenderTexture& texture, const RenderTextureDescriptor& wanted,
             const SamplerState& sampler, std::string_view name)
{
    return texture.descriptor() == wanted && texture.sampler() == sampler && texture.name() == name;
}

bool MatchesButForSize(const RenderTexture& texture, RenderTextureDescriptor wanted,
                       const SamplerState& sampler, std::string_view name)
{
    wanted.width = texture.width();
    wanted.height = texture.height();
    const RenderTexture other("", DescriptorOfHandle(wanted), sampler);
    return Matches(texture, other.descriptor(), sampler, name);
}

} // namespace

RenderTargetIdentifier RTHandle::nameID() const
{
    return m_Identifier ? *m_Identifier : RenderTargetIdentifier(rt());
}

const std::shared_ptr<const RenderTexture>& RTHandle::ScaledToCamera() const
{
    return m_Scaled->texture();
}

glm::vec2 RTHandle::scaleFactor() const
{
    return m_Scaled ? m_Scaled->factor : glm::vec2(0.0f);
}

RTHandle RTHandles::Alloc(RenderTargetIdentifier texture)
{
    if (texture == BuiltinRenderTextureType::None)
    {
        throw ContractError("RTHandles::Alloc: the identifier is none");
    }
    return RTHandle(std::make_shared<const RenderTargetIdentifier>(std::move(texture)));
}

RTHandle RTHandles::Alloc(std::shared_ptr<const RenderTexture> texture)
{
    if (!texture)
    {
        throw ContractError("RTHandles::Alloc: the texture is null");
    }
    return RTHandle(std::move(texture));
}

RenderTargetIdentifier::RenderTargetIdentifier(const RTHandle& handle)
    : RenderTargetIdentifier(handle.nameID())
{
    if (!handle)
    {
        throw ContractError("RenderTargetIdentifier: the handle is empty");
    }
}

RenderTargetIdentifier::RenderTargetIdentifier(std::shared_ptr<const Texture> texture)
{
    if (texture)
    {
        m_Content = std::move(texture);
    }
}

RTHandle RTHandles::Alloc(const RenderTextureDescriptor& descriptor, FilterMode filterMode,
                          TextureWrapMode wrapMode, std::string name)
{
    return RTHandle(std::make_shared<const RenderTexture>(
        std::move(name), DescriptorOfHandle(descriptor), SamplerWith(filterMode, wrapMode)));
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, RenderTextureDescriptor descriptor,
                                        FilterMode filterMode, TextureWrapMode wrapMode,
                                        std::string_view name)
{
    ReAllocateArguments arguments{filterMode, wrapMode};
    arguments.name = name;
    return ReAllocateIfNeeded(handle, descriptor, arguments);
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                                        const ReAllocateArguments& arguments)
{
    RenderTextureDescriptor wanted = DescriptorOfHandle(WithArguments(descriptor, arguments));
    wanted.width = std::max(wanted.width, 1);
    wanted.height = std::max(wanted.height, 1);
    const SamplerState sampler = SamplerWith(wanted, arguments);
    const bool isKept = handle.rt() && !handle.useScaling() &&
                        Matches(*handle.rt(), wanted, sampler, arguments.name);
    if (!isKept)
    {
        handle = RTHandle(
            std::make_shared<const RenderTexture>(std::string(arguments.name), wanted, sampler));
    }
    return !isKept;
}

void AllocateTransient(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                       const char* name, FilterMode filterMode,
                       const std::shared_ptr<const RenderTexture>& depthBuffer)
{
    if (handle && handle.rt()->descriptor() == descriptor &&
        handle.rt()->depthBuffer() == depthBuffer)
    {
        return;
    }
    const SamplerState sampler = SamplerWith(filterMode, TextureWrapMode::Clamp);
    handle = RTHandle(
        depthBuffer
            ? std::make_shared<const RenderTexture>(name, descriptor, sampler, true, depthBuffer)
            : std::make_shared<const RenderTexture>(name, descriptor, sampler, true));
}

RenderTextureDescriptor WithArguments(RenderTextureDescriptor descriptor,
                                      const ReAllocateArguments& arguments)
{
    if (arguments.isShadowMap)
    {
        constexpr int k_WithoutStencil = 16;
        descriptor.shadowSamplingMode = ShadowSamplingMode::CompareDepths;
        descriptor.depthBufferBits = std::max(descriptor.depthBufferBits, k_WithoutStencil);
    }
    return descriptor;
}

SamplerState SamplerWith(const RenderTextureDescriptor& descriptor,
                         const ReAllocateArguments& arguments)
{
    SamplerState sampler = SamplerWith(arguments.filterMode, arguments.wrapMode);
    sampler.comparison = descriptor.shadowSamplingMode == ShadowSamplingMode::CompareDepths;
    sampler.anisoLevel = arguments.anisoLevel;
    sampler.mipMapBias = arguments.mipMapBias;
    return sampler;
}

void RTHandles::SetReferenceSize(int width, int height)
{
    if (width <= 0 || height <= 0)
    {
        throw ContractError("SetReferenceSize: the size is " + std::to_string(width) + "x" +
                            std::to_string(height) + "; both must be greater than 0");
    }
    Reference& reference = SizeOfThread();
    reference.previous = std::exchange(reference.size, {width, height});
}

int RTHandles::maxWidth()
{
    return SizeOfThread().size.x;
}

int RTHandles::maxHeight()
{
    return SizeOfThread().size.y;
}

RTHandleProperties RTHandles::rtHandleProperties()
{
    const Reference& reference = SizeOfThread();
    return {reference.previous, reference.previous, reference.size, reference.size};
}

RTHandleProperties RTHandle::rtHandleProperties() const
{
    return RTHandles::rtHandleProperties();
}

glm::ivec2 RTHandle::GetScaledSize(const glm::ivec2& refSize) const
{
    if (m_Scaled)
    {
        return m_Scaled->SizeFor(refSize);
    }
    return m_Texture ? glm::ivec2(m_Texture->width(), m_Texture->height()) : glm::ivec2(0);
}

glm::ivec2 ScaledTexture::SizeFor(const glm::ivec2& camera) const
{
    return glm::max(m_Scale(camera), glm::ivec2(1));
}

ScaledTexture::ScaledTexture(RTHandles::ScaleFunc scale, const RenderTextureDescriptor& descriptor,
                             const SamplerState& sampler, std::string name)
    : m_Scale(std::move(scale)),
      m_Descriptor(DescriptorOfHandle(descriptor)),
      m_Sampler(sampler),
      m_Name(std::move(name))
{
    texture();
}

const std::shared_ptr<const RenderTexture>& ScaledTexture::texture()
{
    const glm::ivec2 camera = SizeOfThread().size;
    if (!m_Texture || m_CameraSize != camera)
    {
        const glm::ivec2 size = SizeFor(camera);
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

static std::string SubjectOf(const char* call, std::string_view name)
{
    return std::string(call) + (name.empty() ? "" : " '" + std::string(name) + "'");
}

RTHandles::ScaleFunc ScaleBy(const glm::vec2& factor, const char* call, std::string_view name)
{
    if (!(factor.x > 0.0f) || !(factor.y > 0.0f))
    {
        throw ContractError(SubjectOf(call, name) + ": the scale factor is " +
                            NumberText(static_cast<double>(factor.x)) + ", " +
                            NumberText(static_cast<double>(factor.y)) +
                            "; both must be greater than 0");
    }
    return [factor](const glm::ivec2& size)
    {
        return glm::ivec2(Scaled(size.x, factor.x), Scaled(size.y, factor.y));
    };
}

RTHandles::ScaleFunc ScaleBy(RTHandles::ScaleFunc function, const char* call, std::string_view name)
{
    if (!function)
    {
        throw ContractError(SubjectOf(call, name) + ": the scale function is empty");
    }
    return function;
}

static RTHandle ScaledHandle(const char* call, const glm::vec2& factor,
                             const RenderTextureDescriptor& descriptor, const SamplerState& sampler,
                             std::string name)
{
    auto scale = ScaleBy(factor, call, name);
    auto texture =
        std::make_shared<ScaledTexture>(std::move(scale), descriptor, sampler, std::move(name));
    texture->factor = factor;
    return RTHandle(std::move(texture));
}

RTHandle RTHandles::Alloc(ScaleFunc scaleFunc, const RenderTextureDescriptor& descriptor,
                          FilterMode filterMode, TextureWrapMode wrapMode, std::string name)
{
    auto scale = ScaleBy(std::move(scaleFunc), "RTHandles::Alloc", name);
    return RTHandle(std::make_shared<ScaledTexture>(
        std::move(scale), descriptor, SamplerWith(filterMode, wrapMode), std::move(name)));
}

RTHandle RTHandles::Alloc(const glm::vec2& scaleFactor, const RenderTextureDescriptor& descriptor,
                          FilterMode filterMode, TextureWrapMode wrapMode, std::string name)
{
    return ScaledHandle("RTHandles::Alloc", scaleFactor, descriptor,
                        SamplerWith(filterMode, wrapMode), std::move(name));
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, const glm::vec2& scaleFactor,
                                        const RenderTextureDescriptor& descriptor,
                                        FilterMode filterMode, TextureWrapMode wrapMode,
                                        std::string_view name)
{
    ReAllocateArguments arguments{filterMode, wrapMode};
    arguments.name = name;
    return ReAllocateIfNeeded(handle, scaleFactor, descriptor, arguments);
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, const glm::vec2& scaleFactor,
                                        const RenderTextureDescriptor& descriptor,
                                        const ReAllocateArguments& arguments)
{
    const RenderTextureDescriptor wanted = WithArguments(descriptor, arguments);
    const SamplerState sampler = SamplerWith(wanted, arguments);
    if (handle.scaleFactor() == scaleFactor &&
        MatchesButForSize(*handle.rt(), wanted, sampler, arguments.name))
    {
        return false;
    }
    handle = ScaledHandle("ReAllocateIfNeeded", scaleFactor, wanted, sampler,
                          std::string(arguments.name));
    return true;
}

} // namespace limn
