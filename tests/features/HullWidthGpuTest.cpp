#include "features/TranslucentScene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

using namespace limn;
using namespace limn::test;

namespace
{

constexpr const char* k_Article = "Limn/TranslucentOutline";
constexpr const char* k_Hull = "Limn/TranslucentOutlineHull";

/// How a sphere of a known size on the screen is looked at.
struct View
{
    double distance = 1.0;    ///< metres, to the sphere's middle
    double fieldOfView = 0.0; ///< degrees; 0 = orthographic
    int width = 256;
    int height = 256;

    std::string Name() const
    {
        return (fieldOfView > 0 ? std::to_string(fieldOfView).substr(0, 5) + " degrees"
                                : std::string("orthographic")) +
               ", " + std::to_string(distance).substr(0, 5) + " m, " + std::to_string(width) + "x" +
               std::to_string(height);
    }
};

/// A body in the middle of the picture, opaque red, its band opaque green.
class BandScene : public TranslucentScene
{
public:
    explicit BandScene(const char* outlineShader)
        : TranslucentScene(LimnEffectShaders(outlineShader))
    {
        outline->SetColor(ShaderPropertyId("_OutlineColor"), {0, 1, 0, 1});
        solid->SetColor(ShaderPropertyId("_Color"), {1, 0, 0, 1});
    }

    void SetWidth(double pixels)
    {
        outline->SetFloat(ShaderPropertyId("_OutlineWidth"), static_cast<float>(pixels));
    }

    void Look(const View& view)
    {
        camera.orthographic = view.fieldOfView == 0.0;
        camera.fieldOfView = static_cast<float>(view.fieldOfView);
        camera.nearClipPlane = static_cast<float>(0.01 * view.distance);
        camera.farClipPlane = static_cast<float>(100.0 * view.distance);
    }
};

/// The half height of the view one metre in front of the camera, or everywhere.
double HalfHeight(const View& view)
{
    return std::tan(view.fieldOfView * std::numbers::pi / 360.0);
}

/// The areas of body and band as the radii of discs, pixels.
struct Radii
{
    double body = 0.0;
    double whole = 0.0;

