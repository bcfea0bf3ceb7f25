#include "Mentions.h"
#include "core/ThrownMessage.h"
#include "features/TranslucentScene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace limn;
using namespace limn::test;

namespace
{

constexpr int k_ExtremeSize = 96;
constexpr float k_ExtremeWidth = 5.0f;

/// A sphere three diameters before the camera, red with a green band, in whatever state.
class ExtremeScene : public TranslucentScene
{
public:
    explicit ExtremeScene(const char* shader) : TranslucentScene(LimnEffectShaders(shader))
    {
        outline->SetColor(ShaderPropertyId("_OutlineColor"), {0, 1, 0, 1});
        solid->SetColor(ShaderPropertyId("_Color"), {1, 0, 0, 1});
        SetWidth(k_ExtremeWidth);
        camera.fieldOfView = 40.0f;
        static const auto mesh = WithOutlineNormals(*CreatePrimitive(PrimitiveType::Sphere));
        body = &AddBody(mesh, {0, 0, 3});
    }

    void SetWidth(float pixels) { outline->SetFloat(ShaderPropertyId("_OutlineWidth"), pixels); }

    /// Everything so many times as large and as far away.
    void Grow(float factor)
    {
        body->transform.localScale *= factor;
        body->transform.localPosition *= factor;
        camera.nearClipPlane *= factor;
        camera.farClipPlane *= factor;
    }

    GameObject* body;
};

struct Areas
{
    int body = 0;
    int band = 0;

