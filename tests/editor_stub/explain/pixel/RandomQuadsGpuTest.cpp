#include "explain/pixel/PixelTest.h"

#include <random>

namespace limn::test
{

namespace
{

/// A quad of random states, and what the rules of a device make of it, worked out apart.
struct RandomQuad
{
    explicit RandomQuad(std::mt19937& random, int index)
        : left(-1.0 + 0.1 * static_cast<int>(random() % 12)),
          depth(0.9f - 0.05f * static_cast<float>((index * 7) % 17)), // each another one
          isTurned(random() % 2 == 0),
          cull(static_cast<int>(random() % 3)),
          discards(random() % 6 == 0),
          zTest(static_cast<int>(random() % 4)),
          zWrite(random() % 2 == 0),
          hasStencil(random() % 2 == 0),
          reference(static_cast<int>(random() % 3)),
          compare(static_cast<int>(random() % 4)),
          pass(static_cast<int>(random() % 4)),
          fail(static_cast<int>(random() % 4)),
          zFail(static_cast<int>(random() % 4)),
          mask(random() % 5 == 0 ? 0 : 15),
          blend(static_cast<int>(random() % 3)),
          red(random() % 2 == 0 ? 0.0f : 0.5f)
    {
    }

    std::string State() const
    {
        const char* culls[] = {"Off", "Front", "Back"};
        const char* compares[] = {"Always", "LEqual", "Greater", "NotEqual"};
        const char* ops[] = {"Keep", "Replace", "IncrSat", "Zero"};
        const char* blends[] = {"Off", "One One", "Zero One"};
        const auto at = [](const auto& names, int i)
        {
            return std::string(names[static_cast<std::size_t>(i)]);
        };
        std::string text = "Cull " + at(culls, cull) + " ZTest " + at(compares, zTest) +
                           " ZWrite " + (zWrite ? "On" : "Off") + " ColorMask " +
                           (mask == 0 ? "0" : "RGBA") + " Blend " + at(blends, blend);
        return hasStencil ? text + " Stencil { Ref " + std::to_string(reference) + " Comp " +
                                at(compares, compare) + " Pass " + at(ops, pass) + " Fail " +
                                at(ops, fail) + " ZFail " + at(ops, zFail) + " }"
                          : text;
    }

    /// The compares of State: of what is drawn with what is there.
    static bool Holds(int compare, float drawn, float there)
    {
        return compare == 0 || (compare == 1 && drawn <= there) ||
               (compare == 2 && drawn > there) || (compare == 3 && drawn != there);
    }

    struct Target
    {
        float red = 0.0f;
        float alpha = 1.0f;
        float depth = 0.0f; ///< 1 = near
        int stencil = 0;
    };

    void Do(int op, Target& target) const
    {
        target.stencil = op == 1   ? reference
                         : op == 2 ? std::min(target.stencil + 1, 255)
                         : op == 3 ? 0
                                   : target.stencil;
    }

    PixelFate Draw(Target& target) const
    {
        if ((cull == 1 && !isTurned) || (cull == 2 && isTurned))
        {
            return PixelFate::Culled;
        }
        if (discards)
        {
            return PixelFate::Discarded;
        }
        if (hasStencil &&
            !Holds(compare, static_cast<float>(reference), static_cast<float>(target.stencil)))
        {
            Do(fail, target);
            return PixelFate::Stencil;
        }
        if (!Holds(zTest, -depth, -target.depth)) // nearer is less
        {
            Do(hasStencil ? zFail : 0, target);
            return PixelFate::Depth;
        }
        Do(hasStencil ? pass : 0, target);
        target.depth = zWrite ? depth : target.depth;
        if (mask == 0)
        {
            return PixelFate::ColorMask;
        }
        const Target before = target;
        target.red = blend == 0 ? red : blend == 1 ? before.red + red : before.red;
        target.alpha = blend == 0 ? 1.0f : blend == 1 ? before.alpha + 1.0f : before.alpha;
        const bool isChanged = target.red != before.red || target.alpha != before.alpha;
        return isChanged ? PixelFate::Drawn : blend == 0 ? PixelFate::Same : PixelFate::Blend;
    }

    double left;
    float depth;
    bool isTurned;
    int cull;
    bool discards;
    int zTest;
    bool zWrite;
    bool hasStencil;
    int reference;
    int compare;
    int pass;
    int fail;
    int zFail;
    int mask;
    int blend;
    float red;
};

} // namespace

class PixelHistoryOfRandomQuads : public PixelHistoryGpu, public testing::WithParamInterface<int>
{
};

TEST_P(PixelHistoryOfRandomQuads, IsWhatTheRulesSayDrawByDraw)
{
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    std::vector<RandomQuad> quads;
    for (int i = 0; i < 12; ++i)
    {
        const RandomQuad& quad = quads.emplace_back(random, i);
        const std::string name = "q" + std::to_string(i);
        Paint(name, quad.State(), std::to_string(quad.red) + ", 0, 0, 1", 2000 + i,
              quad.discards ? "discard;" : "");
        // Depth d is at z = 6 - 10 d.
        Quad(name, name,
             "position: [" + std::to_string(quad.left + 0.5) + ", 0, " +
                 std::to_string(6.0 - 10.0 * static_cast<double>(quad.depth)) +
                 "], scale: [1, 2, 1]" + (quad.isTurned ? ", rotation: [0, 180, 0]" : ""));
    }
    for (const int x : {3, 8, 13})
    {
        const PixelHistory history = Trace(x, 10);
        RandomQuad::Target target;
        for (std::size_t i = 0; i < quads.size(); ++i)
        {
            const std::string name = "q" + std::to_string(i);
            const double middle = -1.0 + 0.1 * (x + 0.5);
            if (middle < quads[i].left || middle > quads[i].left + 1.0)
            {
                EXPECT_THAT(history.uncovered, testing::Contains(name)) << x;
                continue;
            }
            const PixelFate fate = quads[i].Draw(target);
            const PixelEvent event = EventOf(history, name);
            EXPECT_STREQ(ToString(fate), ToString(event.fate))
                << x << ": " << name << ": " << quads[i].State() << ": " << event.reason;
            EXPECT_EQ((Floats{target.red, 0, 0, target.alpha}), event.colors.at(0).after)
                << x << ": " << name;
            EXPECT_NEAR(target.depth, event.depth->after.at(0), 1e-6f) << x << ": " << name;
            if (event.stencil)
            {
                EXPECT_EQ(static_cast<float>(target.stencil), event.stencil->after.at(0))
                    << x << ": " << name;
            }
            EXPECT_EQ(event.reason.empty(), fate == PixelFate::Drawn);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, PixelHistoryOfRandomQuads, testing::Range(1, 7));

} // namespace limn::test
