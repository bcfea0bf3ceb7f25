#pragma once

#include <cmath>
#include <limn/core/CompiledFrame.h>
#include <map>
#include <stdexcept>
#include <vector>

namespace limn::test
{

/// Runs frames over images of a few whole numbers, one channel a texel, by what commands, loads and
/// stores mean and nothing else. What a draw gives follows from its number (firstInstance), the
/// texels it samples at its own place, and what it promises.
class ImageInterpreter
{
public:
    using Texels = std::vector<long>;
    static constexpr std::size_t k_Size = 4;

    /// Everything in its order, contents kept always.
    void Run(const FrameCommands& frame)
    {
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
        }
    }

    /// As a device may: what is not loaded or not stored becomes a number that nobody expects, and
    /// a texture that is not in the use that its barriers say is an error.
    void Run(const CompiledFrame& frame)
    {
        for (const CompiledRenderPass& pass : frame.passes)
        {
            Run(pass.barriers);
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
                    for (const TextureSlot& slot : draw->bindings->textures)
                    {
                        Expect(*slot.texture, TextureUsage::ShaderRead);
                    }
                    Draw(targets, *draw);
                }
            }
            for (const auto& color : pass.colors)
            {
                Store(*color.texture, color.store);
            }
            if (pass.depth)
            {
                Store(*pass.depth->texture, pass.depth->store);
            }
        }
        Run(frame.finalBarriers);
    }

    const Texels& texels(const Texture& texture) { return Of(texture); }

private:
    static long DepthOf(float depth) { return std::lround(depth * 8.0f); }

    Texels& Of(const Texture& texture)
    {
        return m_Images.try_emplace(texture.id(), k_Size, Poison()).first->second;
    }

    long Poison() { return 1'000'000'007L * ++m_Poisons; }

    void Load(const Texture& texture, LoadOp load, long cleared)
    {
        if (load != LoadOp::Load)
        {
            Of(texture).assign(k_Size, load == LoadOp::Clear ? cleared : Poison());
        }
    }

    void Store(const Texture& texture, StoreOp store)
    {
        if (store == StoreOp::DontCare)
        {
            Of(texture).assign(k_Size, Poison());
        }
    }

    void Run(const std::vector<TextureBarrier>& barriers)
    {
        for (const TextureBarrier& barrier : barriers)
        {
            Expect(*barrier.texture, barrier.before);
            m_Uses[barrier.texture->id()] = barrier.after;
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
                Of(*color).assign(k_Size, std::lround(clear.color.r));
            }
        }
        if (targets.depth && (clear.flags & ClearFlag::Depth))
        {
            Of(*targets.depth).assign(k_Size, DepthOf(clear.depth));
        }
    }

    void Draw(const SetRenderTargetCommand& targets, const DrawCommand& draw)
    {
        const long number = draw.firstInstance;
        for (std::size_t i = 0; i < k_Size; ++i)
        {
            const bool isCovered = draw.fullScreen || ((number >> i) & 1) != 0;
            if (!isCovered || !PassesDepth(targets, draw, i))
            {
                continue;
            }
            const long value = Fragment(draw, i);
            for (std::size_t target = 0; target < targets.colors.size(); ++target)
            {
                const RenderTargetBlendState& blend = draw.state.targets[target];
                const bool keeps = blend.destinationColorBlendMode != BlendMode::Zero;
                long& texel = Of(*targets.colors[target])[i];
                texel = blend.writeMask == 0 ? texel : ((keeps ? texel : 0) + value) % k_Modulus;
            }
        }
    }

    bool PassesDepth(const SetRenderTargetCommand& targets, const DrawCommand& draw, std::size_t i)
    {
        if (!targets.depth || draw.state.zTest == CompareFunction::Disabled)
        {
            return true;
        }
        long& stored = Of(*targets.depth)[i];
        const long depth = draw.firstInstance % 7;
        const bool passes = draw.state.zTest == CompareFunction::Always || depth <= stored;
        stored = passes && draw.state.zWrite ? depth : stored;
        return passes;
    }

    static constexpr long k_Modulus = 1'000'003;

    long Fragment(const DrawCommand& draw, std::size_t i)
    {
        long sum = 0;
        long product = 1 + draw.firstInstance % 3;
        for (const TextureSlot& slot : draw.bindings->textures)
        {
            sum += Of(*slot.texture)[i] % k_Modulus;
            product = product * Of(*slot.texture)[i] % k_Modulus;
        }
        const FullScreenPromise* promise = draw.fullScreen.get();
        return promise && promise->copied                  ? sum
               : promise && !promise->zeroTextures.empty() ? product
                                                           : sum * 5 + draw.firstInstance;
    }

    std::map<std::uint64_t, Texels> m_Images;
    std::map<std::uint64_t, TextureUsage> m_Uses;
    long m_Poisons = 0;
};

} // namespace limn::test
