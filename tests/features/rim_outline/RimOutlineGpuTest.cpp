#include "features/color_edges/PictureRun.h"
#include "features/inflated_outline/BodiesScene.h"
#include "features/inflated_outline/SoftRaster.h"

#include <limn/features/RimOutlineRendererFeature.h>
#include <numbers>

namespace limn::test
{
namespace
{

/// What the rim is asked to be; its colour is (0, 1, 1).
struct Rim
{
    RimVariant variant = RimVariant::Soft;
    double falloff = 1.0;
    double angle = 70.0; ///< degrees
    double width = 3.0;  ///< pixels
    double alpha = 1.0;
};

/// The sine of the angle between normal and line of sight at a pixel of an object.
double SineAt(const BodiesScene& content, const SoftScene::Seen& at)
{
    const glm::dmat4 world = at.object->transform.worldMatrix();
    const glm::dmat3 normalToWorld = glm::transpose(glm::inverse(glm::dmat3(world)));
    const MeshData& data = at.object->renderer->mesh->data();
    glm::dvec3 normal(0.0);
    glm::dvec3 place(0.0);
    for (int i = 0; i < 3; ++i)
    {
        const std::uint32_t vertex = at.vertices[i];
        normal += at.weights[i] * glm::normalize(normalToWorld * glm::dvec3(data.normals[vertex]));
        place +=
            at.weights[i] * glm::dvec3(world * glm::dvec4(glm::dvec3(data.vertices[vertex]), 1.0));
    }
    const Transform& eye = content.camera.transform;
    const glm::dvec3 sight = content.camera.orthographic
                                 ? glm::dvec3(eye.forward())
                                 : glm::normalize(place - glm::dvec3(eye.worldMatrix()[3]));
    return glm::length(glm::cross(glm::normalize(normal), sight));
}

/// The picture in double, moved by a part of a pixel.
Field RimReference(const BodiesScene& content, int width, int height, const Rim& rim,
                   const glm::dvec2& move)
{
    SoftCamera camera(content.camera, width, height);
    camera.move = move;
    const SoftScene seen(camera, content.scene);
    Field field{width, height, 4, {}};
    for (const SoftScene::Seen& at : seen.seen)
    {
        glm::dvec3 color = content.ColorOf(at.object);
        if (at.object && BodiesScene::IsSelected(*at.object))
        {
            const double sine = SineAt(content, at);
            const double limit = std::sin(rim.angle * std::numbers::pi / 180.0);
            const double strength = rim.variant == RimVariant::Soft ? std::pow(sine, rim.falloff)
                                    : sine > limit                  ? 1.0
                                                                    : 0.0;
            color += (glm::dvec3(0, 1, 1) - color) * (strength * rim.alpha);
        }
        field.values.insert(field.values.end(), {color.x, color.y, color.z, 1.0});
    }
    return field;
}

class RimOutlineGpu : public GpuTest
{
protected:
    const VolumeStack& With(const Rim& rim)
    {
        return m_Volumes.With(
            [&](RimOutline& outline)
            {
                outline.m_OutlineColor.Override({0, 1, 1, static_cast<float>(rim.alpha)});
                outline.m_OutlineWidth.Override(static_cast<float>(rim.width));
                outline.m_Variant.Override(rim.variant);
                outline.m_Falloff.Override(static_cast<float>(rim.falloff));
                outline.m_ThresholdAngle.Override(static_cast<float>(rim.angle));
            });
    }

    static void AddRim(PictureRun& run)
    {
        RimOutlineSettings settings;
        settings.m_RenderingLayerMask = k_SelectedLayer;
        run.Add(std::make_unique<RimOutlineRendererFeature>(settings));
    }

