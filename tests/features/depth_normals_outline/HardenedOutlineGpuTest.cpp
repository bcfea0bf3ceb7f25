#include "features/depth_normals_outline/DepthNormalsRun.h"

#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

namespace limn::test
{
namespace
{

/// By what a surface does in the world.
struct HardenedLook
{
    double width = 2.0;
    double depth = 0.1;  ///< metres
    double angle = 30.0; ///< degrees
    double softness = 0.0;
};

std::function<void(DepthNormalsOutline&)> As(const HardenedLook& look)
{
    return [look](DepthNormalsOutline& outline)
    {
        outline.m_OutlineWidth.Override(static_cast<float>(look.width));
        outline.m_DepthThreshold.Override(static_cast<float>(look.depth));
        outline.m_AngleThreshold.Override(static_cast<float>(look.angle));
        outline.m_Softness.Override(static_cast<float>(look.softness));
    };
}

void AsTheArticle(DepthNormalsOutline& outline)
{
    outline.m_Technique.Override(DepthNormalsTechnique::Article);
    outline.m_OutlineWidth.Override(2.0f);
}

double SumOf(const Field& field)
{
    double sum = 0.0;
    for (const double value : field.values)
    {
        sum += value;
    }
    return sum;
}

/// A floor of a kilometre, seen at an angle to it.
struct Floor
{
    Scene black;
    Scene white; ///< the same
    Camera camera;

    Floor()
    {
        for (Scene* scene : {&black, &white})
        {
            GameObject& floor = scene->Add("floor");
            floor.transform.localScale = glm::vec3(100.0f, 1.0f, 100.0f);
            floor.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Plane),
                                          {Plain(glm::vec3(scene == &white ? 1.0f : 0.0f))}};
        }
        camera.backgroundColor = Color::black;
        camera.orthographicSize = 2.0f;
        camera.fieldOfView = 50.0f;
        camera.nearClipPlane = 0.1f;
        camera.farClipPlane = 500.0f;
    }

    void Look(double degrees, bool isOrthographic)
    {
        const double angle = degrees * std::numbers::pi / 180.0;
        const double distance = isOrthographic ? 100.0 : 10.0;
        camera.orthographic = isOrthographic;
        camera.transform.localPosition = {0.3f, static_cast<float>(std::sin(angle) * distance),
                                          static_cast<float>(-std::cos(angle) * distance)};
        camera.transform.localRotation = EulerToRotation({static_cast<float>(degrees), 7.0f, 3.0f});
    }

    /// How far along the view axis the floor is at a place of a picture; far where it is not seen.
    double DepthAt(double x, double y, int width, int height) const
    {
        const glm::dquat rotation(glm::normalize(glm::dquat(camera.transform.localRotation)));
        const double half = camera.orthographic ? static_cast<double>(camera.orthographicSize)
                                                : std::tan(glm::radians(camera.fieldOfView * 0.5));
        const glm::dvec3 across(half * (2.0 * x - width) / height, half * (1.0 - 2.0 * y / height),
                                0.0);
        const glm::dvec3 ahead(0, 0, 1);
        const double up = static_cast<double>(camera.transform.localPosition.y) +
                          (camera.orthographic ? (rotation * across).y : 0.0);
        const double fall = -(rotation * (camera.orthographic ? ahead : across + ahead)).y;
        return fall > 0.0 ? up / fall : 1e9;
    }

    /// Whether three depths in a row, or in a column, that are up to `reach` pixels from a pixel
    /// may leave a line by more than k_Rounded because each may be that of a place SubPixel() away
    /// along both axes: the middle one counts twice.
    bool IsRounded(int x, int y, int width, int height, int reach) const
    {
        double right = 0.0;
        double down = 0.0;
        for (int i = -reach - 1; i <= reach; ++i)
        {
            const auto at = [&](double dx, double dy)
            {
                return DepthAt(x + 0.5 + dx, y + 0.5 + dy, width, height);
            };
            right = std::max({right, std::abs(at(i + 1, 0) - at(i, 0)),
                              std::abs(at(1, i) - at(0, i)), std::abs(at(0, i) - at(-1, i))});
            down = std::max({down, std::abs(at(0, i + 1) - at(0, i)), std::abs(at(i, 1) - at(i, 0)),
                             std::abs(at(i, 0) - at(i, -1))});
        }
        return 4.0 * SubPixel() * (right + down) > k_Rounded;
    }

