#include "frame/FrameBuilder.h"
#include "frame/FrameNode.h"
#include "frame/ImageInterpreter.h"
#include "scene/TestScene.h"

#include <gtest/gtest.h>
#include <limn/core/FrameCompiler.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace limn
{
namespace
{

using test::FrameBuilder;
using test::ImageInterpreter;
using test::RenderTexturePtr;

constexpr unsigned k_Seed = 20'261'122;

/// Records frames that read nothing undefined: of each texture something is known before it is
/// read, of a transient one in the same frame.
class RandomFrames
{
public:
    explicit RandomFrames(unsigned seed) : m_Random(seed)
    {
        for (int i = 0; i < 4; ++i)
        {
            m_Colors.push_back(Color("kept" + std::to_string(i), false));
            m_Colors.push_back(Color("transient" + std::to_string(i), true));
        }
        m_Colors.push_back(Smooth("smooth kept", false, GraphicsFormat::R8_UNorm));
        m_Colors.push_back(Smooth("smooth transient", true, GraphicsFormat::R8_UNorm));
    }

    FrameCommands Record()
    {
        std::erase_if(m_Known, [](const RenderTexturePtr& t) { return t->isTransient(); });
        const int count = Pick(3, 10);
        for (int i = 0; i < count; ++i)
        {
            RecordNode();
        }
        return m_Frame.Take();
    }

    const std::vector<std::shared_ptr<GraphicsBuffer>>& buffers() const { return m_Buffers; }

    /// Some of what is known and outlives a frame.
    std::vector<RenderTexturePtr> Outputs()
    {
        std::vector<RenderTexturePtr> outputs;
        for (const RenderTexturePtr& texture : m_Known)
        {
            if (!IsDepthFormat(texture->graphicsFormat()) && Pick(0, 2) == 0)
            {
                outputs.push_back(texture);
            }
        }
        return outputs;
    }

private:
    static RenderTexturePtr Color(const std::string& name, bool isTransient)
    {
        return test::Target(name, 2, 2, isTransient, GraphicsFormat::R8_UNorm);
    }

    static RenderTexturePtr Smooth(const std::string& name, bool isTransient, GraphicsFormat format)
    {
        RenderTextureDescriptor descriptor(2, 2, format);
        descriptor.msaaSamples = 4;
        return std::make_shared<RenderTexture>(name, descriptor, SamplerState{}, isTransient);
    }

    int Pick(int least, int most) { return std::uniform_int_distribution(least, most)(m_Random); }

    bool IsKnown(const RenderTexturePtr& texture) const
    {
        return std::find(m_Known.begin(), m_Known.end(), texture) != m_Known.end();
    }

    void Know(const RenderTexturePtr& texture)
    {
        if (!IsKnown(texture))
        {
            m_Known.push_back(texture);
        }
    }

    void RecordDispatch()
    {
        std::vector<RenderTexturePtr> written;
        for (const RenderTexturePtr& texture : m_Known)
        {
            const bool canBe = !IsDepthFormat(texture->graphicsFormat()) && !HasSamples(*texture);
            if (canBe && written.size() < 2 && Pick(0, 2) == 0)
            {
                written.push_back(texture);
            }
        }
        std::vector<BufferSlot> buffers;
        for (const auto& buffer : m_Buffers)
        {
            const int use = Pick(0, 5);
            if (use < 2)
            {
                buffers.push_back(use == 0 ? FrameBuilder::Read(buffer)
                                           : FrameBuilder::Write(buffer));
            }
        }
        m_Frame.Dispatch(m_Number++, Sampled(written, 2), written, buffers);
    }

    void RecordNode()
    {
        if (Pick(0, 3) == 0)
        {
            RecordDispatch();
            return;
        }
        if (Pick(0, 5) == 0 && RecordDepthCopy())
        {
            return;
        }
        const RenderTexturePtr color = m_Colors[static_cast<std::size_t>(Pick(0, 9))];
        const RenderTexturePtr depth = Pick(0, 2) != 0      ? nullptr
                                       : HasSamples(*color) ? m_SmoothDepth
                                                            : m_Depth;
        const bool copies = depth == nullptr && Pick(0, 3) == 0 && RecordCopy(color);
        if (copies)
        {
            return;
        }
        std::vector<RenderTexturePtr> colors{color};
        const RenderTexturePtr second = m_Colors[static_cast<std::size_t>(Pick(0, 9))];
        if (second != color && HasSamples(*second) == HasSamples(*color) && Pick(0, 2) == 0)
        {
            colors.push_back(second);
        }
        m_Frame.Bind(colors, depth);
        const bool clears = !IsKnown(color) || !IsKnown(colors.back()) || Pick(0, 3) == 0;
        const bool clearsDepth = depth && (!IsKnown(depth) || Pick(0, 3) == 0);
        m_Frame.Clear((clears ? ClearFlag::Color : ClearFlag::None) |
                          (clearsDepth ? ClearFlag::DepthStencil : ClearFlag::None),
                      {static_cast<float>(Pick(0, 1) * Pick(0, 3)), 0, 0, 0},
                      static_cast<float>(Pick(0, 8)) / 8.0f);
        std::for_each(colors.begin(), colors.end(), [&](const auto& c) { Know(c); });
        if (depth)
        {
            Know(depth);
        }
        const int draws = Pick(0, 2);
        for (int i = 0; i < draws; ++i)
        {
            RecordDraw(colors, depth);
        }
    }

    /// What can be sampled beside drawing into `targets`.
    std::vector<test::TexturePtr> Sampled(const std::vector<RenderTexturePtr>& targets, int most)
    {
        std::vector<test::TexturePtr> result;
        for (const RenderTexturePtr& texture : m_Known)
        {
            const bool isTarget =
                std::find(targets.begin(), targets.end(), texture) != targets.end();
            if (!isTarget && !IsDepthFormat(texture->graphicsFormat()) &&
                static_cast<int>(result.size()) < most && Pick(0, 2) == 0)
            {
                result.push_back(texture);
            }
        }
        return result;
    }

    /// As cameras copy theirs for those who read it.
    bool RecordDepthCopy()
    {
        const RenderTexturePtr& depth = Pick(0, 2) == 0 ? m_SmoothDepth : m_Depth;
        if (!IsKnown(depth))
        {
            return false;
        }
        m_Frame.Bind(m_CopiedDepth).Blit(m_Number++, {depth}, "copy");
        Know(m_CopiedDepth);
        return true;
    }

    bool RecordCopy(const RenderTexturePtr& color)
    {
        const std::vector<test::TexturePtr> from = Sampled({color}, 1);
        if (from.empty())
        {
            return false;
        }
        m_Frame.Bind(color).Blit(m_Number++, from, Pick(0, 1) == 0 ? "copy" : "where");
        Know(color);
        return true;
    }

    void RecordDraw(const std::vector<RenderTexturePtr>& colors, const RenderTexturePtr& depth)
    {
        const RenderTargetBlendState blend =
            Pick(0, 1) == 0 ? RenderTargetBlendState{} : FrameBuilder::Additive();
        std::vector<test::TexturePtr> sampled = Sampled(colors, 2);
        if (IsKnown(m_Depth) && depth != m_Depth && Pick(0, 7) == 0)
        {
            sampled.assign(1, m_Depth);
        }
        const int kind = Pick(0, 3);
        if (kind == 0 && sampled.size() == 1)
        {
            m_Frame.Blit(m_Number++, sampled, "where", blend);
        }
        else if (kind == 1)
        {
            m_Frame.Blit(m_Number++, sampled, "", blend); // no promise, no depth
        }
        else
        {
            m_Frame.Draw(m_Number++, sampled);
        }
        m_Frame.last().state.targets[1] =
            Pick(0, 1) == 0 ? RenderTargetBlendState{} : FrameBuilder::Additive();
    }

    std::mt19937 m_Random;
    std::vector<RenderTexturePtr> m_Colors;
    RenderTexturePtr m_Depth = test::DepthTarget("depth", 2, 2, true);
    RenderTexturePtr m_CopiedDepth =
        test::Target("copied depth", 2, 2, true, GraphicsFormat::R32_SFloat);
    RenderTexturePtr m_SmoothDepth = Smooth("smooth depth", true, GraphicsFormat::D32_SFloat);
    std::vector<RenderTexturePtr> m_Known; ///< what holds something
    std::vector<std::shared_ptr<GraphicsBuffer>> m_Buffers = {
        std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured, 1, 4),
        std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured, 1, 4)};
    FrameBuilder m_Frame;
    std::uint32_t m_Number = 1;
};

