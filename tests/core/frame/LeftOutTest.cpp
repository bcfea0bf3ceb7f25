#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

#include <cmath>
#include <gmock/gmock.h>

#include "Mentions.h"

namespace limn
{
namespace
{

using test::FrameBuilder;
using test::Mentions;
using test::RenderTexturePtr;
using testing::ElementsAre;
using testing::IsEmpty;

/// What of a frame is not run, and why.
class LeftOutOfAFrame : public testing::Test
{
protected:
    /// The passes as "name: commands", and LeftOut's reasons in m_LeftOut.
    std::vector<std::string> Compile(const std::vector<RenderTexturePtr>& outputs)
    {
        m_Last = m_Compiler.Compile(m_Frame.Take(), outputs);
        std::vector<std::string> passes;
        for (const CompiledRenderPass& pass : m_Last.passes)
        {
            std::string text = pass.name + ":";
            for (const std::string& command : test::CommandsOf(pass))
            {
                text += " " + command;
            }
            passes.push_back(text);
        }
        return passes;
    }

    /// "pass: reason"
    std::vector<std::string> Reasons() const
    {
        std::vector<std::string> reasons;
        for (const LeftOut& item : m_Last.leftOut)
        {
            reasons.push_back(item.pass + ": " + item.reason);
        }
        return reasons;
    }

    /// The outline of the article as it is recorded: mask → edges → camera.
    void RecordOutline(bool isSelected)
    {
        m_Frame.Begin("Scene").Bind(m_Camera, m_Depth).Clear(ClearFlag::All).Draw(1).End();
        m_Frame.Begin("Outline").Bind(m_Mask).Clear(ClearFlag::Color);
        if (isSelected)
        {
            m_Frame.Draw(2);
        }
        m_Frame.Bind(m_Edges).Blit(3, {m_Mask}, "0 0 0 1 where");
        m_Frame.Bind(m_Camera).Blit(4, {m_Edges}, "0 0 0 1 where", FrameBuilder::Additive());
        m_Frame.End().Begin("Transparents").Bind(m_Camera, m_Depth).Draw(5).End();
    }

    test::FrameCompiler m_Compiler{true};
    FrameBuilder m_Frame;
    CompiledFrame m_Last;
    const RenderTexturePtr m_Camera = test::Target("Camera");
    const RenderTexturePtr m_Depth = test::DepthTarget("Depth", 8, 4, true);
    const RenderTexturePtr m_Mask = test::Target("Mask", 8, 4, false, GraphicsFormat::R8_UNorm);
    const RenderTexturePtr m_Edges = test::Target("Edges", 8, 4, false, GraphicsFormat::R8_UNorm);
};

TEST_F(LeftOutOfAFrame, IsTheWholeOutlineWhereNothingIsSelected)
{
    RecordOutline(false);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre("Scene: begin Scene draw 1 end begin Transparents "
                                                 "draw 5 end"));
    EXPECT_THAT(Reasons(), ElementsAre(Mentions("Outline", "draws nothing", "clear"),
                                       Mentions("Outline", "the same", "'Mask' is 0"),
                                       Mentions("Outline", "changes nothing", "'Edges' is 0")));
}

TEST_F(LeftOutOfAFrame, IsNothingOfTheOutlineWhereSomethingIsSelected)
{
    RecordOutline(true);
    EXPECT_THAT(Compile({m_Camera}),
                ElementsAre("Outline: begin Outline draw 2 end",
                            "Outline: begin Outline draw 3 end",
                            "Scene: begin Scene draw 1 end begin Outline draw 4 end "
                            "begin Transparents draw 5 end"));
    EXPECT_THAT(Reasons(), IsEmpty());
}

TEST_F(LeftOutOfAFrame, IsAClearUntilSomethingReadsIt)
{
    m_Frame.Begin("Fill").Bind(m_Mask).Clear(ClearFlag::Color, Color::red).End();
    EXPECT_THAT(Compile({}), IsEmpty());
    m_Frame.Begin("Use").Bind(m_Camera).Draw(1, {m_Mask}).End();
    EXPECT_THAT(Compile({m_Camera}), ElementsAre("Clear Mask:", "Use: begin Use draw 1 end"));
    EXPECT_EQ(m_Last.passes[0].colors[0].load, LoadOp::Clear);
    EXPECT_EQ(m_Last.passes[0].colors[0].clearColor, Color::red);
    m_Frame.Bind(m_Camera).Draw(1, {m_Mask});
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": draw 1")) << "it is in the image by now";
}

