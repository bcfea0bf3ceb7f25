#include "features/OutlineScene.h"
#include "features/color_edges/PictureRun.h"

#include <array>
#include <limits>
#include <limn/features/ColorEdgesRendererFeature.h>

namespace limn::test
{
namespace
{

constexpr EdgeOperator k_Operators[] = {EdgeOperator::Roberts, EdgeOperator::Sobel,
                                        EdgeOperator::Prewitt};

struct EdgeLook
{
    EdgeOperator edgeOperator = EdgeOperator::Sobel;
    double width = 2.0;
    double threshold = 0.1;
    double softness = 0.0;
    double alpha = 1.0; ///< of the colour, which is red
};

/// What the README says a pixel is worth, of what it says the picture is.
double ReferenceBrightness(const Field& base, int x, int y)
{
    double luminance = 0.0;
    constexpr std::array<double, 3> weights{0.2126, 0.7152, 0.0722};
    for (int channel = 0; channel < 3; ++channel)
    {
        const double value = base.At(x, y, channel);
        const double shown = std::isnan(value) ? 0.0 : std::clamp(value, 0.0, 1.0);
        luminance += weights[static_cast<std::size_t>(channel)] * shown;
    }
    return std::sqrt(luminance);
}

/// Taps so far before a pixel and so far behind it: whole widths are split, the larger half behind;
/// a width in between is as far in between.
std::pair<double, double> ReferenceTaps(double width)
{
    const double below = std::floor(width);
    const double part = width - below;
    const double before = std::floor(below / 2) * (1 - part) + std::floor((below + 1) / 2) * part;
    const double behind = std::ceil(below / 2) * (1 - part) + std::ceil((below + 1) / 2) * part;
    return {before, behind};
}

double ReferenceGradient(const Field& brightness, const EdgeLook& look, int x, int y)
{
    const auto [before, behind] = ReferenceTaps(look.width);
    const std::array<double, 3> place{-before, (behind - before) / 2, behind};
    const auto at = [&](std::size_t column, std::size_t row)
    {
        return brightness.Sample((x + 0.5 + place[column]) / brightness.width,
                                 (y + 0.5 + place[row]) / brightness.height);
    };
    if (look.edgeOperator == EdgeOperator::Roberts)
    {
        return std::hypot(at(0, 0) - at(2, 2), at(2, 0) - at(0, 2)) / std::sqrt(2.0);
    }
    const double w = look.edgeOperator == EdgeOperator::Sobel ? 2.0 : 1.0;
    const double across = at(2, 0) - at(0, 0) + w * (at(2, 1) - at(0, 1)) + at(2, 2) - at(0, 2);
    const double down = at(0, 2) - at(0, 0) + w * (at(1, 2) - at(1, 0)) + at(2, 2) - at(2, 0);
    return std::hypot(across, down) / (2.0 + w);
}

/// Red over the picture without lines, where the lines are.
Field Reference(const Field& base, const EdgeLook& look)
{
    Field brightness{base.width, base.height, 1, {}};
    for (int y = 0; y < base.height; ++y)
    {
        for (int x = 0; x < base.width; ++x)
        {
            brightness.values.push_back(ReferenceBrightness(base, x, y));
        }
    }
    Field result = base;
    for (int y = 0; y < base.height; ++y)
    {
        for (int x = 0; x < base.width; ++x)
        {
            const double above = ReferenceGradient(brightness, look, x, y) - look.threshold;
            const double hard = above > 0.0 ? 1.0 : 0.0;
            const double soft = std::clamp(above / std::max(look.softness, 1e-9), 0.0, 1.0);
            const double strength = look.alpha * (look.softness > 0.0 ? soft : hard);
            for (int channel = 0; channel < 3; ++channel)
            {
                const double line = channel == 0 ? 1.0 : 0.0;
                result.At(x, y, channel) += (line - base.At(x, y, channel)) * strength;
            }
        }
    }
    return result;
}

/// The reference, and of pixels whose gradient is as near to the threshold as a step of the 8-bit
/// weights by which lavapipe filters, what the picture has of both sides.
Field ReferenceFor(const Field& picture, const Field& base, const EdgeLook& look)
{
    constexpr double k_Step = 1.0 / 256.0;
    Field nearest = Reference(base, look);
    for (const double step : {-k_Step, k_Step})
    {
        EdgeLook other = look;
        other.threshold += step;
        const Field reference = Reference(base, other);
        for (std::size_t i = 0; i < nearest.values.size(); ++i)
        {
            const double value = picture.values[i];
            if (std::abs(value - reference.values[i]) < std::abs(value - nearest.values[i]))
            {
                nearest.values[i] = reference.values[i];
            }
        }
    }
    return nearest;
}

class ColorEdgesGpu : public GpuTest
{
protected:
    const VolumeStack& With(const EdgeLook& look)
    {
        return m_Volumes.With(
            [&](ColorEdges& edges)
            {
                edges.m_OutlineColor.Override(Color{1, 0, 0, static_cast<float>(look.alpha)});
                edges.m_OutlineWidth.Override(static_cast<float>(look.width));
                edges.m_Operator.Override(look.edgeOperator);
                edges.m_Threshold.Override(static_cast<float>(look.threshold));
                edges.m_Softness.Override(static_cast<float>(look.softness));
            });
    }

