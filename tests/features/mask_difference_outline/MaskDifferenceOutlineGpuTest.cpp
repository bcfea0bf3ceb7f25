#include "features/color_edges/PictureRun.h"

#include <limits>
#include <limn/features/MaskDifferenceOutlineRendererFeature.h>
#include <random>

namespace limn::test
{
namespace
{

constexpr int k_OutlinedLayer = 9;
constexpr double k_Near = 1.0;
constexpr double k_Far = 11.0;

/// A rectangle as FlatScene places it.
struct Rectangle
{
    glm::ivec2 low;
    glm::ivec2 high;
    double depth;
    bool isOutlined;
};

/// What is in front at a pixel, which may lie outside of the picture; -1 = nothing.
int FrontAt(const std::vector<Rectangle>& rectangles, int x, int y, bool onlyOutlined)
{
    int front = -1;
    for (std::size_t i = 0; i < rectangles.size(); ++i)
    {
        const Rectangle& r = rectangles[i];
        const bool isHere = x >= r.low.x && x < r.high.x && y >= r.low.y && y < r.high.y &&
                            (r.isOutlined || !onlyOutlined);
        if (isHere && (front < 0 || r.depth < rectangles[static_cast<std::size_t>(front)].depth))
        {
            front = static_cast<int>(i);
        }
    }
    return front;
}

struct MaskLook
{
    double width = 2.0;
    double threshold = 2.0;
    double distance = 0.0; ///< metres; 0 = no limit
};

/// 0 at the near plane, 1 at the far one.
double DepthAt(double distance, bool orthographic)
{
    return orthographic ? (distance - k_Near) / (k_Far - k_Near)
                        : k_Far * (distance - k_Near) / (distance * (k_Far - k_Near));
}

bool IsClipped(const MaskLook& look, double distance, bool orthographic)
{
    return DepthAt(distance, orthographic) >= look.threshold ||
           (look.distance > 0.0 && distance >= look.distance);
}

class MaskDifferenceOutlineGpu : public GpuTest
{
protected:
    /// Green lines.
    const VolumeStack& With(const MaskLook& look)
    {
        return m_Volumes.With(
            [&](MaskDifferenceOutline& outline)
            {
                outline.m_OutlineColor.Override(Color::green);
                outline.m_OutlineWidth.Override(static_cast<float>(look.width));
                outline.outline_depth_threshold_clip_player.Override(
                    static_cast<float>(look.threshold));
                outline.m_ClipDistance.Override(static_cast<float>(look.distance));
            });
    }

    static MaskDifferenceOutlineSettings Settings(OutlineGrouping grouping)
    {
        MaskDifferenceOutlineSettings settings;
        settings.m_LayerMask = LayerMask::FromIndex(k_OutlinedLayer);
        settings.m_Grouping = grouping;
        return settings;
    }

    /// The picture of a flat scene.
    struct Outlined : PictureRun
    {
        explicit Outlined(const FlatScene& flat, const MaskDifferenceOutlineSettings& settings =
                                                     Settings(OutlineGrouping::PerObject))
            : PictureRun(flat.scene, flat.camera, static_cast<int>(flat.size.x),
                         static_cast<int>(flat.size.y))
        {
            Add(std::make_unique<MaskDifferenceOutlineRendererFeature>(settings));
        }
    };

    static void Add(FlatScene& flat, const Rectangle& r,
                    const glm::vec3& color = {0.1f, 0.2f, 0.3f})
    {
        flat.Add(r.low, r.high, static_cast<float>(r.depth), Plain(color)).layer =
            r.isOutlined ? k_OutlinedLayer : 0;
    }

