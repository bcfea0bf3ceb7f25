#include "Mentions.h"
#include "features/color_edges/PictureRun.h"
#include "features/post_process/PostProcessReference.h"

#include <gmock/gmock.h>
#include <limn/features/Bloom.h>
#include <limn/features/PostProcessRendererFeature.h>
#include <limn/features/Vignette.h>

namespace limn::test
{
namespace
{

class PostProcessGpu : public GpuTest
{
protected:
    /// Patches of 6 x 6 pixels: greys from dark to far beyond white, colours, a black border.
    static FlatScene Patches()
    {
        FlatScene flat(50, 26);
        const std::vector<glm::vec3> colors = {{0.01f, 0.01f, 0.01f},
                                               {0.18f, 0.18f, 0.18f},
                                               {0.5f, 0.5f, 0.5f},
                                               {1, 1, 1},
                                               {4, 4, 4},
                                               {30, 30, 30},
                                               {200, 200, 200},
                                               {0.8f, 0.1f, 0.1f},
                                               {0.1f, 0.8f, 0.1f},
                                               {0.1f, 0.1f, 0.8f},
                                               {5, 0.5f, 0.1f},
                                               {0.2f, 3, 0.4f},
                                               {0.1f, 0.3f, 7},
                                               {0.9f, 0.6f, 0.5f},
                                               {0.02f, 0.2f, 0.1f}};
        for (std::size_t i = 0; i < colors.size(); ++i)
        {
            const glm::vec2 corner(1 + 6 * (i % 8), 7 * (i / 8) + 1);
            flat.Add(corner, corner + 6.0f, 5, Plain(colors[i]));
        }
        return flat;
    }

    struct Run : PictureRun
    {
        explicit Run(const FlatScene& flat, ColorGradingMode grading = {})
            : PictureRun(flat.scene, flat.camera, static_cast<int>(flat.size.x),
                         static_cast<int>(flat.size.y))
        {
            auto feature = std::make_unique<PostProcessRendererFeature>();
            feature->m_ColorGradingMode = grading;
            Add(std::move(feature));
        }
    };

    const VolumeStack& Nothing()
    {
        return m_Volumes.With([](VolumeProfile&) {});
    }