    static void AddEdges(PictureRun& run, bool onlyFiltered = false)
    {
        ColorEdgesSettings settings;
        settings.m_OnlyFilteredObjects = onlyFiltered;
        settings.m_LayerMask = LayerMask::FromIndex(k_FurnitureLayer);
        run.Add(std::make_unique<ColorEdgesRendererFeature>(settings));
    }

    /// Draws a flat scene with lines.
    struct Lines : PictureRun
    {
        explicit Lines(const FlatScene& flat, bool onlyFiltered = false)
            : PictureRun(flat.scene, flat.camera, static_cast<int>(flat.size.x),
                         static_cast<int>(flat.size.y))
        {
            AddEdges(*this, onlyFiltered);
        }
    };

    BlendedComponent<ColorEdges> m_Volumes;
};

class ColorEdgesAtSizeGpu : public ColorEdgesGpu,
                            public testing::WithParamInterface<std::pair<int, int>>
{
};

TEST_P(ColorEdgesAtSizeGpu, AgreesWithTheDoublePrecisionReference)
{
    OutlineScene content;
    PictureRun run(content.scene, content.camera, GetParam().first, GetParam().second);
    AddEdges(run);
    const Field base = run.ColorRows(nullptr);
    for (const EdgeOperator edgeOperator : k_Operators)
    {
        for (const double width : {0.5, 1.0, 2.0, 3.0, 4.7})
        {
            for (const double softness : {0.0, 0.3})
            {
                const EdgeLook look{edgeOperator, width, 0.1, softness, 0.75};
                const Field picture = run.ColorRows(&With(look));
                const Field reference = ReferenceFor(picture, base, look);
                EXPECT_GE(ShareWithinTwo(picture, reference), 0.999)
                    << static_cast<int>(edgeOperator) << ", width " << width << ", softness "
                    << softness;
                const bool isSmall = base.width * base.height < 100;
                EXPECT_TRUE(isSmall || CountDifferent(picture, base) > 50);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ColorEdgesAtSizeGpu,
                         testing::Values(std::pair(96, 64), std::pair(61, 37), std::pair(33, 65),
                                         std::pair(1, 1), std::pair(1, 17), std::pair(17, 1)),
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" +
                                    std::to_string(size.param.second);
                         });

TEST_F(ColorEdgesGpu, AgreesWithTheReferenceForACameraOfFourSamples)
{
    OutlineScene content;
    PictureRun run(content.scene, content.camera, 61, 37);
    run.SetSamples(4);
    AddEdges(run);
    const Field base = run.ColorRows(nullptr);
    const EdgeLook look{EdgeOperator::Sobel, 2.0, 0.1, 0.3, 1.0};
    EXPECT_GE(ShareWithinTwo(run.ColorRows(&With(look)), Reference(base, look)), 0.999);
}

TEST_F(ColorEdgesGpu, DrawsALineAsWideAsAskedAtAStep)
{
    FlatScene flat(32, 9);
    flat.Add({16, 0}, {32, 9}, 5, Plain({0.5f, 0.5f, 0.5f}));
    Lines lines(flat);
    for (const EdgeOperator edgeOperator : k_Operators)
    {
        for (int width = 1; width <= 9; ++width)
        {
            const Field picture = lines.Color(&With({edgeOperator, static_cast<double>(width)}));
            // Half of it, the larger half of an odd one, lies before the step; all rows are alike,
            // those at the border as well.
            const int first = 16 - (width + 1) / 2;
            for (int y = 0; y < 9; ++y)
            {
                for (int x = 0; x < 32; ++x)
                {
                    const bool isLine = x >= first && x < first + width;
                    const double green = isLine || x < 16 ? 0.0 : 0.5;
                    ASSERT_EQ(picture.At(x, y, 1), green) << width << ": " << x << ", " << y;
                    ASSERT_EQ(picture.At(x, y, 0), isLine ? 1.0 : green)
                        << width << ": " << x << ", " << y;
                }
            }
        }
    }
}

TEST_F(ColorEdgesGpu, DrawsNoLineAlongTheBorderOfThePicture)
{
    FlatScene flat(16, 12);
    flat.Add({-8, -8}, {24, 20}, 5, Plain({0.5f, 0.5f, 0.5f}));
    Lines lines(flat);
    for (const EdgeOperator edgeOperator : k_Operators)
    {
        const Field picture = lines.Color(&With({edgeOperator, 7.0, 0.0}));
        EXPECT_EQ(std::ranges::count(picture.values, 0.5), 16 * 12 * 3);
    }
}

// Taps farther away than that look past whatever is in the picture's middle.
TEST_F(ColorEdgesGpu, LosesNoLineToAWidthThatThePictureIsTooSmallFor)
{
    FlatScene flat(96, 64);
    flat.Add({30, 14}, {66, 50}, 5, Plain({0.5f, 0.5f, 0.5f}));
    Lines lines(flat);
    const Field base = lines.Color(nullptr);
    for (const EdgeOperator edgeOperator : k_Operators)
    {
        int least = 1;
        for (double width = 1.0; width < 1e5; width *= 2.0)
        {
            const int drawn = CountDifferent(lines.Color(&With({edgeOperator, width})), base);
            EXPECT_GE(drawn, least) << static_cast<int>(edgeOperator) << ", width " << width;
            least = drawn;
        }
    }
}

TEST_F(ColorEdgesGpu, TakesAWidthBeyondHalfASideOfThePictureForThat)
{
    FlatScene flat(16, 12);
    flat.Add({8, 0}, {16, 12}, 5, Plain({0.5f, 0.5f, 0.5f}));
    Lines lines(flat);
    const Field widest = lines.Color(&With({EdgeOperator::Sobel, 20.0}));
    constexpr double k_Largest = std::numeric_limits<float>::max();
    for (const double width : {21.0, 1e4, 1e30, k_Largest})
    {
        const Field picture = lines.Color(&With({EdgeOperator::Sobel, width}));
        EXPECT_EQ(CountDifferent(picture, widest), 0) << width;
    }
}

// Whatever is brighter than white is white on the screen, and so are its lines.
TEST_F(ColorEdgesGpu, DrawsNoLineBetweenTwoColoursThatTheScreenShowsAlike)
{
    FlatScene flat(16, 12);
    flat.Add({8, 0}, {16, 12}, 5, Plain({9.0f, 30.0f, 1.5f}));
    flat.Add({0, 0}, {8, 12}, 5, Plain({1.0f, 2.0f, 60000.0f}));
    const Field picture = Lines(flat).Color(&With({EdgeOperator::Sobel, 2.0, 0.0}));
    EXPECT_EQ(picture.At(7, 5, 1), 2.0) << "no line over it";
    EXPECT_EQ(picture.At(8, 5, 1), 30.0);
}

/// A patch of `strange` in the middle of a grey picture against one of `ordinary`.
void ExpectSameLines(const Field& strange, const Field& ordinary)
{
    int lines = 0;
    for (int y = 0; y < strange.height; ++y)
    {
        for (int x = 0; x < strange.width; ++x)
        {
            const bool isPatch = x >= 8 && x < 10 && y >= 6 && y < 8;
            for (int channel = 0; channel < 3; ++channel)
            {
                if (!isPatch)
                {
                    ASSERT_EQ(strange.At(x, y, channel), ordinary.At(x, y, channel))
                        << x << ", " << y;
                }
            }
            lines += !isPatch && strange.At(x, y, 0) == 1.0 ? 1 : 0;
        }
    }
    EXPECT_GT(lines, 4);
}

TEST_F(ColorEdgesGpu, KeepsWhatIsNoNumberWhereItIs)
{
    const std::pair<const char*, float> cases[] = {
        {"asfloat(0x7FC00000u)", 0.0f}, // NaN counts as black
        {"asfloat(0xFFC00000u)", 0.0f},
        {"asfloat(0x7F800000u)", 1.0f}, // infinity as white
        {"asfloat(0xFF800000u)", 0.0f}};
    FlatScene flat(20, 14);
    flat.Add({0, 0}, {20, 14}, 5, Plain({0.25f, 0.25f, 0.25f}));
    GameObject& patch = flat.Add({8, 6}, {10, 8}, 4, nullptr);
    Lines lines(flat);
    for (const auto& [strange, ordinary] : cases)
    {
        for (const EdgeOperator edgeOperator : k_Operators)
        {
            const EdgeLook look{edgeOperator, 3.0};
            patch.renderer->sharedMaterials = {Strange(strange)};
            const Field picture = lines.Color(&With(look));
            patch.renderer->sharedMaterials = {Plain(glm::vec3(ordinary))};
            ExpectSameLines(picture, lines.Color(&With(look)));
        }
    }
}

TEST_F(ColorEdgesGpu, LimitsLinesToWhereFilteredObjectsAreSeen)
{
    FlatScene flat(64, 46);
    flat.Add({0, 0}, {64, 46}, 9, Plain({0.1f, 0.1f, 0.1f}));
    flat.Add({44, 34}, {54, 42}, 6, Plain({0.8f, 0.8f, 0.8f})).layer = k_FurnitureLayer;
    flat.Add({50, 32}, {60, 39}, 3, Plain({0.3f, 0.3f, 0.3f})); // before it, but no furniture
    const EdgeLook look{EdgeOperator::Prewitt, 4.0};
    Lines all(flat);
    const Field base = all.Color(nullptr);
    const Field everywhere = all.Color(&With(look));
    const Field limited = Lines(flat, true).Color(&With(look));
    int lines = 0;
    for (int y = 0; y < 46; ++y)
    {
        for (int x = 0; x < 64; ++x)
        {
            const bool isSeen =
                x >= 44 && x < 54 && y >= 34 && y < 42 && !(x >= 50 && x < 60 && y >= 32 && y < 39);
            for (int channel = 0; channel < 3; ++channel)
            {
                EXPECT_EQ(limited.At(x, y, channel), (isSeen ? everywhere : base).At(x, y, channel))
                    << x << ", " << y;
            }
            lines += isSeen && limited.At(x, y, 0) == 1.0 ? 1 : 0;
        }
    }
    EXPECT_GT(lines, 20);
}

TEST_F(ColorEdgesGpu, SmoothsTheBorderOfFilteredObjectsForACameraOfFourSamples)
{
    OutlineScene content;
    PictureRun run(content.scene, content.camera, 64, 48);
    run.SetSamples(4);
    AddEdges(run, true);
    run.Render(&With({EdgeOperator::Sobel, 3.0}));
    int partly = 0;
    for (const double value : run.Texture("_ColorEdgesMask").values)
    {
        EXPECT_NEAR(value * 4.0, std::round(value * 4.0), 4.0 * 0.5 / 255.0) << "whole samples";
        partly += value > 0.1 && value < 0.9 ? 1 : 0;
    }
    EXPECT_GT(partly, 20);
}

TEST_F(ColorEdgesGpu, DrawsTheSameWhereTheFrameCompilerLeavesThingsOut)
{
    FlatScene flat(96, 64);
    flat.Add({0, 0}, {96, 64}, 9, Plain({0.1f, 0.1f, 0.1f}));
    flat.Add({20, 20}, {40, 40}, 6, Plain({0.8f, 0.8f, 0.8f})).layer = k_FurnitureLayer;
    for (const bool onlyFiltered : {false, true})
    {
        Lines run(flat, onlyFiltered);
        const VolumeStack& stack = With({EdgeOperator::Sobel, 5.0});
        run.Render(&stack, true);
        const Image lean = SharedDevice().ReadBack(*run.result().output.rt());
        run.Render(&stack, false);
        EXPECT_EQ(lean, SharedDevice().ReadBack(*run.result().output.rt()));
    }
}

} // namespace
} // namespace limn::test