TEST_F(LeftOutOfAFrame, BeginsTheNextPassOnATargetThatWasCleared)
{
    m_Frame.Bind(m_Camera, m_Depth).Clear(ClearFlag::All, Color::green, 0.25f, 3);
    m_Frame.Bind(m_Mask).Draw(1).Bind(m_Camera, m_Depth).Draw(2);
    EXPECT_THAT(Compile({m_Camera, m_Mask}), ElementsAre(": draw 1", ": draw 2"));
    const CompiledRenderPass& pass = m_Last.passes[1];
    EXPECT_EQ(pass.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(pass.colors[0].clearColor, Color::green);
    ASSERT_TRUE(pass.depth);
    EXPECT_EQ(pass.depth->load, LoadOp::Clear);
    EXPECT_EQ(pass.depth->clearDepth, 0.25f);
}

TEST_F(LeftOutOfAFrame, IsNoClearOfAnOutput)
{
    m_Frame.Bind(m_Camera).Clear(ClearFlag::Color, Color::green);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre("Clear Camera:"));
    EXPECT_EQ(m_Last.passes[0].colors[0].clearColor, Color::green);
}

TEST_F(LeftOutOfAFrame, IsAClearOfOneOfSeveralTargets)
{
    m_Frame.Bind(m_Mask).Clear(ClearFlag::Color, Color::red);
    m_Frame.Bind({m_Camera, m_Mask}, nullptr).Draw(1);
    EXPECT_THAT(Compile({m_Camera, m_Mask}), ElementsAre(": draw 1"));
    EXPECT_EQ(m_Last.passes.at(0).colors[0].load, LoadOp::DontCare);
    EXPECT_EQ(m_Last.passes[0].colors[1].load, LoadOp::Clear);
    EXPECT_EQ(m_Last.passes[0].colors[1].clearColor, Color::red);
}

TEST_F(LeftOutOfAFrame, IsATransientTextureThatNothingReads)
{
    const RenderTexturePtr transient = test::Target("Unread", 8, 4, true);
    m_Frame.Begin("For nothing").Bind(transient).Draw(1, {m_Mask}).End().Bind(m_Camera).Draw(2);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": draw 2"));
    EXPECT_THAT(Reasons(), ElementsAre("For nothing: nothing reads 'Unread'"));
}

TEST_F(LeftOutOfAFrame, IsWhatOnlyAPassReadsThatIsLeftOut)
{
    const RenderTexturePtr first = test::Target("First", 8, 4, true);
    const RenderTexturePtr second = test::Target("Second", 8, 4, true);
    m_Frame.Bind(first).Draw(1).Bind(second).Draw(2, {first}).Bind(m_Camera).Draw(3);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": draw 3"));
}

//   frame n: history ─▶ camera, then camera ─▶ history
TEST_F(LeftOutOfAFrame, IsNoTextureThatEachFrameHandsToTheNext)
{
    const RenderTexturePtr history = test::Target("History");
    m_Frame.Bind(history).Clear(ClearFlag::Color, Color::red);
    for (int i = 0; i < 4; ++i)
    {
        m_Frame.Bind(m_Camera).Clear(ClearFlag::Color).Draw(1, {history});
        m_Frame.Bind(history).Blit(2, {m_Camera}, "True");
        const std::vector<std::string> first{"Clear History:", ": draw 1", ": draw 2"};
        const std::vector<std::string> later{": draw 1", ": draw 2"};
        EXPECT_EQ(i == 0 ? first : later, Compile({m_Camera})) << "frame " << i;
        EXPECT_EQ(m_Last.passes.back().colors[0].store, StoreOp::Store);
        EXPECT_THAT(m_Last.notes, IsEmpty());
    }
}

TEST_F(LeftOutOfAFrame, IsWhatIsCoveredByAFullScreenPass)
{
    m_Frame.Bind(m_Camera).Clear(ClearFlag::Color).Draw(1).Blit(2, {m_Mask}, "True");
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": draw 2"));
    EXPECT_EQ(m_Last.passes[0].colors[0].load, LoadOp::DontCare);
}