/// The frame with the first steps only.
CompiledFrame CompileWith(int steps, FrameCommands commands, const TextureStates& before,
                          OutputSpan outputs)
{
    CompiledFrame frame;
    frame.states = before;
    static_cast<FrameTables&>(frame) = commands;
    FrameNodes nodes;
    FrameNodes leftOut;
    SplitIntoNodes(commands.commands, frame, nodes);
    for (FrameNode& node : nodes)
    {
        CollectReads(node, frame);
    }
    if (steps > 0)
    {
        FindAccess(nodes, frame);
    }
    using Step = void (*)(FrameNodes&, OutputSpan, CompiledFrame&);
    const Step k_Steps[] = {ElideConstantDraws, EliminateCopies, ReadOriginals, CullPasses,
                            StripUnusedStencil};
    for (int i = 1; i < std::min(steps, 6); ++i)
    {
        k_Steps[i - 1](nodes, outputs, frame);
        EraseLeftOut(nodes, leftOut);
    }
    if (steps == 6)
    {
        MergeNodes(nodes, frame);
    }
    ResolveSamples(nodes, outputs, frame);
    AssignLoadStoreBarriers(nodes, outputs, frame);
    return frame;
}

bool HasPending(const TextureStates& states)
{
    return std::any_of(states.textures.begin(), states.textures.end(),
                       [](const auto& entry) { return entry.second.isPending; });
}

