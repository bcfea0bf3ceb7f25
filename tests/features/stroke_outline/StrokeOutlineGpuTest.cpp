#include "Mentions.h"
#include "features/outline/TechniquePicture.h"
#include "precision/DevicePrecision.h"
#include "report/measure/UntidyMesh.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/features/StrokeOutlineRendererFeature.h>
#include <numbers>
#include <random>

namespace limn::test
{
namespace
{

constexpr int k_CanvasWidth = 96;
constexpr int k_CanvasHeight = 97;

struct Shape
{
    const char* name;
    ScreenTriangles triangles;
};

std::vector<Shape> Shapes()
{
    const glm::dvec2 middle(47.3, 48.6);
    return {
        {"disc", DiscTriangles(middle, 20.2)},
        {"ring", RingTriangles(middle, 11.3, 20.6)},
        {"star", StarTriangles(middle, 5, 8.5, 22.0, 0.3)},
        {"needle", NeedleTriangles({30.2, 40.3}, {66.7, 55.1}, 0.3)},
        {"two",
         Together({DiscTriangles({40.2, 45.7}, 12.4), StarTriangles({54.9, 52.3}, 7, 7.0, 13.0)})},
    };
}

/// Measures against the exact outline. Which side of a border a centre is on is the rasteriser's
/// word, and it may move the border by SubPixel() along both axes: pixels so near to it, of which
/// the wrong word takes or adds up to a half, count as exact.
OutlineScore Score(Coverage measured, const Coverage& exact,
                   std::initializer_list<const Silhouette*> silhouettes)
{
    const double reach = std::sqrt(2.0) * SubPixel();
    for (int y = 0; y < exact.height; ++y)
    {
        for (int x = 0; x < exact.width; ++x)
        {
            const bool isOnBorder = std::ranges::any_of(
                silhouettes,
                [&](const Silhouette* silhouette) {
                    return std::abs(silhouette->SignedDistance({x + 0.5, y + 0.5}, 1.0)) < reach;
                });
            if (isOnBorder && std::abs(measured.At(x, y) - exact.At(x, y)) < 0.6)
            {
                measured.At(x, y) = exact.At(x, y);
            }
        }
    }
    return ScoreOutline(measured, exact);
}

/// A picture with the feature on.
class StrokePicture : public TechniquePicture
{
public:
    explicit StrokePicture(float width, StrokeOutlineSettings settings = {},
                           int pixelsWide = k_CanvasWidth, int pixelsHigh = k_CanvasHeight)
        : TechniquePicture(SharedDevice(), pixelsWide, pixelsHigh),
          feature(AddFeature<StrokeOutlineRendererFeature>(std::move(settings))),
          component(Enable<StrokeOutline>(width))
    {
    }

    /// Of what the objects' meshes are in this picture, taken together.
    OutlineScore Score(double outlineWidth)
    {
        ScreenTriangles all;
        for (const auto& object : scene.objects())
        {
            const ScreenTriangles part = MeshTriangles(*object->renderer->mesh, object->transform,
                                                       camera, width(), height());
            all.insert(all.end(), part.begin(), part.end());
        }
        const Silhouette silhouette(all);
        return test::Score(Alpha(),
                           ExactOutlineCoverage(silhouette, {outlineWidth}, width(), height()),
                           {&silhouette});
    }

