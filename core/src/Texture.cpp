#include <limn/core/Texture.h>

#include <atomic>
#include <limn/shaderlab/Diagnostic.h>
#include <utility>

namespace limn
{

namespace
{

std::uint64_t NextTextureId()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

std::string SizeText(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

} // namespace

Texture::Texture(std::string name, int width, int height, GraphicsFormat format,
                 SamplerState sampler)
    : m_Id(NextTextureId()),
      m_Name(std::move(name)),
      m_Width(width),
      m_Height(height),
      m_Format(format),
      m_Sampler(sampler)
{
    if (width < 1 || height < 1)
    {
        throw ContractError("texture '" + m_Name + "': size " + SizeText(width, height) +
                            "; both must be at least 1");
    }
    if (format == GraphicsFormat::None)
    {
        throw ContractError("texture '" + m_Name + "': format None; it needs a format");
    }
}

Texture2D::Texture2D(std::string name, int width, int height, GraphicsFormat format,
                     std::vector<std::byte> texels, SamplerState sampler)
    : Texture(std::move(name), width, height, format, sampler), m_Texels(std::move(texels))
{
    if (IsDepthFormat(format))
    {
        throw ContractError("texture '" + this->name() + "': format " + ToString(format) +
                            "; only a RenderTexture can hold depth");
    }
    const std::size_t expected = static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(height) *
                                 static_cast<std::size_t>(BytesPerTexel(format));
    if (m_Texels.size() != expected)
    {
        throw ContractError("texture '" + this->name() + "': " + std::to_string(m_Texels.size()) +
                            " bytes of texels; " + SizeText(width, height) + " of " +
                            ToString(format) + " takes " + std::to_string(expected));
    }
}

} // namespace limn