TEST_F(LeftOutOfAFrame, IsAClearBetweenDrawsThatAFullScreenPassCovers)
{
    m_Frame.Bind(m_Mask).Clear(ClearFlag::Color).Bind(m_Edges).Draw(1);
    m_Frame.Clear(ClearFlag::Color, Color::red).Blit(2, {m_Mask}, "0 0 0 1 where");
    EXPECT_THAT(Compile({m_Edges}), ElementsAre("Clear Edges:"));
    EXPECT_EQ(m_Last.passes[0].colors[0].clearColor, Color::black);
}

TEST_F(LeftOutOfAFrame, IsNothingUnderAFullScreenPassInAViewport)
{
    m_Frame.Bind(m_Camera).Viewport(0, 0, 4, 4).Draw(1).Blit(2, {m_Mask}, "True");
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": viewport 0 0 4 4 draw 1 draw 2"));
}

TEST_F(LeftOutOfAFrame, IsDepthThatNoDrawUses)
{
    m_Frame.Bind(m_Camera, m_Depth).Clear(ClearFlag::All).Blit(1, {m_Mask}, "True");
    Compile({m_Camera});
    EXPECT_FALSE(m_Last.passes.at(0).depth);
    m_Frame.Bind(m_Camera, m_Depth).Draw(2);
    Compile({m_Camera});
    EXPECT_TRUE(m_Last.passes.at(0).depth);
}

TEST_F(LeftOutOfAFrame, IsACopyThatCanBeDrawnIntoDirectly)
{
    const RenderTexturePtr scene =
        test::Target("Scene", 8, 4, true, GraphicsFormat::R16G16B16A16_SFloat);
    m_Frame.Begin("Scene").Bind(scene, m_Depth).Clear(ClearFlag::All, {1, 0, 0, 0.5f}).Draw(1);
    m_Frame.End().Begin("Final Blit").Bind(m_Camera).Blit(2, {scene}, "copy").End();
    EXPECT_THAT(Compile({m_Camera}), ElementsAre("Scene: begin Scene draw 1 end"));
    EXPECT_EQ(m_Last.passes[0].colors[0].texture, m_Camera);
    EXPECT_EQ(m_Last.passes[0].colors[0].clearColor, (Color{1, 0, 0, 1}));
    const auto& draw = std::get<DrawCommand>(m_Last.passes[0].commands.at(1));
    EXPECT_EQ(m_Last.Setup(draw).state.targets[0].writeMask,
              ColorWriteMask::All & ~ColorWriteMask::Alpha);
    EXPECT_THAT(Reasons(), ElementsAre(Mentions("Final Blit", "'Camera'", "drawn", "directly",
                                                "'Scene'", "blends")));
}

TEST_F(LeftOutOfAFrame, IsAClearOfDepthWhereNoneIsBound)
{
    m_Frame.Bind(m_Camera, m_Depth).Clear(ClearFlag::All, Color::red, 0.5f).Draw(1);
    m_Frame.Bind(m_Mask).Draw(2, {m_Camera});
    m_Frame.Bind(m_Camera).Clear(ClearFlag::All).Draw(3).Clear(ClearFlag::All).Draw(4);
    m_Frame.Bind(m_Camera, m_Depth).Draw(5);
    EXPECT_THAT(Compile({m_Camera, m_Mask}),
                ElementsAre(": draw 1", ": draw 2", ": draw 3 clear 1 draw 4 draw 5"));
    ASSERT_TRUE(m_Last.passes.at(2).depth);
    EXPECT_EQ(m_Last.passes[2].depth->load, LoadOp::Load);
    EXPECT_EQ(m_Last.passes[2].colors[0].load, LoadOp::Clear);
}

TEST_F(LeftOutOfAFrame, IsAPassThatCanGoOnInOneBeforeIt)
{
    m_Frame.Bind(m_Camera, m_Depth).Clear(ClearFlag::All).Draw(1);
    m_Frame.Begin("Mask").Bind(m_Mask).Draw(2).End();
    m_Frame.Begin("Sky").Bind(m_Camera, m_Depth).Draw(3).End();
    EXPECT_THAT(Compile({m_Camera, m_Mask}),
                ElementsAre(": draw 1 begin Sky draw 3 end", "Mask: begin Mask draw 2 end"));
    m_Frame.Bind(m_Camera).Draw(1).Bind(m_Mask).Draw(2, {m_Camera}).Bind(m_Camera).Draw(3);
    EXPECT_THAT(Compile({m_Camera, m_Mask}), ElementsAre(": draw 1", ": draw 2", ": draw 3"));
}