    StrokeOutlineRendererFeature& feature;
    StrokeOutline& component;
};

/// The material as glass has it: drawn behind opaque objects, tested against depth.
std::shared_ptr<const Material> Transparent(const Material& material)
{
    auto glass = std::make_shared<Material>(material);
    glass->SetFloat(ShaderPropertyId("_Surface"), 1.0f);   // transparent
    glass->SetFloat(ShaderPropertyId("_SrcBlend"), 5.0f);  // SrcAlpha
    glass->SetFloat(ShaderPropertyId("_DstBlend"), 10.0f); // OneMinusSrcAlpha
    glass->SetFloat(ShaderPropertyId("_ZWrite"), 0.0f);
    glass->SetRenderQueue(3000);
    return glass;
}

bool DrawsInto(const RenderResult& result, const std::string& texture)
{
    return std::ranges::any_of(
        result.frame->passes, [&](const CompiledRenderPass& pass)
        { return !pass.colors.empty() && pass.colors.front().texture->name() == texture; });
}

class StrokeOutlineGpu : public GpuTest
{
};

TEST_F(StrokeOutlineGpu, CoversAsMuchOfEachPixelAsTheExactOutlineDoes)
{
    for (const Shape& shape : Shapes())
    {
        const Silhouette silhouette(shape.triangles);
        StrokePicture picture(1.0f);
        picture.Add("shape", shape.triangles);
        for (const double width : {1.0, 2.0, 8.0, 20.0})
        {
            SCOPED_TRACE(shape.name + std::string(", width ") + std::to_string(width));
            picture.component.m_OutlineWidth.Override(static_cast<float>(width));
            const OutlineScore score =
                Score(picture.Alpha(),
                      ExactOutlineCoverage(silhouette, {width}, k_CanvasWidth, k_CanvasHeight),
                      {&silhouette});
            EXPECT_EQ(score.badValues, 0u);
            EXPECT_LE(score.meanAbsoluteError, width < 8.0 ? 0.0125 : 0.004);
            EXPECT_GE(score.intersectionOverUnion, width < 8.0 ? 0.975 : 0.998);
            EXPECT_LE(std::abs(score.areaRatio - 1.0), 0.01);
        }
    }
}

/// Between two arcs that meet in sharp tips.
ScreenTriangles CrescentTriangles(const glm::dvec2& middle, double radius)
{
    constexpr int k_Parts = 64;
    const auto place = [&](int i, double bulge)
    {
        const double angle = std::numbers::pi * (static_cast<double>(i) / k_Parts - 0.5) + 0.3;
        const glm::dvec2 tip(std::cos(0.3), std::sin(0.3));
        const glm::dvec2 onArc(std::cos(angle), std::sin(angle));
        return middle + radius * (onArc - tip * (1.0 - bulge) * glm::dot(onArc, tip));
    };
    ScreenTriangles triangles;
    for (int i = 0; i < k_Parts; ++i)
    {
        triangles.push_back({{place(i, 1.0), place(i + 1, 1.0), place(i, 0.6)}});
        triangles.push_back({{place(i, 0.6), place(i + 1, 1.0), place(i + 1, 0.6)}});
    }
    return triangles;
}

/// Coverage is that of straight borders, so that it is off where one pixel holds a tip.
TEST_F(StrokeOutlineGpu, IsOffByAPixelAtMostWhereThereAreTips)
{
    for (const ScreenTriangles& triangles :
         {CrescentTriangles({40.3, 48.6}, 30.0), StarTriangles({47.3, 48.6}, 9, 6.0, 30.0, 0.2)})
    {
        const Silhouette silhouette(triangles);
        for (const double width : {2.0, 8.0})
        {
            StrokePicture picture(static_cast<float>(width));
            picture.Add("tips", triangles);
            const OutlineScore score =
                Score(picture.Alpha(),
                      ExactOutlineCoverage(silhouette, {width}, k_CanvasWidth, k_CanvasHeight),
                      {&silhouette});
            EXPECT_LE(score.meanAbsoluteError, width < 8.0 ? 0.0125 : 0.004);
            EXPECT_LE(score.largest, 0.9); // the star's nine tips
        }
    }
}

constexpr glm::dvec2 k_CombMiddle(47.3, 48.6);

/// Parallel bars, so far apart that the outlines of two neighbours leave `gap` pixels between them.
ScreenTriangles CombTriangles(double turn, double width, double gap)
{
    constexpr double k_Thickness = 3.0;
    const glm::dvec2 along(std::cos(turn), std::sin(turn));
    const glm::dvec2 across(-along.y, along.x);
    ScreenTriangles triangles;
    for (int i = -2; i <= 2; ++i)
    {
        const glm::dvec2 middle = k_CombMiddle + across * (i * (k_Thickness + 2.0 * width + gap));
        for (const auto& triangle :
             NeedleTriangles(middle - along * 18.0, middle + along * 18.0, k_Thickness))
        {
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

/// A pixel between two bars holds parts of two outlines, and they add up. The bars' corners are
/// left out: coverage is that of straight borders.
TEST_F(StrokeOutlineGpu, CoversTheUnionWhereOutlinesOfTwoPartsNearlyMeet)
{
    for (const double degrees : {0.0, 7.0, 31.0, 45.0, 83.0, 90.0, 140.0})
    {
        for (const double width : {1.0, 3.0})
        {
            for (const double gap : {0.1, 0.4, 0.9})
            {
                SCOPED_TRACE(std::to_string(degrees) + " degrees, width " + std::to_string(width) +
                             ", gap " + std::to_string(gap));
                const double turn = glm::radians(degrees);
                const ScreenTriangles comb = CombTriangles(turn, width, gap);
                const Silhouette silhouette(comb);
                StrokePicture picture(static_cast<float>(width));
                picture.Add("comb", comb);
                const Coverage measured = picture.Alpha();
                Coverage exact =
                    ExactOutlineCoverage(silhouette, {width}, k_CanvasWidth, k_CanvasHeight);
                for (int y = 0; y < k_CanvasHeight; ++y)
                {
                    for (int x = 0; x < k_CanvasWidth; ++x)
                    {
                        const glm::dvec2 place = glm::dvec2(x + 0.5, y + 0.5) - k_CombMiddle;
                        if (std::abs(place.x * std::cos(turn) + place.y * std::sin(turn)) > 16.0)
                        {
                            exact.At(x, y) = measured.At(x, y);
                        }
                    }
                }
                const OutlineScore score = Score(measured, exact, {&silhouette});
                EXPECT_GT(score.bandPixels, 200u);
                EXPECT_LE(score.meanAbsoluteError, 0.004);
                EXPECT_LE(score.largest, 0.1);
            }
        }
    }
}

TEST_F(StrokeOutlineGpu, KeepsAThinNeedleWhole)
{
    const ScreenTriangles needle = NeedleTriangles({30.2, 40.3}, {66.7, 55.1}, 0.3);
    const Silhouette silhouette(needle);
    for (const double width : {1.0, 8.0})
    {
        StrokePicture picture(static_cast<float>(width));
        picture.Add("needle", needle);
        EXPECT_GE(ScoreOutline(picture.Alpha(), ExactOutlineCoverage(silhouette, {width},
                                                                     k_CanvasWidth, k_CanvasHeight))
                      .intersectionOverUnion,
                  0.99);
    }
}

/// Solid, with holes, with corners, and a sheet without thickness.
TEST_F(StrokeOutlineGpu, IsExactForMeshesFromAnywhere)
{
    constexpr PrimitiveType types[] = {PrimitiveType::Sphere, PrimitiveType::Capsule,
                                       PrimitiveType::Cube, PrimitiveType::Torus,
                                       PrimitiveType::Quad};
    float turn = 0.0f;
    for (const PrimitiveType type : types)
    {
        SCOPED_TRACE(static_cast<int>(type));
        StrokePicture picture(8.0f);
        picture.camera.orthographic = false;
        picture.camera.nearClipPlane = 0.1f;
        picture.camera.fieldOfView = 40.0f;
        picture.camera.transform.localPosition = {0.1f, -0.05f, -3.6f};
        GameObject& object = picture.Add("object", CreatePrimitive(type));
        object.transform.localRotation = EulerToRotation({25.0f + turn, 31.0f, 8.0f});
        turn += 13.0f;
        object.transform.localScale = {1.0f, -0.8f, 1.1f}; // mirrored, uneven
        const OutlineScore score = picture.Score(8.0);
        EXPECT_EQ(score.badValues, 0u);
        EXPECT_LE(score.meanAbsoluteError, 0.004);
        EXPECT_GE(score.intersectionOverUnion, 0.998);
        EXPECT_LE(std::abs(score.areaRatio - 1.0), 0.01);
    }
}

TEST_F(StrokeOutlineGpu, IsExactForAMeshThatTheNearPlaneCuts)
{
    StrokePicture picture(6.0f);
    picture.camera.orthographic = false;
    picture.camera.nearClipPlane = 0.5f;
    picture.camera.transform.localPosition = {0.0f, 0.0f, -1.0f};
    GameObject& object = picture.Add("torus", CreatePrimitive(PrimitiveType::Torus));
    object.transform.localRotation = EulerToRotation({70.0f, 15.0f, 0.0f});
    object.transform.localPosition = {0.2f, 0.25f, -0.35f};
    const OutlineScore score = picture.Score(6.0);
    EXPECT_GT(score.bandPixels, 300u);
    EXPECT_LE(score.meanAbsoluteError, 0.006);
    EXPECT_GE(score.intersectionOverUnion, 0.995);
}

TEST_F(StrokeOutlineGpu, IsExactForACamerasOwnProjection)
{
    const auto look = [](bool orthographic)
    {
        auto picture = std::make_unique<StrokePicture>(6.0f);
        Camera& camera = picture->camera;
        camera.orthographic = orthographic;
        camera.orthographicSize = 2.0f;
        camera.nearClipPlane = 0.5f;
        camera.transform.localPosition = {0.0f, 0.0f, -3.0f};
        picture->Add("torus", CreatePrimitive(PrimitiveType::Torus)).transform.localRotation =
            EulerToRotation({70.0f, 15.0f, 0.0f});
        return picture;
    };
    const float aspect = static_cast<float>(k_CanvasWidth) / static_cast<float>(k_CanvasHeight);
    for (const bool orthographic : {false, true})
    {
        const auto plain = look(orthographic);
        const auto moved = look(orthographic);
        glm::dmat4 offCentre = moved->camera.projectionMatrixFor(aspect);
        offCentre[orthographic ? 3 : 2] += glm::dvec4(0.3, -0.2, 0.0, 0.0);
        moved->camera.projectionMatrix = offCentre;
        const auto cut = look(orthographic); // by a plane through the torus
        cut->camera.projectionMatrix =
            cut->camera.CalculateObliqueMatrix({-0.5, 0.2, -1.0, -3.0}, aspect);
        for (const auto& picture : {&moved, &cut})
        {
            const OutlineScore score = (*picture)->Score(6.0);
            EXPECT_GT(score.bandPixels, 300u);
            EXPECT_EQ(score.badValues, 0u);
            // As where any near plane cuts a thin part.
            EXPECT_LE(score.meanAbsoluteError, picture == &cut ? 0.007 : 0.004);
            EXPECT_GE(score.intersectionOverUnion, picture == &cut ? 0.985 : 0.995);
            EXPECT_NE((*picture)->Output(), plain->Output());
        }
    }
}

TEST_F(StrokeOutlineGpu, OutlinesOverlappingObjectsTogetherOrEachOnItsOwn)
{
    const ScreenTriangles left = DiscTriangles({40.2, 45.7}, 12.4);
    const ScreenTriangles right = DiscTriangles({57.9, 52.3}, 12.4);
    for (const OutlineGrouping grouping : {OutlineGrouping::Together, OutlineGrouping::PerObject})
    {
        StrokeOutlineSettings settings;
        settings.m_Grouping = grouping;
        StrokePicture picture(5.0f, settings);
        picture.Add("left", left);
        picture.Add("right", right);
        const Silhouette both(Together({left, right}));
        const Silhouette ofLeft(left);
        const Silhouette ofRight(right);
        Coverage exact = ExactOutlineCoverage(both, {5.0}, k_CanvasWidth, k_CanvasHeight);
        if (grouping == OutlineGrouping::PerObject)
        {
            const Coverage a = ExactOutlineCoverage(ofLeft, {5.0}, k_CanvasWidth, k_CanvasHeight);
            const Coverage b = ExactOutlineCoverage(ofRight, {5.0}, k_CanvasWidth, k_CanvasHeight);
            for (std::size_t i = 0; i < exact.values.size(); ++i)
            {
                exact.values[i] = 1.0 - (1.0 - a.values[i]) * (1.0 - b.values[i]); // blended
            }
        }
        const OutlineScore score = Score(picture.Alpha(), exact, {&ofLeft, &ofRight});
        EXPECT_LE(score.meanAbsoluteError, 0.004) << static_cast<int>(grouping);
        EXPECT_GE(score.intersectionOverUnion, 0.997) << static_cast<int>(grouping);
    }
}

TEST_F(StrokeOutlineGpu, ReachesIntoThePictureFromBesideItAndLeavesTheBorderAlone)
{
    // It ends 3 pixels left of the picture; another one goes over the lower border.
    const ScreenTriangles beside = DiscTriangles({-13.0, 30.4}, 10.0);
    const ScreenTriangles across = DiscTriangles({60.2, 94.3}, 14.1);
    StrokePicture picture(6.0f);
    picture.Add("beside", beside);
    picture.Add("across", across);
    const OutlineScore score =
        ScoreOutline(picture.Alpha(), ExactOutlineCoverage(Silhouette(Together({beside, across})),
                                                           {6.0}, k_CanvasWidth, k_CanvasHeight));
    EXPECT_LE(score.meanAbsoluteError, 0.004);
    EXPECT_GE(score.intersectionOverUnion, 0.998);
}

TEST_F(StrokeOutlineGpu, CostsNothingWhereNothingOfItIsSeen)
{
    const auto expectNothing = [](StrokePicture& picture, const std::vector<std::string>& why)
    {
        const RenderResult& result = picture.Render();
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            EXPECT_NE(pass.name, "Outline") << testing::PrintToString(why);
        }
        EXPECT_THAT(result.report.notes,
                    testing::ElementsAre(
                        testing::AllOf(Mentions("Outline", "not drawn"), MentionsInOrder(why))));
    };
    StrokePicture beside(6.0f);
    beside.Add("beside", DiscTriangles({-18.0, 30.4}, 10.0)); // 8 pixels away
    expectNothing(beside, {"0 of 0", "no renderer"});

    StrokePicture around(6.0f);
    around.Add("around", CreatePrimitive(PrimitiveType::Sphere)).transform.localScale =
        glm::vec3(500.0f);
    expectNothing(around, {"no silhouette", "within reach"});

    StrokePicture thin(0.0f);
    thin.Add("disc", DiscTriangles({50.0, 50.0}, 10.0));
    expectNothing(thin, {"StrokeOutline.m_OutlineWidth is 0"});

    StrokePicture hair(1e-30f);
    hair.Add("disc", DiscTriangles({50.0, 50.0}, 10.0));
    expectNothing(hair, {"StrokeOutline.m_OutlineWidth", "less than 0.001953125"});

    StrokePicture clear(4.0f);
    clear.Add("disc", DiscTriangles({50.0, 50.0}, 10.0));
    clear.component.m_OutlineColor.Override(Color{1.0f, 1.0f, 1.0f, 0.0f});
    expectNothing(clear, {"StrokeOutline.m_OutlineColor", "alpha 0"});

    StrokeOutlineSettings settings;
    settings.m_RenderingLayerMask = 9;
    StrokePicture unselected(4.0f, settings);
    unselected.Add("disc", DiscTriangles({50.0, 50.0}, 10.0));
    expectNothing(unselected, {"0 of 1", "rendering layer mask leaves out 1"});
}

TEST_F(StrokeOutlineGpu, GrowsWithItsWidthAndStaysWithinItsTexturesOfTheObjectsSize)
{
    double last = 0.0;
    StrokePicture picture(1.0f);
    picture.Add("disc", DiscTriangles({47.3, 48.6}, 12.2));
    for (const float width : {0.0625f, 0.25f, 0.5f, 1.0f, 3.0f, 12.0f, 40.0f, 1e4f})
    {
        picture.component.m_OutlineWidth.Override(width);
        const double area = picture.Alpha().Sum();
        EXPECT_GT(area, last) << width;
        last = area;
    }
    // Beyond the diagonal the whole picture but the disc is covered.
    EXPECT_NEAR(last, k_CanvasWidth * k_CanvasHeight - 3.14159265 * 12.2 * 12.2, 2.0);

    StrokePicture small(8.0f, {}, 640, 480);
    small.Add("disc", DiscTriangles({300.3, 200.6}, 20.2));
    bool isSmall = false;
    for (const CompiledRenderPass& pass : small.Render().frame->passes)
    {
        for (const auto& color : pass.colors)
        {
            if (color.texture->name() == "_StrokeCoverage")
            {
                EXPECT_EQ(color.texture->width(), 64);
                EXPECT_EQ(color.texture->height(), 64);
                isSmall = true;
            }
        }
    }
    EXPECT_TRUE(isSmall);
}

TEST_F(StrokeOutlineGpu, DrawsPicturesOfAFewPixels)
{
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {3, 2}})
    {
        StrokePicture picture(2.0f, {}, width, height);
        picture.Add("disc", DiscTriangles({-1.0, 0.5}, 0.8));
        const Silhouette silhouette(DiscTriangles({-1.0, 0.5}, 0.8));
        const OutlineScore score =
            ScoreOutline(picture.Alpha(), ExactOutlineCoverage(silhouette, {2.0}, width, height));
        EXPECT_LE(score.largest, 0.05) << width << " x " << height;
    }
}

/// A disc, its left half behind a wall.
TEST_F(StrokeOutlineGpu, TellsWhatIsHiddenFromWhatIsSeen)
{
    const glm::dvec2 middle(47.3, 48.6);
    const Silhouette disc(DiscTriangles(middle, 20.2));
    const Coverage whole = ExactOutlineCoverage(disc, {5.0}, k_CanvasWidth, k_CanvasHeight);
    const double rounded = std::sqrt(2.0) * SubPixel();
    const auto alpha = [&](OutlineOcclusion occlusion, int channel)
    {
        StrokeOutlineSettings settings;
        settings.m_Occlusion = occlusion;
        settings.m_RenderingLayerMask = 1;
        StrokePicture picture(5.0f, settings);
        picture.component.m_OutlineColor.Override(Color{1.0f, 0.0f, 0.0f, 1.0f});
        picture.component.m_OccludedColor.Override(Color{0.0f, 1.0f, 0.0f, 1.0f});
        picture.Add("disc", DiscTriangles(middle, 20.2)).renderer->renderingLayerMask =
            RenderingLayerMask::FromIndex(1);
        picture.Add("wall",
                    {{{{-10.0, -10.0}, {47.3, -10.0}, {47.3, 110.0}}},
                     {{{-10.0, -10.0}, {47.3, 110.0}, {-10.0, 110.0}}}},
                    -20.0f);
        return ChannelOf(picture.Colors(), channel);
    };
    /// The exact outline of one side, apart from the columns around the wall's end.
    const auto expect = [&](const Coverage& measured, bool left, bool right)
    {
        double largest = 0.0;
        for (int y = 0; y < k_CanvasHeight; ++y)
        {
            for (int x = 0; x < k_CanvasWidth; ++x)
            {
                const bool isIn = x < 40 ? left : right;
                const bool isOnBorder =
                    std::abs(disc.SignedDistance({x + 0.5, y + 0.5}, 1.0)) < rounded;
                if ((x < 40 || x > 54) && !isOnBorder)
                {
                    largest = std::max(largest,
                                       std::abs(measured.At(x, y) - (isIn ? whole.At(x, y) : 0.0)));
                }
            }
        }
        EXPECT_LE(largest, 0.15);
    };
    expect(alpha(OutlineOcclusion::All, 0), true, true);
    expect(alpha(OutlineOcclusion::Visible, 0), false, true);
    expect(alpha(OutlineOcclusion::Hidden, 0), true, false);
    expect(alpha(OutlineOcclusion::SeeThrough, 0), false, true);
    expect(alpha(OutlineOcclusion::SeeThrough, 1), true, false);
}

/// An outlined object on a floor, and others in front of it, behind it and beside it, some of them
/// transparent.
std::unique_ptr<StrokePicture> RandomOccluders(std::mt19937& random,
                                               const StrokeOutlineSettings& settings)
{
    const auto pick = [&](float least, float most)
    {
        return std::uniform_real_distribution(least, most)(random);
    };
    constexpr PrimitiveType k_Types[] = {PrimitiveType::Sphere, PrimitiveType::Cube,
                                         PrimitiveType::Torus, PrimitiveType::Quad};
    auto picture = std::make_unique<StrokePicture>(pick(1.0f, 8.0f), settings);
    picture->camera.orthographic = false;
    picture->camera.nearClipPlane = 0.3f;
    picture->camera.fieldOfView = 40.0f;
    picture->camera.transform.localPosition = {0.0f, 0.3f, -4.0f};
    picture->component.m_OutlineColor.Override(Color{1.0f, 0.6f, 0.1f, 0.8f});
    picture->component.m_OccludedColor.Override(Color{0.2f, 0.4f, 1.0f, 0.6f});
    GameObject& floor = picture->Add("floor", CreatePrimitive(PrimitiveType::Plane));
    floor.transform.localPosition = {0.0f, -0.5f, 0.0f};
    const int others = std::uniform_int_distribution(0, 4)(random);
    for (int i = 0; i <= others; ++i)
    {
        const PrimitiveType type = k_Types[std::uniform_int_distribution(0, 3)(random)];
        GameObject& object = picture->Add("object", CreatePrimitive(type),
                                          Color{pick(0.0f, 1.0f), pick(0.0f, 1.0f), 0.5f, 0.5f});
        object.transform.localRotation =
            EulerToRotation({pick(0.0f, 360.0f), pick(0.0f, 360.0f), 0.0f});
        object.transform.localScale = glm::vec3(pick(0.3f, 1.0f));
        if (i == 0)
        {
            object.renderer->renderingLayerMask = RenderingLayerMask::FromIndex(1);
            continue;
        }
        object.transform.localPosition = {pick(-1.0f, 1.0f), pick(-0.5f, 0.8f), pick(-2.0f, 2.0f)};
        if (pick(0.0f, 1.0f) < 0.2f)
        {
            object.renderer->sharedMaterials[0] = Transparent(*object.renderer->sharedMaterials[0]);
        }
    }
    return picture;
}

TEST_F(StrokeOutlineGpu, DrawsTheSameWhereItReadsTheCamerasDepthAndNoCopyOfIt)
{
    std::mt19937 random(20'261'127);
    constexpr OutlineOcclusion k_Occlusions[] = {
        OutlineOcclusion::Visible, OutlineOcclusion::Hidden, OutlineOcclusion::SeeThrough};
    constexpr RenderPassEvent k_Events[] = {RenderPassEvent::AfterRenderingOpaques,
                                            RenderPassEvent::AfterRenderingTransparents,
                                            RenderPassEvent::BeforeRenderingPostProcessing};
    int with = 0;
    int without = 0;
    for (int i = 0; i < 60; ++i)
    {
        StrokeOutlineSettings settings;
        settings.m_RenderingLayerMask = 1;
        settings.m_Occlusion = k_Occlusions[i % 3];
        settings.m_RenderPassEvent = k_Events[i / 3 % 3];
        const auto picture = RandomOccluders(random, settings);
        picture->SetSamples(i % 2 == 0 ? 1 : 4);
        const Image expected = picture->OutputOfAll();
        EXPECT_TRUE(DrawsInto(picture->result(), "_CameraDepthTexture"));
        EXPECT_EQ(picture->Output(), expected) << i;
        ++(DrawsInto(picture->result(), "_CameraDepthTexture") ? with : without);
    }
    EXPECT_GE(without, 40) << "nothing is drawn with the depth behind what reads it";
    EXPECT_GE(with, 2) << "transparent objects are tested against it";
}

TEST_F(StrokeOutlineGpu, SeesASolidObjectInFrontOfAllElseAsVisible)
{
    StrokeOutlineSettings settings;
    settings.m_Occlusion = OutlineOcclusion::Visible;
    for (const int samples : {1, 4})
    {
        StrokePicture picture(5.0f, settings);
        picture.SetSamples(samples);
        picture.camera.orthographic = false;
        picture.camera.nearClipPlane = 0.3f;
        picture.camera.fieldOfView = 40.0f;
        picture.camera.transform.localPosition = {0.0f, 0.0f, -3.0f};
        picture.Add("sphere", CreatePrimitive(PrimitiveType::Sphere));
        const OutlineScore score = picture.Score(5.0);
        EXPECT_LE(score.meanAbsoluteError, 0.004) << samples;
        EXPECT_GE(score.intersectionOverUnion, 0.997) << samples;
    }
}

TEST_F(StrokeOutlineGpu, IsHiddenByNoSurfaceOfItsOwn)
{
    std::mt19937 random(20'261'128);
    const auto pick = [&](float least, float most)
    {
        return std::uniform_real_distribution(least, most)(random);
    };
    constexpr PrimitiveType k_Types[] = {PrimitiveType::Quad,    PrimitiveType::Cube,
                                         PrimitiveType::Torus,   PrimitiveType::Sphere,
                                         PrimitiveType::Capsule, PrimitiveType::Cylinder};
    for (int i = 0; i < 60; ++i)
    {
        // With several samples a pixel sheets, but not from their edge: a face of a solid object
        // may be thinner than a pixel, where it has no depth that tells.
        const int samples = i < 30 ? 4 : 1;
        const PrimitiveType type = samples > 1 ? PrimitiveType::Quad : k_Types[i % 6];
        const glm::vec3 turn{pick(-55.0f, 55.0f), pick(-55.0f, 55.0f), pick(0.0f, 360.0f)};
        const glm::vec3 scale{pick(0.3f, 1.5f), pick(0.3f, 1.5f), pick(0.3f, 1.5f)};
        const float distance = pick(1.7f, 6.0f);
        const auto draw = [&](OutlineOcclusion occlusion)
        {
            StrokeOutlineSettings settings;
            settings.m_Occlusion = occlusion;
            StrokePicture picture(4.0f, settings, 160, 150);
            picture.SetSamples(samples);
            picture.camera.orthographic = false;
            picture.camera.nearClipPlane = 0.1f;
            picture.camera.fieldOfView = 40.0f;
            picture.camera.transform.localPosition = {0.0f, 0.0f, -distance};
            Transform& transform = picture.Add("object", CreatePrimitive(type)).transform;
            transform.localRotation = EulerToRotation(turn);
            transform.localScale = scale;
            return picture.Output();
        };
        EXPECT_EQ(draw(OutlineOcclusion::Visible), draw(OutlineOcclusion::All)) << i;
    }
}

/// The error of its outline of 8 pixels.
OutlineScore ScoreUntidy(PrimitiveType type, study::Untidiness untidiness)
{
    StrokeOutlineSettings settings;
    settings.m_Grouping = OutlineGrouping::Together;
    StrokePicture picture(8.0f, settings, 200, 190);
    picture.camera.orthographic = false;
    picture.camera.nearClipPlane = 0.1f;
    picture.camera.fieldOfView = 40.0f;
    picture.camera.transform.localPosition = {0.1f, -0.05f, -3.6f};
    const auto mesh = study::MakeUntidy(*CreatePrimitive(type), untidiness);
    for (int i = 0; i < (untidiness == study::Untidiness::TwoObjects ? 2 : 1); ++i)
    {
        picture.Add("object", mesh).transform.localRotation = EulerToRotation({25.0f, 31.0f, 8.0f});
    }
    return picture.Score(8.0);
}

TEST_F(StrokeOutlineGpu, IsAsExactForMeshesThatNobodyTidied)
{
    for (const PrimitiveType type :
         {PrimitiveType::Cube, PrimitiveType::Torus, PrimitiveType::Sphere})
    {
        const double tidy = ScoreUntidy(type, study::Untidiness::None).meanAbsoluteError;
        EXPECT_LE(tidy, 0.002);
        for (std::size_t i = 1; i < study::k_UntidinessNames.size(); ++i)
        {
            SCOPED_TRACE(std::to_string(static_cast<int>(type)) + ", " +
                         study::k_UntidinessNames[i]);
            const auto untidiness = static_cast<study::Untidiness>(i);
            const OutlineScore score = ScoreUntidy(type, untidiness);
            EXPECT_EQ(score.badValues, 0u);
            if (untidiness < study::Untidiness::Open) // it looks as the tidy one does
            {
                EXPECT_NEAR(score.meanAbsoluteError, tidy, 2e-5);
            }
            else // another shape: the ends of a cut tube, and tips sharper than a pixel
            {
                EXPECT_LE(score.meanAbsoluteError, 0.004);
                EXPECT_GE(score.intersectionOverUnion, 0.996);
            }
        }
    }
}

} // namespace
} // namespace limn::test
