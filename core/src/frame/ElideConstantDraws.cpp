#include "frame/FrameNode.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace limn
{

namespace
{

bool UsesDepth(const FrameNode& node, const FrameTables& tables)
{
    return AnyDraw(node, tables, [](const DrawSetup& draw) { return UsesDepth(draw.state); }) ||
           std::ranges::any_of(node.commands,
                               [](const PassCommand& command)
                               {
                                   const auto* clear = std::get_if<ClearCommand>(&command);
                                   return clear && (clear->flags & ClearFlag::DepthStencil);
                               });
}

/// The one colour that every fragment of a full-screen draw has.
struct ConstantDraw
{
    std::pmr::string why; ///< "" = they differ, as far as anybody knows
    Color output;         ///< linear
};

/// Returns what an sRGB texture of 8 bits shows a component as that was rounded to a half float;
/// nothing where that lies so near to the middle of two steps that devices differ.
std::optional<float> ShowHalf(float component)
{
    constexpr float k_Steps = 255.0f;
    constexpr float k_Sure = 0.4f; // of a step; conversions to sRGB are right within 0.6 of one
    const float held = glm::unpackHalf1x16(glm::packHalf1x16(component));
    const float shown = std::clamp(Color(held, held, held).gamma().r, 0.0f, 1.0f) * k_Steps;
    const float step = std::round(shown) / k_Steps;
    return std::abs(shown - std::round(shown)) < k_Sure
               ? std::optional(Color(step, step, step).linear().r)
               : std::nullopt;
}

/// Returns a colour to clear a texture of the format `to` to, so that it holds what a copy from one
/// of the format `from` would give that was cleared to `color`; nothing where devices differ.
std::optional<Color> ColorOfCopy(GraphicsFormat from, GraphicsFormat to, const Color& color)
{
    const auto isExact = [](float component)
    {
        return component == 0.0f || component == 1.0f;
    };
    if (from == to || (isExact(color.r) && isExact(color.g) && isExact(color.b)))
    {
        return color;
    }
    if (from != GraphicsFormat::R16G16B16A16_SFloat || to != GraphicsFormat::R8G8B8A8_SRGB)
    {
        return std::nullopt;
    }
    const std::optional<float> r = ShowHalf(color.r);
    const std::optional<float> g = ShowHalf(color.g);
    const std::optional<float> b = ShowHalf(color.b);
    return r && g && b ? std::optional(Color(*r, *g, *b)) : std::nullopt;
}

/// Returns the set-up of a draw that reads another texture in place of the one that it copies.
DrawSetup CopyingInstead(DrawSetup setup, const std::shared_ptr<const Texture>& texture)
{
    auto promise = std::make_shared<FullScreenPromise>(*setup.fullScreen);
    setup.bindings = WithTexture(*setup.bindings, *promise->copied, texture);
    promise->copied = nullptr; // else the copy would be left out, with what its format rounds
    setup.fullScreen = std::move(promise);
    return setup;
}

/// Goes through a frame in its order and knows of each texture what every texel of it is, if that
/// is known.
class ConstantFolder
{
public:
    ConstantFolder(CompiledFrame& frame, const FrameAllocator& memory)
        : m_Tables(frame), m_States(frame.states), m_Nodes(memory), m_Why(memory)
    {
    }

    void Fold(FrameNodes& nodes, OutputSpan outputs)
    {
        m_Nodes.reserve(2 * nodes.size()); // each may have a clear before it
        for (FrameNode& node : nodes)
        {
            Fold(node);
        }
        for (const auto& output : outputs)
        {
            WriteWhatIsPending(output);
        }
        nodes = std::move(m_Nodes);
    }

private:
    void Fold(FrameNode& node)
    {
        m_Place = node.place;
        FoldDraws(node);
        LeaveOutSamples(node);
        LeaveOutDepth(node);
        CollectReads(node, m_Tables);
        if (!HasDraws(node) && !Has<ClearCommand>(node))
        {
            RememberClear(node);
            node.whyLeftOut =
                m_Why.empty()
                    ? "it draws nothing; its clear is done where a later pass reads the texture"
                    : m_Why;
        }
        else
        {
            for (const auto& texture : node.reads)
            {
                WriteWhatIsPending(std::static_pointer_cast<const RenderTexture>(texture));
            }
            BeginWithWhatIsPending(node);
        }
        m_Nodes.push_back(std::move(node));
    }

    TextureState& StateOf(const std::shared_ptr<const RenderTexture>& texture)
    {
        return limn::StateOf(m_States, texture);
    }

    /// Draws that change nothing go; a first one that makes its target a constant is a clear.
    void FoldDraws(FrameNode& node)
    {
        m_Why.clear();
        bool isFirst = true;
        std::erase_if(node.commands,
                      [&](const PassCommand& command)
                      {
                          const auto* draw = std::get_if<DrawCommand>(&command);
                          const bool folds = draw && Fold(node, m_Tables.Setup(*draw), isFirst);
                          isFirst = isFirst && (draw == nullptr || folds);
                          return folds;
                      });
    }

    /// @return whether the draw can go
    bool Fold(FrameNode& node, const DrawSetup& draw, bool isFirst)
    {
        if (!draw.fullScreen)
        {
            return false;
        }
        const ConstantDraw constant = FindConstant(node, *draw.fullScreen);
        if (constant.why.empty() || (node.targets.depth && UsesDepth(draw.state)))
        {
            return false;
        }
        if (ChangesNothing(node, draw, constant.output))
        {
            m_Why = Text({"it changes nothing: ", constant.why});
            return true;
        }
        if (isFirst && node.coversColor)
        {
            m_Why = Text({"it makes every texel the same: ", constant.why});
            node.coversColor = false;
            AddClear(node, {ClearFlag::Color, constant.output});
            return true;
        }
        return false;
    }

    /// A draw that still copies one colour from a texture of several samples gets a texture of one
    /// sample to copy from.
    void LeaveOutSamples(FrameNode& node)
    {
        for (PassCommand& command : node.commands)
        {
            auto* draw = std::get_if<DrawCommand>(&command);
            const FullScreenPromise* promise =
                draw ? m_Tables.Setup(*draw).fullScreen.get() : nullptr;
            const auto from =
                promise ? std::dynamic_pointer_cast<const RenderTexture>(promise->copied) : nullptr;
            if (from && HasSamples(*from) && StateOf(from).isPending &&
                (StateOf(from).constant.flags & ClearFlag::Color))
            {
                m_Tables.setups.push_back(
                    CopyingInstead(m_Tables.Setup(*draw), WithOneSample(*from)));
                draw->setup = static_cast<std::uint32_t>(m_Tables.setups.size() - 1);
            }
        }
    }

    /// Makes a texture that is to hold what the other one does.
    std::shared_ptr<const RenderTexture> WithOneSample(const RenderTexture& texture)
    {
        RenderTextureDescriptor descriptor = texture.descriptor();
        descriptor.msaaSamples = 1;
        const auto twin = std::make_shared<const RenderTexture>(texture.name(), descriptor,
                                                                texture.sampler(), true);
        TextureState& state = StateOf(twin);
        state.constant = m_States.textures[texture.id()].constant;
        state.isPending = true;
        return twin;
    }

    ConstantDraw FindConstant(const FrameNode& node, const FullScreenPromise& promise)
    {
        if (promise.copied && node.targets.colors.size() == 1)
        {
            return FindCopiedConstant(*promise.copied, *node.targets.colors.front());
        }
        return {WhyConstant(promise), promise.output};
    }

    /// A copy of a texture that is one colour all over is that colour.
    ConstantDraw FindCopiedConstant(const Texture& from, const RenderTexture& to) const
    {
        const Color* held = FindColor(from);
        const std::optional<Color> color =
            held ? ColorOfCopy(from.graphicsFormat(), to.graphicsFormat(), *held) : std::nullopt;
        return color ? ConstantDraw{Text({"'", from.name(), "' has one value everywhere"}),
                                    {color->r, color->g, color->b, 1.0f}}
                     : ConstantDraw{};
    }

    /// Returns the colour that a texture has all over; null if it may have others.
    const Color* FindColor(const Texture& texture) const
    {
        const TextureState* state = FindState(m_States, texture);
        return state && (state->constant.flags & ClearFlag::Color) ? &state->constant.color
                                                                   : nullptr;
    }

    /// Why the fragment function gives the output that is promised; "" = it need not.
    std::pmr::string WhyConstant(const FullScreenPromise& promise)
    {
        if (promise.zeroProperty != ShaderPropertyId())
        {
            return Text({promise.zeroProperty.name(), " is 0"});
        }
        for (const auto& texture : promise.zeroTextures)
        {
            const Color* held = FindColor(*texture);
            if (held && IsZero(*held, texture->graphicsFormat()))
            {
                return Text({"'", texture->name(), "' is 0 everywhere"});
            }
        }
        return {};
    }

    static bool ChangesNothing(const FrameNode& node, const DrawSetup& draw, const Color& output)
    {
        return node.targets.colors.size() == 1 &&
               LeavesTargetAsItIs(draw.state.targets.at(0), output);
    }

    /// Depth that no draw uses is not attached.
    void LeaveOutDepth(FrameNode& node)
    {
        if (!node.targets.depth || node.targets.colors.empty() || UsesDepth(node, m_Tables))
        {
            return;
        }
        if (node.clear)
        {
            FrameNode depthOnly(m_Nodes.get_allocator());
            depthOnly.targets.depth = node.targets.depth;
            depthOnly.clear = node.clear;
            RememberClear(depthOnly);
            node.clear->flags = Only(node.clear->flags, ClearFlag::Color);
        }
        node.targets.depth = nullptr;
    }

    void RememberClear(const FrameNode& node)
    {
        const auto remember = [&](const std::shared_ptr<const RenderTexture>& target)
        {
            TextureState& state = StateOf(target);
            ClearCommand clear = node.clear ? *node.clear : ClearCommand{};
            clear.flags = Only(clear.flags, AspectsOf(*target));
            if (clear.flags != ClearFlag::None)
            {
                Merge(state.constant, clear);
                state.isPending = true;
            }
        };
        ForEachTarget(node, remember);
    }

    /// A node that writes what is known of the texture and not in its image yet.
    void WriteWhatIsPending(const std::shared_ptr<const RenderTexture>& texture)
    {
        TextureState& state = StateOf(texture);
        if (!state.isPending)
        {
            return;
        }
        state.isPending = false;
        FrameNode& node = m_Nodes.emplace_back();
        node.name = Text({"Clear ", texture->name()});
        node.place = m_Place;
        node.clear = state.constant;
        if (IsDepthFormat(texture->graphicsFormat()))
        {
            node.targets.depth = texture;
        }
        else
        {
            node.targets.colors = {texture};
        }
    }

    void BeginWithWhatIsPending(FrameNode& node)
    {
        for (const auto& target : node.writes)
        {
            WriteWhatIsPending(target); // a dispatch clears nothing
            StateOf(target).constant.flags = ClearFlag::None;
        }
        const auto begin = [&](const std::shared_ptr<const RenderTexture>& target)
        {
            TextureState& state = StateOf(target);
            const bool isDepth = IsDepthFormat(target->graphicsFormat());
            ClearCommand clear = state.constant;
            clear.flags = Without(clear.flags, node.clear ? node.clear->flags : ClearFlag::None);
            if (!state.isPending || clear.flags == ClearFlag::None ||
                (!isDepth && node.coversColor))
            {
                // It is written anew, or holds what it should.
            }
            else if (isDepth || node.targets.colors.size() == 1)
            {
                AddClear(node, clear);
            }
            else
            {
                const auto& colors = node.targets.colors;
                node.clearedColors.resize(colors.size());
                const auto index = std::find(colors.begin(), colors.end(), target) - colors.begin();
                node.clearedColors[static_cast<std::size_t>(index)] = clear.color;
            }
            state.isPending = false;
            state.constant.flags = ClearFlag::None;
        };
        ForEachTarget(node, begin);
    }

    std::pmr::string Text(std::initializer_list<std::string_view> parts) const
    {
        std::pmr::string text(m_Nodes.get_allocator());
        Append(text, parts);
        return text;
    }

    FrameTables& m_Tables;
    TextureStates& m_States;
    FrameNodes m_Nodes;
    std::pmr::string m_Why; ///< draws of the node went; "" = none
    std::size_t m_Place = 0;
};

} // namespace

void ElideConstantDraws(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame)
{
    ConstantFolder(frame, nodes.get_allocator()).Fold(nodes, outputs);
}

} // namespace limn
