#include "report/truth/OutlineReference.h"

#include <cmath>
#include <functional>
#include <glm/ext/scalar_constants.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/Camera.h>
#include <limn/core/Image.h>
#include <limn/core/PrimitiveMesh.h>

namespace limn::study
{
namespace
{

constexpr double k_Pi = glm::pi<double>();
using Polygon = std::vector<glm::dvec2>;

/// Of the border, holes included, in the picture or not.
double PerimeterOf(const Silhouette& silhouette)
{
    double sum = 0.0;
    for (const auto& segment : silhouette.border())
    {
        sum += glm::length(segment[1] - segment[0]);
    }
    return sum;
}

double AreaOf(const Polygon& polygon)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const glm::dvec2& a = polygon[i];
        const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2.0;
}

/// What of a polygon is where inside(point), a linear function, is positive.
Polygon CutBy(const Polygon& polygon, const std::function<double(glm::dvec2)>& inside)
{
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const glm::dvec2& a = polygon[i];
        const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
        if (inside(a) > 0.0)
        {
            result.push_back(a);
        }
        if ((inside(a) > 0.0) != (inside(b) > 0.0))
        {
            result.push_back(glm::mix(a, b, inside(a) / (inside(a) - inside(b))));
        }
    }
    return result;
}

double OutlineArea(const ScreenTriangles& triangles, const OutlineBand& band, int size = 96)
{
    return ExactOutlineCoverage(Silhouette(triangles), band, size, size).Sum();
}

TEST(OutlineReference, GivesTheAreasOfBandsAroundADisc)
{
    const double r = 20.0;
    const ScreenTriangles disc = DiscTriangles({47.3, 48.1}, r);
    for (const double w : {0.25, 1.0, 2.0, 8.0, 17.5})
    {
        SCOPED_TRACE(w);
        EXPECT_NEAR(OutlineArea(disc, {w}), k_Pi * (2.0 * r * w + w * w), 0.02);
        EXPECT_NEAR(OutlineArea(disc, {w, OutlineSide::Inner}), k_Pi * (2.0 * r * w - w * w), 0.02);
        EXPECT_NEAR(OutlineArea(disc, {w, OutlineSide::Centred}), k_Pi * 2.0 * r * w, 0.02);
        const double g = 1.5;
        EXPECT_NEAR(OutlineArea(disc, {w, OutlineSide::Outer, g}),
                    k_Pi * (2.0 * (r + g) * w + w * w), 0.02);
        EXPECT_NEAR(OutlineArea(disc, {w, OutlineSide::Inner, g}),
                    k_Pi * (2.0 * (r - g) * w - w * w), 0.02);
    }
    EXPECT_NEAR(ExactFillCoverage(Silhouette(disc), 96, 96).Sum(), k_Pi * r * r, 0.005);
    EXPECT_NEAR(PerimeterOf(Silhouette(disc)), 2.0 * k_Pi * r, 1e-3);
}

TEST(OutlineReference, OutlinesTheHoleOfARingToo)
{
    const ScreenTriangles ring = RingTriangles({48.0, 48.0}, 15.0, 25.0);
    const double w = 4.0;
    EXPECT_NEAR(OutlineArea(ring, {w}), k_Pi * (29.0 * 29.0 - 25.0 * 25.0 + 15.0 * 15.0 - 121.0),
                0.02);
    EXPECT_NEAR(OutlineArea(ring, {w, OutlineSide::Inner}),
                k_Pi * (25.0 * 25.0 - 21.0 * 21.0 + 19.0 * 19.0 - 15.0 * 15.0), 0.02);
    EXPECT_NEAR(OutlineArea(ring, {99.0, OutlineSide::Inner}), k_Pi * (625.0 - 225.0), 0.02)
        << "all of it";
    EXPECT_NEAR(PerimeterOf(Silhouette(ring)), 2.0 * k_Pi * 40.0, 1e-3);
}