TEST_F(LeftOutOfAFrame, IsAPassThatOneBeforeItCanWaitFor)
{
    m_Frame.Bind(m_Camera).Draw(1).Bind(m_Mask).Draw(2).Bind(m_Camera).Draw(3, {m_Mask});
    EXPECT_THAT(Compile({m_Camera, m_Mask}), ElementsAre(": draw 2", ": draw 1 draw 3"));
    // What neither of them needs stays behind both.
    const RenderTexturePtr other = test::Target("Other");
    m_Frame.Bind(m_Camera).Draw(1).Bind(other).Draw(2).Bind(m_Mask).Draw(3);
    m_Frame.Bind(m_Edges).Draw(4, {m_Mask}).Bind(m_Camera).Draw(5, {m_Edges});
    EXPECT_THAT(Compile({m_Camera, other}),
                ElementsAre(": draw 3", ": draw 4", ": draw 1 draw 5", ": draw 2"));
    // One that reads the first target by way of others cannot go before it.
    m_Frame.Bind(m_Camera).Draw(1).Bind(m_Mask).Draw(2, {m_Camera});
    m_Frame.Bind(m_Edges).Draw(3, {m_Mask}).Bind(m_Camera).Draw(4, {m_Edges});
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": draw 1", ": draw 2", ": draw 3", ": draw 4"));
    // Nor can one that overwrites what the first pass reads.
    m_Frame.Bind(m_Camera).Draw(1, {m_Mask}).Bind(m_Mask).Draw(2);
    m_Frame.Bind(m_Camera).Draw(3, {m_Mask});
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": draw 1", ": draw 2", ": draw 3"));
}

TEST_F(LeftOutOfAFrame, IsNoLoadOfAColourBesideOneThatIsCovered)
{
    m_Frame.Bind(m_Edges).Draw(1);
    Compile({m_Edges});
    m_Frame.Bind(m_Camera).Blit(2, {}, "True").Bind({m_Camera, m_Edges}, nullptr).Draw(3);
    Compile({m_Camera, m_Edges});
    ASSERT_EQ(m_Last.passes.back().colors.size(), 2u);
    EXPECT_EQ(m_Last.passes.back().colors[1].load, LoadOp::Load);
}

TEST_F(LeftOutOfAFrame, IsAPassThatHoldsAPartOfASample)
{
    m_Frame.Bind(m_Camera).Draw(1).Bind(m_Mask).Draw(2);
    m_Frame.Begin("Half").Bind(m_Camera).Draw(3).Bind(m_Edges).Draw(4).End();
    EXPECT_THAT(
        Compile({m_Camera, m_Mask, m_Edges}),
        ElementsAre(": draw 1 begin Half draw 3 end", ": draw 2", "Half: begin Half draw 4 end"));
}

struct CopyCase
{
    const char* name;
    std::function<void(FrameBuilder&, const RenderTexturePtr& scene, const RenderTexturePtr& other)>
        between; ///< before the copy
    std::function<void(FrameBuilder&, const RenderTexturePtr& scene, const RenderTexturePtr& other)>
        after;
};

TEST_F(LeftOutOfAFrame, IsNoCopyOfWhatIsNeededOtherwise)
{
    const auto nothing = [](FrameBuilder&, const RenderTexturePtr&, const RenderTexturePtr&) {
    };
    const CopyCase cases[] = {
        {"blending in a format that holds more",
         [](FrameBuilder& f, const RenderTexturePtr& scene, const RenderTexturePtr&)
         { f.Bind(scene).Blit(7, {}, "", FrameBuilder::Additive()); },
         nothing},
        {"another reader",
         [](FrameBuilder& f, const RenderTexturePtr& scene, const RenderTexturePtr& other)
         { f.Bind(other).Draw(7, {scene}); },
         nothing},
        {"a later reader", nothing,
         [](FrameBuilder& f, const RenderTexturePtr& scene, const RenderTexturePtr& other)
         {
             f.Bind(other).Draw(7, {scene});
         }},
        {"beside another colour",
         [](FrameBuilder& f, const RenderTexturePtr& scene, const RenderTexturePtr& other) {
             f.Bind({scene, other}, nullptr).Draw(7);
         },
         nothing}};
    for (const CopyCase& c : cases)
    {
        const RenderTexturePtr scene =
            test::Target("Scene", 8, 4, true, GraphicsFormat::R16G16B16A16_SFloat);
        const RenderTexturePtr other = test::Target("Other");
        m_Frame.Bind(scene).Clear(ClearFlag::Color).Draw(1);
        c.between(m_Frame, scene, other);
        m_Frame.Bind(m_Camera).Blit(2, {scene}, "copy");
        c.after(m_Frame, scene, other);
        EXPECT_THAT(Compile({m_Camera, other}), testing::Contains(": draw 2")) << c.name;
    }
}

