#include <limn/core/Image.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <fstream>
#include <limn/base/Diagnostic.h>
#include <limn/base/ReadFile.h>
#include <limn/base/WriteFile.h>
#include <png.h>
#include <string>
#include <zlib.h>

namespace limn
{

namespace
{

/// libpng's simplified interface, which reports by return value instead of longjmp.
class PngImage
{
public:
    PngImage() { m_Image.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&m_Image); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;

    png_image* get() { return &m_Image; }
    png_image* operator->() { return &m_Image; }

private:
    png_image m_Image{};
};

int PngColorTypeOf(GraphicsFormat format)
{
    switch (format)
    {
    case GraphicsFormat::R8G8B8A8_SRGB:
    case GraphicsFormat::R8G8B8A8_UNorm:
        return PNG_COLOR_TYPE_RGBA;
    case GraphicsFormat::R8_UNorm:
        return PNG_COLOR_TYPE_GRAY;
    default:
        throw ContractError(std::string("WritePng: the format is ") + ToString(format) +
                            "; it must be R8G8B8A8_SRGB, R8G8B8A8_UNorm or R8_UNorm");
    }
}

void RequireWholeImage(const Image& image)
{
    const std::string size = std::to_string(image.width) + "x" + std::to_string(image.height);
    if (image.width < 1 || image.height < 1)
    {
        throw ContractError("WritePng: the size is " + size + "; both must be at least 1");
    }
    const std::size_t expected = static_cast<std::size_t>(image.width) *
                                 static_cast<std::size_t>(image.height) *
                                 static_cast<std::size_t>(BytesPerTexel(image.format));
    if (image.texels.size() != expected)
    {
        throw ContractError("WritePng: there are " + std::to_string(image.texels.size()) +
                            " bytes of texels; " + size + " of " + ToString(image.format) +
                            " takes " + std::to_string(expected));
    }
}

constexpr png_uint_32 k_MaxSide = 16384; // of textures, on every device worth the name

/// Why a picture of the header's size is not made; "" if it is. Memory is taken by what the file
/// can hold, not by what it says: deflate makes at most 1032 bytes of one.
std::string SizeProblem(const png_image& header, std::string_view file)
{
    const std::string size = std::to_string(header.width) + "x" + std::to_string(header.height);
    if (header.width > k_MaxSide || header.height > k_MaxSide)
    {
        return "the picture is " + size + "; limn reads at most " + std::to_string(k_MaxSide) +
               " texels either way";
    }
    constexpr std::uint64_t maxRatio = 1032;
    constexpr std::uint64_t channels[] = {1, 0, 3, 1, 2, 0, 4}; // by the header's colour type
    const auto depth = static_cast<unsigned char>(file[24]);
    const auto type = static_cast<std::size_t>(file[25]);
    const std::uint64_t bits = std::uint64_t{header.width} * header.height * depth * channels[type];
    return bits / 8 > maxRatio * file.size()
               ? "the file is no readable PNG: a file of " + std::to_string(file.size()) +
                     " bytes cannot hold its picture of " + size
               : std::string();
}

/// The state of one picture that libpng writes. It outlives the function that libpng jumps out of,
/// in which a destructor might not run.
struct PngWriter
{
    PngWriter()
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, &Fail, nullptr)),
          info(png == nullptr ? nullptr : png_create_info_struct(png))
    {
    }
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    [[noreturn]] static void Fail(png_structp png, png_const_charp message)
    {
        static_cast<PngWriter*>(png_get_error_ptr(png))->error = message;
        png_longjmp(png, 1);
    }

    static void Append(png_structp png, png_bytep data, std::size_t size)
    {
        std::vector<std::byte>& bytes = static_cast<PngWriter*>(png_get_io_ptr(png))->bytes;
        const auto* const begin = reinterpret_cast<const std::byte*>(data);
        bytes.insert(bytes.end(), begin, begin + size);
    }

    png_structp png;
    png_infop info;
    std::vector<std::byte> bytes;
    std::string error = "there is not enough memory";
};

