#include "cull/ProjectedBounds.h"
#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/FrameCompiler.h>
#include <random>

namespace limn
{
namespace
{

using test::FrameBuilder;
using test::RenderTexturePtr;

/// Where the passes of an outline are drawn, whose objects have bounds.
class LimitedRegion : public testing::Test
{
protected:
    /// mask (100x50) → edges (100x50) → camera (200x100)
    /// @param reach  of the edges, in texels of the mask
    CompiledFrame Outline(const std::vector<std::optional<TargetRegion>>& objects,
                          float reach = 3.0f)
    {
        return CompileFrame(Record(objects, reach), {}, std::vector{m_Camera}, m_Options);
    }

    FrameCommands Record(const std::vector<std::optional<TargetRegion>>& objects,
                         float reach = 3.0f) const
    {
        FrameBuilder frame;
        frame.Bind(m_Camera).Draw(0).Bind(m_Mask).Clear(ClearFlag::Color);
        for (const auto& bounds : objects)
        {
            frame.Draw(1);
            frame.lastDraw().bounds = bounds;
        }
        frame.Bind(m_Edges).Blit(2, {m_Mask}, "0 0 0 1 where", {}, reach);
        frame.Bind(m_Camera).Blit(3, {m_Edges}, "0 0 0 1 where", FrameBuilder::Additive(), 0.0f);
        return frame.Take();
    }

    static std::optional<ViewportRect> ScissorOf(const CompiledRenderPass& pass)
    {
        return std::get<DrawCommand>(pass.commands.back()).scissor;
    }
    static const CompiledRenderPass& PassInto(const CompiledFrame& frame,
                                              const RenderTexturePtr& target)
    {
        return *std::ranges::find_if(frame.passes, [&](const CompiledRenderPass& pass)
                                     { return pass.colors.at(0).texture == target; });
    }

