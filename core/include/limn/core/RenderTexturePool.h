#pragma once

#include <limn/core/RTHandle.h>
#include <vector>

namespace limn
{

/// A texture of a RenderTexturePool, which gets it back when this goes or is released. May outlive
/// its pool.
class TemporaryTexture
{
public:
    TemporaryTexture() = default; ///< none
    TemporaryTexture(TemporaryTexture&&) noexcept = default;
    TemporaryTexture& operator=(TemporaryTexture&& other) noexcept;
    ~TemporaryTexture() { Release(); }

    /// The texture; an empty handle for none.
    const RTHandle& handle() const;
    /// As any other texture is used.
    operator const RTHandle&() const { return handle(); }
    const std::shared_ptr<const RenderTexture>& rt() const { return handle().rt(); }
    explicit operator bool() const { return m_Entry != nullptr; }

    void Release() noexcept;

private:
    friend class RenderTexturePool;

    struct Entry
    {
        RTHandle texture;
        bool isTaken = false;
        int idleFrames = 0; ///< begun since it was last given out
    };
    explicit TemporaryTexture(std::shared_ptr<Entry> entry) : m_Entry(std::move(entry)) {}

    std::shared_ptr<Entry> m_Entry;
};

/// Textures that are needed for a part of a frame. What one pass is done with the next one gets; in
/// a frame that asks for the same as the one before, each request is given the texture that it was
/// given there, so that such a frame makes nothing and is not compiled again. A pipeline has one,
/// which passes find in RenderingData. One thread at a time.
/// Unity: UnityEngine.RenderTexture.GetTemporary, ReleaseTemporary (2022.3).
class RenderTexturePool
{
public:
    /// A texture for as long as the result lives. What is in it is undefined: clear it, or draw
    /// over the whole of it.
    /// @param depthBuffer  bits of a depth that the colour has, see RenderTextureDescriptor
    /// @throws ContractError as RenderTexture does
    TemporaryTexture
    GetTemporary(int width, int height, int depthBuffer = 0,
                 RenderTextureFormat format = RenderTextureFormat::ARGB32,
                 RenderTextureReadWrite readWrite = RenderTextureReadWrite::Default,
                 int antiAliasing = 1);
    TemporaryTexture GetTemporary(const RenderTextureDescriptor& descriptor,
                                  FilterMode filterMode = FilterMode::Bilinear,
                                  TextureWrapMode wrapMode = TextureWrapMode::Clamp);
    /// Gives `texture` back before its scope ends; it is none afterwards.
    static void ReleaseTemporary(TemporaryTexture& texture) { texture.Release(); }

    /// Returns the ids of the textures that are given out: of what is not, nothing is kept for the
    /// next frame, whoever gets it then.
    std::vector<std::uint64_t> held() const;

    /// Forgets textures that nobody has asked for in the last 15 frames.
    void BeginFrame();

    /// Textures that it holds, given out or not.
    std::size_t size() const { return m_Entries.size(); }

private:
    std::vector<std::shared_ptr<TemporaryTexture::Entry>> m_Entries; ///< the oldest first
    std::uint64_t m_Made = 0;
};

} // namespace limn