/// Returns false if libpng fails; the writer then has the error.
bool Write(PngWriter& writer, const Image& image, int colorType)
{
    if (writer.info == nullptr || setjmp(png_jmpbuf(writer.png)) != 0)
    {
        return false;
    }
    png_set_write_fn(writer.png, &writer, &PngWriter::Append, nullptr);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8, colorType, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    // For a lit frame of 1280x720 31 ms and 1.20 MB, where PNG_IMAGE_FLAG_FAST takes 53 ms for
    // 1.44 MB and libpng's own choice 300 ms.
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_strategy(writer.png, Z_RLE);
    png_set_compression_buffer_size(writer.png, std::size_t{1} << 20);
    png_write_info(writer.png, writer.info);
    const std::size_t row = image.texels.size() / static_cast<std::size_t>(image.height);
    for (std::size_t at = 0; at < image.texels.size(); at += row)
    {
        png_write_row(writer.png, reinterpret_cast<png_const_bytep>(image.texels.data() + at));
    }
    png_write_end(writer.png, nullptr);
    return true;
}

} // namespace

std::vector<std::byte> FlipRows(std::span<const std::byte> texels, int rows)
{
    if (rows < 1 || texels.size() % static_cast<std::size_t>(rows) != 0)
    {
        throw ContractError("FlipRows: " + std::to_string(texels.size()) + " bytes are not " +
                            std::to_string(rows) + " rows");
    }
    const std::size_t length = texels.size() / static_cast<std::size_t>(rows);
    std::vector<std::byte> flipped;
    flipped.reserve(texels.size());
    for (std::size_t end = texels.size(); end != 0; end -= length)
    {
        const auto row = texels.subspan(end - length, length);
        flipped.insert(flipped.end(), row.begin(), row.end());
    }
    return flipped;
}

std::vector<std::byte> EncodePng(const Image& image)
{
    const int colorType = PngColorTypeOf(image.format);
    RequireWholeImage(image);
    PngWriter writer;
    // Appending must not allocate, since an exception must not pass through libpng.
    const std::size_t filtered = image.texels.size() + static_cast<std::size_t>(image.height);
    writer.bytes.reserve(filtered + filtered / 256 + 4096); // deflate stores what does not shrink
    if (!Write(writer, image, colorType))
    {
        throw AssetError("PNG", {}, "the picture cannot be made: " + writer.error);
    }
    return std::move(writer.bytes);
}

void WritePng(const std::filesystem::path& path, const Image& image)
{
    const std::vector<std::byte> bytes = EncodePng(image);
    WriteFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Image ReadPng(const std::filesystem::path& path)
{
    return DecodePng(ReadFile(path, k_MaxDataBytes), path.string());
}

Image DecodePng(std::string_view bytes, const std::string& name)
{
    PngImage png;
    const auto fail = [&]
    {
        return AssetError(name, {}, std::string("the file is no readable PNG: ") + png->message);
    };

    if (png_image_begin_read_from_memory(png.get(), bytes.data(), bytes.size()) == 0)
    {
        throw fail();
    }
    if (std::string problem = SizeProblem(*png.get(), bytes); !problem.empty())
    {
        throw AssetError(name, {}, std::move(problem));
    }
    png->format = PNG_FORMAT_RGBA;
    // Without this, libpng takes a 16-bit file that does not state its gamma for linear.
    png->flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    Image image{static_cast<int>(png->width), static_cast<int>(png->height),
                GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(PNG_IMAGE_SIZE(*png.get()))};
    if (png_image_finish_read(png.get(), nullptr, image.texels.data(), 0, nullptr) == 0)
    {
        throw fail();
    }
    return image;
}

std::uintmax_t PngTexelBytes(const std::filesystem::path& path)
{
    std::error_code error;
    std::array<char, 24> header{};
    if (!std::filesystem::is_regular_file(path, error) ||
        !std::ifstream(path, std::ios::binary).read(header.data(), header.size()))
    {
        return 0;
    }
    const auto number = [&header](std::size_t at)
    {
        std::uintmax_t value = 0;
        for (std::size_t i = at; i < at + 4; ++i)
        {
            value = value << 8 | static_cast<unsigned char>(header[i]);
        }
        return value;
    };
    const std::uintmax_t width = std::min<std::uintmax_t>(number(16), k_MaxSide);
    return width * std::min<std::uintmax_t>(number(20), k_MaxSide) * 4;
}

} // namespace limn
