#include "report/measure/StudyPicture.h"

#include "report/measure/StudyFiles.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <utility>

namespace limn::study
{

namespace
{

double FromSrgb(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

using Rgb = std::array<double, 3>;

Image MakeImage(int width, int height)
{
    const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, GraphicsFormat::R8G8B8A8_SRGB,
            std::vector<std::byte>(4 * texels, std::byte{255})};
}

/// Returns a part of an image, opaque. A texel becomes scale x scale texels.
Image Part(const Image& image, int x, int y, int width, int height, int scale)
{
    Image part = MakeImage(width * scale, height * scale);
    for (int row = 0; row < part.height; ++row)
    {
        for (int column = 0; column < part.width; ++column)
        {
            const int from = 4 * ((y + row / scale) * image.width + x + column / scale);
            std::copy_n(image.texels.begin() + from, 3,
                        part.texels.begin() + 4 * (row * part.width + column));
        }
    }
    return part;
}

Image Draw(const PictureWindow& window, const std::function<Rgb(int x, int y)>& color)
{
    Image image = MakeImage(window.side, window.side);
    auto texel = image.texels.begin();
    for (int y = 0; y < window.side; ++y)
    {
        for (int x = 0; x < window.side; ++x)
        {
            for (const double channel : color(window.x + x, window.y + y))
            {
                *texel++ =
                    static_cast<std::byte>(std::lround(std::clamp(channel, 0.0, 1.0) * 255.0));
            }
            ++texel; // opaque
        }
    }
    return Part(image, 0, 0, window.side, window.side, window.scale);
}

/// 0 outside of the picture, and for NaN.
double At(const Coverage& coverage, int x, int y)
{
    const bool isInside = x >= 0 && y >= 0 && x < coverage.width && y < coverage.height;
    const double value = isInside ? coverage.At(x, y) : 0.0;
    return std::isnan(value) ? 0.0 : value;
}

std::string FileName(std::string name)
{
    for (char& letter : name)
    {
        const bool isPlain =
            std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '.' || letter == '-';
        letter = isPlain ? letter : '_';
    }
    return name;
}

} // namespace

StudyPicture::StudyPicture(SceneAsset asset, const AssetContext& assets, GraphicsDevice& device)
    : m_Device(device), m_Pipeline(device), m_View(std::move(asset), assets)
{
}

const RenderResult& StudyPicture::Render(Timeline* timeline)
{
    m_Request.time = time;
    m_Request.timeline = timeline;
    m_View.Render(m_Pipeline, m_Request, m_Result);
    return m_Result;
}

Image StudyPicture::Colors()
{
    constexpr const char* k_CameraColor = "_CameraColorAttachmentA";
    m_Request.compile.leavesOut = false; // a colour that goes straight into the output is 8 bits
    const HDRColorBufferPrecision usual = std::exchange( // 32 bits have few steps
        m_View.asset().hdrColorBufferPrecision, HDRColorBufferPrecision::_64Bits);
    m_Request.alsoReadBack.clear();
    Render();
    for (const CompiledRenderPass& pass : m_Result.frame->passes)
    {
        if (!pass.colors.empty() && pass.colors.front().texture->name() == k_CameraColor)
        {
            m_Request.alsoReadBack = {RTHandle(pass.colors.front().texture)};
        }
    }
    Render();
    m_Request.compile.leavesOut = true;
    m_View.asset().hdrColorBufferPrecision = usual;
    return m_Device.ReadBack(*m_Request.alsoReadBack.at(0).rt());
}

Coverage StudyPicture::Alpha()
{
    const Image colors = Colors();
    Coverage alpha = ChannelOf(colors, 0);
    if (IsSRGBFormat(colors.format)) // of a camera without HDR
    {
        std::ranges::transform(alpha.values, alpha.values.begin(), FromSrgb);
    }
    return alpha;
}

Image StudyPicture::Output()
{
    m_Request.alsoReadBack.clear();
    Render();
    return m_Device.ReadBack(*m_Result.output.rt());
}

PictureWindow WindowOnBorder(const Silhouette& silhouette, int width, int height)
{
    const glm::dvec2 size(width, height);
    const auto distance = [&size](const std::array<glm::dvec2, 2>& segment)
    {
        const bool isInside = glm::clamp(segment[0], glm::dvec2(0.0), size) == segment[0];
        return isInside ? segment[0].x + segment[0].y : std::numeric_limits<double>::infinity();
    };
    const auto first = std::ranges::min_element(silhouette.border(), {}, distance);
    const bool isAny = first != silhouette.border().end() && std::isfinite(distance(*first));
    const glm::dvec2 nearest = isAny ? (*first)[0] : 0.5 * size;
    PictureWindow window;
    window.x = static_cast<int>(nearest.x) - window.side / 2;
    window.y = static_cast<int>(nearest.y) - window.side / 2;
    return window;
}

Image AlphaImage(const Coverage& alpha, const PictureWindow& window)
{
    return Draw(window,
                [&alpha](int x, int y)
                {
                    const double value = At(alpha, x, y);
                    return Rgb{value, value, value};
                });
}

Image DifferenceImage(const Coverage& alpha, const Coverage& exact, const PictureWindow& window)
{
    return Draw(window,
                [&](int x, int y)
                {
                    const double error = At(alpha, x, y) - At(exact, x, y);
                    const double rest = 1.0 - std::min(1.0, std::abs(error));
                    return error > 0.0 ? Rgb{1.0, rest, rest} : Rgb{rest, rest, 1.0};
                });
}

std::string WriteStudyPicture(const Image& image, const std::filesystem::path& folder,
                              const CellId& id, const std::string& what)
{
    const std::string name = "pictures/" + FileName(id.Name() + "." + what) + ".png";
    const std::filesystem::path file = FileOfStudy(folder, name);
    std::filesystem::create_directories(file.parent_path());
    WritePng(file, image);
    return name;
}

Image EnlargedPart(const Image& image, const PictureWindow& window)
{
    const auto first = [&window](int wanted, int size)
    {
        return std::clamp(wanted, 0, std::max(0, size - window.side));
    };
    return Part(image, first(window.x, image.width), first(window.y, image.height),
                std::min(window.side, image.width), std::min(window.side, image.height),
                window.scale);
}

PictureWindow CloseUp(const PictureWindow& window, double width, double renderedPixel)
{
    constexpr int k_Side = 96;   // pixels of the picture
    constexpr int k_Drawn = 288; // pixels of the file, about as wide as it is shown
    constexpr int k_Widest = 64; // a wider outline need not be seen as a whole
    const double widest = std::clamp(width, 0.0, 1.0 * k_Widest) * renderedPixel;
    PictureWindow result;
    result.side = std::max(k_Side, static_cast<int>(std::ceil(3.0 * widest)));
    result.scale = std::max(1, k_Drawn / result.side);
    const auto first = [&](int x)
    {
        return static_cast<int>((x + window.side / 2) * renderedPixel) - result.side / 2;
    };
    result.x = first(window.x);
    result.y = first(window.y);
    return result;
}

Image ScenePart(const Image& image, const Box& bounds, double width)
{
    const double margin = std::min(width, 64.0) + 24.0;
    const glm::dvec2 size(image.width, image.height);
    const glm::ivec2 low(glm::clamp(bounds.low - margin, glm::dvec2(0.0), size - 1.0));
    const glm::ivec2 high(glm::clamp(bounds.high + margin, glm::dvec2(1.0), size));
    return Part(image, low.x, low.y, std::max(1, high.x - low.x), std::max(1, high.y - low.y), 1);
}

} // namespace limn::study
