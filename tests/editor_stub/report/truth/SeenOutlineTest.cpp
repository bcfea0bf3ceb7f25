#include "report/truth/OutlineReference.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limn/core/Camera.h>
#include <limn/core/Mesh.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/Transform.h>
#include <numbers>

namespace limn::study
{
namespace
{

/// A rectangle of the picture whose nearness is `left` at its left side and `right` at its right
/// one.
std::vector<DepthTriangle> Sheet(const glm::dvec2& low, const glm::dvec2& high, double left,
                                 double right)
{
    const glm::dvec3 a(low, left);
    const glm::dvec3 b(high.x, low.y, right);
    const glm::dvec3 c(high, right);
    const glm::dvec3 d(low.x, high.y, left);
    return {{a, b, c}, {a, c, d}};
}

std::vector<DepthTriangle> Flat(const ScreenTriangles& triangles, double nearness)
{
    std::vector<DepthTriangle> result;
    for (const auto& [a, b, c] : triangles)
    {
        result.push_back({glm::dvec3(a, nearness), {b, nearness}, {c, nearness}});
    }
    return result;
}

Surfaces Of(const std::vector<DepthTriangle>& triangles, std::size_t owner = 0)
{
    Surfaces surfaces;
    surfaces.Add(triangles, owner);
    surfaces.Finish();
    return surfaces;
}

class SeenOutlineOfARectangle : public testing::Test
{
protected:
    static constexpr double k_Width = 6.0;

