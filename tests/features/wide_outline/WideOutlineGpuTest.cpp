#include "features/wide_outline/WideOutlineScene.h"
#include "vulkan/GpuTestDevice.h"

#include <cmath>
#include <cstdlib>
#include <limn/core/PrimitiveMesh.h>
#include <map>

namespace limn::test
{
namespace
{

constexpr int k_Picture = 96;
constexpr WideOutlineMethod k_Methods[] = {WideOutlineMethod::JumpFlood,
                                           WideOutlineMethod::Separable};

WideOutlineSettings With(WideOutlineMethod method)
{
    WideOutlineSettings settings;
    settings.m_Method = method;
    return settings;
}

/// What a mask of four samples allows: the mean error inside the band, which outlines.md (section
/// 2, "edge seeds, 4x") gives as .044, .017 and .0053 for the widths 2, 8 and 32 around a disc. The
/// overlap counts pixels above one half: one of which two samples are covered may fall on either
/// side. Of the band around the disc's 1 206 pixels some 390 lie on its ends, a quarter of them
/// with two samples; half of those on the wrong side are 4 %.
struct Limits
{
    const char* name;
    ScreenTriangles triangles;
    double error[4]; ///< for the widths 1, 2, 8, 32
    double overlap;  ///< intersection over union for 8
};
constexpr double k_Widths[] = {1.0, 2.0, 8.0, 32.0};

std::vector<Limits> ShapeLimits()
{
    return {
        {"disc", DiscTriangles({47.3, 48.6}, 20.0), {.06, .042, .015, .0053}, .96},
        {"ring", RingTriangles({48.2, 47.4}, 9.5, 22.0), {.06, .042, .015, .0053}, .96},
        {"star", StarTriangles({47.7, 48.3}, 5, 11.0, 25.0, 0.3), {.07, .056, .034, .02}, .95},
        // Thinner than the samples of a pixel lie apart: the slope decides which of them it meets.
        {"needle", NeedleTriangles({25.3, 55.9}, {70.2, 38.3}, 0.3), {.26, .135, .04, .015}, .93},
        {"pair",
         Together(
             {DiscTriangles({40.3, 44.6}, 12.0), NeedleTriangles({38.0, 52.0}, {66.0, 49.0}, 9.0)}),
         {.06, .042, .017, .0065},
         .96}};
}

class WideOutlineGpu : public GpuTest
{
protected:
    ~WideOutlineGpu() override { ExpectNoValidationMessages(); }