TEST_F(LeftOutOfAFrame, IsNoCopyOfAnotherSize)
{
    const RenderTexturePtr scene = test::Target("Scene", 4, 4, true);
    m_Frame.Bind(scene).Clear(ClearFlag::Color).Draw(1).Bind(m_Camera).Blit(2, {scene}, "copy");
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": draw 1", ": draw 2"));
}

TEST_F(LeftOutOfAFrame, IsACopyOfDepthThatNothingIsDrawnWithAnyMore)
{
    const RenderTexturePtr copied = test::Target("Copied", 8, 4, true, GraphicsFormat::R32_SFloat);
    m_Frame.Bind(m_Camera, m_Depth).Clear(ClearFlag::All).Draw(1);
    m_Frame.Begin("CopyDepth").Bind(copied).Blit(2, {m_Depth}, "copy").End();
    m_Frame.Bind(m_Mask).Draw(3, {m_Edges, copied}).Bind(m_Camera).Draw(4, {m_Mask, copied});
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(": draw 1", ": draw 3", ": draw 4"));
    EXPECT_THAT(Reasons(), ElementsAre(Mentions("CopyDepth", "read 'Copied'", "read 'Depth'",
                                                "nothing draws")));
    const CompiledRenderPass& scene = m_Last.passes[0];
    EXPECT_EQ(scene.depth->store, StoreOp::Store);
    for (const std::size_t reader : {1u, 2u})
    {
        const auto& draw = std::get<DrawCommand>(m_Last.passes[reader].commands.at(0));
        const auto& textures = m_Last.Setup(draw).bindings->textures;
        EXPECT_EQ(textures.at(0).texture, reader == 1 ? m_Edges : m_Mask);
        EXPECT_EQ(textures.at(1).texture, scene.depth->texture);
    }
}