    /// What is seen of the outline of a rectangle of 40 x 20 pixels, its lower left corner at
    /// (30, 50) of the picture.
    SeenOutline See(const Surfaces& others, HiddenAt where)
    {
        const ScreenTriangles rectangle = NeedleTriangles({30, 40}, {70, 40}, 20.0);
        const Silhouette silhouette(rectangle);
        return SeenOutlineCoverage(ExactOutlineCoverage(silhouette, {k_Width}, 100, 80), silhouette,
                                   k_Width, Of(Flat(rectangle, 0.5)), others, where);
    }
};

TEST_F(SeenOutlineOfARectangle, IsWholeWithoutAnythingInFront)
{
    const double whole = k_Width * 120.0 + std::numbers::pi * k_Width * k_Width;
    for (const HiddenAt where : {HiddenAt::Border, HiddenAt::Point})
    {
        EXPECT_NEAR(See(Of({}), where).seen.Sum(), whole, 0.05);
        const SeenOutline behind = See(Of(Sheet({0, 0}, {100, 80}, 0.4, 0.4)), where);
        EXPECT_NEAR(behind.seen.Sum(), whole, 0.05);
        EXPECT_TRUE(behind.hiding.empty());
        const SeenOutline touching = See(Of(Sheet({0, 0}, {100, 80}, 0.5, 0.5)), where);
        EXPECT_NEAR(touching.seen.Sum(), whole, 0.05);
        EXPECT_TRUE(touching.hiding.empty());
    }
}

TEST_F(SeenOutlineOfARectangle, EndsWhereTheBorderGoesBehindSomething)
{
    // It covers the right end up to 10 pixels before the corners, and the outline beside it.
    const SeenOutline half = See(Of(Sheet({60, 0}, {100, 80}, 0.6, 0.6), 7), HiddenAt::Border);
    EXPECT_NEAR(half.seen.Sum(),
                k_Width * (30 + 30 + 20) + std::numbers::pi * k_Width * k_Width / 2, 0.05);
    EXPECT_EQ(half.hiding, std::vector<std::size_t>{7});
    EXPECT_NEAR(See(Of(Sheet({60, 0}, {100, 80}, 0.6, 0.6)), HiddenAt::Point).seen.Sum(),
                k_Width * (30 + 30 + 20) + std::numbers::pi * k_Width * k_Width / 2, 0.05);
}

TEST_F(SeenOutlineOfARectangle, IsHiddenAtItsBorderOrAtItsOwnPlaces)
{
    const double whole = k_Width * 120.0 + std::numbers::pi * k_Width * k_Width;
    // It covers the outline below the rectangle, and not the border.
    const Surfaces below = Of(Sheet({0, 50.5}, {100, 80}, 0.6, 0.6));
    EXPECT_NEAR(See(below, HiddenAt::Border).seen.Sum(), whole, 0.05);
    const double corners = std::numbers::pi * k_Width * k_Width / 2;
    const double strip = 0.5 * (40 + 2 * k_Width); // seen above the sheet; the corners' arcs begin
    EXPECT_NEAR(See(below, HiddenAt::Point).seen.Sum(), k_Width * 80 + corners + strip, 0.3);
    // It covers the border of the lower side, and nothing of the outline.
    const Surfaces within = Of(Sheet({31, 45}, {69, 50}, 0.6, 0.6));
    EXPECT_NEAR(See(within, HiddenAt::Border).seen.Sum(), whole - 38 * k_Width, 0.05);
    EXPECT_NEAR(See(within, HiddenAt::Point).seen.Sum(), whole, 0.05);
}

TEST_F(SeenOutlineOfARectangle, IsHiddenByTheNearerPartOfWhatLeansIntoIt)
{
    // As near as the rectangle at x = 50.
    const SeenOutline leaning = See(Of(Sheet({0, 0}, {100, 80}, 0.0, 1.0)), HiddenAt::Border);
    // Both lines end within half of the distance of two places in a pixel.
    EXPECT_NEAR(leaning.seen.Sum(),
                k_Width * (20 + 20 + 20) + std::numbers::pi * k_Width * k_Width / 2,
                2 * k_Width / 8);
}

/// Counts samples of a disc behind a sheet that leans, by the disc's own formula.
TEST(SeenOutline, AgreesWithSamplesOfADiscBehindALeaningSheet)
{
    constexpr double k_Width = 5.0;
    constexpr double k_Radius = 15.2;
    constexpr int k_Side = 16;
    const glm::dvec2 middle(30.3, 29.6);
    const ScreenTriangles disc = DiscTriangles(middle, k_Radius);
    const Silhouette silhouette(disc);
    const Coverage whole = ExactOutlineCoverage(silhouette, {k_Width}, 60, 60);
    const Surfaces own = Of(Flat(disc, 0.5));
    // x + 0.4 y <= 40, where the nearness grows downwards: 0.5 at y = 24.
    const std::vector<DepthTriangle> sheet = {
        {glm::dvec3(40, 0, 0.26), {16, 60, 0.86}, {-50, 60, 0.86}},
        {glm::dvec3(40, 0, 0.26), {-50, 60, 0.86}, {-50, 0, 0.26}}};
    for (const HiddenAt where : {HiddenAt::Border, HiddenAt::Point})
    {
        const Coverage seen =
            SeenOutlineCoverage(whole, silhouette, k_Width, own, Of(sheet), where).seen;
        Coverage sampled(60, 60);
        for (int i = 0; i < 60 * k_Side * 60 * k_Side; ++i)
        {
            const glm::dvec2 p((i % (60 * k_Side) + 0.5) / k_Side,
                               (static_cast<int>(i / (60 * k_Side)) + 0.5) / k_Side);
            const double distance = glm::distance(p, middle) - k_Radius;
            const glm::dvec2 border = middle + k_Radius * glm::normalize(p - middle);
            const glm::dvec2 asked = where == HiddenAt::Border ? border : p;
            const bool isHidden =
                asked.x + 0.4 * asked.y < 40.0 && 0.26 + 0.01 * asked.y > 0.5 * 1.001;
            if (distance > 0.0 && distance < k_Width && !isHidden)
            {
                sampled.At(static_cast<int>(p.x), static_cast<int>(p.y)) += 1.0 / (k_Side * k_Side);
            }
        }
        const OutlineScore score = ScoreOutline(seen, sampled);
        // Four places a row of a pixel that is cut, sixteen samples: a row of each is in doubt.
        EXPECT_LT(score.largest, 1.0 / 4.0 + 1.0 / 16.0);
        EXPECT_LT(score.meanAbsoluteError, 0.01);
        EXPECT_NEAR(score.areaRatio, 1.0, 0.002);
        EXPECT_LT(seen.Sum(), 0.8 * whole.Sum());
    }
}

TEST(MeshDepths, AreThoseOfTheFacesThatAreDrawn)
{
    Camera camera;
    camera.orthographic = true;
    camera.orthographicSize = 2.0f;
    camera.nearClipPlane = 1.0f;
    camera.farClipPlane = 11.0f;
    camera.transform.localPosition = {0.0f, 0.0f, -5.0f};
    const auto quad = CreatePrimitive(PrimitiveType::Quad); // faces a viewer who looks along +z
    Transform transform;
    transform.localPosition = {0.0f, 0.0f, -1.5f}; // 3.5 m away: 2.5 of 10 behind the near plane
    const auto depths = [&](CullMode cull)
    {
        return MeshDepths(*quad, 0, transform, camera, 64, 64, cull);
    };
    EXPECT_EQ(depths(CullMode::Off).size(), 2u);
    EXPECT_EQ(depths(CullMode::Back).size(), 2u);
    EXPECT_TRUE(depths(CullMode::Front).empty());
    EXPECT_NEAR(Of(depths(CullMode::Back)).NearestAt({33, 30}).nearness, 0.75, 1e-6);
    EXPECT_EQ(Of(depths(CullMode::Back)).NearestAt({45, 30}).owner, Surfaces::k_NoOwner);
    transform.localScale = {-1.0f, 1.0f, 1.0f};
    EXPECT_EQ(depths(CullMode::Back).size(), 2u) << "mirrored, and seen from its front";
    transform.localRotation = EulerToRotation({0.0f, 180.0f, 0.0f});
    EXPECT_TRUE(depths(CullMode::Back).empty()) << "seen from behind";
    EXPECT_EQ(depths(CullMode::Front).size(), 2u);
}

/// A ray through the picture meets the plane of a turned quad, found without any projection.
TEST(MeshDepths, AreThoseOfRaysThroughThePicture)
{
    constexpr double k_Near = 0.5;
    constexpr double k_Far = 20.0;
    Camera camera; // at the origin, looks along +z
    camera.nearClipPlane = k_Near;
    camera.farClipPlane = k_Far;
    camera.fieldOfView = 90.0f;
    Transform transform;
    transform.localPosition = {0.0f, 0.0f, 4.0f};
    transform.localScale = {6.0f, 6.0f, 1.0f};
    transform.localRotation = EulerToRotation({0.0f, 45.0f, 0.0f}); // z = 4 - x
    const Surfaces quad = Of(MeshDepths(*CreatePrimitive(PrimitiveType::Quad), 0, transform, camera,
                                        80, 80, CullMode::Off));
    for (const double x : {28.0, 33.25, 40.0, 61.0})
    {
        const double slope = (x - 40.0) / 40.0; // of the ray: x = slope z
        const double z = 4.0 / (1.0 + slope);
        const double nearness = k_Near * (k_Far - z) / (z * (k_Far - k_Near));
        EXPECT_NEAR(quad.NearestAt({x, 41.5}).nearness, nearness, 1e-6) << x;
    }
}

} // namespace
} // namespace limn::study