TEST(OutlineReference, GivesTheAreasOfBandsAroundANeedleAndAStar)
{
    for (const double thickness : {0.05, 0.3, 3.0})
    {
        const ScreenTriangles needle = NeedleTriangles({20.0, 30.0}, {70.0, 55.0}, thickness);
        const double perimeter = 2.0 * (std::hypot(50.0, 25.0) + thickness);
        for (const double w : {0.5, 2.0, 8.0})
        {
            EXPECT_NEAR(OutlineArea(needle, {w}), perimeter * w + k_Pi * w * w, 0.05);
        }
    }
    // Strips along the edges and sectors at the tips; between tips two strips overlap in a kite.
    const Silhouette star(StarTriangles({48.0, 48.0}, 5, 14.0, 34.0, 0.2));
    const double step = k_Pi / 5.0;
    const double edge = std::hypot(34.0 - 14.0 * std::cos(step), 14.0 * std::sin(step));
    const double halfTip = std::asin(14.0 * std::sin(step) / edge);
    const double turnAtTip = k_Pi - 2.0 * halfTip;
    const double turnBetween = turnAtTip - 2.0 * k_Pi / 5.0;
    const double w = 3.0;
    EXPECT_NEAR(PerimeterOf(star), 10.0 * edge, 1e-9);
    EXPECT_NEAR(ExactOutlineCoverage(star, {w}, 96, 96).Sum(),
                10.0 * edge * w + 5.0 * w * w * (turnAtTip / 2.0 - std::tan(turnBetween / 2.0)),
                0.05);
}

TEST(OutlineReference, GivesEachPixelThePartOfItsSquareThatAStraightBandCovers)
{
    for (const double angle : {0.0, 0.1, 0.463, k_Pi / 4.0, 1.3})
    {
        const glm::dvec2 along(std::cos(angle), std::sin(angle));
        const glm::dvec2 aside(-along.y, along.x);
        const glm::dvec2 through(16.2, 15.7);
        // A rectangle on one side of the line, far larger than the picture.
        const Silhouette half(NeedleTriangles(through - along * 900.0 - aside * 200.0,
                                              through + along * 900.0 - aside * 200.0, 400.0));
        const double w = 3.3;
        const Coverage exact = ExactOutlineCoverage(half, {w}, 32, 32);
        double largest = 0.0;
        for (int y = 0; y < 32; ++y)
        {
            for (int x = 0; x < 32; ++x)
            {
                const glm::dvec2 corner(x, y);
                Polygon part{corner, corner + glm::dvec2(1, 0), corner + 1.0,
                             corner + glm::dvec2(0, 1)};
                const auto away = [&](const glm::dvec2& p)
                {
                    return dot(p - through, aside);
                };
                part = CutBy(part, away);
                part = CutBy(part, [&](const glm::dvec2& p) { return w - away(p); });
                largest = std::max(largest, std::abs(exact.At(x, y) - AreaOf(part)));
            }
        }
        EXPECT_LT(largest, 2e-3) << angle;
    }
}

TEST(OutlineReference, ComesNearerTheTruthWithSmallerSquares)
{
    const Silhouette star(StarTriangles({15.2, 16.1}, 5, 5.0, 12.0, 0.3));
    const OutlineBand band{1.7};
    const Coverage truth = ExactOutlineCoverage(star, band, 32, 32, 8);
    double previous = 1.0;
    for (const int levels : {0, 1, 2, 3, 4, 5})
    {
        const double error =
            ScoreOutline(ExactOutlineCoverage(star, band, 32, 32, levels), truth).meanAbsoluteError;
        EXPECT_LT(error, 0.6 * previous) << levels;
        previous = error;
    }
    EXPECT_LT(previous, 2e-5);
}