    FrameCompilerOptions m_Options;
    const RenderTexturePtr m_Camera = test::Target("Camera", 200, 100);
    const RenderTexturePtr m_Mask = test::Target("Mask", 100, 50, false, GraphicsFormat::R8_UNorm);
    const RenderTexturePtr m_Edges =
        test::Target("Edges", 100, 50, false, GraphicsFormat::R8_UNorm);
};

// Texels of the mask: 20…30 x 20…25 and 3 + 2 around them; then 2 more for the camera's filter.
TEST_F(LimitedRegion, IsTheBoundsAndTheReachOfEachPass)
{
    const CompiledFrame frame = Outline({TargetRegion{0.2, 0.4, 0.3, 0.5}});
    ASSERT_EQ(3u, frame.passes.size());
    EXPECT_EQ(LoadOp::Clear, PassInto(frame, m_Edges).colors[0].load);
    const ViewportRect edges = ScissorOf(PassInto(frame, m_Edges)).value();
    EXPECT_LE(edges.x, 15);
    EXPECT_GE(edges.x, 15 - 3);
    EXPECT_GE(edges.x + edges.width, 35);
    EXPECT_LE(edges.x + edges.width, 35 + 3);
    EXPECT_LE(edges.y, 15);
    EXPECT_GE(edges.y + edges.height, 30);
    EXPECT_LE(edges.y + edges.height, 30 + 3);
    const ViewportRect camera = ScissorOf(PassInto(frame, m_Camera)).value();
    EXPECT_LE(camera.x, 2 * 13);
    EXPECT_GE(camera.x, 2 * 13 - 3);
    EXPECT_GE(camera.x + camera.width, 2 * 37);
    EXPECT_LE(camera.x + camera.width, 2 * 37 + 3);
}

TEST_F(LimitedRegion, HoldsAllObjects)
{
    const CompiledFrame frame =
        Outline({TargetRegion{0.1, 0.1, 0.2, 0.2}, TargetRegion{0.3, 0.3, 0.4, 0.4}});
    const ViewportRect edges = ScissorOf(PassInto(frame, m_Edges)).value();
    EXPECT_LE(edges.x, 5);
    EXPECT_GE(edges.x + edges.width, 45);
}

TEST_F(LimitedRegion, IsAllOfTheTargetWhereBoundsAreNotKnownOrLarge)
{
    for (const auto& objects : std::vector<std::vector<std::optional<TargetRegion>>>{
             {std::nullopt},
             {TargetRegion{0.2, 0.4, 0.3, 0.5}, std::nullopt},
             {TargetRegion{0.1, 0.0, 0.9, 1.0}}})
    {
        const CompiledFrame frame = Outline(objects);
        EXPECT_EQ(LoadOp::DontCare, PassInto(frame, m_Edges).colors[0].load);
        EXPECT_FALSE(ScissorOf(PassInto(frame, m_Edges)));
        EXPECT_FALSE(ScissorOf(PassInto(frame, m_Camera)));
    }
}

TEST_F(LimitedRegion, IsAllOfTheTargetWhereAPassMayLookAnywhere)
{
    const CompiledFrame frame = Outline({TargetRegion{0.2, 0.4, 0.3, 0.5}}, -1.0f);
    EXPECT_FALSE(ScissorOf(PassInto(frame, m_Edges)));
    EXPECT_FALSE(ScissorOf(PassInto(frame, m_Camera)));
}

TEST_F(LimitedRegion, CanBeSwitchedOff)
{
    m_Options.limitsRegions = false;
    const CompiledFrame frame = Outline({TargetRegion{0.2, 0.4, 0.3, 0.5}});
    EXPECT_FALSE(ScissorOf(PassInto(frame, m_Edges)));
}

TEST_F(LimitedRegion, StaysWithinTheTarget)
{
    const CompiledFrame frame = Outline({TargetRegion{-3.0, 0.9, 0.05, 7.0}});
    const ViewportRect edges = ScissorOf(PassInto(frame, m_Edges)).value();
    EXPECT_EQ(0, edges.x);
    EXPECT_GE(edges.width, 10);
    EXPECT_EQ(50, edges.y + edges.height);
}

/// Frames in which nothing changes but where the objects are seen.
class RegionThatMoves : public LimitedRegion
{
protected:
    std::shared_ptr<const CompiledFrame> Compile(const std::optional<TargetRegion>& object)
    {
        FrameCommands commands = Record({object});
        auto frame = m_Cache.Compile(commands, m_States, std::vector{m_Camera}, m_Options);
        m_States = frame->states;
        return frame;
    }
    ViewportRect Drawn(const TargetRegion& object)
    {
        return ScissorOf(PassInto(*Compile(object), m_Edges)).value();
    }
    static TargetRegion At(double left) { return {left, 0.4, left + 0.2, 0.6}; }

