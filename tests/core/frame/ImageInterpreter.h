#pragma once

#include <algorithm>
#include <cmath>
#include <limn/core/CompiledFrame.h>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace limn::test
{

/// Runs frames over images of a few whole numbers, one channel a texel, by what commands, loads,
/// stores and resolves mean and nothing else. What a draw gives follows from its number
/// (firstInstance), the texels it samples at its own place, and what it promises; a texel of
/// several samples is a weighted sum of them, in which each counts and equal ones give themselves.
/// A dispatch changes some texels of what it may write, by its number, what it samples and what is
/// in there and in its buffers, and each of the buffers, which hold one number.
class ImageInterpreter
{
public:
    using Texels = std::vector<long>;
    static constexpr std::size_t k_Size = 4; ///< texels

    /// Everything in its order, contents kept always.
    void Run(const FrameCommands& frame)
    {
        m_SeesSamples = true;
        m_Tables = &frame;
        SetRenderTargetCommand targets;
        for (const FrameCommand& command : frame.commands)
        {
            if (const auto* bind = std::get_if<SetRenderTargetCommand>(&command))
            {
                targets = *bind;
            }
            else if (const auto* clear = std::get_if<ClearCommand>(&command))
            {
                Clear(targets, *clear);
            }
            else if (const auto* draw = std::get_if<DrawCommand>(&command))
            {
                Draw(targets, *draw);
            }
            else if (const auto* dispatch = std::get_if<DispatchCommand>(&command))
            {
                Dispatch(*dispatch);
            }
        }
    }

    /// As a device may: what is not loaded or not stored becomes a number that nobody expects, and
    /// so does all that lies in the same memory as what is written; a texture that is not in the
    /// use that its barriers say is an error.
    void Run(const CompiledFrame& frame)
    {
        m_SeesSamples = false;
        m_Tables = &frame;
        Place(frame.placed);
        for (const CompiledRenderPass& pass : frame.passes)
        {
            Run(pass.barriers);
            Run(pass.bufferBarriers);
            SetRenderTargetCommand targets;
            for (const auto& color : pass.colors)
            {
                Expect(*color.texture, TextureUsage::ColorAttachment);
                targets.colors.push_back(color.texture);
                Load(*color.texture, color.load, std::lround(color.clearColor.r));
            }
            if (pass.depth)
            {
                Expect(*pass.depth->texture, TextureUsage::DepthStencilAttachment);
                targets.depth = pass.depth->texture;
                Load(*pass.depth->texture, pass.depth->load, DepthOf(pass.depth->clearDepth));
            }
            for (const PassCommand& command : pass.commands)
            {
                if (const auto* clear = std::get_if<ClearCommand>(&command))
                {
                    Clear(targets, *clear);
                }
                else if (const auto* draw = std::get_if<DrawCommand>(&command))
                {
                    for (const TextureSlot& slot : frame.Setup(*draw).bindings->textures)
                    {
                        Expect(*slot.texture, TextureUsage::ShaderRead);
                    }
                    Draw(targets, *draw);
                }
                else if (const auto* dispatch = std::get_if<DispatchCommand>(&command))
                {
                    ExpectReady(*frame.Setup(*dispatch).bindings);
                    Dispatch(*dispatch);
                }
            }
            for (const auto& color : pass.colors)
            {
                Resolve(*color.texture, color.resolve, TextureUsage::ColorAttachment);
                Store(*color.texture, color.store);
            }
            if (pass.depth)
            {
                Resolve(*pass.depth->texture, pass.depth->resolve,
                        TextureUsage::DepthStencilAttachment);
                Store(*pass.depth->texture, pass.depth->store);
            }
        }
        Run(frame.finalBarriers);
    }

    long value(const GraphicsBuffer& buffer) { return m_Buffers[buffer.id()].value; }

    Texels texels(const Texture& texture)
    {
        Texels result;
        for (std::size_t i = 0; i < k_Size; ++i)
        {
            result.push_back(Seen(texture, i));
        }
        return result;
    }

private:
    static long DepthOf(float depth) { return std::lround(depth * 8.0f); }

    static std::size_t SampleCount(const Texture& texture)
    {
        const auto& target = dynamic_cast<const RenderTexture&>(texture);
        return static_cast<std::size_t>(target.descriptor().msaaSamples);
    }

    /// All samples, those of one texel together.
    Texels& Of(const Texture& texture)
    {
        return m_Images.try_emplace(texture.id(), k_Size * SampleCount(texture), Poison())
            .first->second;
    }

    /// What a frame places holds nothing at first, and neither does what the last one placed.
    void Place(const std::vector<PlacedTexture>& placed)
    {
        const auto forget = [&](const PlacedTexture& place)
        {
            std::ranges::fill(Of(*place.texture), Poison());
        };
        std::ranges::for_each(m_Placed, forget);
        std::ranges::for_each(placed, forget);
        m_Placed = placed;
    }

    /// For writing: destroys what lies in the same memory.
    Texels& Written(const Texture& texture)
    {
        const auto place = std::ranges::find(
            m_Placed, texture.id(), [](const PlacedTexture& p) { return p.texture->id(); });
        for (const PlacedTexture& other : m_Placed)
        {
            const bool overlaps = place != m_Placed.end() && other.texture != place->texture &&
                                  other.kind == place->kind &&
                                  other.offset < place->offset + place->size &&
                                  place->offset < other.offset + other.size;
            if (overlaps)
            {
                std::ranges::fill(Of(*other.texture), Poison());
            }
        }
        return Of(texture);
    }

    Texels& ResolvedOf(const Texture& texture)
    {
        return m_Resolved.try_emplace(texture.id(), k_Size, Poison()).first->second;
    }

    static long ResolveTexel(const long* samples, std::size_t count, bool isDepth)
    {
        return count == 1 || isDepth
                   ? samples[0]
                   : 2 * samples[0] + 3 * samples[1] - samples[2] - 3 * samples[3];
    }

    /// What a reader gets.
    long Seen(const Texture& texture, std::size_t i)
    {
        const std::size_t count = SampleCount(texture);
        return count == 1 || m_SeesSamples ? ResolveTexel(&Of(texture)[i * count], count,
                                                          IsDepthFormat(texture.graphicsFormat()))
                                           : ResolvedOf(texture)[i];
    }

    void Resolve(const Texture& texture, const std::shared_ptr<const RenderTexture>& to,
                 TextureUsage usage)
    {
        if (!to)
        {
            return;
        }
        Expect(*to, usage);
        const std::size_t count = SampleCount(texture);
        for (std::size_t i = 0; i < k_Size; ++i)
        {
            Texels& result = to.get() == &texture ? ResolvedOf(texture) : Written(*to);
            result[i] = ResolveTexel(&Of(texture)[i * count], count,
                                     IsDepthFormat(texture.graphicsFormat()));
        }
    }

    long Poison() { return 1'000'000'007L * ++m_Poisons; }

    void Load(const Texture& texture, LoadOp load, long cleared)
    {
        if (load != LoadOp::Load)
        {
            std::ranges::fill(Written(texture), load == LoadOp::Clear ? cleared : Poison());
        }
    }

    void Store(const Texture& texture, StoreOp store)
    {
        if (store == StoreOp::DontCare)
        {
            std::ranges::fill(Of(texture), Poison());
        }
    }

    void Run(const std::vector<TextureBarrier>& barriers)
    {
        for (const TextureBarrier& barrier : barriers)
        {
            if (barrier.before == TextureUsage::Undefined)
            {
                std::ranges::fill(Written(*barrier.texture), Poison());
            }
            else
            {
                Expect(*barrier.texture, barrier.before);
            }
            m_Uses[barrier.texture->id()] = barrier.after;
            if (barrier.after == TextureUsage::RandomWrite)
            {
                m_Barred.insert(barrier.texture->id());
            }
        }
    }

    /// What a kernel wrote is seen behind a barrier, and written over behind one for all readers.
    void Run(const std::vector<BufferBarrier>& barriers)
    {
        for (const BufferBarrier& barrier : barriers)
        {
            BufferContent& content = m_Buffers[barrier.buffer->id()];
            content.isHidden = content.isHidden && !barrier.wasWritten;
            content.isRead = content.isRead && !barrier.isWritten;
        }
    }

    void ExpectReady(const DrawBindings& bindings)
    {
        for (const TextureSlot& slot : bindings.textures)
        {
            Expect(*slot.texture, TextureUsage::ShaderRead);
        }
        for (const StorageTextureSlot& slot : bindings.storageTextures)
        {
            Expect(*slot.texture, TextureUsage::RandomWrite);
            if (!m_Barred.contains(slot.texture->id()))
            {
                throw std::logic_error("'" + slot.texture->name() + "' is written twice");
            }
            m_Barred.erase(slot.texture->id());
        }
        for (const BufferSlot& slot : bindings.buffers)
        {
            BufferContent& content = m_Buffers[slot.buffer->id()];
            if (content.isHidden || (slot.isWritten && content.isRead))
            {
                throw std::logic_error("a buffer needs a barrier");
            }
            content.isHidden = slot.isWritten;
            content.isRead = !slot.isWritten;
        }
    }

    void Dispatch(const DispatchCommand& dispatch)
    {
        const DrawBindings& bindings = *m_Tables->Setup(dispatch).bindings;
        const long number = dispatch.groups[0];
        long sum = number;
        for (const BufferSlot& slot : bindings.buffers)
        {
            sum += m_Buffers[slot.buffer->id()].value * 7;
        }
        long all = 0;
        for (std::size_t i = 0; i < k_Size; ++i)
        {
            long value = sum;
            for (const TextureSlot& slot : bindings.textures)
            {
                value += Seen(*slot.texture, i) % k_Modulus;
            }
            all += value;
            for (const StorageTextureSlot& slot : bindings.storageTextures)
            {
                long& texel = Written(*slot.texture)[i];
                const bool changes = ((number >> i) & 1) != 0;
                texel = changes ? (texel % k_Modulus * 3 + value) % k_Modulus : texel;
            }
        }
        for (const BufferSlot& slot : bindings.buffers)
        {
            long& value = m_Buffers[slot.buffer->id()].value;
            value = slot.isWritten ? (value + all) % k_Modulus : value;
        }
    }

    void Expect(const Texture& texture, TextureUsage usage)
    {
        if (m_Uses[texture.id()] != usage)
        {
            throw std::logic_error("'" + texture.name() + "' is in another use");
        }
    }

    void Clear(const SetRenderTargetCommand& targets, const ClearCommand& clear)
    {
        for (const auto& color : targets.colors)
        {
            if (clear.flags & ClearFlag::Color)
            {
                std::ranges::fill(Written(*color), std::lround(clear.color.r));
            }
        }
        if (targets.depth && (clear.flags & ClearFlag::Depth))
        {
            std::ranges::fill(Written(*targets.depth), DepthOf(clear.depth));
        }
    }

    void Draw(const SetRenderTargetCommand& targets, const DrawCommand& draw)
    {
        const std::size_t count =
            SampleCount(targets.colors.empty() ? *targets.depth : *targets.colors.front());
        for (std::size_t sample = 0; sample < k_Size * count; ++sample)
        {
            if (!Covers(draw, sample, count) || !PassesDepth(targets, draw, sample))
            {
                continue;
            }
            const long value = Fragment(draw, sample / count);
            for (std::size_t target = 0; target < targets.colors.size(); ++target)
            {
                const RenderTargetBlendState& blend = m_Tables->Setup(draw).state.targets[target];
                const bool keeps = blend.destinationColorBlendMode != BlendMode::Zero;
                long& texel = Written(*targets.colors[target])[sample];
                texel = blend.writeMask == 0 ? texel : ((keeps ? texel : 0) + value) % k_Modulus;
            }
        }
    }

    bool Covers(const DrawCommand& draw, std::size_t sample, std::size_t count) const
    {
        const std::size_t bits = count == 1 ? draw.firstInstance : draw.firstInstance * 0x9E37U;
        return m_Tables->Setup(draw).fullScreen || ((bits >> sample) & 1) != 0;
    }

    bool PassesDepth(const SetRenderTargetCommand& targets, const DrawCommand& draw, std::size_t i)
    {
        const PipelineState& state = m_Tables->Setup(draw).state;
        if (!targets.depth || state.zTest == CompareFunction::Disabled)
        {
            return true;
        }
        long& stored = Written(*targets.depth)[i];
        const long depth = draw.firstInstance % 7;
        const bool passes = state.zTest == CompareFunction::Always || depth <= stored;
        stored = passes && state.zWrite ? depth : stored;
        return passes;
    }

    static constexpr long k_Modulus = 1'000'003;

    long Fragment(const DrawCommand& draw, std::size_t i)
    {
        long sum = 0;
        long product = 1 + draw.firstInstance % 3;
        for (const TextureSlot& slot : m_Tables->Setup(draw).bindings->textures)
        {
            sum += Seen(*slot.texture, i) % k_Modulus;
            product = product * (Seen(*slot.texture, i) % k_Modulus) % k_Modulus;
        }
        const FullScreenPromise* promise = m_Tables->Setup(draw).fullScreen.get();
        return promise && promise->copied                  ? sum
               : promise && !promise->zeroTextures.empty() ? product
                                                           : sum * 5 + draw.firstInstance;
    }

    const FrameTables* m_Tables = nullptr; ///< of the frame that runs
    bool m_SeesSamples = true; ///< readers see what samples are, not what they were resolved to
    std::map<std::uint64_t, Texels> m_Images;
    std::map<std::uint64_t, Texels> m_Resolved;
    std::map<std::uint64_t, TextureUsage> m_Uses;
    std::vector<PlacedTexture> m_Placed; ///< by the last frame
    std::set<std::uint64_t> m_Barred;    ///< a barrier made them writable, and nothing wrote since
    struct BufferContent
    {
        long value = 0;
        bool isHidden = false; ///< written, and no barrier since
        bool isRead = false;   ///< and no barrier for a writer since
    };
    std::map<std::uint64_t, BufferContent> m_Buffers;
    long m_Poisons = 0;
};

} // namespace limn::test
