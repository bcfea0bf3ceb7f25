#pragma once

#include <limn/core/RTHandle.h>
#include <vector>

namespace limn
{

/// A texture of a RenderTexturePool, which gets it back when this is destroyed or released. It may
/// outlive its pool.
class TemporaryTexture
{
public:
    TemporaryTexture() = default; ///< none
    TemporaryTexture(TemporaryTexture&&) noexcept = default;
    TemporaryTexture& operator=(TemporaryTexture&& other) noexcept;
    ~TemporaryTexture() { Release(); }

    /// Returns the texture, or an empty handle if there is none.
    const RTHandle& handle() const;
    /// Converts to the texture's handle.
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
        int idleFrames = 0; ///< frames begun since it was last given out
    };
    explicit TemporaryTexture(std::shared_ptr<Entry> entry) : m_Entry(std::move(entry)) {}

    std::shared_ptr<Entry> m_Entry;
};

/// A pool of textures that are needed for a part of a frame. A texture that one pass has released
/// goes to the next pass that asks. In a frame that asks for the same as the one before, each
/// request gets the texture that it got there, so that such a frame makes nothing and is not
/// compiled again. A pipeline has one, which passes find in RenderingData. Only one thread at a
/// time may use it. Unity: UnityEngine.RenderTexture.GetTemporary, ReleaseTemporary (2022.3).
class RenderTexturePool
{
public:
    /// Returns a texture that stays taken as long as the result lives. Its contents are undefined:
    /// clear it, or draw over the whole of it.
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
    /// Gives `texture` back before its scope ends; it is empty afterwards.
    static void ReleaseTemporary(TemporaryTexture& texture) { texture.Release(); }

    /// Returns the ids of the textures that are given out. Nothing of the others is kept for the
    /// next frame.
    std::vector<std::uint64_t> held() const;

    /// Forgets textures that nothing has asked for in the last 15 frames.
    void BeginFrame();

    /// Returns the number of textures that it holds, given out or not.
    std::size_t size() const { return m_Entries.size(); }

private:
    std::vector<std::shared_ptr<TemporaryTexture::Entry>> m_Entries; ///< the oldest first
    std::uint64_t m_Made = 0;
};

} // namespace limn
