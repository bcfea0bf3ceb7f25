#include "report/measure/StudyPictures.h"

#include "report/measure/StudyFiles.h"
#include "scene/SceneView.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>

namespace limn::study
{

namespace
{

using Rgb = std::array<double, 3>;

Image MakeImage(int width, int height)
{
    Image image;
    image.width = width;
    image.height = height;
    image.format = GraphicsFormat::R8G8B8A8_SRGB;
    image.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4,
                        std::byte{255});
    return image;
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

PictureWindow WindowOnBorder(const Silhouette& silhouette, int width, int height)
{
    const glm::dvec2 size(width, height);
    glm::dvec2 nearest = 0.5 * size;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& segment : silhouette.border())
    {
        const glm::dvec2& place = segment[0];
        const bool isInside = glm::clamp(place, glm::dvec2(0.0), size) == place;
        const double distance = place.x + place.y;
        if (isInside && distance < least)
        {
            least = distance;
            nearest = place;
        }
    }
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
    const auto low = [margin](double place, int size)
    {
        return static_cast<int>(std::clamp(place - margin, 0.0, size - 1.0));
    };
    const auto high = [margin](double place, int size)
    {
        return static_cast<int>(std::clamp(place + margin, 1.0, static_cast<double>(size)));
    };
    const int x = low(bounds.low.x, image.width);
    const int y = low(bounds.low.y, image.height);
    return Part(image, x, y, std::max(1, high(bounds.high.x, image.width) - x),
                std::max(1, high(bounds.high.y, image.height) - y), 1);
}

} // namespace limn::study