TEST_F(LeftOutOfAFrame, IsNoCopyOfDepthThatReadersNeed)
{
    struct Textures
    {
        RenderTexturePtr depth;
        RenderTexturePtr copied;
        RenderTexturePtr camera;
        RenderTexturePtr other;
    };
    struct Case
    {
        const char* name;
        GraphicsFormat format;
        bool isTransient;
        void (*between)(FrameBuilder&, const Textures&);
        void (*after)(FrameBuilder&, const Textures&);
    };
    const auto nothing = [](FrameBuilder&, const Textures&) {
    };
    constexpr GraphicsFormat k_Format = GraphicsFormat::R32_SFloat;
    const Case k_Cases[] = {
        {"a later draw with the depth", k_Format, true, nothing,
         [](FrameBuilder& f, const Textures& t)
         {
             f.Bind(t.camera, t.depth).Draw(7);
         }},
        {"a draw with the depth before what reads", k_Format, true,
         [](FrameBuilder& f, const Textures& t) { f.Bind(t.camera, t.depth).Draw(7); }, nothing},
        {"a later clear of the depth", k_Format, true,
         [](FrameBuilder& f, const Textures& t)
         { f.Bind(nullptr, t.depth).Clear(ClearFlag::Depth).Draw(7); },
         nothing},
        {"a reader that draws with the depth", k_Format, true, nothing,
         [](FrameBuilder& f, const Textures& t)
         {
             f.Bind(t.camera, t.depth).Draw(7, {t.copied});
         }},
        {"a second draw into the copy", k_Format, true,
         [](FrameBuilder& f, const Textures& t) { f.Bind(t.copied).Draw(7); }, nothing},
        {"a kernel that reads it", k_Format, true, nothing,
         [](FrameBuilder& f, const Textures& t)
         {
             f.Dispatch(7, {t.copied}, {t.other});
         }},
        {"a kernel that writes it", k_Format, true,
         [](FrameBuilder& f, const Textures& t) { f.Dispatch(7, {}, {t.copied}); }, nothing},
        {"a reader that filters", k_Format, true, nothing,
         [](FrameBuilder& f, const Textures& t)
         {
             f.Bind(t.other).Draw(7, {t.copied});
             auto bindings = std::make_shared<DrawBindings>(*f.last().bindings);
             bindings->samplers.push_back({1, SamplerState{FilterMode::Bilinear}});
             f.last().bindings = bindings;
         }},
        {"a reader with a filter of the texture", k_Format, true, nothing,
         [](FrameBuilder& f, const Textures& t)
         {
             f.Bind(t.other).Draw(7, {t.copied});
             auto bindings = std::make_shared<DrawBindings>(*f.last().bindings);
             bindings->textures[0].sampler = SamplerState{FilterMode::Bilinear};
             f.last().bindings = bindings;
         }},
        {"a copy that rounds", GraphicsFormat::R16_SFloat, true, nothing, nothing},
        {"a copy that outlives the frame", k_Format, false, nothing, nothing},
    };
    for (const Case& c : k_Cases)
    {
        const Textures t{test::DepthTarget("Depth", 8, 4, true),
                         test::Target("Copied", 8, 4, c.isTransient, c.format),
                         test::Target("Camera"), test::Target("Other")};
        m_Frame.Bind(t.camera, t.depth).Clear(ClearFlag::All).Draw(1);
        m_Frame.Bind(t.copied).Blit(2, {t.depth}, "copy");
        c.between(m_Frame, t);
        m_Frame.Bind(m_Mask).Draw(3, {t.copied});
        c.after(m_Frame, t);
        EXPECT_THAT(Compile({t.camera, t.other, m_Mask}),
                    testing::Contains(testing::StartsWith(": draw 2")))
            << c.name;
    }
    // Of another size, of a target that is read back, of one that is not a copy, and a pass that
    // is kept.
    const RenderTexturePtr small = test::Target("Small", 4, 4, true, k_Format);
    m_Frame.Bind(m_Camera, m_Depth).Draw(1).Bind(small).Blit(2, {m_Depth}, "copy");
    m_Frame.Bind(m_Mask).Draw(3, {small});
    EXPECT_THAT(Compile({m_Mask}), testing::Contains(": draw 2"));
    const RenderTexturePtr copied = test::Target("Copied", 8, 4, true, k_Format);
    m_Frame.Bind(m_Camera, m_Depth).Draw(1).Bind(copied).Blit(2, {m_Depth}, "copy");
    m_Frame.Bind(m_Mask).Draw(3, {copied});
    EXPECT_THAT(Compile({m_Mask, copied}), testing::Contains(": draw 2"));
    m_Frame.Bind(m_Camera, m_Depth).Draw(1).Bind(copied).Blit(2, {m_Depth}, "True");
    m_Frame.Bind(m_Mask).Draw(3, {copied});
    EXPECT_THAT(Compile({m_Mask}), testing::Contains(": draw 2"));
    m_Frame.Bind(copied).Blit(2, {m_Depth}, "copy").Bind(m_Mask).Draw(3, {copied});
    FrameCommands kept = m_Frame.Take();
    std::get<SetRenderTargetCommand>(kept.commands.front()).isKept = true;
    EXPECT_EQ(m_Compiler.Compile(std::move(kept), {m_Mask}).passes.size(), 2u);
}

TEST_F(LeftOutOfAFrame, IsAllThatANextFrameWouldReadOfTheLast)
{
    m_Frame.Bind(m_Mask).Draw(1).Bind(m_Camera).Draw(2);
    const CompiledFrame last =
        CompileFrame(m_Frame.Take(), {}, std::vector{m_Camera}, {.isLast = true, .held = {}});
    EXPECT_EQ(last.passes.size(), 1u);
}