    /// Made once a test: shaders are compiled for it.
    WideOutlineScene& SceneFor(WideOutlineMethod method)
    {
        auto& scene = m_Scenes[method];
        if (!scene)
        {
            scene = std::make_unique<WideOutlineScene>(SharedDevice(), k_Picture, k_Picture,
                                                       With(method));
        }
        return *scene;
    }
    Coverage Draw(const ScreenTriangles& triangles, const OutlineBand& band,
                  WideOutlineMethod method)
    {
        WideOutlineScene& scene = SceneFor(method);
        scene.Show(triangles);
        scene.Set(band);
        return scene.DrawAlpha();
    }

private:
    std::map<WideOutlineMethod, std::unique_ptr<WideOutlineScene>> m_Scenes;
};

class WideOutlineByMethodGpu : public WideOutlineGpu,
                               public testing::WithParamInterface<WideOutlineMethod>
{
};
INSTANTIATE_TEST_SUITE_P(Methods, WideOutlineByMethodGpu, testing::ValuesIn(k_Methods),
                         [](const auto& method) {
                             return method.param == WideOutlineMethod::JumpFlood ? "JumpFlood"
                                                                                 : "Separable";
                         });

TEST_P(WideOutlineByMethodGpu, IsAsNearToTheExactOutlineAsFourSamplesAllow)
{
    for (const Limits& shape : ShapeLimits())
    {
        const Silhouette silhouette(shape.triangles);
        for (std::size_t i = 0; i < std::size(k_Widths); ++i)
        {
            const OutlineBand band{k_Widths[i]};
            const Coverage measured = Draw(shape.triangles, band, GetParam());
            const OutlineScore score = ScoreOutline(
                measured, ExactOutlineCoverage(silhouette, band, k_Picture, k_Picture));
            SCOPED_TRACE(shape.name + std::string(", width ") + std::to_string(band.width));
            EXPECT_LE(score.meanAbsoluteError, shape.error[i]);
            EXPECT_EQ(score.badValues, 0u);
            if (band.width == 8.0)
            {
                EXPECT_GE(score.intersectionOverUnion, shape.overlap);
                EXPECT_NEAR(score.areaRatio, 1.0, 0.025);
            }
            if (std::getenv("LIMN_PRINT_FIGURES") != nullptr)
            {
                std::printf("%-7s w %2g: MAE %.4f IoU %.3f bias %+.4f outer end %+.3f\n",
                            shape.name, band.width, score.meanAbsoluteError,
                            score.intersectionOverUnion, score.areaRatio - 1.0,
                            ScoreContours(measured, silhouette, band).high.mean);
            }
        }
    }
}

TEST_F(WideOutlineGpu, IsAlikeByEitherMethod)
{
    for (const Limits& shape : ShapeLimits())
    {
        for (const OutlineBand& band :
             {OutlineBand{2.0}, {8.0}, {30.0}, {3.0, OutlineSide::Outer, 2.5}})
        {
            const Coverage flood = Draw(shape.triangles, band, WideOutlineMethod::JumpFlood);
            const Coverage columns = Draw(shape.triangles, band, WideOutlineMethod::Separable);
            const OutlineScore score = ScoreOutline(columns, flood);
            EXPECT_LE(score.meanAbsoluteError, 0.006) << shape.name << ", " << band.width;
            EXPECT_LE(score.percentile99, 0.1) << shape.name << ", " << band.width;
            EXPECT_NEAR(score.areaRatio, 1.0, 0.006) << shape.name << ", " << band.width;
        }
    }
}

TEST_P(WideOutlineByMethodGpu, LiesInsideOrAcrossTheEdgeOrApartFromIt)
{
    const ScreenTriangles disc = DiscTriangles({47.3, 48.6}, 20.0);
    for (const OutlineSide side : {OutlineSide::Outer, OutlineSide::Inner, OutlineSide::Centred})
    {
        for (const double gap : {0.0, 3.5})
        {
            const OutlineBand band{6.0, side, gap};
            const OutlineScore score =
                ScoreOutline(Draw(disc, band, GetParam()),
                             ExactOutlineCoverage(Silhouette(disc), band, k_Picture, k_Picture));
            SCOPED_TRACE(std::to_string(static_cast<int>(side)) + ", gap " + std::to_string(gap));
            EXPECT_LE(score.meanAbsoluteError, 0.025);
            EXPECT_GE(score.intersectionOverUnion, 0.95);
            EXPECT_NEAR(score.areaRatio, 1.0, 0.02);
        }
    }
}

TEST_P(WideOutlineByMethodGpu, OutlinesAMeshInPerspective)
{
    WideOutlineScene scene(SharedDevice(), k_Picture, k_Picture, With(GetParam()));
    scene.camera.orthographic = false;
    scene.camera.transform.localPosition = {0.0f, 0.0f, -3.0f};
    GameObject& cube = scene.Add(CreatePrimitive(PrimitiveType::Cube));
    cube.transform.localRotation = EulerToRotation({25.0f, 40.0f, 10.0f});
    const Silhouette silhouette(
        MeshTriangles(*cube.renderer->mesh, cube.transform, scene.camera, k_Picture, k_Picture));
    for (const double width : {2.0, 8.0})
    {
        scene.Set({width});
        const OutlineScore score = ScoreOutline(
            scene.DrawAlpha(), ExactOutlineCoverage(silhouette, {width}, k_Picture, k_Picture));
        EXPECT_LE(score.meanAbsoluteError, width == 2.0 ? 0.05 : 0.02);
        EXPECT_GE(score.intersectionOverUnion, width == 2.0 ? 0.9 : 0.97);
    }
}

TEST_P(WideOutlineByMethodGpu, OutlinesWhatReachesBehindTheCamera)
{
    WideOutlineScene& scene = SceneFor(GetParam());
    scene.camera = Camera();
    scene.camera.backgroundColor = Color::clear;
    scene.scene = Scene();
    GameObject& floor = scene.Add(CreatePrimitive(PrimitiveType::Quad));
    floor.transform.localPosition = {0.4f, -1.0f, 0.0f};
    floor.transform.localRotation = EulerToRotation({80.0f, 25.0f, 0.0f});
    floor.transform.localScale = {1.5f, 9.0f, 1.0f};
    const Silhouette silhouette(
        MeshTriangles(*floor.renderer->mesh, floor.transform, scene.camera, k_Picture, k_Picture));
    scene.Set({7.0});
    const OutlineScore score = ScoreOutline(
        scene.DrawAlpha(), ExactOutlineCoverage(silhouette, {7.0}, k_Picture, k_Picture));
    EXPECT_GT(score.bandPixels, 200u);
    EXPECT_LE(score.meanAbsoluteError, 0.025);
    EXPECT_GE(score.intersectionOverUnion, 0.96);
}

TEST_P(WideOutlineByMethodGpu, ComesIntoViewFromOutsideAndDrawsNoLineAlongTheBorder)
{
    const double far = k_Picture + 4.3; // half the width outside of the picture
    const ScreenTriangles cases[] = {
        NeedleTriangles({-24.3, 30.0}, {-4.3, 40.0}, 11.0), // left of the picture
        NeedleTriangles({far, 30.0}, {far + 20.0, 40.0}, 11.0),
        NeedleTriangles({30.0, -24.0}, {40.0, -4.3}, 11.0),
        NeedleTriangles({30.0, far}, {40.0, far + 20.0}, 11.0),
        DiscTriangles({-4.0, -4.0}, 3.0),             // across the corner
        DiscTriangles({3.0, 50.0}, 14.0),             // across a border
        DiscTriangles({93.0, 94.0}, 14.0),            // across two
        NeedleTriangles({-20, 48}, {116, 52}, 200.0), // fills the picture
    };
    for (const OutlineSide side : {OutlineSide::Outer, OutlineSide::Inner})
    {
        for (const ScreenTriangles& triangles : cases)
        {
            const OutlineBand band{8.6, side};
            const Coverage exact =
                ExactOutlineCoverage(Silhouette(triangles), band, k_Picture, k_Picture);
            const OutlineScore score = ScoreOutline(Draw(triangles, band, GetParam()), exact);
            SCOPED_TRACE(std::to_string(&triangles - cases) +
                         (side == OutlineSide::Inner ? " in" : ""));
            EXPECT_LE(score.meanAbsoluteError, 0.055);
            EXPECT_LE(score.largest, 0.6);
            EXPECT_EQ(score.bandPixels > 0, exact.Sum() > 0.0);
        }
    }
}

TEST_P(WideOutlineByMethodGpu, GrowsWithItsWidthUpToTheWholePicture)
{
    const ScreenTriangles disc = DiscTriangles({20.3, 22.6}, 9.0);
    WideOutlineScene& scene = SceneFor(GetParam());
    scene.SetPicture(48, 40);
    scene.Show(disc);
    double before = 0.0;
    for (const double width : {1e-3, 0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 9.0, 17.0, 40.0})
    {
        scene.Set({width});
        const double area = scene.DrawAlpha().Sum();
        EXPECT_GT(area, before) << width;
        before = area;
    }
    for (const double width : {64.0, 1e4, HUGE_VAL})
    {
        scene.Set({width});
        const Coverage alpha = scene.DrawAlpha();
        const double outside = 48.0 * 40.0 - ExactFillCoverage(Silhouette(disc), 48, 40).Sum();
        EXPECT_NEAR(alpha.Sum(), outside, 0.01 * outside) << width;
    }
}

TEST_P(WideOutlineByMethodGpu, DrawsPicturesOfAnySize)
{
    WideOutlineScene& scene = SceneFor(GetParam());
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {3, 7}, {65, 1}, {37, 61}})
    {
        scene.SetPicture(width, height);
        // All to the left of the middle.
        const ScreenTriangles triangles = NeedleTriangles({-50.0, 0.0}, {0.5 * width, 0.0}, 200.0);
        scene.Show(triangles);
        for (const double outline : {0.25, 2.0, 64.0, 1e4})
        {
            scene.Set({outline});
            const OutlineScore score =
                ScoreOutline(scene.DrawAlpha(),
                             ExactOutlineCoverage(Silhouette(triangles), {outline}, width, height));
            SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + ", " +
                         std::to_string(outline));
            EXPECT_EQ(score.badValues, 0u);
            EXPECT_LE(score.meanAbsoluteError, 0.02);
        }
    }
}

