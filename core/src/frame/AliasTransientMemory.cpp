#include "frame/FrameNode.h"

#include <algorithm>
#include <limn/core/FrameCompiler.h>

namespace limn
{

namespace
{

/// A texture that holds something from one node to another.
struct Lifetime
{
    std::shared_ptr<const RenderTexture> texture;
    std::size_t first = 0;
    std::size_t last = 0; ///< included
    TextureFootprint footprint;
    std::uint64_t offset = 0;
};

using Lifetimes = std::pmr::vector<Lifetime>;

class LifetimeFinder
{
public:
    explicit LifetimeFinder(const FrameAllocator& memory) : m_Lifetimes(memory), m_Index(memory) {}

    Lifetimes Find(const FrameNodes& nodes)
    {
        for (std::size_t i = 0; i < nodes.size(); ++i)
        {
            for (const auto& texture : nodes[i].reads)
            {
                Use(std::static_pointer_cast<const RenderTexture>(texture), i);
            }
            ForEachTarget(nodes[i], [&](const auto& target) { Use(target, i); });
            for (const SampleResolve& resolve : nodes[i].resolves)
            {
                Use(resolve.to, i);
            }
        }
        return std::move(m_Lifetimes);
    }

private:
    void Use(const std::shared_ptr<const RenderTexture>& texture, std::size_t node)
    {
        const auto [found, isNew] = m_Index.try_emplace(texture->id(), m_Lifetimes.size());
        if (isNew)
        {
            m_Lifetimes.push_back({texture, node, node, {}, 0});
        }
        m_Lifetimes[found->second].last = node;
    }

    Lifetimes m_Lifetimes;
    std::pmr::unordered_map<std::uint64_t, std::size_t> m_Index; ///< by Texture::id
};

bool MayShare(const Lifetime& a, const Lifetime& b)
{
    return a.footprint.kind != b.footprint.kind || a.last < b.first || b.last < a.first;
}

std::uint64_t AlignUp(std::uint64_t offset, std::uint64_t alignment)
{
    return (offset + alignment - 1) / alignment * alignment;
}

/// The lowest offset where nothing lies that is alive at the same time.
std::uint64_t FreeOffset(const Lifetime& lifetime, const Lifetimes& placed)
{
    using Extent = std::pair<std::uint64_t, std::uint64_t>; // begin and end
    std::pmr::vector<Extent> taken(placed.get_allocator());
    for (const Lifetime& other : placed)
    {
        if (!MayShare(lifetime, other))
        {
            taken.emplace_back(other.offset, other.offset + other.footprint.size);
        }
    }
    std::sort(taken.begin(), taken.end());
    std::uint64_t offset = 0;
    for (const auto& [begin, end] : taken)
    {
        if (offset + lifetime.footprint.size <= begin)
        {
            break;
        }
        offset = std::max(offset, AlignUp(end, lifetime.footprint.alignment));
    }
    return offset;
}

/// Returns whether some of them lie in one place.
bool Shares(const Lifetimes& placed)
{
    const auto overlap = [](const Lifetime& a, const Lifetime& b)
    {
        return &a != &b && a.footprint.kind == b.footprint.kind &&
               a.offset < b.offset + b.footprint.size && b.offset < a.offset + a.footprint.size;
    };
    return std::ranges::any_of(
        placed, [&](const Lifetime& a)
        { return std::ranges::any_of(placed, [&](const Lifetime& b) { return overlap(a, b); }); });
}

/// Nothing of the contents is kept, since the memory is or was another texture's, too.
void Forget(TextureState& state, bool isPlaced)
{
    if (state.isPlaced || isPlaced)
    {
        state.usage = TextureUsage::Undefined;
        state.isFilled = false;
    }
    state.isPlaced = isPlaced;
}

} // namespace

void AliasTransientMemory(const FrameNodes& nodes, OutputSpan outputs,
                          const TextureFootprintFunction& footprint, CompiledFrame& frame)
{
    Lifetimes lifetimes = LifetimeFinder(nodes.get_allocator()).Find(nodes);
    Lifetimes placed(nodes.get_allocator());
    for (Lifetime& lifetime : lifetimes)
    {
        const RenderTexture& texture = *lifetime.texture;
        // A pass may still read what an earlier frame has left in the texture, though nobody need
        // keep it any longer.
        const TextureState* state = FindState(frame.states, texture);
        if (footprint && !Contains(outputs, texture) && !(state && state->isFilled) &&
            !HasSamples(texture) && !OutlivesFrame(texture, frame.states))
        {
            lifetime.footprint = footprint(texture);
            if (lifetime.footprint.size > 0)
            {
                placed.push_back(lifetime);
            }
        }
    }
    // The largest first: the smaller ones fit into what they leave.
    const auto rank = [](const Lifetime& lifetime)
    {
        return std::pair(~lifetime.footprint.size, lifetime.texture->id());
    };
    std::ranges::sort(placed, {}, rank);
    Lifetimes done(nodes.get_allocator());
    for (Lifetime& lifetime : placed)
    {
        lifetime.offset = FreeOffset(lifetime, done);
        done.push_back(lifetime);
    }
    if (!Shares(done))
    {
        done.clear();
    }
    const auto takeOwnMemory = [&](const RenderTexture& texture)
    {
        const auto found = frame.states.textures.find(texture.id());
        if (found != frame.states.textures.end())
        {
            Forget(found->second, false);
        }
    };
    std::ranges::for_each(lifetimes, [&](const Lifetime& l) { takeOwnMemory(*l.texture); });
    std::ranges::for_each(outputs, [&](const auto& output) { takeOwnMemory(*output); });
    for (const Lifetime& lifetime : done)
    {
        Forget(StateOf(frame.states, lifetime.texture), true);
        frame.placed.push_back(
            {lifetime.texture, lifetime.footprint.kind, lifetime.offset, lifetime.footprint.size});
    }
}

} // namespace limn