    BlendedComponent<MaskDifferenceOutline> m_Volumes;
};

/// Rectangles anywhere, partly or wholly outside of the picture, no two of one depth.
std::vector<Rectangle> RandomRectangles(int width, int height, std::mt19937& random)
{
    std::vector<Rectangle> rectangles;
    for (int i = 0; i < 14; ++i)
    {
        const auto between = [&](int low, int high)
        {
            return std::uniform_int_distribution<int>(low, high)(random);
        };
        const glm::ivec2 low(between(-width / 4 - 1, width + 1),
                             between(-height / 4 - 1, height + 1));
        const glm::ivec2 size(between(1, 1 + width / 2), between(1, 1 + height / 2));
        rectangles.push_back({low, low + size, 2.0 + 0.5 * i, i % 3 != 0});
    }
    return rectangles;
}

/// A line wherever one of the four neighbours shows another object than the pixel itself.
Field Reference(const Field& base, const std::vector<Rectangle>& rectangles, const MaskLook& look,
                bool orthographic)
{
    Field result = base;
    const int w = static_cast<int>(look.width);
    for (int y = 0; y < base.height; ++y)
    {
        for (int x = 0; x < base.width; ++x)
        {
            const int center = FrontAt(rectangles, x, y, true);
            bool isEdge = false;
            bool hasColor = false;
            for (const glm::ivec2 tap : {glm::ivec2(0, -w), {0, w}, {-w, 0}, {w, 0}})
            {
                const int other = FrontAt(rectangles, x + tap.x, y + tap.y, true);
                isEdge = isEdge || other != center;
                hasColor = hasColor || other >= 0;
            }
            const int seen = FrontAt(rectangles, x, y, false);
            const double distance =
                seen < 0 ? k_Far : rectangles[static_cast<std::size_t>(seen)].depth;
            const bool hasLine = isEdge && hasColor && !IsClipped(look, distance, orthographic);
            result.At(x, y, 1) += hasLine ? 1.0 : 0.0;
        }
    }
    return result;
}

class MaskDifferenceOutlineAtSizeGpu : public MaskDifferenceOutlineGpu,
                                       public testing::WithParamInterface<std::pair<int, int>>
{
};

TEST_P(MaskDifferenceOutlineAtSizeGpu, AgreesWithTheReferenceForEveryDepthAndCamera)
{
    const auto [width, height] = GetParam();
    std::mt19937 random(3);
    int lines = 0; // pixels of all pictures
    for (const bool orthographic : {true, false})
    {
        // Rectangles are 2, 2.5, 3 ... 8.5 m away; the background counts as the far plane.
        const double near = DepthAt(3.25, orthographic);
        const double far = DepthAt(6.75, orthographic);
        const MaskLook looks[] = {
            {1},           {2}, {5}, {3, 1.0}, {3, near}, {7, far}, {2, 2.0, 4.25}, {2, near, 6.75},
            {2, far, 3.25}};
        const std::vector<Rectangle> rectangles = RandomRectangles(width, height, random);
        FlatScene flat(width, height);
        if (!orthographic)
        {
            flat.MakePerspective();
        }
        for (const Rectangle& r : rectangles)
        {
            Add(flat, r, {0.03f * static_cast<float>(r.depth), 0.2f, 0.3f});
        }
        Outlined inPlace(flat);
        auto settings = Settings(OutlineGrouping::PerObject);
        settings.m_FramebufferFetch = false;
        Outlined fromTexture(flat, settings);
        const Field base = inPlace.Color(nullptr);
        for (const MaskLook& look : looks)
        {
            const Field picture = inPlace.Color(&With(look));
            EXPECT_GE(ShareWithinTwo(picture, Reference(base, rectangles, look, orthographic)),
                      0.999)
                << look.width << ", threshold " << look.threshold << ", " << look.distance << " m";
            lines += CountDifferent(picture, base);
            // Blending may round the sum otherwise than the conversion of what a shader writes.
            EXPECT_LE(LargestDifferenceInHalfSteps(fromTexture.Color(&With(look)), picture), 1.0);
        }
    }
    EXPECT_GT(lines, width * height);
}

INSTANTIATE_TEST_SUITE_P(Sizes, MaskDifferenceOutlineAtSizeGpu,
                         testing::Values(std::pair(64, 48), std::pair(61, 37), std::pair(33, 65),
                                         std::pair(1, 1), std::pair(1, 19), std::pair(19, 1)),
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" +
                                    std::to_string(size.param.second);
                         });

TEST_F(MaskDifferenceOutlineGpu, DrawsALineOfItsWidthOnBothSidesOfASilhouette)
{
    FlatScene flat(40, 32);
    const Rectangle r{{12, 10}, {28, 22}, 5, true};
    Add(flat, r);
    Outlined run(flat);
    for (int width = 1; width <= 5; ++width)
    {
        const Field picture = run.Color(&With({static_cast<double>(width)}));
        for (int x = 0; x < 40; ++x)
        {
            const bool isLine = std::abs(x + 0.5 - 12) < width || std::abs(x + 0.5 - 28) < width;
            const double base = x >= 12 && x < 28 ? 0.2 : 0.0;
            EXPECT_NEAR(picture.At(x, 16, 1), base + (isLine ? 1.0 : 0.0), 1e-3)
                << width << ", " << x;
        }
    }
}

TEST_F(MaskDifferenceOutlineGpu, DrawsNoLineAlongTheBorderOfThePicture)
{
    FlatScene flat(24, 16);
    Add(flat, {{-40, -40}, {64, 56}, 5, true});
    Outlined run(flat);
    const Field base = run.Color(nullptr);
    for (const double width : {1.0, 5.0, 13.0})
    {
        EXPECT_EQ(CountDifferent(run.Color(&With({width})), base), 0) << width;
    }
}

//   object │ picture          the object ends 2 pixels outside, a line of 4 begins there
TEST_F(MaskDifferenceOutlineGpu, OutlinesIntoThePictureWhatLiesJustOutside)
{
    FlatScene flat(24, 16);
    Add(flat, {{-6, 4}, {-2, 12}, 5, true});
    const Field picture = Outlined(flat).Color(&With({4.0}));
    for (int y = 0; y < 16; ++y)
    {
        for (int x = 0; x < 24; ++x)
        {
            EXPECT_EQ(picture.At(x, y, 1), x < 2 && y >= 4 && y < 12 ? 1.0 : 0.0) << x << ", " << y;
        }
    }
}

/// Pixels with a line in a row through the middle of three rectangles side by side, of which the
/// last two are children of one object.
std::vector<int> LinesThrough(PictureRun& run, const VolumeStack& stack)
{
    const Field base = run.Color(nullptr);
    const Field picture = run.Color(&stack);
    std::vector<int> lines;
    for (int x = 0; x < picture.width; ++x)
    {
        if (picture.At(x, 8, 1) != base.At(x, 8, 1))
        {
            lines.push_back(x);
        }
    }
    return lines;
}

TEST_F(MaskDifferenceOutlineGpu, DrawsLinesBetweenGroupsThatTouch)
{
    FlatScene flat(40, 16);
    Add(flat, {{4, 2}, {14, 14}, 5, true});
    Add(flat, {{14, 2}, {24, 14}, 5, true});
    Add(flat, {{24, 2}, {34, 14}, 5, true});
    const auto& objects = flat.scene.objects();
    GameObject& parent = flat.scene.Add("parent");
    objects[1]->transform.parent = &parent.transform;
    objects[2]->transform.parent = &parent.transform;
    const std::pair<OutlineGrouping, std::vector<int>> cases[] = {
        {OutlineGrouping::Together, {3, 4, 33, 34}},
        {OutlineGrouping::PerGroup, {3, 4, 13, 14, 33, 34}},
        {OutlineGrouping::PerObject, {3, 4, 13, 14, 23, 24, 33, 34}}};
    for (const auto& [grouping, lines] : cases)
    {
        Outlined run(flat, Settings(grouping));
        EXPECT_EQ(LinesThrough(run, With({1.0})), lines) << static_cast<int>(grouping);
    }
}

// The third of five, amid the others: the mean of 1, 2, 4 and 5 is 3, so that ids that count up
// would hide it.
TEST_F(MaskDifferenceOutlineGpu, DrawsLinesAroundWhatLiesInTheMiddleOfOthers)
{
    FlatScene flat(9, 9);
    const std::vector<Rectangle> rectangles{{{1, 4}, {4, 5}, 5, true},
                                            {{5, 4}, {8, 5}, 5, true},
                                            {{4, 4}, {5, 5}, 5, true},
                                            {{4, 1}, {5, 4}, 6, true},
                                            {{4, 5}, {5, 8}, 6, true}};
    for (const Rectangle& r : rectangles)
    {
        Add(flat, r);
    }
    Outlined run(flat);
    const Field base = run.Color(nullptr);
    const MaskLook look{1.0};
    EXPECT_EQ(ShareWithinTwo(run.Color(&With(look)), Reference(base, rectangles, look, true)), 1.0);
}

TEST_F(MaskDifferenceOutlineGpu, GivesEachGroupItsColourWhereAsked)
{
    FlatScene flat(40, 16);
    for (int i = 0; i < 3; ++i)
    {
        Add(flat, {{4 + 12 * i, 4}, {12 + 12 * i, 12}, 5, true}, {0, 0, 0});
    }
    auto settings = Settings(OutlineGrouping::PerObject);
    settings.m_ColorByGroup = true;
    const Field picture = Outlined(flat, settings).Color(&With({1.0}));
    for (int i = 0; i < 3; ++i)
    {
        for (int channel = 0; channel < 3; ++channel)
        {
            EXPECT_NEAR(picture.At(4 + 12 * i, 8, channel), ColorOfGroup(i)[channel], 2.0 / 255.0);
        }
    }
}

TEST_F(MaskDifferenceOutlineGpu, DrawsTheSameForACameraOfFourSamples)
{
    FlatScene flat(24, 16);
    Add(flat, {{4, 4}, {14, 12}, 5, true});
    Add(flat, {{10, 6}, {20, 14}, 6, true});
    for (const bool framebufferFetch : {true, false})
    {
        auto settings = Settings(OutlineGrouping::PerObject);
        settings.m_FramebufferFetch = framebufferFetch;
        Outlined run(flat, settings);
        const Field one = run.Color(&With({2.0}));
        run.SetSamples(4);
        EXPECT_EQ(CountDifferent(run.Color(&With({2.0})), one), 0) << framebufferFetch;
    }
}

TEST_F(MaskDifferenceOutlineGpu, KeepsWhatIsNoNumberWhereItIs)
{
    FlatScene flat(24, 16);
    Add(flat, {{4, 4}, {14, 12}, 5, true});
    Outlined run(flat);
    const Field without = run.Color(&With({2.0}));
    flat.Add({3, 6}, {5, 8}, 3, Strange("asfloat(0x7FC00000u)"));
    const Field with = run.Color(&With({2.0}));
    for (int y = 0; y < 16; ++y)
    {
        for (int x = 0; x < 24; ++x)
        {
            const bool isStrange = x >= 3 && x < 5 && y >= 6 && y < 8;
            EXPECT_TRUE(isStrange || with.At(x, y, 1) == without.At(x, y, 1)) << x << ", " << y;
        }
    }
}

TEST_F(MaskDifferenceOutlineGpu, TakesEveryWidthFromTheWidestOnForTheWidest)
{
    FlatScene flat(24, 16);
    Add(flat, {{4, 4}, {14, 12}, 5, true});
    Outlined run(flat);
    const Field widest = run.Color(&With({256.0}));
    for (const double width : {257.0, 1e6, static_cast<double>(std::numeric_limits<float>::max())})
    {
        EXPECT_EQ(CountDifferent(run.Color(&With({width})), widest), 0) << width;
    }
}

TEST_F(MaskDifferenceOutlineGpu, DrawsTheSameWhereTheFrameCompilerLeavesThingsOut)
{
    FlatScene flat(96, 64);
    Add(flat, {{20, 20}, {40, 40}, 5, true});
    for (const bool framebufferFetch : {true, false})
    {
        auto settings = Settings(OutlineGrouping::Together);
        settings.m_FramebufferFetch = framebufferFetch;
        Outlined run(flat, settings);
        const VolumeStack& stack = With({3.0});
        run.Render(&stack, true);
        const Image lean = SharedDevice().ReadBack(*run.result().output.rt());
        run.Render(&stack, false);
        EXPECT_EQ(lean, SharedDevice().ReadBack(*run.result().output.rt())) << framebufferFetch;
    }
}

} // namespace
} // namespace limn::test