    FrameCache m_Cache;
    TextureStates m_States;
};

TEST_F(RegionThatMoves, IsWorkedOutOnceForASmallWay)
{
    Compile(At(0.3));
    Compile(At(0.3));
    const std::uint64_t moved = Compile(At(0.31))->structure;
    for (const double left : {0.3, 0.32, 0.315, 0.29})
    {
        EXPECT_EQ(moved, Compile(At(left))->structure) << left;
    }
    EXPECT_NE(moved, Compile(At(0.36))->structure);
}

// One that has moved is drawn with a border of 1/32 of the target, which is 3.125 of 100 texels.
TEST_F(RegionThatMoves, IsTheExactOneAgainOnceItRests)
{
    const ViewportRect exact = Drawn(At(0.3));
    Drawn(At(0.3));
    const ViewportRect moved = Drawn(At(0.31));
    EXPECT_LT(moved.x, exact.x + 1);
    EXPECT_GE(moved.x, exact.x + 1 - 4);
    for (int i = 0; i < 20; ++i)
    {
        Drawn(At(0.3));
    }
    EXPECT_EQ(exact, Drawn(At(0.3)));
}

TEST_F(RegionThatMoves, IsNoReasonToCompileWhereNothingIsLimited)
{
    m_Options.limitsRegions = false;
    Compile(At(0.3));
    const std::uint64_t structure = Compile(At(0.3))->structure;
    EXPECT_EQ(structure, Compile(At(0.6))->structure);
    EXPECT_EQ(structure, Compile(std::nullopt)->structure);
}

TEST_F(RegionThatMoves, HoldsTheExactOneAndLittleMore)
{
    std::mt19937 random(20261127);
    std::uniform_real_distribution<double> step(-0.02, 0.02);
    double left = 0.4;
    int kept = 0;
    std::uint64_t last = 0;
    for (int i = 0; i < 2000; ++i)
    {
        left = std::clamp(left + step(random), -0.5, 1.3);
        const auto frame = Compile(At(left));
        kept += frame->structure == last ? 1 : 0;
        last = frame->structure;
        const ViewportRect drawn = ScissorOf(PassInto(*frame, m_Edges)).value();
        const ViewportRect exact = ScissorOf(PassInto(Outline({At(left)}), m_Edges)).value();
        if (exact.width == 0)
        {
            continue;
        }
        // Two borders of 3.125 texels, and one for rounding.
        EXPECT_LE(drawn.x, exact.x) << left;
        EXPECT_GE(drawn.x, exact.x - 8) << left;
        EXPECT_GE(drawn.x + drawn.width, exact.x + exact.width) << left;
        EXPECT_LE(drawn.x + drawn.width, exact.x + exact.width + 8) << left;
        EXPECT_LE(drawn.y, exact.y) << left;
        EXPECT_GE(drawn.y + drawn.height, exact.y + exact.height) << left;
    }
    EXPECT_GT(kept, 1000) << "hardly any frame was kept";
}

// A camera at the origin looking along -z in view space: x and y of a point at distance d are
// ±d at the borders of a field of view of 90 degrees.
TEST(ProjectedBounds, HoldTheCornersAsTheyAreSeen)
{
    glm::mat4 projection(0.0f);
    projection[0][0] = 1.0f;
    projection[1][1] = 1.0f;
    projection[2][3] = -1.0f;
    projection[3][2] = 0.3f;
    const Bounds bounds{{0, 0, 0}, {1, 2, 1}};
    const auto at = [&](float x, float y, float z)
    {
        return ProjectBounds(bounds, std::numeric_limits<float>::infinity(),
                             glm::translate(glm::mat4(1.0f), {x, y, z}), projection);
    };
    const TargetRegion ahead = at(0, 0, -5).value(); // nearest at distance 4
    EXPECT_NEAR(0.5 - 0.5 * 1 / 4, ahead.left, 1e-6);
    EXPECT_NEAR(0.5 + 0.5 * 1 / 4, ahead.right, 1e-6);
    EXPECT_NEAR(0.5 - 0.5 * 2 / 4, ahead.top, 1e-6);
    EXPECT_NEAR(0.5 + 0.5 * 2 / 4, ahead.bottom, 1e-6);
    const TargetRegion above = at(0, 10, -5).value(); // y 8…12 at distances 4…6
    EXPECT_NEAR(0.5 - 0.5 * 12 / 4, above.top, 1e-6);
    EXPECT_NEAR(0.5 - 0.5 * 8 / 6, above.bottom, 1e-6);
    EXPECT_FALSE(at(0, 0, -0.5f)) << "a part of it is behind the camera";
    EXPECT_FALSE(at(0, 0, 5));
}

// Thousands of points of the sphere, one by one, for matrices that make ellipsoids of it.
TEST(ProjectedBounds, AreThoseOfTheSphereWhereItIsTheSmaller)
{
    std::vector<glm::dvec3> ways; // spread evenly over the sphere
    for (int step = 0; step < 40'000; ++step)
    {
        const double z = 2.0 * (step + 0.5) / 40'000 - 1.0;
        const double angle = 2.399963229728653 * step; // the golden one
        const double around = std::sqrt(1 - z * z);
        ways.emplace_back(around * std::cos(angle), around * std::sin(angle), z);
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1.0f, 1.0f);
    for (int i = 0; i < 100; ++i)
    {
        glm::mat4 projection = i % 3 == 0 ? glm::ortho(-3.0f, 3.0f, -2.0f, 2.0f, 1.0f, 50.0f)
                                          : glm::perspective(1.0f, 1.5f, 0.1f, 100.0f);
        glm::mat4 matrix =
            glm::translate(glm::mat4(1.0f), {6.0f * number(random), 4.0f * number(random), -8.0f});
        matrix = glm::rotate(matrix, 3.0f * number(random), {1.0f, 0.5f, number(random)});
        matrix = glm::scale(matrix, {1.5f, 0.2f + std::abs(number(random)), 1.0f});
        const glm::vec3 center(number(random), number(random), number(random));
        const float radius = 0.1f + std::abs(number(random));
        // A box so large that the sphere alone decides.
        const Bounds bounds{center, glm::vec3(1.8f)};
        const auto seen = ProjectBounds(bounds, radius, matrix, projection);
        ASSERT_TRUE(seen);
        TargetRegion sampled{1e9, 1e9, -1e9, -1e9};
        const glm::dmat4 toClip = glm::dmat4(projection) * glm::dmat4(matrix);
        const glm::dvec3 middle(center);
        for (const glm::dvec3& way : ways)
        {
            const glm::dvec4 clip =
                toClip * glm::dvec4(middle + static_cast<double>(radius) * way, 1.0);
            const double x = 0.5 + 0.5 * clip.x / clip.w;
            const double y = 0.5 - 0.5 * clip.y / clip.w;
            sampled = Union(sampled, {x, y, x, y});
        }
        const double size = sampled.right - sampled.left + sampled.bottom - sampled.top;
        for (const auto& [exact, found] : {std::pair(seen->left, sampled.left),
                                           {seen->top, sampled.top},
                                           {-seen->right, -sampled.right},
                                           {-seen->bottom, -sampled.bottom}})
        {
            EXPECT_LE(exact, found + 1e-9) << i << ": a point lies outside";
            EXPECT_NEAR(exact, found, 1e-3 * size) << i << ": more than there is";
        }
    }
}

TEST(ProjectedBounds, AreTheSmallerOnAnySide)
{
    const glm::mat4 plain = glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, -9.0f, 9.0f);
    const Bounds flat{{0, 0, 0}, {0.5f, 0.1f, 0.5f}};
    const TargetRegion seen = ProjectBounds(flat, 0.25f, glm::mat4(1.0f), plain).value();
    EXPECT_NEAR(0.5 - 0.25 / 2, seen.left, 1e-7) << "the sphere's";
    EXPECT_NEAR(0.5 - 0.1 / 2, seen.top, 1e-7) << "the box's";
    EXPECT_NEAR(0.5 + 0.25 / 2, seen.right, 1e-7);
    EXPECT_NEAR(0.5 + 0.1 / 2, seen.bottom, 1e-7);
}

TEST(ProjectedBounds, AreThoseOfTheSphereWhereOnlyTheBoxReachesBehindTheCamera)
{
    const glm::mat4 projection = glm::perspective(1.0f, 1.0f, 0.1f, 100.0f);
    const glm::mat4 ahead = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -1.2f});
    const Bounds bounds{{0, 0, 0}, {1.5f, 1.5f, 1.5f}};
    EXPECT_TRUE(ProjectBounds(bounds, 1.0f, ahead, projection));
    EXPECT_FALSE(ProjectBounds(bounds, 1.3f, ahead, projection));
}

} // namespace
} // namespace limn