    /// The band's mean width in pixels, of a round body.
    double Width() const
    {
        return std::sqrt((body + band) / std::numbers::pi) - std::sqrt(body / std::numbers::pi);
    }
};

/// What is drawn; fails the test if a value is no number.
Areas DrawnAreas(TranslucentScene& scene)
{
    const EffectPicture picture = scene.Draw(k_ExtremeSize, k_ExtremeSize);
    EXPECT_TRUE(std::all_of(picture.color.values.begin(), picture.color.values.end(),
                            [](double value) { return std::isfinite(value); }));
    Areas areas;
    for (int y = 0; y < k_ExtremeSize; ++y)
    {
        for (int x = 0; x < k_ExtremeSize; ++x)
        {
            areas.body += picture.color.At(x, y, 0) > 0.5 ? 1 : 0;
            areas.band += picture.color.At(x, y, 1) > 0.5 ? 1 : 0;
        }
    }
    return areas;
}

class HullExtremesGpu : public GpuTest, public testing::WithParamInterface<const char*>
{
protected:
    bool IsHardened() const { return std::string_view(GetParam()).ends_with("Hull"); }
};

INSTANTIATE_TEST_SUITE_P(Shaders, HullExtremesGpu,
                         testing::Values("Limn/TranslucentOutline", "Limn/TranslucentOutlineHull"),
                         [](const auto& shader) { return std::string(shader.param).substr(5); });

TEST_P(HullExtremesGpu, KeepTheBandAtEveryScaleAndMirrored)
{
    for (const float factor : {1.0f, 1e-6f, 1e6f})
    {
        SCOPED_TRACE(factor);
        ExtremeScene scene(GetParam());
        scene.Grow(factor);
        EXPECT_NEAR(DrawnAreas(scene).Width(), k_ExtremeWidth, 0.5);
    }
    ExtremeScene mirrored(GetParam());
    mirrored.body->transform.localScale = {-1, 1, 1};
    EXPECT_NEAR(DrawnAreas(mirrored).Width(), k_ExtremeWidth, 0.5);
}

TEST_P(HullExtremesGpu, OutlineAFlattenedBodyOnlyWhereTheHullIsHardened)
{
    // Its normals have no inverse transpose, so the article's hull stays where the body is.
    ExtremeScene scene(GetParam());
    scene.body->transform.localScale = {1, 1, 0};
    const Areas areas = DrawnAreas(scene);
    EXPECT_GT(areas.body, 300);
    EXPECT_NEAR(areas.Width(), IsHardened() ? k_ExtremeWidth : 0.0, 0.5);
}

TEST_P(HullExtremesGpu, DrawNoBandOfWidthZeroAndNothingElseOfAnEnormousOne)
{
    ExtremeScene scene(GetParam());
    scene.SetWidth(0.0f);
    const Areas none = DrawnAreas(scene);
    EXPECT_EQ(none.band, 0);
    scene.SetWidth(10.0f);
    EXPECT_NEAR(DrawnAreas(scene).Width(), 10.0, 0.7);
    scene.SetWidth(1e4f);
    const Areas all = DrawnAreas(scene);
    EXPECT_EQ(all.body, none.body);
    EXPECT_EQ(all.band, k_ExtremeSize * k_ExtremeSize - none.body);
}

TEST_P(HullExtremesGpu, RefuseAWidthThatIsNoNumber)
{
    ExtremeScene scene(GetParam());
    EXPECT_THAT(
        ThrownMessage<ContractError>([&]
                                     { scene.SetWidth(std::numeric_limits<float>::quiet_NaN()); }),
        test::Mentions(std::string("'") + GetParam() + "'", "'_OutlineWidth'", "not finite"));
}

TEST_P(HullExtremesGpu, FillTheViewFromInsideTheBody)
{
    // Only back faces are seen from there: all is hull and nothing is body.
    ExtremeScene scene(GetParam());
    scene.camera.nearClipPlane = 0.01f;
    scene.body->transform.localPosition = {0.1f, 0.05f, 0.0f};
    const Areas areas = DrawnAreas(scene);
    EXPECT_EQ(areas.body, 0);
    EXPECT_EQ(areas.band, k_ExtremeSize * k_ExtremeSize);
}

TEST_P(HullExtremesGpu, SurviveABodyThatReachesThroughTheNearPlane)
{
    for (const float distance : {0.3f, 0.5f, 0.65f, 0.79f})
    {
        SCOPED_TRACE(distance);
        ExtremeScene scene(GetParam());
        scene.body->transform.localScale = {1, 1, 4};
        scene.body->transform.localPosition = {0.7f, 0, 2 + distance};
        scene.camera.transform.localPosition = {0, 0, 1};
        scene.camera.fieldOfView = 100.0f;
        const Areas areas = DrawnAreas(scene);
        EXPECT_GT(areas.body + areas.band, 300);
        EXPECT_LT(areas.body + areas.band, k_ExtremeSize * k_ExtremeSize * 3 / 4);
    }
}

TEST_P(HullExtremesGpu, IgnoreTrianglesWithoutArea)
{
    ExtremeScene scene(GetParam());
    const EffectPicture before = scene.Draw(k_ExtremeSize, k_ExtremeSize);
    MeshData data = CreatePrimitive(PrimitiveType::Sphere)->data();
    data.subMeshes.clear();
    data.triangles.insert(data.triangles.end(), {5, 5, 5, 40, 41, 41, 100, 100, 7});
    scene.body->renderer->mesh = WithOutlineNormals(Mesh("sphere", std::move(data)));
    const EffectPicture after = scene.Draw(k_ExtremeSize, k_ExtremeSize);
    EXPECT_EQ(before.color.values, after.color.values);
    EXPECT_EQ(before.stencil, after.stencil);
}

class HardenedHullGpu : public GpuTest
{
};

TEST_F(HardenedHullGpu, GoesByTheNormalsOfAMeshWithoutTheSpareChannel)
{
    ExtremeScene scene("Limn/TranslucentOutlineHull");
    scene.body->renderer->mesh = CreatePrimitive(PrimitiveType::Sphere);
    EXPECT_NEAR(DrawnAreas(scene).Width(), k_ExtremeWidth, 0.5);
}

TEST_F(HardenedHullGpu, OutlinesATwoSidedSheetThatFacesTheCamera)
{
    // Its faces cancel each other out, so that it is widened from its middle.
    MeshData data = CreatePrimitive(PrimitiveType::Quad)->data();
    data.subMeshes.clear();
    for (std::size_t i = 0; i < 6; i += 3)
    {
        const std::vector<std::uint32_t> back = {data.triangles[i], data.triangles[i + 2],
                                                 data.triangles[i + 1]};
        data.triangles.insert(data.triangles.end(), back.begin(), back.end());
    }
    ExtremeScene scene("Limn/TranslucentOutlineHull");
    scene.body->renderer->mesh = WithOutlineNormals(Mesh("sheet", std::move(data)));
    const Areas areas = DrawnAreas(scene);
    const double side = std::sqrt(areas.body);
    EXPECT_GT(side, 10.0);
    const double whole = std::sqrt(areas.body + areas.band);
    // From the middle the corners move by the width along the diagonals.
    EXPECT_NEAR((whole - side) / 2, k_ExtremeWidth / std::sqrt(2.0), 0.7);
}

TEST_F(HardenedHullGpu, DrawsATranslucentBandOnceWhereItsLayersOverlap)
{
    ExtremeScene scene("Limn/TranslucentOutlineHull");
    scene.outline->SetColor(ShaderPropertyId("_OutlineColor"), {0, 1, 0, 0.5f});
    scene.AddBody(scene.body->renderer->mesh, {0.3f, 0, 3.5f});
    const EffectPicture picture = scene.Draw(k_ExtremeSize, k_ExtremeSize);
    for (int y = 0; y < k_ExtremeSize; ++y)
    {
        for (int x = 0; x < k_ExtremeSize; ++x)
        {
            const double green = picture.color.At(x, y, 1);
            EXPECT_TRUE(green == 0.0 || green == 0.5) << x << ", " << y << ": " << green;
        }
    }
}

} // namespace