    double Band() const { return whole - body; }
};

bool IsBody(const EffectPicture& picture, int x, int y)
{
    return picture.color.At(x, y, 0) > 0.5;
}

bool IsBand(const EffectPicture& picture, int x, int y)
{
    return picture.color.At(x, y, 1) > 0.5;
}

Radii Measure(const EffectPicture& picture)
{
    int body = 0;
    int band = 0;
    for (int y = 0; y < picture.color.height; ++y)
    {
        for (int x = 0; x < picture.color.width; ++x)
        {
            body += IsBody(picture, x, y) ? 1 : 0;
            band += IsBand(picture, x, y) ? 1 : 0;
        }
    }
    return {std::sqrt(body / std::numbers::pi), std::sqrt((body + band) / std::numbers::pi)};
}

/// A sphere in the middle, a quarter of the picture's shorter side in radius.
struct SphereView
{
    double radius = 0.0; ///< metres
    double angle = 0.0;  ///< under which the radius is seen, radians; 0 = orthographic
};

SphereView Sphere(const View& view, BandScene& scene)
{
    const double share = 0.5 * std::min(view.width, view.height) / view.height;
    if (view.fieldOfView == 0.0)
    {
        // The view is as high as the distance, so that the sphere does not reach the camera.
        scene.camera.orthographicSize = static_cast<float>(0.5 * view.distance);
        return {share * 0.5 * view.distance, 0.0};
    }
    const double angle = std::atan(share * HalfHeight(view));
    return {view.distance * std::sin(angle), angle};
}

/// A sphere of diameter 1, fine enough to be a true one, its rings around the view axis.
std::shared_ptr<const Mesh> FineSphere()
{
    constexpr int k_Rings = 96;
    constexpr int k_Segments = 96;
    MeshData data;
    for (int ring = 0; ring <= k_Rings; ++ring)
    {
        for (int segment = 0; segment <= k_Segments; ++segment)
        {
            const double turn = std::numbers::pi * ring / k_Rings;
            const double around = 2.0 * std::numbers::pi * (segment % k_Segments) / k_Segments;
            const double across = ring % k_Rings == 0 ? 0.0 : std::sin(turn);
            data.normals.emplace_back(across * std::cos(around), across * std::sin(around),
                                      -std::cos(turn));
            data.vertices.push_back(0.5f * data.normals.back());
        }
    }
    constexpr std::uint32_t k_Row = k_Segments + 1;
    for (std::uint32_t i = 0; i < k_Rings * k_Row; ++i)
    {
        if (i % k_Row != k_Segments)
        {
            data.triangles.insert(data.triangles.end(),
                                  {i, i + 1, i + k_Row, i + 1, i + k_Row + 1, i + k_Row});
        }
    }
    return WithOutlineNormals(Mesh("fine sphere", std::move(data)));
}

Radii MeasureSphere(const char* shader, const View& view, double pixels, SphereView* seen = nullptr)
{
    BandScene scene(shader);
    scene.SetWidth(pixels);
    scene.Look(view);
    const SphereView sphere = Sphere(view, scene);
    if (seen != nullptr)
    {
        *seen = sphere;
    }
    static const auto mesh = FineSphere();
    scene.AddBody(mesh, {0, 0, static_cast<float>(view.distance)}).transform.localScale =
        glm::vec3(static_cast<float>(2.0 * sphere.radius));
    return Measure(scene.Draw(view.width, view.height));
}

std::vector<View> PerspectiveViews()
{
    std::vector<View> views;
    for (const double distance : {0.5, 1.0, 5.0, 50.0, 500.0})
    {
        views.push_back({distance, 60.0});
    }
    for (const double fieldOfView : {1.0, 10.0, 30.0, 90.0, 120.0, 150.0, 170.0})
    {
        views.push_back({3.0, fieldOfView});
    }
    views.push_back({3.0, 60.0, 64, 64});
    views.push_back({3.0, 60.0, 640, 64});
    views.push_back({3.0, 60.0, 64, 640});
    views.push_back({3.0, 60.0, 4096, 64});
    views.push_back({3.0, 60.0, 64, 4096});
    views.push_back({3.0, 170.0, 64, 640});
    views.push_back({3.0, 1.0, 640, 64});
    return views;
}

std::vector<View> OrthographicViews()
{
    return {{0.5}, {1.0}, {2.0}, {4.0}, {1.0, 0.0, 640, 64}, {1.0, 0.0, 64, 640}};
}

/// A row of the table in features/translucent_outline/README.md.
void PrintRow(const View& view, double asked, double expected, double measured)
{
    std::printf("| %s | %.1f | %.2f | %.2f |\n", view.Name().c_str(), asked, expected, measured);
}

/// The band of the article's hull around a sphere, pixels, from the geometry alone: each point of
/// the sphere goes along its normal by so many pixels at its own depth, and the silhouette is
/// where what became of them is farthest from the axis.
double ArticleBand(const View& view, const SphereView& sphere, double pixels)
{
    const double metresPerPixel = 2.0 * HalfHeight(view) / view.height; // for each metre of depth
    double farthest = 0.0;
    for (int i = 0; i <= 20000; ++i)
    {
        const double turn = std::numbers::pi * i / 20000.0; // from the point next to the camera
        const double depth = view.distance - sphere.radius * std::cos(turn);
        const double moved = pixels * metresPerPixel * depth;
        farthest = std::max(farthest, std::sin(turn) * (sphere.radius + moved) /
                                          (depth - moved * std::cos(turn)));
    }
    return (farthest - std::tan(sphere.angle)) / metresPerPixel;
}

class HullWidthGpu : public GpuTest
{
};

TEST_F(HullWidthGpu, OfTheArticlesFormulaIsTheAskedOneWhereTheSilhouetteIsNearTheViewAxis)
{
    constexpr double k_Asked = 4.0;
    for (const View& view : PerspectiveViews())
    {
        SCOPED_TRACE(view.Name());
        SphereView sphere;
        const double measured = MeasureSphere(k_Article, view, k_Asked, &sphere).Band();
        const double expected = ArticleBand(view, sphere, k_Asked);
        PrintRow(view, k_Asked, expected, measured);
        if (sphere.angle * 180.0 / std::numbers::pi < 35.0)
        {
            EXPECT_NEAR(measured, k_Asked, 1.0);
        }
        EXPECT_NEAR(measured, expected, 1.0);
    }
}

TEST_F(HullWidthGpu, OfTheArticlesFormulaGrowsWithTheDistanceInOrthographicViews)
{
    constexpr double k_Asked = 4.0;
    for (const View& view : OrthographicViews())
    {
        SCOPED_TRACE(view.Name());
        const double measured = MeasureSphere(k_Article, view, k_Asked).Band();
        PrintRow(view, k_Asked, k_Asked * view.distance, measured);
        EXPECT_NEAR(measured, k_Asked * view.distance, 1.0);
    }
}

TEST_F(HullWidthGpu, OfTheHardenedHullIsWithinHalfAPixelOnASphereInEveryView)
{
    std::vector<View> views = PerspectiveViews();
    for (const View& view : OrthographicViews())
    {
        views.push_back(view);
    }
    for (const View& view : views)
    {
        SCOPED_TRACE(view.Name());
        for (const double asked : {1.0, 7.5})
        {
            const double measured = MeasureSphere(k_Hull, view, asked).Band();
            PrintRow(view, asked, asked, measured);
            EXPECT_NEAR(measured, asked, 0.5);
        }
    }
}

/// The shortest distance from a pixel that is neither body nor band to one of the body, and the
/// longest from one of the band: the thinnest and the thickest place of the band.
struct Reach
{
    double thinnest = std::numeric_limits<double>::infinity();
    double thickest = 0.0;
};

/// The body's pixels that have a neighbour outside.
std::vector<glm::ivec2> BodyBorder(const EffectPicture& picture)
{
    std::vector<glm::ivec2> border;
    for (int y = 1; y + 1 < picture.color.height; ++y)
    {
        for (int x = 1; x + 1 < picture.color.width; ++x)
        {
            const bool inner = IsBody(picture, x - 1, y) && IsBody(picture, x + 1, y) &&
                               IsBody(picture, x, y - 1) && IsBody(picture, x, y + 1);
            if (IsBody(picture, x, y) && !inner)
            {
                border.emplace_back(x, y);
            }
        }
    }
    return border;
}

Reach MeasureReach(const EffectPicture& picture)
{
    const std::vector<glm::ivec2> border = BodyBorder(picture);
    Reach reach;
    for (int y = 0; y < picture.color.height; ++y)
    {
        for (int x = 0; x < picture.color.width; ++x)
        {
            if (IsBody(picture, x, y))
            {
                continue;
            }
            int nearest = std::numeric_limits<int>::max();
            for (const glm::ivec2& b : border)
            {
                nearest = std::min(nearest, (b.x - x) * (b.x - x) + (b.y - y) * (b.y - y));
            }
            const double distance = std::sqrt(static_cast<double>(nearest));
            if (IsBand(picture, x, y))
            {
                reach.thickest = std::max(reach.thickest, distance);
            }
            else
            {
                reach.thinnest = std::min(reach.thinnest, distance);
            }
        }
    }
    return reach;
}

Reach MeasureCube(const char* shader, const View& view, const glm::vec3& degrees, double pixels)
{
    BandScene scene(shader);
    scene.SetWidth(pixels);
    scene.Look(view);
    scene.camera.orthographicSize = static_cast<float>(0.5 * view.distance);
    const double half = view.fieldOfView > 0.0 ? HalfHeight(view) : 0.5;
    static const auto mesh = WithOutlineNormals(*CreatePrimitive(PrimitiveType::Cube));
    GameObject& cube = scene.AddBody(mesh, {0, 0, static_cast<float>(view.distance)});
    cube.transform.localRotation = EulerToRotation(degrees);
    cube.transform.localScale =
        glm::vec3(static_cast<float>(std::min(0.5 * half, 0.4) * view.distance));
    return MeasureReach(scene.Draw(view.width, view.height));
}

const glm::vec3 k_Turns[] = {{0, 0, 0}, {45, 0, 0}, {35.26f, 45, 0}, {20, 30, 10}};

TEST_F(HullWidthGpu, OfTheHardenedHullIsNowhereThinOnACube)
{
    constexpr double k_Asked = 16.0;
    constexpr double k_Pixel = 0.7; // from a pixel's middle to the body's border in it
    for (const View& view :
         {View{3.0, 60.0, 128, 128}, View{50.0, 60.0, 128, 128}, View{3.0, 1.0, 128, 128},
          View{3.0, 120.0, 128, 128}, View{3.0, 0.0, 128, 128}})
    {
        for (const glm::vec3& turn : k_Turns)
        {
            SCOPED_TRACE(view.Name() + ", turned by " + std::to_string(turn.x) + ", " +
                         std::to_string(turn.y) + ", " + std::to_string(turn.z));
            const Reach reach = MeasureCube(k_Hull, view, turn, k_Asked);
            EXPECT_GE(reach.thinnest, 0.95 * k_Asked + k_Pixel);
            EXPECT_LE(reach.thickest, std::sqrt(3.0) * k_Asked + 1.0 + k_Pixel);
        }
    }
}

TEST_F(HullWidthGpu, OfTheHardenedHullIsTheSameAllAroundASphereFarFromTheAxis)
{
    constexpr double k_Asked = 7.5;
    constexpr double k_Pixel = 0.7; // from a pixel's middle to the body's border in it
    for (const double fieldOfView : {30.0, 90.0, 120.0})
    {
        SCOPED_TRACE(fieldOfView);
        const View view{3.0, fieldOfView, 192, 192};
        BandScene scene(k_Hull);
        scene.SetWidth(k_Asked);
        scene.Look(view);
        const double reach = HalfHeight(view) * view.distance;
        scene
            .AddBody(FineSphere(),
                     {static_cast<float>(0.4 * reach), static_cast<float>(-0.3 * reach), 3.0f})
            .transform.localScale = glm::vec3(static_cast<float>(0.4 * std::min(reach, 3.0)));
        const Reach band = MeasureReach(scene.Draw(view.width, view.height));
        EXPECT_GE(band.thinnest, k_Asked);
        EXPECT_LE(band.thickest, k_Asked + k_Pixel);
    }
}

TEST_F(HullWidthGpu, OfTheArticlesHullGapesAtACubesCorners)
{
    // Its sides move apart where the normals differ, and the corner between them stays bare.
    const Reach reach = MeasureCube(k_Article, {3.0, 10.0, 128, 128}, {20, 30, 10}, 16.0);
    EXPECT_LT(reach.thinnest, 0.5 * 16.0);
}

} // namespace