template <typename Textures>
std::string NamesOf(const Textures& textures)
{
    std::string names;
    for (const RenderTexturePtr& texture : textures)
    {
        names += " " + texture->name();
    }
    return names;
}

/// For a person who has to find out why a frame went wrong.
std::string Describe(const FrameCommands& frame)
{
    std::string text;
    for (const FrameCommand& command : frame.commands)
    {
        if (const auto* bind = std::get_if<SetRenderTargetCommand>(&command))
        {
            text += "\n " + NamesOf(bind->colors) + (bind->depth ? " depth:" : ":");
        }
        else if (const auto* clear = std::get_if<ClearCommand>(&command))
        {
            text += " clear " + std::to_string(static_cast<int>(clear->flags)) + " to " +
                    std::to_string(std::lround(clear->color.r));
        }
        else if (const auto* dispatch = std::get_if<DispatchCommand>(&command))
        {
            const DrawBindings& bindings = *frame.Setup(*dispatch).bindings;
            text += "\n  dispatch";
            for (const StorageTextureSlot& slot : bindings.storageTextures)
            {
                text += " " + slot.texture->name();
            }
            text += " of";
            for (const TextureSlot& slot : bindings.textures)
            {
                text += " " + slot.texture->name();
            }
        }
        else if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            const DrawSetup& setup = frame.Setup(*draw);
            text += setup.state.targets[0] == FrameBuilder::Additive() ? " add" : " draw";
            text += !setup.fullScreen ? "" : setup.fullScreen->copied ? " copy" : " where";
            for (const TextureSlot& slot : setup.bindings->textures)
            {
                text += " " + slot.texture->name();
            }
        }
    }
    return text;
}

/// What the frames of one sequence came to.
struct Tally
{
    int frames = 0;
    int steady = 0; ///< as the one before
    std::uint64_t structure = 0;
    std::size_t leftOut = 0;
    int dispatches = 0; ///< passes
    int sharing = 0;    ///< frames in which textures share memory
    int originals = 0;  ///< copies of depth that went
};