TEST_F(LeftOutOfAFrame, IsACopyIntoTheSameFormatAlsoOfWhatIsBlended)
{
    struct Case
    {
        BlendMode destination;
        GraphicsFormat format;
        std::size_t passes;
    };
    const Case k_Cases[] = {
        {BlendMode::OneMinusSrcAlpha, GraphicsFormat::R8G8B8A8_UNorm, 1},
        {BlendMode::OneMinusSrcAlpha, GraphicsFormat::R16G16B16A16_SFloat, 2}, // holds more
        {BlendMode::DstAlpha, GraphicsFormat::R8G8B8A8_UNorm, 2}, // the copy's alpha is 1
    };
    for (const Case& one : k_Cases)
    {
        RenderTargetBlendState blend;
        blend.destinationColorBlendMode = one.destination;
        const RenderTexturePtr scene = test::Target("Scene", 8, 4, true, one.format);
        m_Frame.Bind(scene).Clear(ClearFlag::Color).Draw(1);
        m_Frame.last().state.targets[0] = blend;
        m_Frame.Bind(m_Camera).Blit(2, {scene}, "copy");
        EXPECT_EQ(Compile({m_Camera}).size(), one.passes) << static_cast<int>(one.destination);
    }
}

TEST_F(LeftOutOfAFrame, IsACopyIntoAFormatThatHoldsLessWhereNoColourIsBlended)
{
    struct Case
    {
        RenderTargetBlendState blend;
        std::size_t passes;
    };
    using enum BlendMode;
    Case cases[] = {{{}, 1}, {{}, 1}, {{}, 1}, {{}, 2}, {{}, 2}, {{}, 2}};
    cases[0].blend.writeMask = ColorWriteMask::Red | ColorWriteMask::Green;
    cases[1].blend.sourceAlphaBlendMode = OneMinusDstAlpha; // nobody sees the alpha
    cases[2].blend.alphaBlendOperation = BlendOp::Max;
    cases[3].blend.sourceColorBlendMode = SrcAlpha; // of a colour above 1
    cases[4].blend.destinationColorBlendMode = One;
    cases[5].blend.colorBlendOperation = BlendOp::Max;
    for (const Case& one : cases)
    {
        const RenderTexturePtr scene =
            test::Target("Scene", 8, 4, true, GraphicsFormat::R16G16B16A16_SFloat);
        m_Frame.Bind(scene).Clear(ClearFlag::Color).Draw(1).Draw(2);
        m_Frame.last().state.targets[0] = one.blend;
        m_Frame.Bind(m_Camera).Blit(3, {scene}, "copy");
        EXPECT_EQ(Compile({m_Camera}).size(), one.passes) << &one - cases;
    }
}

TEST_F(LeftOutOfAFrame, IsACopyOfWhatIsCoveredAndItsAlphaIsOne)
{
    const RenderTexturePtr scene = test::Target("Scene", 8, 4, true);
    m_Frame.Bind(scene).Blit(1, {m_Edges}, "True");
    m_Frame.Bind(m_Camera).Blit(2, {scene}, "copy");
    ASSERT_EQ(Compile({m_Camera}).size(), 1u);
    const auto& color = m_Last.passes[0].colors[0];
    EXPECT_EQ(color.texture, m_Camera);
    EXPECT_EQ(color.load, LoadOp::Clear);
    EXPECT_EQ(color.clearColor.a, 1.0f);
}

/// The camera's picture where nothing is drawn: a clear, and a copy to an output of 8 bits of sRGB.
class CopyOfOneColour : public LeftOutOfAFrame
{
protected:
    void Compile(const RenderTexturePtr& scene, const Color& color)
    {
        m_Frame.Bind(scene, m_Depth).Clear(ClearFlag::All, color);
        m_Frame.Begin("Final Blit").Bind(m_Output).Blit(2, {scene}, "copy").End();
        LeftOutOfAFrame::Compile({m_Output});
    }

    static RenderTexturePtr Smooth(GraphicsFormat format)
    {
        RenderTextureDescriptor descriptor(8, 4, format);
        descriptor.msaaSamples = 4;
        return std::make_shared<RenderTexture>("Scene", descriptor, SamplerState{}, true);
    }

    /// Linear, of a step of 255 of sRGB.
    static float LinearOf(double step)
    {
        return static_cast<float>(std::pow((step / 255.0 + 0.055) / 1.055, 2.4));
    }

    const RenderTexturePtr m_Output =
        test::Target("Output", 8, 4, false, GraphicsFormat::R8G8B8A8_SRGB);
};