/// Distance to the union of triangles by looking at all of them, 0 inside.
double SlowDistance(const ScreenTriangles& triangles, const glm::dvec2& p)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& triangle : triangles)
    {
        int left = 0;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const glm::dvec2 a = triangle[i];
            const glm::dvec2 along = triangle[(i + 1) % 3] - a;
            left += along.x * (p.y - a.y) - along.y * (p.x - a.x) > 0.0 ? 1 : 0;
            const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
            nearest = std::min(nearest, distance(p, a + t * along));
        }
        nearest = left == 0 || left == 3 ? 0.0 : nearest;
    }
    return nearest;
}

TEST(OutlineReference, AgreesWithSubSamplesOfTheDistanceToOverlappingTriangles)
{
    const ScreenTriangles both =
        Together({StarTriangles({8.0, 8.0}, 4, 2.0, 5.0), NeedleTriangles({6, 13}, {17, 6}, 3),
                  NeedleTriangles({17, 6}, {17, 18}, 0.4)});
    const double w = 2.6;
    const Coverage exact = ExactOutlineCoverage(Silhouette(both), {w}, 22, 22);
    Coverage sampled(22, 22);
    for (int y = 0; y < 22; ++y)
    {
        for (int x = 0; x < 22; ++x)
        {
            for (int i = 0; i < 16 * 16; ++i)
            {
                const double d = SlowDistance(
                    both, {x + (i % 16 + 0.5) / 16.0, y + (static_cast<int>(i / 16) + 0.5) / 16.0});
                sampled.At(x, y) += d > 0.0 && d < w ? 1.0 / 256.0 : 0.0;
            }
        }
    }
    const OutlineScore score = ScoreOutline(sampled, exact);
    EXPECT_LT(score.largest, 0.04) << "a sample a row of sixteen";
    EXPECT_LT(score.meanAbsoluteError, 0.003);
}

TEST(Silhouette, HasNoEdgesInsideItsUnion)
{
    // Two squares of 10, one shifted by (5, 5); a third meets the first edge to edge.
    const auto square = [](double x, double y)
    {
        return NeedleTriangles({x, y + 5.0}, {x + 10.0, y + 5.0}, 10.0);
    };
    EXPECT_NEAR(PerimeterOf(Silhouette(Together({square(0, 0), square(5, 5)}))), 60.0, 1e-9);
    EXPECT_NEAR(PerimeterOf(Silhouette(Together({square(0, 0), square(10, 0)}))), 60.0, 1e-9);
    EXPECT_NEAR(PerimeterOf(Silhouette(Together({square(0, 0), square(10, 3)}))), 66.0, 1e-9);
    EXPECT_NEAR(PerimeterOf(Silhouette(Together({square(0, 0), square(0, 0)}))), 40.0, 1e-9);
    EXPECT_TRUE(Silhouette({{{{0, 0}, {5, 5}, {10, 10}}}}).border().empty()) << "no area";
}

TEST(Silhouette, OfATurnedCubeIsTheHullOfItsCorners)
{
    Camera camera;
    camera.transform.localPosition = {0.0f, 0.0f, -3.0f};
    Transform transform;
    transform.localRotation = EulerToRotation({25.0f, 40.0f, 10.0f});
    const Silhouette cube(
        MeshTriangles(*CreatePrimitive(PrimitiveType::Cube), transform, camera, 96, 64));
    // Every corner is inside or on the border, and the border turns one way only.
    const auto& border = cube.border();
    EXPECT_EQ(border.size(), 6u);
    double length = 0.0;
    for (const auto& edge : border)
    {
        int left = 0;
        int right = 0;
        for (const auto& other : border)
        {
            const glm::dvec2 along = edge[1] - edge[0];
            const glm::dvec2 to = other[0] - edge[0];
            const double side = (along.x * to.y - along.y * to.x) / glm::length(along);
            left += side > 1e-6 ? 1 : 0;
            right += side < -1e-6 ? 1 : 0;
        }
        EXPECT_TRUE(left == 0 || right == 0);
        length += glm::length(edge[1] - edge[0]);
    }
    EXPECT_DOUBLE_EQ(PerimeterOf(cube), length);
    const double w = 3.0;
    EXPECT_NEAR(ExactOutlineCoverage(cube, {w}, 96, 64).Sum(), length * w + k_Pi * w * w, 0.05);
}