    /// Empties the pixels of lines that rounding may draw. @return how many others there are
    int PassOverRounded(Field& lines, int reach) const
    {
        int others = 0;
        for (int y = 0; y < lines.height; ++y)
        {
            for (int x = 0; x < lines.width; ++x)
            {
                const bool isRounded = IsRounded(x, y, lines.width, lines.height, reach);
                lines.At(x, y) = isRounded ? 0.0 : lines.At(x, y);
                others += isRounded ? 0 : 1;
            }
        }
        return others;
    }

    /// OutlineObject.hlsl knows of corners that are placed to 1/256 pixel. Where a device places
    /// them less finely, planes have steps; a threshold of this many metres passes over those of
    /// the pixels that are not too steep for it.
    static constexpr double k_Rounded = 0.5;
    static double Threshold() { return HasCoarseCorners() ? k_Rounded : 0.0; }
};

/// Lines in pixels that see the same surface all around.
int CountInside(const Field& lines, const Field& coverage, int reach)
{
    int count = 0;
    for (int y = 0; y < lines.height; ++y)
    {
        for (int x = 0; x < lines.width; ++x)
        {
            bool isInside = true;
            for (int step = -reach; step <= reach; ++step)
            {
                isInside = isInside &&
                           coverage.At(std::clamp(x + step, 0, lines.width - 1), y) == 1.0 &&
                           coverage.At(x, std::clamp(y + step, 0, lines.height - 1)) == 1.0;
            }
            count += isInside && lines.At(x, y) > 0.0 ? 1 : 0;
        }
    }
    return count;
}

class HardenedOutlineGpu : public GpuTest
{
};

TEST_F(HardenedOutlineGpu, DrawsNothingOnAPlaneHoweverItLies)
{
    Floor floor;
    PictureRun covered(floor.white, floor.camera, 96, 63);
    LinedRun run(floor.black, floor.camera, 96, 63);
    int article = 0;
    int hardened = 0;
    int compared = 0;
    double seen = 0.0;
    for (const bool isOrthographic : {false, true})
    {
        for (const double degrees : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 45.0, 60.0, 80.0, 89.9})
        {
            floor.Look(degrees, isOrthographic);
            const Field coverage = FirstChannel(covered.Color(nullptr));
            seen += SumOf(coverage);
            article += CountInside(run.Lines(AsTheArticle), coverage, 1);
            for (const double width : {2.0, 4.0})
            {
                Field lines = run.Lines(As({width, Floor::Threshold(), 2.0}));
                const int reach = static_cast<int>(width) / 2;
                compared += HasCoarseCorners() ? floor.PassOverRounded(lines, reach) : 1;
                const int found = CountInside(lines, coverage, reach);
                EXPECT_EQ(found, 0) << degrees << " degrees, width " << width << ", orthographic "
                                    << isOrthographic;
                hardened += found;
            }
        }
    }
    EXPECT_GT(article, 500) << "the article's draws lines here";
    EXPECT_GT(compared, HasCoarseCorners() ? 40000 : 0) << "too much is rounded";
    RecordProperty("seen", static_cast<int>(seen));
    RecordProperty("article", article);
    RecordProperty("hardened", hardened);
    std::printf("of %.0f pixels of a plane: article %d, hardened %d with lines\n", seen, article,
                hardened);
}

// The floor goes on, but is not drawn any more.
TEST_F(HardenedOutlineGpu, DrawsNothingWhereThePlaneIsCutOffByTheFarPlane)
{
    Floor floor;
    floor.camera.farClipPlane = 60.0f;
    LinedRun run(floor.black, floor.camera, 64, 41);
    for (const bool isOrthographic : {false, true})
    {
        for (const double degrees : {3.0, 5.0, 12.0})
        {
            floor.Look(degrees, isOrthographic);
            floor.camera.farClipPlane = isOrthographic ? 101.0f : 60.0f;
            for (const int samples : {1, 4})
            {
                run.SetSamples(samples);
                EXPECT_EQ(SumOf(run.Lines(As({4.0, Floor::Threshold(), 2.0}))), 0.0)
                    << degrees << " degrees, orthographic " << isOrthographic << ", samples "
                    << samples;
                EXPECT_GT(SumOf(run.Lines(AsTheArticle)), 20.0) << degrees;
            }
        }
    }
}