    BlendedComponent<RimOutline> m_Volumes;
};

class RimOutlineAtSizeGpu : public RimOutlineGpu,
                            public testing::WithParamInterface<std::pair<int, int>>
{
};

} // namespace

TEST_P(RimOutlineAtSizeGpu, AgreesWithTheDoublePrecisionReference)
{
    const auto [width, height] = GetParam();
    for (const bool isOrthographic : {false, true})
    {
        BodiesScene content(isOrthographic);
        PictureRun run(content.scene, content.camera, width, height);
        AddRim(run);
        const Field base = run.Color(nullptr);
        for (const Rim& rim : {Rim{RimVariant::Soft}, Rim{RimVariant::Soft, 5.0, 0.0, 0.0, 0.6},
                               Rim{RimVariant::Threshold, 1.0, 60.0},
                               Rim{RimVariant::Threshold, 1.0, 45.0, 0.0, 0.6}})
        {
            const Field picture = run.Color(&With(rim));
            const FieldRange reference =
                RangeOf([&, width = width, height = height](const glm::dvec2& move)
                        { return RimReference(content, width, height, rim, move); });
            EXPECT_GE(ShareWithinTwo(picture, reference), 0.999)
                << static_cast<int>(rim.variant) << ", falloff " << rim.falloff << ", angle "
                << rim.angle << (isOrthographic ? ", orthographic" : ", perspective");
            EXPECT_GT(CountDifferent(picture, base), 50);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, RimOutlineAtSizeGpu,
                         testing::Values(std::pair(96, 64), std::pair(61, 47), std::pair(53, 95)),
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" +
                                    std::to_string(size.param.second);
                         });

// By area, on balls of several sizes.
TEST_F(RimOutlineGpu, IsAsManyPixelsWideAsAskedOnABall)
{
    for (const float size : {1.0f, 2.0f})
    {
        Scene scene;
        GameObject& ball = scene.Add("Ball");
        ball.transform.localScale = glm::vec3(size);
        ball.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Sphere),
                                     {Plain({0.5f, 0.0f, 0.0f})},
                                     RenderingLayerMask::FromIndex(k_SelectedLayer)};
        Camera camera;
        camera.orthographic = true;
        camera.orthographicSize = 1.2f;
        camera.transform.localPosition.z = -5.0f;
        camera.backgroundColor = Color::black;
        PictureRun run(scene, camera, 96, 96);
        AddRim(run);
        for (const double width : {2.0, 4.0, 8.0})
        {
            const Field picture = run.Color(&With({RimVariant::Pixels, 1.0, 70.0, width}));
            double body = 0.0;
            double inside = 0.0;
            for (int y = 0; y < 96; ++y)
            {
                for (int x = 0; x < 96; ++x)
                {
                    body += picture.At(x, y, 0) + picture.At(x, y, 1) > 0.1;
                    inside += picture.At(x, y, 0) / 0.5;
                }
            }
            const double measured =
                std::sqrt(body / std::numbers::pi) - std::sqrt(inside / std::numbers::pi);
            std::printf("rim of a ball of %2.0f px: asked %.0f, measured %.2f\n",
                        std::sqrt(body / std::numbers::pi), width, measured);
            EXPECT_NEAR(width, measured, 0.25);
        }
    }
}

// A face has one angle all over, near or far from its edge.
TEST_F(RimOutlineGpu, DrawsNoneInPixelsOnFlatFacesSeenFromInFront)
{
    FlatScene flat(32, 32);
    GameObject& sheet = flat.Add({8, 8}, {24, 24}, 5, Plain({0.0f, 1.0f, 0.0f}));
    sheet.renderer->renderingLayerMask = RenderingLayerMask::FromIndex(k_SelectedLayer);
    PictureRun run(flat.scene, flat.camera, 32, 32);
    AddRim(run);
    const Field base = run.Color(nullptr);
    for (const RimVariant variant : {RimVariant::Soft, RimVariant::Threshold, RimVariant::Pixels})
    {
        EXPECT_EQ(0, CountDifferent(base, run.Color(&With({variant, 1.0, 70.0, 50.0}))));
    }
}

} // namespace limn::test
