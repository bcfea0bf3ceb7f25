#include "assets/ExrFile.h"

#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfRgbaFile.h>
#include <cstring>
#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

/// A file in memory, as OpenEXR reads one.
class ExrBytes : public Imf::IStream
{
public:
    explicit ExrBytes(std::string_view bytes) : IStream("picture"), m_Bytes(bytes) {}

    bool read(char target[], int count) override
    {
        if (count < 0 || static_cast<std::size_t>(count) > m_Bytes.size() - m_At)
        {
            throw std::runtime_error("the file ends before its picture does");
        }
        std::memcpy(target, m_Bytes.data() + m_At, static_cast<std::size_t>(count));
        m_At += static_cast<std::size_t>(count);
        return m_At < m_Bytes.size();
    }
    std::uint64_t tellg() override { return m_At; }
    void seekg(std::uint64_t at) override
    {
        m_At = static_cast<std::size_t>(std::min<std::uint64_t>(at, m_Bytes.size()));
    }

private:
    std::string_view m_Bytes;
    std::size_t m_At = 0;
};

} // namespace

Image DecodeExr(const std::filesystem::path& path, std::string_view bytes,
                const std::function<void(std::uint32_t width, std::uint32_t height)>& requireSize)
{
    try
    {
        // Tables as long as the header says are made before anybody else sees it.
        constexpr int k_Most = 16384;
        Imf::Header::setMaxImageSize(k_Most, k_Most);
        Imf::Header::setMaxTileSize(k_Most, k_Most);
        ExrBytes stream(bytes);
        Imf::RgbaInputFile file(stream, 0);
        const Imath::Box2i window = file.dataWindow();
        const auto width = static_cast<std::uint32_t>(window.max.x - window.min.x) + 1;
        const auto height = static_cast<std::uint32_t>(window.max.y - window.min.y) + 1;
        requireSize(width, height);
        std::vector<Imf::Rgba> texels(std::size_t{width} * height);
        file.setFrameBuffer(texels.data() - window.min.x -
                                static_cast<std::ptrdiff_t>(window.min.y) *
                                    static_cast<std::ptrdiff_t>(width),
                            1, width);
        file.readPixels(window.min.y, window.max.y);
        Image image{static_cast<int>(width), static_cast<int>(height),
                    GraphicsFormat::R16G16B16A16_SFloat,
                    std::vector<std::byte>(texels.size() * sizeof(Imf::Rgba))};
        std::byte* target = image.texels.data();
        for (const Imf::Rgba& texel : texels)
        {
            for (const Imath::half channel : {texel.r, texel.g, texel.b, texel.a})
            {
                const std::uint16_t half =
                    channel.isFinite() ? channel.bits() : HalfOf(static_cast<float>(channel));
                std::memcpy(target, &half, sizeof(half));
                target += sizeof(half);
            }
        }
        return image;
    }
    catch (const AssetError&)
    {
        throw;
    }
    catch (const std::bad_alloc&)
    {
        throw;
    }
    catch (const std::exception& error)
    {
        throw AssetError(path.generic_string(), {},
                         std::string("this is no OpenEXR picture, or a broken one: ") +
                             error.what());
    }
}

} // namespace limn