/// Two black sheets, each over half of a picture whose units are pixels, turned around the y axis.
struct Sheets
{
    static constexpr int k_Width = 48;
    static constexpr int k_Height = 12;
    FlatScene flat{k_Width, k_Height};

    Sheets()
    {
        flat.camera.farClipPlane = 201.0f;
        for (int i = 0; i < 2; ++i)
        {
            flat.Add({0, 0}, {1, 1}, 100.0f, Plain(glm::vec3(0.0f)));
        }
    }

    /// A sheet that reaches from the middle of the picture (x = 0) to one side of it.
    /// @param depth  at the middle
    /// @param slope  of the depth towards the right
    void Set(std::size_t index, double depth, double slope)
    {
        const double side = index == 0 ? -1.0 : 1.0;
        const double length = k_Width * 0.5;
        Transform& transform = flat.scene.objects()[index]->transform;
        transform.localPosition = {static_cast<float>(side * length * 0.5), 0.0f,
                                   static_cast<float>(depth + side * length * 0.5 * slope)};
        transform.localScale = {static_cast<float>(length * std::hypot(1.0, slope)), k_Height,
                                1.0f};
        transform.localRotation = EulerToRotation(
            {0.0f, static_cast<float>(-std::atan(slope) * 180.0 / std::numbers::pi), 0.0f});
    }
};

/// The columns around the middle that hold a full line in all rows.
int FullColumns(const Field& lines)
{
    int columns = 0;
    for (int x = 0; x < lines.width; ++x)
    {
        bool isFull = true;
        for (int y = 0; y < lines.height; ++y)
        {
            isFull = isFull && lines.At(x, y) == 1.0;
        }
        columns += isFull ? 1 : 0;
    }
    return columns;
}

//   ────────┐          whatever the slope of both: the gap along the view counts
//           └────────
TEST_F(HardenedOutlineGpu, FindsAllStepsAboveTheThresholdAndNoneBelow)
{
    Sheets sheets;
    LinedRun run(sheets.flat.scene, sheets.flat.camera, Sheets::k_Width, Sheets::k_Height);
    for (const double slope : {0.0, 0.5, -1.0, 3.0})
    {
        for (const double threshold : {0.05, 0.5, 4.0})
        {
            for (const double times : {-1.2, -1.05, -0.95, 0.5, 0.95, 1.05, 10.0})
            {
                // What is not known of a slope is a part of it.
                const double gap = times * (threshold + std::abs(slope) / 30.0);
                sheets.Set(0, 100.0 - gap * 0.5, slope);
                sheets.Set(1, 100.0 + gap * 0.5, slope);
                const Field lines = run.Lines(As({2.0, threshold, 180.0}));
                const bool isAbove = std::abs(gap) > threshold + std::abs(slope) / 30.0;
                if (isAbove || std::abs(gap) < threshold)
                {
                    EXPECT_EQ(FullColumns(lines), isAbove ? 2 : 0)
                        << "slope " << slope << ", threshold " << threshold << ", gap " << gap;
                    EXPECT_EQ(SumOf(lines), isAbove ? 2.0 * Sheets::k_Height : 0.0);
                }
            }
        }
    }
}

//   ╱╲ and ╲╱
TEST_F(HardenedOutlineGpu, FindsAllCreasesAboveTheThresholdAndNoneBelow)
{
    Sheets sheets;
    LinedRun run(sheets.flat.scene, sheets.flat.camera, Sheets::k_Width, Sheets::k_Height);
    for (const double threshold : {4.0, 15.0, 30.0, 90.0, 140.0})
    {
        for (const double side : {-1.0, 1.0})
        {
            for (const double more : {-1.5, 1.5}) // normals of 8 bits are off by 0.4 each
            {
                const double turn = threshold + more;
                const double slope = side * std::tan(turn * 0.5 * std::numbers::pi / 180.0);
                sheets.Set(0, 100.0, -slope);
                sheets.Set(1, 100.0, slope);
                const Field lines = run.Lines(As({2.0, 1000.0, threshold}));
                EXPECT_EQ(FullColumns(lines), more > 0.0 ? 2 : 0) << threshold << " " << turn;
                EXPECT_EQ(SumOf(lines), more > 0.0 ? 2.0 * Sheets::k_Height : 0.0);
            }
        }
    }
}

