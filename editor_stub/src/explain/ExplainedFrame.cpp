#include "explain/ExplainedFrame.h"

#include "console/Texts.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace limn
{

namespace
{

std::uint64_t BytesOf(const Texture& texture, int samples)
{
    return static_cast<std::uint64_t>(texture.width()) *
           static_cast<std::uint64_t>(texture.height()) *
           static_cast<std::uint64_t>(texture.slices() * samples) *
           static_cast<std::uint64_t>(BytesPerTexel(texture.graphicsFormat()));
}

const char* NameOf(TextureUsage usage)
{
    constexpr std::array k_Names{"Undefined",  "ColorAttachment", "DepthStencilAttachment",
                                 "ShaderRead", "CopySource",      "RandomWrite"};
    return k_Names.at(static_cast<std::size_t>(usage));
}

class FrameExplainer
{
public:
    explicit FrameExplainer(const FrameTables& tables) : m_Tables(tables) {}

    ExplainedFrame Explain(const CompiledFrame& frame)
    {
        for (const CompiledRenderPass& pass : frame.passes)
        {
            m_Result.passes.emplace_back();
            Explain(pass);
        }
        for (const TextureBarrier& barrier : frame.finalBarriers)
        {
            m_Result.finalBarriers.push_back(Explain(barrier));
            ExplainedTexture& texture = m_Result.textures[m_Result.finalBarriers.back().texture];
            texture.isOutput = texture.isOutput || barrier.after == TextureUsage::CopySource;
        }
        ExplainShared(frame.placed);
        m_Result.leftOut = frame.leftOut;
        std::ranges::stable_sort(m_Result.leftOut, {}, &LeftOut::place);
        return std::move(m_Result);
    }

private:
    void ExplainShared(const std::vector<PlacedTexture>& placed)
    {
        for (const PlacedTexture& one : placed)
        {
            for (const PlacedTexture& other : placed)
            {
                if (one.texture != other.texture && one.kind == other.kind &&
                    one.offset < other.offset + other.size && other.offset < one.offset + one.size)
                {
                    m_Result.textures[IndexOf(*one.texture)].sharedWith.push_back(
                        other.texture->name());
                }
            }
        }
    }

    /// Explains the textures and buffers that dispatches may write.
    void ExplainWritten(const CompiledRenderPass& pass, ExplainedPass& result)
    {
        for (const TextureBarrier& barrier : pass.barriers)
        {
            if (barrier.after == TextureUsage::RandomWrite)
            {
                result.targets.push_back({Use(*barrier.texture, m_Result.passes.size()),
                                          barrier.before == TextureUsage::Undefined ? "-" : "load",
                                          "store"});
            }
        }
    }

    /// Explains a colour or depth attachment. A stencil that is used counts with the depth.
    template <typename Attachment>
    ExplainedAttachment Explain(const Attachment& attachment, LoadOp load, bool isStored)
    {
        constexpr std::array k_Loads{"load", "clear", "-"};
        const std::size_t pass = m_Result.passes.size();
        const std::size_t texture = Use(*attachment.texture, pass);
        if (attachment.resolve)
        {
            Use(*attachment.resolve, pass);
        }
        return {texture, k_Loads.at(static_cast<std::size_t>(load)),
                isStored && attachment.resolve ? "store and resolve"
                : isStored                     ? "store"
                : attachment.resolve           ? "resolve"
                                               : "-"};
    }

    void Explain(const CompiledRenderPass& pass)
    {
        ExplainedPass result;
        result.place = pass.place;
        result.width = pass.width;
        result.height = pass.height;
        for (const TextureBarrier& barrier : pass.barriers)
        {
            result.barriers.push_back(Explain(barrier));
        }
        result.bufferBarriers = static_cast<int>(pass.bufferBarriers.size());
        for (const ColorAttachment& color : pass.colors)
        {
            result.targets.push_back(Explain(color, color.load, color.store == StoreOp::Store));
        }
        if (pass.depth)
        {
            const DepthAttachment& depth = *pass.depth;
            const bool isStored =
                depth.store == StoreOp::Store || depth.stencilStore == StoreOp::Store;
            result.targets.push_back(Explain(
                depth, depth.stencilLoad == LoadOp::Load ? LoadOp::Load : depth.load, isStored));
        }
        ExplainWritten(pass, result);
        AddCommands(pass, result);
        m_Result.passes.back() = std::move(result);
    }

    void AddCommands(const CompiledRenderPass& pass, ExplainedPass& result)
    {
        result.name = pass.Title();
        for (const PassCommand& command : pass.commands)
        {
            if (const auto* draw = std::get_if<DrawCommand>(&command))
            {
                ++result.draws;
                result.instances += static_cast<int>(draw->instanceCount);
                result.limited += draw->scissor ? 1 : 0;
                AddBindings(*m_Tables.Setup(*draw).bindings, result);
            }
            if (const auto* dispatch = std::get_if<DispatchCommand>(&command))
            {
                ++result.dispatches;
                AddBindings(*m_Tables.Setup(*dispatch).bindings, result);
            }
        }
    }

    void AddBindings(const DrawBindings& bindings, ExplainedPass& result)
    {
        result.indirect += bindings.arguments() != nullptr ? 1 : 0;
        for (const TextureSlot& slot : bindings.textures)
        {
            AddOnce(Use(*slot.texture, m_Result.passes.size()), result.reads);
        }
    }

    /// @param pass  from 1
    std::size_t Use(const Texture& texture, std::size_t pass)
    {
        const std::size_t index = IndexOf(texture);
        ExplainedTexture& explained = m_Result.textures[index];
        explained.last = static_cast<int>(pass);
        explained.first = explained.first == 0 ? explained.last : explained.first;
        return index;
    }

    std::size_t IndexOf(const Texture& texture)
    {
        const auto found = std::ranges::find(m_Ids, texture.id());
        if (found != m_Ids.end())
        {
            return static_cast<std::size_t>(found - m_Ids.begin());
        }
        const auto* drawn = dynamic_cast<const RenderTexture*>(&texture);
        ExplainedTexture explained;
        explained.name = texture.name();
        explained.size = texture.DescribeSize();
        explained.format = ToString(texture.graphicsFormat());
        explained.samples = drawn ? drawn->descriptor().msaaSamples : 1;
        explained.bytes = BytesOf(texture, explained.samples);
        explained.isDrawn = drawn != nullptr;
        m_Result.textures.push_back(std::move(explained));
        m_Ids.push_back(texture.id());
        return m_Ids.size() - 1;
    }

    ExplainedBarrier Explain(const TextureBarrier& barrier)
    {
        return {IndexOf(*barrier.texture), NameOf(barrier.before), NameOf(barrier.after)};
    }

    const FrameTables& m_Tables;
    ExplainedFrame m_Result;
    std::vector<std::uint64_t> m_Ids; ///< of m_Result.textures
};

} // namespace

ExplainedFrame ExplainFrame(const CompiledFrame& frame)
{
    return FrameExplainer(frame).Explain(frame);
}

std::vector<std::shared_ptr<const RenderTexture>> TargetTextures(const CompiledRenderPass& pass)
{
    std::vector<std::shared_ptr<const RenderTexture>> targets;
    std::ranges::transform(pass.colors, std::back_inserter(targets), &ColorAttachment::texture);
    if (pass.depth)
    {
        targets.push_back(pass.depth->texture);
    }
    return targets;
}

std::string DrawsText(const ExplainedPass& pass)
{
    const auto some = [](int count, int all, const std::string& what)
    {
        return count == 0     ? ""
               : count == all ? " " + what
                              : ", " + std::to_string(count) + " of them " + what;
    };
    if (pass.dispatches > 0)
    {
        return std::to_string(pass.dispatches) +
               (pass.dispatches == 1 ? " dispatch" : " dispatches") +
               some(pass.indirect, pass.dispatches, "by a buffer's counts");
    }
    const std::string before =
        pass.instances == pass.draws ? "" : std::to_string(pass.instances) + " → ";
    const char* part = pass.limited == pass.draws ? "in a part only" : "in a part";
    return before + CountText(static_cast<std::size_t>(pass.draws), "draw") +
           some(pass.limited, pass.draws, part) +
           some(pass.indirect, pass.draws, "by a buffer's counts");
}

std::string BytesText(std::uint64_t bytes)
{
    constexpr std::array k_Units{"KiB", "MiB", "GiB"};
    double value = static_cast<double>(bytes) / 1024.0;
    std::size_t unit = 0;
    for (; value >= 1000.0 && unit + 1 < k_Units.size(); ++unit)
    {
        value /= 1024.0;
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f %s", value, k_Units.at(unit));
    return bytes < 1024 ? std::to_string(bytes) + " B" : text.data();
}

} // namespace limn