TEST_F(WideOutlineGpu, GivesObjectsOneSilhouetteOrEachItsOwn)
{
    const ScreenTriangles a = DiscTriangles({36.3, 44.6}, 16.0);
    const ScreenTriangles b = DiscTriangles({54.8, 47.1}, 18.0);
    const ScreenTriangles c = NeedleTriangles({40, 70}, {60, 75}, 8.0);
    const OutlineBand band{4.0};
    const auto exact = [&](const ScreenTriangles& triangles)
    {
        return ExactOutlineCoverage(Silhouette(triangles), band, k_Picture, k_Picture);
    };
    const auto over = [](const Coverage& below, const Coverage& above)
    {
        Coverage both = below;
        for (std::size_t i = 0; i < both.values.size(); ++i)
        {
            both.values[i] += above.values[i] * (1.0 - both.values[i]);
        }
        return both;
    };
    const std::pair<OutlineGrouping, Coverage> cases[] = {
        {OutlineGrouping::Together, exact(Together({a, b, c}))},
        {OutlineGrouping::PerGroup, over(exact(a), exact(Together({b, c})))},
        {OutlineGrouping::PerObject, over(over(exact(a), exact(b)), exact(c))}};
    for (const auto& [grouping, expected] : cases)
    {
        WideOutlineSettings settings;
        settings.m_Grouping = grouping;
        WideOutlineScene scene(SharedDevice(), k_Picture, k_Picture, settings);
        scene.Add(a);
        GameObject& parent = scene.Add(b);
        scene.Add(c).transform.parent = &parent.transform;
        scene.Set(band);
        const OutlineScore score = ScoreOutline(scene.DrawAlpha(), expected);
        EXPECT_LE(score.meanAbsoluteError, 0.03) << static_cast<int>(grouping);
        EXPECT_GE(score.intersectionOverUnion, 0.95) << static_cast<int>(grouping);
    }
}