    BlendedProfile m_Volumes;
};

void ExpectNear(const Field& picture, const Field& reference, const glm::dvec3& relative,
                double absolute)
{
    ASSERT_EQ(picture.values.size(), reference.values.size());
    double worst = 0.0;
    for (int y = 0; y < picture.height; ++y)
    {
        for (int x = 0; x < picture.width; ++x)
        {
            for (int channel = 0; channel < 3; ++channel)
            {
                const double value = picture.At(x, y, channel);
                const double wanted = reference.At(x, y, channel);
                const double allowed = absolute + relative[channel] * std::abs(wanted);
                ASSERT_LE(std::abs(value - wanted), allowed)
                    << x << ", " << y << ", channel " << channel << ": " << value << ", not "
                    << wanted;
                worst = std::max(worst, std::abs(value - wanted) / allowed);
            }
        }
    }
    testing::Test::RecordProperty("partOfAllowedError", std::to_string(worst));
}

struct Mode
{
    ColorGradingMode grading;
    TonemappingMode tonemapping;
};

class PostProcessGradingGpu : public PostProcessGpu, public testing::WithParamInterface<Mode>
{
};

TEST_P(PostProcessGradingGpu, IsWhatTheFormulasSayInDouble)
{
    const FlatScene flat = Patches();
    const ColorGradingMode grading = GetParam().grading;
    const TonemappingMode tonemapping = GetParam().tonemapping;
    Run run(flat, grading);
    const Field base = run.Color(&Nothing());
    const std::vector<Adjustments> looks = {{},
                                            {.exposure = 1.5},
                                            {.contrast = 40},
                                            {.contrast = -60, .filter = {1.5, 0.8, 0.25}},
                                            {.hueShift = 75, .saturation = 30},
                                            {.exposure = -1,
                                             .contrast = 20,
                                             .filter = {0.5, 1, 2},
                                             .hueShift = -150,
                                             .saturation = -45},
                                            {.saturation = -100}};
    for (const Adjustments& look : looks)
    {
        const Field picture = run.Color(&m_Volumes.With(
            [&](VolumeProfile& profile)
            {
                profile.Add<Tonemapping>().mode.Override(tonemapping);
                look.SetOn(profile.Add<ColorAdjustments>());
            }));
        const bool drawsNothing = tonemapping == TonemappingMode::None && look.isNone();
        const Field reference = PerPixel(
            base, [&](const glm::dvec3& color, double, double)
            { return drawsNothing ? color : GradeReference(color, look, grading, tonemapping); });
        // Matrices of ACES are known to four digits; the picture has halves.
        ExpectNear(picture, reference, glm::dvec3(1e-3),
                   tonemapping == TonemappingMode::ACES ? 4e-3 : 1e-3);
    }
}

std::string ModeName(const testing::TestParamInfo<Mode>& mode)
{
    constexpr const char* names[] = {"None", "Neutral", "Aces"};
    const bool isHdr = mode.param.grading == ColorGradingMode::HighDynamicRange;
    return (isHdr ? "Hdr" : "Ldr") + std::string(names[static_cast<int>(mode.param.tonemapping)]);
}

INSTANTIATE_TEST_SUITE_P(
    Modes, PostProcessGradingGpu,
    testing::Values(Mode{ColorGradingMode::LowDynamicRange, TonemappingMode::None},
                    Mode{ColorGradingMode::LowDynamicRange, TonemappingMode::Neutral},
                    Mode{ColorGradingMode::LowDynamicRange, TonemappingMode::ACES},
                    Mode{ColorGradingMode::HighDynamicRange, TonemappingMode::None},
                    Mode{ColorGradingMode::HighDynamicRange, TonemappingMode::Neutral},
                    Mode{ColorGradingMode::HighDynamicRange, TonemappingMode::ACES}),
    ModeName);

TEST_F(PostProcessGpu, FadesToTheVignettesColourAwayFromItsCentre)
{
    FlatScene flat(45, 21);
    flat.Add({-1, -1}, {46, 22}, 5, Plain({0.8f, 0.5f, 0.25f}));
    Run run(flat);
    const Field base = run.Color(&Nothing());
    for (const bool rounded : {false, true})
    {
        const Field picture = run.Color(&m_Volumes.With(
            [&](VolumeProfile& profile)
            {
                Vignette& vignette = profile.Add<Vignette>();
                vignette.intensity.Override(0.5f);
                vignette.smoothness.Override(0.4f);
                vignette.center.Override({0.3f, 0.8f}); // left, and above the middle
                vignette.color.Override({0.1f, 0.0f, 0.5f, 1.0f});
                vignette.rounded.Override(rounded);
            }));
        const auto faded = [&](const glm::dvec3& color, double u, double v)
        {
            const double x = (u - 0.3) * 1.5 * (rounded ? 45.0 / 21.0 : 1.0);
            const double y = (v - 0.2) * 1.5;
            const double kept = std::pow(std::clamp(1.0 - x * x - y * y, 0.0, 1.0), 2.0);
            return color * glm::mix(glm::dvec3(0.1, 0.0, 0.5), glm::dvec3(1.0), kept);
        };
        ExpectNear(picture, PerPixel(base, faded), glm::dvec3(1e-3), 1e-3); // lavapipe's pow
    }
}

struct BloomCase
{
    const char* name;
    glm::ivec2 size;
    BloomLook look;
};

class PostProcessBloomGpu : public PostProcessGpu, public testing::WithParamInterface<BloomCase>
{
};

TEST_P(PostProcessBloomGpu, IsWhatTheFormulasSayInDouble)
{
    const glm::ivec2 size = GetParam().size;
    const BloomLook& look = GetParam().look;
    FlatScene flat(size.x, size.y);
    const glm::vec2 middle = flat.size * 0.5f;
    flat.Add({0, 0}, middle, 6, Plain({0.05f, 0.1f, 0.2f}));
    flat.Add(middle - 3.0f, middle + 2.0f, 5, Plain({6.0f, 2.5f, 0.3f}));
    flat.Add({2, 3}, {3, 4}, 5, Plain({90.0f, 90.0f, 90.0f}));
    Run run(flat);
    const Field base = run.Color(&Nothing());
    const Field picture = run.Color(
        &m_Volumes.With([&](VolumeProfile& profile) { look.SetOn(profile.Add<Bloom>()); }));
    const Field glow = BloomReference(base, look);
    int glowing = 0;
    const Field reference = PerPixel(base,
                                     [&](const glm::dvec3& color, double u, double v)
                                     {
                                         const glm::dvec3 sum = color + At(glow, u, v);
                                         glowing += At(glow, u, v).x > 0.02 ? 1 : 0;
                                         return glm::min(sum, 1.0);
                                     });
    EXPECT_GT(glowing, size.x * size.y / 10);
    // Each of the pictures has six bits behind the point, blue five, and a device may cut the rest
    // off: up to a unit.
    const double pictures = 2.0 * BloomMipCount(base, look) - 1.0;
    ExpectNear(picture, reference, pictures * glm::exp2(-glm::dvec3(6, 6, 5)), 2e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Looks, PostProcessBloomGpu,
    testing::Values(BloomCase{"Default", {48, 32}, {}},
                    BloomCase{"HighQuality", {48, 32}, {.isHighQuality = true}},
                    BloomCase{"OddSize", {37, 23}, {.isHighQuality = true}},
                    BloomCase{"Quarter", {64, 40}, {.quarter = true, .maxIterations = 3}},
                    BloomCase{"Tinted", {41, 33}, {.scatter = 0.2, .tint = {1.0, 0.5, 0.25}}},
                    BloomCase{"OneTexel", {5, 5}, {.threshold = 0.2}},
                    BloomCase{"Clamped", {32, 32}, {.clamp = 2.0, .maxIterations = 2}}),
    [](const auto& bloom) { return std::string(bloom.param.name); });

TEST_F(PostProcessGpu, MakesNumbersOfWhatIsNone)
{
    FlatScene flat(32, 24);
    flat.Add({0, 0}, {32, 24}, 6, Plain({0.2f, 0.3f, 0.4f}));
    GameObject& patch = flat.Add({10, 10}, {12, 12}, 5, nullptr);
    Run run(flat, ColorGradingMode::HighDynamicRange);
    for (const auto tonemapping : {TonemappingMode::Neutral, TonemappingMode::ACES})
    {
        const VolumeStack& effects = m_Volumes.With(
            [&](VolumeProfile& profile)
            {
                profile.Add<Bloom>().intensity.Override(1.0f);
                profile.Add<Tonemapping>().mode.Override(tonemapping);
                profile.Add<ColorAdjustments>().contrast.Override(50.0f);
            });
        const auto drawn = [&](const char* patchIs)
        {
            patch.renderer->sharedMaterials = {Strange(patchIs)};
            return run.Color(&effects).values;
        };
        const std::vector<double> black = drawn("0.0");
        const std::vector<double> brightest = drawn("65504.0");
        EXPECT_NE(black, brightest);
        EXPECT_EQ(drawn("asfloat(0x7FC00000u)"), black) << "NaN";
        EXPECT_EQ(drawn("-5.0"), black);
        // The sampler makes NaN of infinity and its neighbours, so that its glow depends on the
        // device: all it may not do is leave the range.
        for (const auto& values : {black, brightest, drawn("asfloat(0x7F800000u)")})
        {
            EXPECT_TRUE(std::ranges::all_of(values, [](double v) { return v >= 0.0 && v <= 1.0; }));
        }
    }
}

std::vector<std::string> PassNames(const RenderResult& result)
{
    std::vector<std::string> names;
    for (const CompiledRenderPass& pass : result.frame->passes)
    {
        names.push_back(pass.name);
    }
    return names;
}

TEST_F(PostProcessGpu, CostsNothingWhileNoEffectIsOn)
{
    const FlatScene flat = Patches();
    PictureRun plain(flat.scene, flat.camera, 50, 26);
    plain.Render(&Nothing(), true);
    Run run(flat);
    run.Render(&Nothing(), true);
    EXPECT_EQ(PassNames(run.result()), PassNames(plain.result()));
    EXPECT_THAT(
        run.result().report.notes,
        testing::Contains(Mentions("PostProcessRendererFeature", "not drawn", "no volume", "Bloom",
                                   "Vignette", "ColorAdjustments", "Tonemapping")));
}

TEST_F(PostProcessGpu, IsLeftToTheCamera)
{
    FlatScene flat = Patches();
    flat.camera.renderPostProcessing = false;
    Run run(flat);
    const auto fill = [](VolumeProfile& profile)
    {
        profile.Add<Tonemapping>().mode.Override(TonemappingMode::ACES);
    };
    run.Render(&m_Volumes.With(fill), true);
    EXPECT_THAT(run.result().report.notes,
                testing::Contains(Mentions("PostProcessRendererFeature", "not drawn",
                                           "renderPostProcessing is off")));
    run.Render(&Nothing(), true);
    EXPECT_THAT(run.result().report.notes, testing::IsEmpty()) << "no volume asks for it either";
    flat.camera.renderPostProcessing = true;
    run.Render(&m_Volumes.With(fill), true);
    EXPECT_THAT(run.result().report.notes, testing::IsEmpty());
}

class FxaaGpu : public PostProcessGpu
{
protected:
    /// Slanted bars, a dark patch, single texels and colours beyond white.
    static FlatScene Edges()
    {
        FlatScene flat(67, 45);
        flat.Add({0, 0}, {67, 45}, 9, Plain({0.05f, 0.1f, 0.2f}));
        for (int i = 0; i < 24; ++i)
        {
            const glm::vec2 corner(2 + 2 * i, 8 + i / 3);
            flat.Add(corner, corner + glm::vec2(2, 9), 7, Plain({0.9f, 0.8f, 0.2f}));
            const glm::vec2 steep(40 + i / 4, 19 + i);
            flat.Add(steep, steep + glm::vec2(12, 1), 6, Plain({4.0f, 0.3f, 0.1f}));
        }
        // A faint edge with bright texels on it, which only the wide blur meets.
        flat.Add({0, 39}, {40, 45}, 8, Plain({0.07f, 0.13f, 0.25f}));
        for (int i = 0; i < 9; ++i)
        {
            const glm::vec2 dot(3 + 4 * i, 38);
            flat.Add(dot, dot + 1.0f, 5, Plain({1.0f, 1.0f, 1.0f}));
        }
        flat.Add({20, 28}, {28, 36}, 5, Plain({0.01f, 0.02f, 0.01f}));
        flat.camera.antialiasing = AntialiasingMode::FastApproximateAntialiasing;
        return flat;
    }
};

TEST_F(FxaaGpu, IsWhatTheFormulasSayInDouble)
{
    FlatScene flat = Edges();
    Run run(flat);
    run.Render(&Nothing());
    const Field picture = run.Rows("_CameraColorAttachmentB");
    const Field base = run.Rows("_CameraColorAttachmentA");
    // Samplers have eight bits for the place between two texels, colours eleven.
    constexpr double k_Allowed = 1.0 / 256.0 + 1e-3;
    int changed = 0;
    int narrow = 0;
    for (int y = 0; y < base.height; ++y)
    {
        for (int x = 0; x < base.width; ++x)
        {
            const SmoothedPixel wanted = SmoothReference(base, x, y);
            const auto distance = [&](const glm::dvec3& color)
            {
                double largest = 0.0;
                for (int channel = 0; channel < 3; ++channel)
                {
                    largest =
                        std::max(largest, std::abs(picture.At(x, y, channel) - color[channel]));
                }
                return largest;
            };
            const bool mayBeWide = wanted.margin > -k_Allowed;
            const bool mayBeNarrow = wanted.margin < k_Allowed;
            const double nearest = std::min(mayBeWide ? distance(wanted.wide) : 1.0,
                                            mayBeNarrow ? distance(wanted.narrow) : 1.0);
            ASSERT_LE(nearest, k_Allowed) << x << ", " << y;
            changed += distance({base.At(x, y, 0), base.At(x, y, 1), base.At(x, y, 2)}) > 0.02;
            narrow += !mayBeWide;
        }
    }
    EXPECT_GT(changed, 200);
    EXPECT_GT(narrow, 5);
}

TEST_F(FxaaGpu, IsDrawnBehindAllPassesAndOnlyWhereACameraAsksForIt)
{
    FlatScene flat = Edges();
    Run run(flat);
    const VolumeStack& toned =
        m_Volumes.With([](VolumeProfile& profile)
                       { profile.Add<Tonemapping>().mode.Override(TonemappingMode::Neutral); });
    const auto passes = [&](const VolumeStack& stack)
    {
        run.Render(&stack, true);
        return PassNames(run.result());
    };
    EXPECT_THAT(passes(toned).back(), testing::HasSubstr("FXAA"));
    EXPECT_THAT(passes(Nothing()).back(), testing::HasSubstr("FXAA"));
    EXPECT_THAT(run.result().report.notes, testing::IsEmpty());
    flat.camera.renderPostProcessing = false;
    EXPECT_THAT(passes(Nothing()), testing::Not(testing::Contains(testing::HasSubstr("FXAA"))));
    flat.camera.renderPostProcessing = true;
    flat.camera.antialiasing = AntialiasingMode::None;
    EXPECT_THAT(passes(Nothing()), testing::Not(testing::Contains(testing::HasSubstr("FXAA"))));
}

TEST_F(FxaaGpu, SmoothsAStackOfCamerasOnceAsTheBaseCameraSays)
{
    FlatScene flat = Edges();
    const auto overlay = std::make_shared<Camera>(flat.camera);
    overlay->renderType = CameraRenderType::Overlay;
    overlay->antialiasing = AntialiasingMode::None;
    overlay->renderPostProcessing = false;
    flat.camera.cameraStack = {overlay};
    Run run(flat);
    run.Render(&Nothing(), true);
    EXPECT_EQ(std::ranges::count_if(PassNames(run.result()), [](const std::string& pass)
                                    { return pass.find("FXAA") != pass.npos; }),
              1);
    EXPECT_THAT(PassNames(run.result()).back(), testing::HasSubstr("FXAA"));
}

} // namespace
} // namespace limn::test
