#include "report/truth/twins/Field.h"
#include "report/truth/twins/SelectionTwin.h"
#include "report/truth/twins/Twins.h"

#include <algorithm>
#include <cmath>
#include <limn/features/MaskDifferenceOutline.h>
#include <limn/features/SelectionOutline.h>

namespace limn::study
{

namespace
{

/// 1 where the silhouette has the middle of a texel, in all channels.
Field MaskOf(const Silhouette& silhouette, const glm::dvec2& picture, int width, int height,
             int channels)
{
    Field mask{width, height, channels, {}};
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            const glm::dvec2 place((x + 0.5) * picture.x / width, (y + 0.5) * picture.y / height);
            mask.values.insert(mask.values.end(), static_cast<std::size_t>(channels),
                               silhouette.Contains(place) ? 1.0 : 0.0);
        }
    }
    return mask;
}

Coverage ToCoverage(const Field& field)
{
    Coverage coverage(field.width, field.height);
    for (int y = 0; y < field.height; ++y)
    {
        for (int x = 0; x < field.width; ++x)
        {
            coverage.At(x, y) = field.At(x, y);
        }
    }
    return coverage;
}

Field Black(int width, int height, int channels)
{
    const auto count = static_cast<std::size_t>(width * height * channels);
    return {width, height, channels, std::vector<double>(count)};
}

} // namespace

Coverage ScreenSpaceTwin(const Silhouette& silhouette, double width, int pictureWidth,
                         int pictureHeight)
{
    const Field mask = MaskOf(silhouette, {pictureWidth, pictureHeight},
                              std::max(pictureWidth / 2, 1), std::max(pictureHeight / 2, 1), 1);
    Field edge = RobertsReference(mask, width);
    std::ranges::transform(edge.values, edge.values.begin(),
                           [](double value) { return std::min(value, 1.0); });
    return ToCoverage(
        CompositeReference(Black(pictureWidth, pictureHeight, 3), edge, {1.0, 1.0, 1.0}));
}

Coverage SelectionTwin(const Silhouette& silhouette, double width, int pictureWidth,
                       int pictureHeight)
{
    SelectionOutline component;
    component.m_OutlineWidth.Override(static_cast<float>(width));
    const Field stencil =
        MaskOf(silhouette, {pictureWidth, pictureHeight}, pictureWidth, pictureHeight, 4);
    Field blur = stencil;
    for (int i = 0; i < component.blurCount(); ++i)
    {
        blur = BlurReference(blur, static_cast<double>(component.tapOffset()));
    }
    return ToCoverage(CompositeReference(Black(pictureWidth, pictureHeight, 4), stencil, blur,
                                         static_cast<double>(component.outlineStrength.value())));
}

Coverage MaskDifferenceTwin(const Silhouette& silhouette, double width, int pictureWidth,
                            int pictureHeight)
{
    MaskDifferenceOutline component;
    component.m_OutlineWidth.Override(static_cast<float>(width));
    const int away = static_cast<int>(component.reach());
    Coverage alpha(pictureWidth, pictureHeight);
    // The mask goes on outside of the picture.
    const auto mask = [&](int x, int y)
    {
        return silhouette.Contains({x + 0.5, y + 0.5}) ? 1 : 0;
    };
    for (int y = 0; y < pictureHeight; ++y)
    {
        for (int x = 0; x < pictureWidth; ++x)
        {
            const int sum =
                mask(x, y - away) + mask(x, y + away) + mask(x - away, y) + mask(x + away, y);
            alpha.At(x, y) = sum > 0 && 4 * mask(x, y) != sum ? 1.0 : 0.0;
        }
    }
    return alpha;
}

} // namespace limn::study