TEST_F(WideOutlineGpu, OutlinesWholeObjectsOrWhatIsSeenOfThem)
{
    // No edge of it cuts pixels in halves: of which two samples are covered, they are on no side.
    const auto bar = [](double top, double bottom, double narrowed)
    {
        const double middle = 0.5 * k_Picture + 0.3 * narrowed;
        return NeedleTriangles({middle, top}, {middle, bottom}, 20.2 * narrowed);
    };
    const double turned = std::cos(glm::radians(5.0));
    for (const WideOutlineOcclusion occlusion :
         {WideOutlineOcclusion::All, WideOutlineOcclusion::Visible})
    {
        for (const int samples : {1, 4})
        {
            WideOutlineSettings settings;
            settings.m_Occlusion = occlusion;
            settings.m_LayerMask = LayerMask::FromIndex(3);
            WideOutlineScene scene(SharedDevice(), k_Picture, k_Picture, settings);
            scene.SetSamples(samples);
            GameObject& seen = scene.Add(bar(20.2, 80.2, 1.0));
            seen.layer = 3;
            seen.transform.localRotation = EulerToRotation({0.0f, 5.0f, 0.0f});
            scene.Add(NeedleTriangles({0, 70}, {96, 70}, 40.0)).transform.localPosition.z = -3.0f;
            scene.Add(NeedleTriangles({0, 30}, {96, 30}, 40.0)).transform.localPosition.z = 3.0f;
            scene.Set({6.0});
            const Silhouette expected(
                bar(20.2, occlusion == WideOutlineOcclusion::All ? 80.2 : 50.0, turned));
            const OutlineScore score = ScoreOutline(
                scene.DrawAlpha(), ExactOutlineCoverage(expected, {6.0}, k_Picture, k_Picture));
            EXPECT_LE(score.meanAbsoluteError, 0.03) << static_cast<int>(occlusion) << samples;
            EXPECT_GE(score.intersectionOverUnion, 0.95) << static_cast<int>(occlusion) << samples;
        }
    }
}

