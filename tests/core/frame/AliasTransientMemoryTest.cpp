#include "frame/FrameNode.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace limn::test
{

namespace
{

using TransientPtr = std::shared_ptr<const RenderTexture>;

/// Nobody looks at it after the frame. @param units  of 16 bytes
TransientPtr MakeTransient(int units)
{
    return std::make_shared<const RenderTexture>(
        "t", RenderTextureDescriptor(units, 1, GraphicsFormat::R32G32B32A32_SFloat), SamplerState{},
        true);
}

FrameNode PlaceNode(const TransientPtr& target,
                    const std::vector<std::shared_ptr<const Texture>>& reads = {})
{
    FrameNode node;
    node.targets.colors = {target};
    node.reads.assign(reads.begin(), reads.end());
    return node;
}

template <typename... Node>
FrameNodes Nodes(Node&&... node)
{
    FrameNodes nodes;
    (nodes.push_back(std::forward<Node>(node)), ...);
    return nodes;
}

/// 16 bytes a texel.
TextureFootprint SixteenBytes(const RenderTexture& texture)
{
    return {static_cast<std::uint64_t>(texture.width()) * 16, 16, 0};
}

const PlacedTexture* FindPlaced(const CompiledFrame& frame, const TransientPtr& target)
{
    for (const PlacedTexture& placed : frame.placed)
    {
        if (placed.texture == target)
        {
            return &placed;
        }
    }
    return nullptr;
}

} // namespace

TEST(AliasTransientMemory, GivesTheMemoryOfATextureThatIsReadNoMoreToTheNext)
{
    const TransientPtr a = MakeTransient(4);
    const TransientPtr b = MakeTransient(4);
    const TransientPtr c = MakeTransient(2);
    CompiledFrame frame;
    AliasTransientMemory(Nodes(PlaceNode(a), PlaceNode(b, {a}), PlaceNode(c, {b})), {},
                         SixteenBytes, frame);
    ASSERT_EQ(3u, frame.placed.size());
    EXPECT_EQ(0u, FindPlaced(frame, a)->offset);
    EXPECT_EQ(64u, FindPlaced(frame, b)->offset);
    EXPECT_EQ(0u, FindPlaced(frame, c)->offset);
    EXPECT_EQ(32u, FindPlaced(frame, c)->size);
}

TEST(AliasTransientMemory, LeavesTexturesAloneWhereNoneCanShare)
{
    const TransientPtr a = MakeTransient(4);
    const TransientPtr b = MakeTransient(4);
    CompiledFrame frame;
    AliasTransientMemory(Nodes(PlaceNode(a), PlaceNode(b, {a})), {}, SixteenBytes, frame);
    EXPECT_TRUE(frame.placed.empty());
}

TEST(AliasTransientMemory, KeepsWhatIsLookedAtAfterTheFrameApart)
{
    const TransientPtr a = MakeTransient(4);
    const auto kept = std::make_shared<const RenderTexture>(
        "kept", RenderTextureDescriptor(4, 1, GraphicsFormat::R32G32B32A32_SFloat));
    const TransientPtr output = MakeTransient(4);
    const std::vector<TransientPtr> outputs{output};
    CompiledFrame frame;
    AliasTransientMemory(Nodes(PlaceNode(a), PlaceNode(kept), PlaceNode(output)), outputs,
                         SixteenBytes, frame);
    EXPECT_TRUE(frame.placed.empty());
}

/// As in the last of several frames, after which nothing is kept.
TEST(AliasTransientMemory, LeavesWhatHoldsSomethingOfAFrameBeforeInMemoryOfItsOwn)
{
    const auto history = std::make_shared<const RenderTexture>(
        "history", RenderTextureDescriptor(4, 1, GraphicsFormat::R32G32B32A32_SFloat));
    const TransientPtr a = MakeTransient(4);
    CompiledFrame frame;
    frame.states.isLast = true;
    TextureState& state = frame.states.textures[history->id()];
    state.texture = history;
    state.usage = TextureUsage::ShaderRead;
    state.isFilled = true;
    AliasTransientMemory(Nodes(PlaceNode(a), PlaceNode(history)), {}, SixteenBytes, frame);
    EXPECT_EQ(nullptr, FindPlaced(frame, history));
    EXPECT_TRUE(state.isFilled);

    state.isFilled = false;
    AliasTransientMemory(Nodes(PlaceNode(a), PlaceNode(history)), {}, SixteenBytes, frame);
    EXPECT_NE(nullptr, FindPlaced(frame, history));
}

TEST(AliasTransientMemory, BeginsAnewWithWhatLiesOrLayInSharedMemory)
{
    const TransientPtr a = MakeTransient(4);
    const TransientPtr b = MakeTransient(4);
    CompiledFrame frame;
    frame.states.textures[a->id()] = {a, TextureUsage::ShaderRead, false, false, {}, false, {}};
    AliasTransientMemory(Nodes(PlaceNode(a), PlaceNode(b)), {}, SixteenBytes, frame);
    EXPECT_EQ(2u, frame.placed.size());
    TextureState& state = frame.states.textures[a->id()];
    EXPECT_EQ(TextureUsage::Undefined, state.usage);
    EXPECT_FALSE(state.isFilled);
    EXPECT_TRUE(state.isPlaced);

    state.usage = TextureUsage::ColorAttachment;
    CompiledFrame next;
    next.states = frame.states;
    AliasTransientMemory(Nodes(PlaceNode(a)), {}, SixteenBytes, next);
    EXPECT_TRUE(next.placed.empty());
    EXPECT_EQ(TextureUsage::Undefined, next.states.textures[a->id()].usage);
    EXPECT_FALSE(next.states.textures[a->id()].isPlaced);
}

TEST(AliasTransientMemory, BeginsAnewWithAnOutputThatLayInSharedMemoryAndNoPassUses)
{
    const TransientPtr output = MakeTransient(4);
    const std::vector<TransientPtr> outputs{output};
    CompiledFrame frame;
    TextureState& state = frame.states.textures[output->id()];
    state.texture = output;
    state.usage = TextureUsage::ColorAttachment;
    state.isPlaced = true;
    AliasTransientMemory({}, outputs, SixteenBytes, frame);
    EXPECT_EQ(TextureUsage::Undefined, state.usage);
    EXPECT_FALSE(state.isPlaced);
}

TEST(AliasTransientMemory, LetsNoTwoHoldSomethingInOnePlaceAtOnce)
{
    std::mt19937 random(20'261'122);
    const auto pick = [&](std::size_t least, std::size_t most)
    {
        return std::uniform_int_distribution(least, most)(random);
    };
    std::uint64_t apart = 0;
    std::uint64_t together = 0;
    for (int i = 0; i < 2000; ++i)
    {
        std::vector<TransientPtr> textures;
        for (int t = 0; t < 8; ++t)
        {
            textures.push_back(MakeTransient(static_cast<int>(pick(1, 9))));
        }
        FrameNodes nodes;
        std::vector<std::vector<bool>> used(textures.size()); // by texture and node
        for (std::size_t n = pick(1, 10); n > 0; --n)
        {
            const std::size_t target = pick(0, 7);
            const std::size_t read = pick(0, 7);
            nodes.push_back(PlaceNode(textures[target], {textures[read]}));
            for (std::size_t t = 0; t < textures.size(); ++t)
            {
                used[t].push_back(t == target || t == read);
            }
        }
        const auto holds = [&](std::size_t texture, std::size_t node)
        {
            const auto& uses = used[texture];
            const auto at = uses.begin() + static_cast<std::ptrdiff_t>(node);
            return std::count(uses.begin(), at + 1, true) > 0 &&
                   std::count(at, uses.end(), true) > 0;
        };
        CompiledFrame frame;
        const auto footprint = [](const RenderTexture& texture)
        {
            const auto units = static_cast<std::uint64_t>(texture.width());
            return TextureFootprint{units * 16, units % 2 == 0 ? 64u : 16u,
                                    static_cast<std::uint32_t>(units % 3 == 0)};
        };
        AliasTransientMemory(nodes, {}, footprint, frame);
        std::uint64_t end[2] = {0, 0};
        for (const PlacedTexture& placed : frame.placed)
        {
            const TextureFootprint needs = footprint(*placed.texture);
            ASSERT_EQ(needs.size, placed.size);
            ASSERT_EQ(0u, placed.offset % needs.alignment);
            apart += placed.size;
            end[placed.kind] = std::max(end[placed.kind], placed.offset + placed.size);
        }
        together += end[0] + end[1];
        for (std::size_t a = 0; a < textures.size(); ++a)
        {
            for (std::size_t b = 0; b < a; ++b)
            {
                const PlacedTexture* one = FindPlaced(frame, textures[a]);
                const PlacedTexture* other = FindPlaced(frame, textures[b]);
                if (one == nullptr || other == nullptr || one->kind != other->kind ||
                    one->offset >= other->offset + other->size ||
                    other->offset >= one->offset + one->size)
                {
                    continue;
                }
                for (std::size_t n = 0; n < nodes.size(); ++n)
                {
                    ASSERT_FALSE(holds(a, n) && holds(b, n)) << "frame " << i << ", node " << n;
                }
            }
        }
    }
    EXPECT_LT(together, apart * 9 / 10) << "some memory is saved";
}

} // namespace limn::test