/// Of several sizes, in two kinds of memory.
TextureFootprint FootprintOf(const RenderTexture& texture)
{
    return {64 * (1 + texture.id() % 3), 64, texture.id() % 9 == 0 ? 1u : 0u};
}

void RunSequence(unsigned seed, Tally& tally)
{
    RandomFrames random(seed);
    ImageInterpreter naive;
    ImageInterpreter device;
    FrameCache cache;
    TextureStates states;
    std::string frames;
    FrameCommands recorded;
    std::vector<RenderTexturePtr> outputs;
    for (int i = 0; i < 9; ++i)
    {
        // The later ones are drawn thrice: what reads and draws comes and goes, as features do that
        // are switched on and off, and reads what all frames before have drawn over unseen.
        if (i < 3 || i % 3 == 0)
        {
            recorded = random.Record();
            outputs = random.Outputs();
        }
        naive.Run(recorded);
        frames += "\nframe " + std::to_string(i) + " gives" + NamesOf(outputs) + Describe(recorded);
        FrameCommands commands = recorded;
        FrameCompilerOptions options;
        options.footprint = FootprintOf;
        options.isLast = i == 8;
        const std::uint64_t before = tally.structure;
        const CompiledFrame frame = *cache.Compile(commands, states, outputs, options);
        tally.structure = frame.structure;
        tally.steady += tally.structure == before ? 1 : 0;
        tally.sharing += frame.placed.empty() ? 0 : 1;
        ++tally.frames;
        tally.leftOut += frame.leftOut.size();
        tally.originals += static_cast<int>(
            std::ranges::count_if(frame.leftOut, [](const LeftOut& item)
                                  { return item.reason.starts_with("passes that read"); }));
        ASSERT_TRUE(frame.notes.empty()) << frame.notes.front() << frames;
        // One by one takes its time: every fifth frame.
        for (int steps = HasPending(states) ? 2 : 0; steps <= 6 && tally.frames % 5 == 0; ++steps)
        {
            ImageInterpreter copy = device;
            copy.Run(CompileWith(steps, recorded, states, outputs));
            for (const RenderTexturePtr& output : outputs)
            {
                ASSERT_EQ(naive.texels(*output), copy.texels(*output))
                    << output->name() << " of frame " << i << " after step " << steps << frames;
            }
        }
        device.Run(frame);
        for (const auto& buffer : random.buffers())
        {
            ASSERT_EQ(naive.value(*buffer), device.value(*buffer)) << "frame " << i << frames;
        }
        for (const auto& pass : frame.passes)
        {
            tally.dispatches += pass.isCompute() ? 1 : 0;
        }
        for (const RenderTexturePtr& output : outputs)
        {
            ASSERT_EQ(naive.texels(*output), device.texels(*output))
                << output->name() << " of frame " << i << frames;
        }
        states = frame.states;
    }
}

} // namespace

TEST(RandomFrame, GivesWhatItsCommandsGiveOneByOneAfterEveryStep)
{
    Tally tally;
    for (unsigned seed = k_Seed; seed < k_Seed + 500; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ASSERT_NO_THROW(RunSequence(seed, tally));
        if (HasFatalFailure())
        {
            return;
        }
    }
    EXPECT_EQ(tally.frames, 500 * 9);
    EXPECT_GT(tally.steady, 200) << "some are as the one before";
    EXPECT_GT(tally.leftOut, 2000u) << "there is something to leave out";
    EXPECT_GT(tally.sharing, 100) << "there is something to put into one place";
    EXPECT_GT(tally.dispatches, 1000) << "there are kernels among them";
    EXPECT_GT(tally.originals, 100) << "some read depth in place of a copy";
    RecordProperty("originals", tally.originals);
    RecordProperty("frames", tally.frames);
    RecordProperty("sharing", tally.sharing);
}

} // namespace limn