/// A quad that the alpha of a texture makes a disc of a quarter of its width, as URP's materials
/// do.
std::shared_ptr<Material> CutoutDisc()
{
    constexpr int k_DiscSide = 64;
    std::vector<std::byte> texels;
    for (int i = 0; i < k_DiscSide * k_DiscSide; ++i)
    {
        const double away =
            std::hypot(i % k_DiscSide - 31.5, static_cast<int>(i / k_DiscSide) - 31.5);
        const double alpha = std::clamp(0.6 + (16.0 - away) / 8.0, 0.0, 1.0); // 0.6 at the edge
        texels.insert(texels.end(), 3, std::byte{255});
        texels.push_back(static_cast<std::byte>(std::lround(255.0 * alpha)));
    }
    const auto material = std::make_shared<Material>(ShaderOf(
        "Shader \"Test/Cutout\" { SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" }"
        " HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n#include "
        "\"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "float4 V(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }\n"
        "half4 F() : SV_Target { clip(-1); return 0; }\nENDHLSL } } }"));
    material->EnableKeyword("_ALPHATEST_ON");
    material->SetTexture(Shader::PropertyToID("_BaseMap"),
                         std::make_shared<Texture2D>("disc", k_DiscSide, k_DiscSide,
                                                     GraphicsFormat::R8G8B8A8_UNorm, texels));
    material->SetFloat(Shader::PropertyToID("_Cutoff"), 0.6f);
    return material;
}

TEST_F(WideOutlineGpu, FollowsWhatTheAlphaOfATextureCutsOut)
{
    for (const auto& [occlusion, grouping] :
         {std::pair(WideOutlineOcclusion::All, OutlineGrouping::Together),
          {WideOutlineOcclusion::All, OutlineGrouping::PerObject},
          {WideOutlineOcclusion::Visible, OutlineGrouping::Together}})
    {
        WideOutlineSettings settings;
        settings.m_Occlusion = occlusion;
        settings.m_Grouping = grouping;
        WideOutlineScene scene(SharedDevice(), k_Picture, k_Picture, settings);
        GameObject& quad = scene.Add(CreatePrimitive(PrimitiveType::Quad));
        quad.transform.localScale = glm::vec3(80.0f);
        quad.renderer->sharedMaterials = {CutoutDisc()};
        const ScreenTriangles solid = NeedleTriangles({40.0, 6.3}, {60.0, 4.1}, 5.0);
        scene.Add(solid);
        scene.Set({8.0});
        const Silhouette disc(DiscTriangles({48.0, 48.0}, 20.0));
        const Silhouette bar(solid);
        Coverage exact = ExactOutlineCoverage(disc, {8.0}, k_Picture, k_Picture);
        const Coverage other = ExactOutlineCoverage(bar, {8.0}, k_Picture, k_Picture);
        for (std::size_t i = 0; i < exact.values.size(); ++i)
        {
            exact.values[i] = std::max(exact.values[i], other.values[i]);
        }
        const OutlineScore score = ScoreOutline(scene.DrawAlpha(), exact);
        SCOPED_TRACE(std::to_string(static_cast<int>(occlusion)) + ", " +
                     std::to_string(static_cast<int>(grouping)));
        EXPECT_LE(score.meanAbsoluteError, 0.015);
        EXPECT_GE(score.intersectionOverUnion, 0.97);
    }
}