TEST_F(HardenedOutlineGpu, DrawsALineAlongACreaseAsWideAsAsked)
{
    Sheets sheets;
    sheets.Set(0, 100.0, -1.0);
    sheets.Set(1, 100.0, 1.0);
    LinedRun run(sheets.flat.scene, sheets.flat.camera, Sheets::k_Width, Sheets::k_Height);
    for (const double width : {0.5, 1.0, 1.7, 2.0, 3.0, 4.0, 5.5, 6.0, 8.0, 11.0, 16.0})
    {
        const Field lines = run.Lines(As({width, 1000.0, 30.0}));
        EXPECT_NEAR(SumOf(lines) / Sheets::k_Height, width, 0.01);
        EXPECT_EQ(FullColumns(lines), width < 2.0 ? 0 : 2 * static_cast<int>(width * 0.5));
    }
}

TEST_F(HardenedOutlineGpu, GetsStrongerAboveTheThreshold)
{
    Sheets sheets;
    LinedRun run(sheets.flat.scene, sheets.flat.camera, Sheets::k_Width, Sheets::k_Height);
    for (const double gap : {0.9, 1.1, 1.25, 1.4, 1.6})
    {
        sheets.Set(0, 100.0, 0.0);
        sheets.Set(1, 100.0 + gap, 0.0);
        const double expected = std::clamp((gap - 1.0) / 0.5, 0.0, 1.0);
        EXPECT_NEAR(run.Lines(As({2.0, 1.0, 180.0, 0.5})).At(Sheets::k_Width / 2 - 1, 5), expected,
                    0.003);
    }
}

// A cube before nothing: all its pixels within half a width of the border, and no others.
TEST_F(HardenedOutlineGpu, DrawsTheSilhouetteBeforeTheBackgroundAndAlongNoBorderOfThePicture)
{
    for (const bool isOrthographic : {false, true})
    {
        Scene scene;
        AddCube(scene, "cube", {0, 0, 0}, {Plain(glm::vec3(0.0f))});
        Camera camera;
        camera.transform.localPosition = {0, 0, -5};
        camera.backgroundColor = Color::black;
        camera.orthographic = isOrthographic;
        camera.orthographicSize = 2.0f;
        camera.fieldOfView = 40.0f;
        camera.farClipPlane = 1e6f;
        LinedRun run(scene, camera, 49, 41);
        const Field coverage =
            Coverage(scene, camera, 49, 41, 1, [](const GameObject&) { return true; });
        const Field lines = run.Lines(As({4.0, 0.1, 30.0}));
        for (int y = 2; y < 39; ++y)
        {
            for (int x = 2; x < 47; ++x)
            {
                const bool isNear = coverage.At(x - 2, y) + coverage.At(x + 2, y) +
                                        coverage.At(x, y - 2) + coverage.At(x, y + 2) <
                                    4.0;
                const bool isLine = coverage.At(x, y) == 1.0 && isNear;
                ASSERT_EQ(lines.At(x, y), isLine ? 1.0 : 0.0) << x << ", " << y;
            }
        }
        scene.Find("cube")->transform.localScale = glm::vec3(100.0f, 100.0f, 1.0f);
        EXPECT_EQ(SumOf(run.Lines(As({4.0, 0.0, 2.0}))), 0.0) << "it fills the picture";
    }
}

