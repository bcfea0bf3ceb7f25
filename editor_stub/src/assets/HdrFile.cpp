#include "assets/HdrFile.h"

#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfRgbaFile.h>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

/// The bytes of a file one after the other.
class HdrBytes
{
public:
    HdrBytes(const std::filesystem::path& path, std::string_view bytes)
        : m_Path(path), m_Bytes(bytes)
    {
    }

    [[noreturn]] void Fail(const std::string& message) const
    {
        throw AssetError(m_Path.generic_string(), {}, message);
    }
    std::string_view Line()
    {
        const std::size_t end = m_Bytes.find('\n');
        if (end == m_Bytes.npos)
        {
            Fail("this is no Radiance HDR file, or one that is cut off");
        }
        const std::string_view line = m_Bytes.substr(0, end);
        m_Bytes.remove_prefix(end + 1);
        return line;
    }
    std::uint8_t Byte()
    {
        if (m_Bytes.empty())
        {
            Fail("the file ends before its picture does");
        }
        const auto byte = static_cast<std::uint8_t>(m_Bytes.front());
        m_Bytes.remove_prefix(1);
        return byte;
    }
    /// Returns whether the next row is packed: it then begins with 2, 2 and its width.
    bool SkipPackedMark(std::uint32_t width)
    {
        const auto at = [&](std::size_t i)
        {
            return static_cast<std::uint8_t>(m_Bytes[i]);
        };
        const bool isPacked = width >= 8 && width < 32768 && m_Bytes.size() >= 4 && at(0) == 2 &&
                              at(1) == 2 && at(2) == width >> 8 && at(3) == (width & 255);
        m_Bytes.remove_prefix(isPacked ? 4 : 0);
        return isPacked;
    }

private:
    const std::filesystem::path& m_Path;
    std::string_view m_Bytes;
};

/// Two numbers of a line such as "-Y 512 +X 1024".
std::array<std::uint32_t, 2> ReadHdrSize(HdrBytes& bytes)
{
    std::string_view line = bytes.Line();
    std::array<std::uint32_t, 2> size{}; // height, width
    for (const std::string_view key : {"-Y ", "+X "})
    {
        std::uint32_t& number = size[key == "+X " ? 1 : 0];
        const bool isThere = line.starts_with(key);
        line.remove_prefix(isThere ? key.size() : 0);
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
        if (!isThere || error != std::errc())
        {
            bytes.Fail(
                "the Radiance HDR file has no size such as '-Y 512 +X 1024', which limn needs");
        }
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
        line.remove_prefix(line.starts_with(' ') ? 1 : 0);
    }
    return size;
}

using Rgbe = std::array<std::uint8_t, 4>;

/// A run of equal bytes or some that differ, for one channel after the other.
void ReadPackedRow(HdrBytes& bytes, std::vector<Rgbe>& row)
{
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
        for (std::size_t x = 0; x < row.size();)
        {
            const std::uint8_t code = bytes.Byte();
            const bool isRun = code > 128;
            const std::size_t count = isRun ? code - 128u : code;
            if (count == 0 || count > row.size() - x)
            {
                bytes.Fail("the Radiance HDR file is broken: a row has more texels than the "
                           "picture is wide");
            }
            const std::uint8_t value = isRun ? bytes.Byte() : std::uint8_t{0};
            for (std::size_t i = 0; i < count; ++i)
            {
                row[x++][channel] = isRun ? value : bytes.Byte();
            }
        }
    }
}

void AppendHalves(const Rgbe& texel, std::byte* target)
{
    const float scale = texel[3] == 0 ? 0.0f : std::ldexp(1.0f, static_cast<int>(texel[3]) - 136);
    for (std::size_t c = 0; c < 4; ++c)
    {
        const std::uint16_t half = HalfOf(c == 3 ? 1.0f : scale * static_cast<float>(texel[c]));
        std::memcpy(target + c * sizeof(half), &half, sizeof(half));
    }
}

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

Image DecodeHdr(const std::filesystem::path& path, std::string_view file,
                const std::function<void(std::uint32_t width, std::uint32_t height)>& requireSize)
{
    HdrBytes bytes(path, file);
    const std::string_view magic = bytes.Line();
    if (!magic.starts_with("#?RADIANCE") && !magic.starts_with("#?RGBE"))
    {
        bytes.Fail("this is no Radiance HDR file, which begins with #?RADIANCE");
    }
    bool isRgbe = false;
    for (std::string_view line = bytes.Line(); !line.empty(); line = bytes.Line())
    {
        isRgbe = isRgbe || line == "FORMAT=32-bit_rle_rgbe";
    }
    if (!isRgbe)
    {
        bytes.Fail("the Radiance HDR file is not of the format 32-bit_rle_rgbe, which limn reads");
    }
    const auto [height, width] = ReadHdrSize(bytes);
    requireSize(width, height);
    constexpr std::size_t k_TexelBytes = 8;
    Image image{static_cast<int>(width), static_cast<int>(height),
                GraphicsFormat::R16G16B16A16_SFloat,
                std::vector<std::byte>(std::size_t{width} * height * k_TexelBytes)};
    std::byte* target = image.texels.data();
    std::vector<Rgbe> row(width);
    for (std::uint32_t y = 0; y < height; ++y)
    {
        if (bytes.SkipPackedMark(width))
        {
            ReadPackedRow(bytes, row);
        }
        else
        {
            for (Rgbe& texel : row)
            {
                texel = {bytes.Byte(), bytes.Byte(), bytes.Byte(), bytes.Byte()};
            }
        }
        for (const Rgbe& texel : row)
        {
            AppendHalves(texel, target);
            target += k_TexelBytes;
        }
    }
    return image;
}

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
