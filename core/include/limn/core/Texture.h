#pragma once

#include <cstddef>
#include <cstdint>
#include <limn/core/GraphicsFormat.h>
#include <string>
#include <vector>

namespace limn
{

/// How a shader reads a texture.
struct SamplerState
{
    FilterMode filterMode = FilterMode::Bilinear;
    TextureWrapMode wrapModeU = TextureWrapMode::Repeat;
    TextureWrapMode wrapModeV = TextureWrapMode::Repeat;
    bool comparison = false; ///< depth comparison GreaterEqual (reversed Z)

    bool operator==(const SamplerState&) const = default;
};

/// Something a shader can sample. An object of this type is a description: the device makes the
/// image when a frame first uses it and frees it some frames after the last owner is gone.
/// Unity: UnityEngine.Texture.
class Texture
{
public:
    virtual ~Texture() = default;
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    /// Unique in the process, never used again.
    std::uint64_t id() const { return m_Id; }
    const std::string& name() const { return m_Name; }
    int width() const { return m_Width; }
    int height() const { return m_Height; }
    GraphicsFormat graphicsFormat() const { return m_Format; }
    const SamplerState& sampler() const { return m_Sampler; }

protected:
    Texture(std::string name, int width, int height, GraphicsFormat format, SamplerState sampler);

private:
    std::uint64_t m_Id;
    std::string m_Name;
    int m_Width;
    int m_Height;
    GraphicsFormat m_Format;
    SamplerState m_Sampler;
};

/// An image whose texels come from the CPU. Row 0 is at v = 0: a picture goes in bottom row first,
/// as Unity imports it, so that it stands upright on a mesh. Unity: UnityEngine.Texture2D.
class Texture2D final : public Texture
{
public:
    /// @param texels  height rows of width texels in `format`, tightly packed
    /// @throws ContractError naming the texture, if the size is not positive, the bytes do not fit
    ///         it, or the format is None or a depth format
    Texture2D(std::string name, int width, int height, GraphicsFormat format,
              std::vector<std::byte> texels, SamplerState sampler = {});

    const std::vector<std::byte>& texels() const { return m_Texels; }

private:
    std::vector<std::byte> m_Texels;
};

} // namespace limn