TEST_F(WideOutlineGpu, HasNoLineWhereAnObjectHidesAPartOfAnotherOfItsGroup)
{
    WideOutlineSettings settings;
    settings.m_Occlusion = WideOutlineOcclusion::Visible;
    WideOutlineScene scene(SharedDevice(), k_Picture, k_Picture, settings);
    const ScreenTriangles behind = DiscTriangles({40.3, 44.6}, 20.0);
    const ScreenTriangles front = StarTriangles({52.0, 52.0}, 6, 12.0, 24.0, 0.3);
    scene.Add(behind);
    scene.Add(front).transform.localPosition.z = -2.0f;
    scene.Set({4.0});
    const Coverage alpha = scene.DrawAlpha();
    const Silhouette both(Together({behind, front}));
    EXPECT_LE(ScoreOutline(alpha, ExactOutlineCoverage(both, {4.0}, k_Picture, k_Picture))
                  .meanAbsoluteError,
              0.04);
    for (int y = 0; y < k_Picture; ++y)
    {
        for (int x = 0; x < k_Picture; ++x)
        {
            const bool isDeep = both.SignedDistance({x + 0.5, y + 0.5}, 9.0) < -2.0;
            EXPECT_LE(isDeep ? alpha.At(x, y) : 0.0, 0.0) << x << ", " << y;
        }
    }
}

TEST_F(WideOutlineGpu, GoesOverToItsOuterColourAndFadesAsAGlowDoes)
{
    const Color near{1.0f, 0.0f, 0.25f, 1.0f};
    const Color far{0.0f, 0.5f, 0.25f, 1.0f};
    WideOutlineScene scene(SharedDevice(), 64, 32);
    scene.Add(NeedleTriangles({-40.0, 16.0}, {20.0, 16.0}, 200.0));
    scene.Set({16.0, OutlineSide::Outer, 2.0});
    scene.outline->m_OutlineColor.Override(near);
    scene.outline->m_OuterColor.Override(far);
    for (const auto& [gradient, falloff] :
         {std::pair(0.0, 0.0), {1.0, 0.0}, {0.5, 0.0}, {0.0, 1.0}, {1.0, 2.5}, {0.0, 1e4}})
    {
        scene.outline->m_Gradient.Override(static_cast<float>(gradient));
        scene.outline->m_Falloff.Override(static_cast<float>(falloff));
        const Image image = scene.Draw();
        for (int x = 22; x < 38; ++x)
        {
            const double along = (x + 0.5 - 22.0) / 16.0;
            const double alpha = falloff > 0.0 ? std::pow(1.0 - along, falloff) : 1.0;
            const double share = along * gradient;
            const double half = 0.21404114; // 0.5 and 0.25 of sRGB
            const double quarter = 0.05087609;
            SCOPED_TRACE(std::to_string(gradient) + ", " + std::to_string(falloff) + " at " +
                         std::to_string(x));
            EXPECT_NEAR(ChannelOf(image, 0).At(x, 16), alpha * (1.0 - share), 0.004);
            EXPECT_NEAR(ChannelOf(image, 3).At(x, 16), alpha, 0.004);
            EXPECT_NEAR(ChannelOf(image, 1).At(x, 16), alpha * share * half, 0.004);
            EXPECT_NEAR(ChannelOf(image, 2).At(x, 16), alpha * quarter, 0.004);
        }
    }
}

TEST_F(WideOutlineGpu, IsTheSameBeforeACameraOfSeveralSamples)
{
    const ScreenTriangles star = StarTriangles({31.7, 32.3}, 5, 9.0, 20.0, 0.3);
    Coverage alpha[2];
    for (const int samples : {1, 4})
    {
        WideOutlineScene scene(SharedDevice(), 64, 64);
        scene.SetSamples(samples);
        scene.Add(star);
        scene.Set({5.0});
        alpha[samples / 4] = scene.DrawAlpha();
    }
    EXPECT_LE(ScoreOutline(alpha[1], alpha[0]).largest, 0.002);
}

} // namespace
} // namespace limn::test