TEST_F(HardenedOutlineGpu, HasLinesAtTheSamplesOfAnObjectOnlyForACameraOfFourSamples)
{
    Scene scene;
    AddCube(scene, "cube", {0, 0, 0}, {Plain(glm::vec3(0.0f))});
    scene.Find("cube")->transform.localRotation = EulerToRotation({0.0f, 0.0f, 20.0f});
    Camera camera;
    camera.transform.localPosition = {0, 0, -5};
    camera.backgroundColor = Color::black;
    camera.fieldOfView = 30.0f;
    const Field coverage =
        Coverage(scene, camera, 48, 48, 4, [](const GameObject&) { return true; });
    LinedRun run(scene, camera, 48, 48);
    run.SetSamples(4);
    const Field lines = run.Lines(As({2.0, 0.1, 30.0}));
    int partly = 0;
    for (int y = 0; y < 48; ++y)
    {
        for (int x = 0; x < 48; ++x)
        {
            const bool isPart = coverage.At(x, y) > 0.0 && coverage.At(x, y) < 1.0;
            partly += isPart ? 1 : 0;
            if (isPart)
            {
                EXPECT_NEAR(lines.At(x, y), coverage.At(x, y), 1e-3) << x << ", " << y;
            }
        }
    }
    EXPECT_GT(partly, 30);
}

// Taps as far away as a wide line reaches would jump over the tube.
TEST_F(HardenedOutlineGpu, LosesNoLineOfAThinPartWhereTheLineIsWider)
{
    Scene scene;
    GameObject& torus = scene.Add("torus");
    torus.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Torus), {Plain(glm::vec3(0.0f))}};
    torus.transform.localRotation = EulerToRotation({-63.0f, 21.0f, 8.0f});
    Camera camera;
    camera.transform.localPosition = {0, 0, -3};
    camera.backgroundColor = Color::black;
    camera.fieldOfView = 30.0f;
    for (const bool isOrthographic : {false, true})
    {
        camera.orthographic = isOrthographic;
        camera.orthographicSize = 0.9f;
        LinedRun run(scene, camera, 61, 47);
        const double byAngle = 1000.0; // metres
        Field before = run.Lines(As({1.0, byAngle}));
        for (const double width : {2.0, 4.0, 8.0, 16.0, 32.0, 64.0})
        {
            const Field lines = run.Lines(As({width, byAngle}));
            int lost = 0;
            for (std::size_t i = 0; i < lines.values.size(); ++i)
            {
                lost += lines.values[i] < before.values[i] ? 1 : 0;
            }
            EXPECT_EQ(lost, 0) << "width " << width << ", orthographic " << isOrthographic;
            before = lines;
        }
        EXPECT_GT(SumOf(before), 200.0);
    }
}

// What a shader graph may be given.
TEST_F(HardenedOutlineGpu, FindsNothingByThresholdsThatAreNone)
{
    Scene scene;
    AddCube(scene, "cube", {0, 0, 0}, {Plain(glm::vec3(0.0f))});
    Camera camera;
    camera.transform.localPosition = {0.2f, 0.3f, -4};
    const Field found = Probed(scene, camera, 32, 24, R"(
        static const float nan = asfloat(0x7FC00000u);
        static const float3 none[] = {float3(2, nan, nan), float3(2, -1, -1), float3(nan, 0.1, 30),
                                      float3(0, 0.1, 30), float3(-3, 0.1, 30)};
        float4 result = 0;
        float edge;
        [loop] for (int i = 0; i < 5; ++i)
        {
            OutlineObjectHardened_float(uv, none[i].x, none[i].y, none[i].z, nan, edge);
            result.x += edge == 0.0 ? 0.0 : 1.0;
        }
        static const float2 nothing[] = {float2(0, 0), float2(-1, -1), float2(nan, nan)};
        [loop] for (int j = 0; j < 3; ++j)
        {
            OutlineObject_float(uv, 2, nothing[j].x, nothing[j].y, edge);
            result.y += edge == 0.0 ? 0.0 : 1.0;
        }
        OutlineObjectHardened_float(uv, 2, 0.1, nan, nan, result.z);
        OutlineObject_float(uv, 2, 0.2, nan, result.w);
        return result;)");
    std::array<double, 4> sums{};
    for (std::size_t i = 0; i < found.values.size(); ++i)
    {
        sums[i % 4] += found.values[i];
    }
    EXPECT_EQ(sums[0], 0.0);
    EXPECT_EQ(sums[1], 0.0);
    EXPECT_GT(sums[2], 20.0) << "by depth alone";
    EXPECT_GT(sums[3], 20.0);
}

} // namespace
} // namespace limn::test
