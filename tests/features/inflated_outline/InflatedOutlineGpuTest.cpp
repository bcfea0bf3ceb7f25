#include "features/color_edges/PictureRun.h"
#include "features/inflated_outline/BodiesScene.h"
#include "features/inflated_outline/SoftRaster.h"

#include <cstdio>
#include <limn/features/InflatedOutlineRendererFeature.h>
#include <numbers>

namespace limn::test
{
namespace
{

/// What the outline is asked to be; its colour is (1, 0, 1).
struct Inflation
{
    double pixels = 3.0;
    double metres = 0.0; ///< not 0: these, not the pixels
    double alpha = 1.0;
};

/// A vertex of the hull that README.md describes.
glm::dvec4 HullVertex(const SoftCamera& camera, const GameObject& object, const Inflation& look,
                      std::uint32_t vertex)
{
    const MeshData& data = object.renderer->mesh->data();
    const glm::dmat4 world = object.transform.worldMatrix();
    const glm::dmat3 normalToWorld = glm::transpose(glm::inverse(glm::dmat3(world)));
    const glm::dvec4 place = world * glm::dvec4(glm::dvec3(data.vertices[vertex]), 1.0);
    const glm::dvec3 own(data.normals[vertex]);
    if (look.metres > 0.0)
    {
        const glm::dvec3 way = glm::normalize(normalToWorld * own) * look.metres;
        return camera.projection * camera.view * (place + glm::dvec4(way, 0.0));
    }
    const glm::dvec3 baked = data.uv8.empty() || data.uv8[vertex] == glm::vec3(0.0f)
                                 ? own
                                 : glm::dvec3(data.uv8[vertex]);
    const glm::dvec3 normal = glm::normalize(glm::dmat3(camera.view) * normalToWorld * baked);
    const glm::dvec3 seen(camera.view * place);
    const glm::dvec3 sight = camera.isOrthographic ? glm::dvec3(0, 0, -1) : glm::normalize(seen);
    // A plane through the camera with this normal is a line on the screen. Two of its directions:
    const glm::dvec4 clip = camera.projection * glm::dvec4(seen, 1.0);
    const glm::dvec3 inPlane = glm::normalize(glm::cross(normal, glm::dvec3(0, 0, 1)));
    const auto onScreen = [&](const glm::dvec3& point)
    {
        const glm::dvec4 p = camera.projection * glm::dvec4(point, 1.0);
        return glm::dvec2(p) / p.w * glm::dvec2(camera.width, camera.height) * 0.5;
    };
    // Parallel to the screen, a direction keeps its own on it, from wherever it starts.
    const glm::dvec2 along = onScreen(glm::dvec3(0, 0, -1) + inPlane) - onScreen({0, 0, -1});
    glm::dvec2 across = glm::normalize(glm::dvec2(-along.y, along.x));
    across *= glm::dot(across, glm::dvec2(normal)) < 0.0 ? -1.0 : 1.0;
    const double sine = glm::length(glm::cross(normal, sight));
    const double pixels = look.pixels * std::max(1.0, glm::length(baked) * sine);
    return clip +
           glm::dvec4(across * pixels * 2.0 / glm::dvec2(camera.width, camera.height) * clip.w, 0.0,
                      0.0);
}

/// The picture in double: bodies, then the farthest hull, its body over it, and so on; moved by a
/// part of a pixel.
Field InflatedReference(const BodiesScene& content, int width, int height, const Inflation& look,
                        const glm::dvec2& move)
{
    SoftCamera camera(content.camera, width, height);
    camera.move = move;
    const SoftScene seen(camera, content.scene);
    std::vector<glm::dvec3> colors;
    for (const SoftScene::Seen& at : seen.seen)
    {
        colors.push_back(content.ColorOf(at.object));
    }
    std::vector<const GameObject*> bodies;
    for (const auto& object : content.scene.objects())
    {
        if (BodiesScene::IsSelected(*object))
        {
            bodies.push_back(object.get());
        }
    }
    std::ranges::sort(bodies, {},
                      [&](const GameObject* body)
                      { return (camera.view * body->transform.worldMatrix()[3]).z; });
    for (const GameObject* body : bodies)
    {
        std::vector<glm::dvec4> hull; // worked out once: several triangles share a vertex
        for (std::uint32_t i = 0; i < body->renderer->mesh->data().vertices.size(); ++i)
        {
            hull.push_back(HullVertex(camera, *body, look, i));
        }
        ForEachPixel(
            camera, *body, [&](std::uint32_t vertex) { return hull[vertex]; }, true,
            [&](const SoftPixel& pixel, const std::uint32_t(&)[3])
            {
                if (pixel.depth >= seen.At(pixel.x, pixel.y).depth)
                {
                    glm::dvec3& color = colors[static_cast<std::size_t>(pixel.y * width + pixel.x)];
                    color += (glm::dvec3(1, 0, 1) - color) * look.alpha;
                }
            });
        for (std::size_t i = 0; i < colors.size(); ++i)
        {
            colors[i] = seen.seen[i].object == body ? content.ColorOf(body) : colors[i];
        }
    }
    Field field{width, height, 4, {}};
    for (const glm::dvec3& color : colors)
    {
        field.values.insert(field.values.end(), {color.x, color.y, color.z, 1.0});
    }
    return field;
}

class InflatedOutlineGpu : public GpuTest
{
protected:
    const VolumeStack& With(const Inflation& look)
    {
        return m_Volumes.With(
            [&](InflatedOutline& outline)
            {
                outline.m_OutlineColor.Override({1, 0, 1, static_cast<float>(look.alpha)});
                outline.m_OutlineWidth.Override(static_cast<float>(look.pixels));
                outline.m_WidthUnit.Override(look.metres > 0.0 ? InflatedWidthUnit::Metres
                                                               : InflatedWidthUnit::Pixels);
                outline.m_WidthInMetres.Override(static_cast<float>(look.metres));
            });
    }