TEST_F(CopyOfOneColour, IsAClearAlsoWhereSamplesOrSizesDiffer)
{
    const RenderTexturePtr scenes[] = {
        Smooth(GraphicsFormat::R16G16B16A16_SFloat), Smooth(GraphicsFormat::R8G8B8A8_SRGB),
        test::Target("Scene", 16, 8, true, GraphicsFormat::R16G16B16A16_SFloat)};
    for (const RenderTexturePtr& scene : scenes)
    {
        Compile(scene, {1, 0, 1, 0.25f});
        ASSERT_EQ(m_Last.passes.size(), 1u);
        ASSERT_EQ(m_Last.passes[0].colors.size(), 1u);
        EXPECT_EQ(m_Last.passes[0].colors[0].texture, m_Output);
        EXPECT_EQ(m_Last.passes[0].colors[0].load, LoadOp::Clear);
        EXPECT_EQ(m_Last.passes[0].colors[0].clearColor, (Color{1, 0, 1, 1}));
        EXPECT_FALSE(m_Last.passes[0].depth);
        EXPECT_THAT(Reasons(),
                    testing::Contains(Mentions("Final Blit", "the same", "'Scene'", "one value")));
    }
}

TEST_F(CopyOfOneColour, IsTheStepThatTheOutputShows)
{
    Compile(Smooth(GraphicsFormat::R16G16B16A16_SFloat), {LinearOf(123.3), 5.0f, -1.0f, 1});
    ASSERT_EQ(m_Last.passes.size(), 1u);
    const Color& color = m_Last.passes[0].colors[0].clearColor;
    EXPECT_FLOAT_EQ(color.r, LinearOf(123.0));
    EXPECT_FLOAT_EQ(color.g, 1.0f);
    EXPECT_EQ(color.b, 0.0f);
}

TEST_F(CopyOfOneColour, IsDrawnWhereDevicesDifferInWhatItShows)
{
    for (const double step : {127.5, 127.55, 127.45})
    {
        Compile(Smooth(GraphicsFormat::R16G16B16A16_SFloat), {0, LinearOf(step), 0, 1});
        EXPECT_EQ(m_Last.passes.size(), 2u) << step;
    }
    const RenderTexturePtr coarse = Smooth(GraphicsFormat::B10G11R11_UFloatPack32);
    Compile(coarse, {LinearOf(123.0), 0, 0, 1});
    EXPECT_EQ(m_Last.passes.size(), 2u) << "rounded or cut off";
    Compile(coarse, Color::black);
    EXPECT_EQ(m_Last.passes.size(), 1u);
}

TEST_F(CopyOfOneColour, IsNoneWhereSomethingIsDrawn)
{
    const RenderTexturePtr scene = Smooth(GraphicsFormat::R16G16B16A16_SFloat);
    m_Frame.Bind(scene).Clear(ClearFlag::All).Draw(1);
    m_Frame.Bind(m_Output).Blit(2, {scene}, "copy");
    EXPECT_THAT(LeftOutOfAFrame::Compile({m_Output}), ElementsAre(": draw 1", ": draw 2"));
}

TEST_F(LeftOutOfAFrame, BlendsWithAlphaThatATextureLacksOnlyWithANote)
{
    const auto compile = [&](GraphicsFormat format, BlendMode destination)
    {
        const RenderTexturePtr scene = test::Target("Scene", 8, 4, true, format);
        m_Frame.Begin("Glow").Bind(scene).Clear(ClearFlag::Color).Draw(1).Draw(2).End();
        m_Frame.last().state.targets[0].destinationColorBlendMode = destination;
        m_Frame.Bind(m_Camera).Blit(3, {scene}, "copy");
        Compile({m_Camera});
        return m_Last.notes;
    };
    using enum GraphicsFormat;
    EXPECT_THAT(compile(B10G11R11_UFloatPack32, BlendMode::DstAlpha),
                ElementsAre(Mentions("'Glow'", "alpha of 'Scene'", "B10G11R11_UFloatPack32",
                                     "no alpha", "hdrColorBufferPrecision")));
    EXPECT_THAT(compile(B10G11R11_UFloatPack32, BlendMode::OneMinusSrcAlpha), IsEmpty());
    EXPECT_THAT(compile(R16G16B16A16_SFloat, BlendMode::DstAlpha), IsEmpty());
}

} // namespace
} // namespace limn