TEST(Silhouette, ShowsAMeshWhereTheCameraSeesIt)
{
    Camera camera;
    camera.transform.localPosition = {0.0f, 0.0f, -5.0f};
    camera.orthographic = true;
    camera.orthographicSize = 2.0f; // 64 rows: 16 pixels a metre
    Transform transform;
    transform.localPosition = {1.0f, 0.5f, 0.0f};
    const auto quad = CreatePrimitive(PrimitiveType::Quad);
    const Silhouette seen(MeshTriangles(*quad, transform, camera, 96, 64));
    EXPECT_NEAR(seen.bounds().low.x, 56.0, 1e-4);
    EXPECT_NEAR(seen.bounds().high.x, 72.0, 1e-4);
    EXPECT_NEAR(seen.bounds().low.y, 16.0, 1e-4);
    EXPECT_NEAR(seen.bounds().high.y, 32.0, 1e-4);

    // The floor below a camera goes on behind it: what is seen ends at the near plane.
    camera = Camera();
    camera.nearClipPlane = 0.5f;
    camera.fieldOfView = 90.0f;
    transform.localPosition = {0.0f, -1.0f, 0.0f};
    transform.localRotation = EulerToRotation({90.0f, 0.0f, 0.0f});
    transform.localScale = glm::vec3(20.0f);
    const Silhouette floor(MeshTriangles(*quad, transform, camera, 64, 64));
    EXPECT_NEAR(floor.bounds().high.y, 32.0 + 32.0 * 1.0 / 0.5, 1e-4);
    EXPECT_NEAR(floor.bounds().low.y, 32.0 + 32.0 * 1.0 / 10.0, 1e-4);
    EXPECT_NEAR(floor.bounds().high.x, 32.0 + 32.0 * 10.0 / 0.5, 1e-3);

    transform.localPosition = {0.0f, 0.0f, -4.0f};
    EXPECT_TRUE(
        MeshTriangles(*CreatePrimitive(PrimitiveType::Sphere), transform, camera, 8, 8).size() > 0)
        << "the camera is inside";
    transform.localPosition = {0.0f, 0.0f, -40.0f};
    EXPECT_TRUE(
        MeshTriangles(*CreatePrimitive(PrimitiveType::Sphere), transform, camera, 8, 8).empty());
}