    static void AddOutline(PictureRun& run, OutlineGrouping grouping = OutlineGrouping::PerGroup)
    {
        InflatedOutlineSettings settings;
        settings.m_Grouping = grouping;
        settings.m_RenderingLayerMask = k_SelectedLayer;
        run.Add(std::make_unique<InflatedOutlineRendererFeature>(settings));
    }

    BlendedComponent<InflatedOutline> m_Volumes;
};

class InflatedOutlineAtSizeGpu : public InflatedOutlineGpu,
                                 public testing::WithParamInterface<std::pair<int, int>>
{
};

int CountPixels(const Field& picture, const std::function<bool(double, double, double)>& is)
{
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
    {
        for (int x = 0; x < picture.width; ++x)
        {
            count += is(picture.At(x, y, 0), picture.At(x, y, 1), picture.At(x, y, 2));
        }
    }
    return count;
}

bool IsOutline(double red, double green, double blue)
{
    return red > 0.9 && green < 0.01 && blue > 0.9;
}

} // namespace

TEST_P(InflatedOutlineAtSizeGpu, AgreesWithTheDoublePrecisionReference)
{
    const auto [width, height] = GetParam();
    for (const bool isOrthographic : {false, true})
    {
        for (const bool isBaked : {false, true})
        {
            BodiesScene content(isOrthographic);
            if (isBaked)
            {
                content.BakeNormals();
            }
            PictureRun run(content.scene, content.camera, width, height);
            AddOutline(run);
            for (const Inflation& look : {Inflation{1.0}, Inflation{3.0}, Inflation{7.5},
                                          Inflation{0.0, 0.05}, Inflation{0.0, 0.2}})
            {
                const Field picture = run.Color(&With(look));
                const FieldRange reference =
                    RangeOf([&, width = width, height = height](const glm::dvec2& move)
                            { return InflatedReference(content, width, height, look, move); });
                EXPECT_GE(ShareWithinTwo(picture, reference), 0.999)
                    << look.pixels << " px, " << look.metres << " m, "
                    << (isOrthographic ? "orthographic" : "perspective")
                    << (isBaked ? ", baked" : "");
                EXPECT_GT(CountPixels(picture, IsOutline), 30);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, InflatedOutlineAtSizeGpu,
                         testing::Values(std::pair(96, 64), std::pair(61, 47), std::pair(53, 95)),
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" +
                                    std::to_string(size.param.second);
                         });

// Asked in pixels it is so wide at any distance; in metres it shrinks with the object.
TEST_F(InflatedOutlineGpu, HoldsItsWidthInPixelsAndShrinksInMetres)
{
    for (const double distance : {2.0, 8.0})
    {
        Scene scene;
        GameObject& ball = scene.Add("+Ball");
        ball.transform.localPosition = {0.0f, 0.0f, static_cast<float>(distance)};
        ball.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Sphere),
                                     {Plain({0.0f, 1.0f, 0.0f})},
                                     RenderingLayerMask::FromIndex(k_SelectedLayer)};
        Camera camera;
        camera.fieldOfView = 40.0f;
        camera.backgroundColor = Color::black;
        PictureRun run(scene, camera, 96, 96);
        AddOutline(run);
        const auto bandOf = [&](const Inflation& look)
        {
            const Field picture = run.Color(&With(look));
            const double body =
                CountPixels(picture, [](double r, double g, double) { return g > 0.5 && r < 0.5; });
            const double band = CountPixels(picture, IsOutline);
            return std::sqrt((body + band) / std::numbers::pi) - std::sqrt(body / std::numbers::pi);
        };
        std::printf(
            "hull of a ball %.0f m away: 4 px asked, %.2f drawn; 0.1 m asked, %.2f px drawn\n",
            distance, bandOf({4.0}), bandOf({0.0, 0.1}));
        EXPECT_NEAR(4.0, bandOf({4.0}), 0.25) << distance;
        // A ball of radius 0.5 whose hull's is 0.6: the tangents' angles from the middle.
        const double pixels = 48.0 / std::tan(20.0 * std::numbers::pi / 180.0);
        const double expected =
            pixels * (std::tan(std::asin(0.6 / distance)) - std::tan(std::asin(0.5 / distance)));
        EXPECT_NEAR(expected, bandOf({0.0, 0.1}), 0.25) << distance;
    }
}

TEST_F(InflatedOutlineGpu, BlendsASheetsBandWithItsAlpha)
{
    FlatScene flat(32, 32);
    GameObject& sheet = flat.Add({8, 8}, {24, 24}, 5, Plain({0.0f, 1.0f, 0.0f}));
    sheet.renderer->renderingLayerMask = RenderingLayerMask::FromIndex(k_SelectedLayer);
    sheet.renderer->mesh = WithOutlineNormals(*sheet.renderer->mesh);
    PictureRun run(flat.scene, flat.camera, 32, 32);
    AddOutline(run);
    // Straight from in front its normals point along the view axis: away from the middle then.
    const Field picture = run.Color(&With({4.0, 0.0, 0.5}));
    EXPECT_NEAR(0.0, picture.At(16, 16, 0), 1e-3) << "the sheet itself";
    EXPECT_NEAR(1.0, picture.At(16, 16, 1), 1e-3);
    EXPECT_NEAR(0.5, picture.At(16, 6, 0), 1e-2) << "the band";
    EXPECT_NEAR(0.0, picture.At(16, 6, 1), 1e-3);
    EXPECT_NEAR(0.0, picture.At(16, 3, 0), 1e-3) << "outside";
}

TEST_F(InflatedOutlineGpu, RunsOverFartherGroupsAndNotOverItsOwn)
{
    for (const bool isNearFirst : {false, true}) // in the scene
    {
        FlatScene flat(32, 32);
        const auto add = [&](bool isNear)
        {
            GameObject& sheet = flat.Add(isNear ? glm::vec2(12, 12) : glm::vec2(4, 4),
                                         isNear ? glm::vec2(20, 20) : glm::vec2(28, 28),
                                         isNear ? 4.0f : 6.0f, Plain({0.0f, 1.0f, 0.0f}));
            sheet.renderer->renderingLayerMask = RenderingLayerMask::FromIndex(k_SelectedLayer);
        };
        add(isNearFirst);
        add(!isNearFirst);
        const auto redBeside = [&](OutlineGrouping grouping)
        {
            PictureRun run(flat.scene, flat.camera, 32, 32);
            AddOutline(run, grouping);
            return run.Color(&With({3.0})).At(16, 10, 0);
        };
        EXPECT_NEAR(1.0, redBeside(OutlineGrouping::PerObject), 1e-3);
        EXPECT_NEAR(1.0, redBeside(OutlineGrouping::PerGroup), 1e-3);
        EXPECT_NEAR(0.0, redBeside(OutlineGrouping::Together), 1e-3);
    }
}

// The half of it that lies in the picture, of an object that does not.
TEST_F(InflatedOutlineGpu, ReachesIntoThePictureFromOutside)
{
    FlatScene flat(32, 32);
    GameObject& sheet = flat.Add({-18, 8}, {-2, 24}, 5, Plain({0.0f, 1.0f, 0.0f}));
    sheet.renderer->renderingLayerMask = RenderingLayerMask::FromIndex(k_SelectedLayer);
    PictureRun run(flat.scene, flat.camera, 32, 32);
    AddOutline(run);
    const Field picture = run.Color(&With({8.0}));
    EXPECT_GT(CountPixels(picture, IsOutline), 20);
    EXPECT_EQ(0, CountPixels(picture, [](double, double g, double) { return g > 0.1; }));
}

} // namespace limn::test
