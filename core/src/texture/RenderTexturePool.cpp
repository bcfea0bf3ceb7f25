#include <algorithm>
#include <limn/core/RenderTexturePool.h>

#include "texture/ScaledTexture.h"

namespace limn
{

namespace
{

constexpr int k_FramesKept = 15;

} // namespace

TemporaryTexture& TemporaryTexture::operator=(TemporaryTexture&& other) noexcept
{
    if (this != &other)
    {
        Release();
        m_Entry = std::move(other.m_Entry);
    }
    return *this;
}

const RTHandle& TemporaryTexture::handle() const
{
    static const RTHandle none;
    return m_Entry ? m_Entry->texture : none;
}

void TemporaryTexture::Release() noexcept
{
    if (m_Entry)
    {
        m_Entry->isTaken = false;
        m_Entry.reset();
    }
}

TemporaryTexture RenderTexturePool::GetTemporary(int width, int height, int depthBuffer,
                                                 RenderTextureFormat format,
                                                 RenderTextureReadWrite readWrite, int antiAliasing)
{
    RenderTextureDescriptor descriptor(
        width, height, ToGraphicsFormat(format, readWrite != RenderTextureReadWrite::Linear),
        depthBuffer);
    descriptor.msaaSamples = antiAliasing;
    return GetTemporary(descriptor);
}

TemporaryTexture RenderTexturePool::GetTemporary(const RenderTextureDescriptor& descriptor,
                                                 FilterMode filterMode, TextureWrapMode wrapMode)
{
    const SamplerState sampler = SamplerWith(filterMode, wrapMode);
    // The oldest: which one that is must not depend on the order in which the others came back.
    const auto free = std::ranges::find_if(m_Entries,
                                           [&](const auto& entry)
                                           {
                                               const RenderTexture& texture = *entry->texture.rt();
                                               return !entry->isTaken &&
                                                      texture.descriptor() == descriptor &&
                                                      texture.sampler() == sampler;
                                           });
    auto entry = free != m_Entries.end() ? *free : nullptr;
    if (!entry)
    {
        entry = std::make_shared<TemporaryTexture::Entry>();
        entry->texture = RTHandle(std::make_shared<const RenderTexture>(
            "TempBuffer " + std::to_string(++m_Made) + " " + std::to_string(descriptor.width) +
                "x" + std::to_string(descriptor.height),
            descriptor, sampler, true));
        m_Entries.push_back(entry);
    }
    entry->isTaken = true;
    entry->idleFrames = 0;
    return TemporaryTexture(std::move(entry));
}

std::vector<std::uint64_t> RenderTexturePool::held() const
{
    std::vector<std::uint64_t> ids;
    for (const auto& entry : m_Entries)
    {
        if (entry->isTaken)
        {
            const RenderTexture& texture = *entry->texture.rt();
            ids.push_back(texture.id());
            if (texture.depthBuffer())
            {
                ids.push_back(texture.depthBuffer()->id());
            }
        }
    }
    return ids;
}

void RenderTexturePool::BeginFrame()
{
    std::erase_if(m_Entries, [](const auto& entry)
                  { return !entry->isTaken && ++entry->idleFrames > k_FramesKept; });
}

} // namespace limn