/// What the ramp saturate(0.5 - d) is off across a straight edge, a pixel's length of it, averaged
/// over the edge's directions.
double MeanErrorOfTheRamp()
{
    double sum = 0.0;
    const int directions = 32;
    const double step = 0.005;
    for (int i = 0; i < directions; ++i)
    {
        const double angle = k_Pi / 4.0 * (i + 0.5) / directions;
        const glm::dvec2 normal(std::cos(angle), std::sin(angle));
        for (double d = -1.0; d < 1.0; d += step)
        {
            const Polygon square{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
            const double exact =
                AreaOf(CutBy(square, [&](const glm::dvec2& p) { return -d - dot(p, normal); }));
            sum += std::abs(exact - std::clamp(0.5 - d, 0.0, 1.0)) * step / directions;
        }
    }
    return sum;
}

TEST(OutlineReference, ScoresTheUsualRampAsItsErrorAcrossStraightEdgesSays)
{
    const glm::dvec2 center(250.3, 249.6);
    const double r = 200.0;
    const Silhouette disc(DiscTriangles(center, r));
    const double error = MeanErrorOfTheRamp();
    for (const double w : {2.0, 8.0, 32.0})
    {
        const Coverage exact = ExactOutlineCoverage(disc, {w}, 500, 500);
        Coverage ramp(500, 500);
        for (int y = 0; y < 500; ++y)
        {
            for (int x = 0; x < 500; ++x)
            {
                const double d = distance(glm::dvec2(x + 0.5, y + 0.5), center) - r;
                ramp.At(x, y) = std::clamp(w - d + 0.5, 0.0, 1.0) - std::clamp(0.5 - d, 0.0, 1.0);
            }
        }
        const OutlineScore score = ScoreOutline(ramp, exact, PerimeterOf(disc));
        const double bothEdges = 2.0 * k_Pi * (r + r + w);
        const auto pixels = static_cast<double>(score.bandPixels);
        EXPECT_NEAR(score.meanAbsoluteError, error * bothEdges / pixels, 0.03 * error) << w;
        EXPECT_NEAR(pixels, bothEdges * w / 2.0 + bothEdges * 0.6, bothEdges * 0.1);
        EXPECT_GE(score.intersectionOverUnion, 0.996);
        EXPECT_NEAR(score.areaRatio, 1.0, 1e-3);
        EXPECT_NEAR(score.effectiveWidth, w * (1.0 + w / (2.0 * r)), 0.01);
    }
}

TEST(OutlineReference, ScoresWhatIsKnown)
{
    Coverage exact(4, 1);
    exact.values = {0.0, 1.0, 1.0, 0.0};
    Coverage measured(4, 1);
    measured.values = {0.0, 0.75, 1.0, 0.6};
    const OutlineScore score = ScoreOutline(measured, exact, 2.0);
    EXPECT_EQ(score.bandPixels, 3u);
    EXPECT_NEAR(score.meanAbsoluteError, 0.85 / 3.0, 1e-12);
    EXPECT_NEAR(score.rootMeanSquare, std::sqrt((0.0625 + 0.36) / 3.0), 1e-12);
    EXPECT_NEAR(score.largest, 0.6, 1e-12);
    EXPECT_NEAR(score.intersectionOverUnion, 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(score.areaRatio, 2.35 / 2.0, 1e-12);
    EXPECT_NEAR(score.effectiveWidth, 2.35 / 2.0, 1e-12);
    EXPECT_EQ(score.badValues, 0u);
    measured.values = {std::numeric_limits<double>::quiet_NaN(), 2.0, 1.0, 0.0};
    EXPECT_EQ(ScoreOutline(measured, exact).badValues, 2u);
    EXPECT_EQ(ScoreOutline(exact, exact).meanAbsoluteError, 0.0);
    EXPECT_EQ(ScoreOutline(Coverage(2, 2), Coverage(2, 2)).intersectionOverUnion, 1.0);
    EXPECT_THROW(ScoreOutline(exact, Coverage(2, 2)), std::invalid_argument);
}

TEST(OutlineReference, SaysWhichEndOfALineIsOff)
{
    const Silhouette disc(DiscTriangles({48.2, 47.9}, 20.0));
    const ContourScores scores =
        ScoreContours(ExactOutlineCoverage(disc, {8.5}, 96, 96), disc, {8.0});
    EXPECT_NEAR(scores.high.mean, 0.5, 0.01);
    EXPECT_NEAR(scores.low.mean, 0.0, 0.01);
    EXPECT_GT(scores.low.crossings, 100u);
}

TEST(OutlineReference, ReadsChannelsOfImages)
{
    Image image{2, 1, GraphicsFormat::R8G8B8A8_UNorm, {}};
    for (const int value : {0, 51, 255, 102, 1, 2, 3, 204})
    {
        image.texels.push_back(static_cast<std::byte>(value));
    }
    EXPECT_NEAR(ChannelOf(image, 3).At(1, 0), 0.8, 1e-12);
    EXPECT_NEAR(ChannelOf(image, 1).At(0, 0), 0.2, 1e-12);
    image = {1, 1, GraphicsFormat::R16G16B16A16_SFloat, {}};
    for (const int value : {0, 0, 0x00, 0x38, 0, 0x3c, 0, 0})
    {
        image.texels.push_back(static_cast<std::byte>(value));
    }
    EXPECT_EQ(ChannelOf(image, 1).At(0, 0), 0.5);
    EXPECT_EQ(ChannelOf(image, 2).At(0, 0), 1.0);
    image.format = GraphicsFormat::R32_SFloat;
    EXPECT_THROW(ChannelOf(image, 0), std::invalid_argument);
}

/// One row of pixels.
Coverage Row(std::vector<double> values)
{
    Coverage row(static_cast<int>(values.size()), 1);
    row.values = std::move(values);
    return row;
}

TEST(HausdorffDistance, IsThatOfThePlacesWhereAlphaIsOneHalf)
{
    // Pixel centres are at 0.5, 1.5, ...: it rises through one half at 1.0 here, at 2.25 there, and
    // falls at 4.0 in both.
    const Coverage a = Row({0.0, 1.0, 1.0, 1.0, 0.0, 0.0});
    const Coverage b = Row({0.0, 0.2, 0.6, 1.0, 0.0, 0.0});
    EXPECT_DOUBLE_EQ(HausdorffDistance(a, b), 1.25);
    EXPECT_DOUBLE_EQ(HausdorffDistance(b, a), 1.25);
    EXPECT_EQ(HausdorffDistance(a, a), 0.0);
}

TEST(HausdorffDistance, SeesWhatOnlyOneOfThemHas)
{
    // A second line, four pixels beyond the nearest end of the first.
    const Coverage one = Row({0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    const Coverage two = Row({0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0});
    EXPECT_DOUBLE_EQ(HausdorffDistance(one, two), 5.0);
    EXPECT_EQ(HausdorffDistance(one, Row(std::vector<double>(9, 0.0))),
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(HausdorffDistance(Row({0.0, 0.4}), Row({0.0, 0.0})), 0.0);
}

TEST(MeanErrorChange, CountsWhatTheErrorsChangeByInTheOutlinesOfEitherFrame)
{
    // Errors before: 0, -0.5, 0.25, 0; now: 0, 0.5, 0.25, 0. The last pixel is no outline at all.
    EXPECT_DOUBLE_EQ(MeanErrorChange(Row({1.0, 0.5, 0.25, 0.0}), Row({1.0, 1.0, 0.0, 0.0}),
                                     Row({1.0, 1.0, 0.5, 0.0}), Row({1.0, 0.5, 0.25, 0.0})),
                     1.0 / 3.0);
}

TEST(MeanErrorChange, TakesNoOffenceAtMotion)
{
    EXPECT_EQ(MeanErrorChange(Row({1.0, 0.0, 0.0}), Row({1.0, 0.0, 0.0}), Row({0.0, 0.5, 0.5}),
                              Row({0.0, 0.5, 0.5})),
              0.0);
}

TEST(ScoreContours, TellsHowUnevenALinesEndIs)
{
    // A straight border, and a line whose upper half ends a pixel farther out than its lower half.
    const Silhouette left(NeedleTriangles({-20.0, 8.0}, {6.0, 8.0}, 60.0));
    Coverage line(16, 16);
    for (int y = 0; y < 16; ++y)
    {
        for (int x = 6; x < (y < 8 ? 11 : 10); ++x)
        {
            line.At(x, y) = 1.0;
        }
    }
    // One crossing leads from one half to the other; it is 4.5 out, where 4 is asked.
    const ContourScore end = ScoreContours(line, left, {4.0}).high;
    EXPECT_EQ(end.crossings, 17u);
    EXPECT_DOUBLE_EQ(end.mean, 8.5 / 17.0);
    EXPECT_NEAR(end.spread, std::sqrt(8.25 / 17.0 - 0.25), 1e-12);
}

} // namespace
} // namespace limn::study
