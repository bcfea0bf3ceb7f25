#pragma once

#include <limn/core/FrameCompiler.h>
#include <limn/shaderlab/ShaderProgram.h>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace limn::test
{

using TexturePtr = std::shared_ptr<const Texture>;
using RenderTexturePtr = std::shared_ptr<const RenderTexture>;

/// Writes a frame's commands by hand.
class FrameBuilder
{
public:
    FrameBuilder& Bind(const RenderTexturePtr& color, const RenderTexturePtr& depth = nullptr)
    {
        SetRenderTargetCommand command;
        if (color)
        {
            command.colors.push_back(color);
        }
        command.depth = depth;
        return Add(std::move(command));
    }
    FrameBuilder& Bind(std::vector<RenderTexturePtr> colors, const RenderTexturePtr& depth)
    {
        return Add(SetRenderTargetCommand{{colors.begin(), colors.end()}, depth});
    }
    /// With CommandBuffer::GenerateMips behind what is drawn.
    FrameBuilder& BindForMips(const RenderTexturePtr& color)
    {
        SetRenderTargetCommand command;
        command.colors.push_back(color);
        command.generatesMips = true;
        return Add(std::move(command));
    }
    FrameBuilder& Clear(ClearFlag flags, const Color& color = Color::clear, float depth = 1.0f,
                        int stencil = 0)
    {
        return Add(ClearCommand{flags, color, depth, stencil});
    }
    FrameBuilder& Viewport(int x, int y, int width, int height)
    {
        return Add(SetViewportCommand{{x, y, width, height}});
    }
    /// @param number  what Describe calls the draw
    FrameBuilder& Draw(std::uint32_t number, const std::vector<TexturePtr>& sampled = {})
    {
        auto bindings = std::make_shared<DrawBindings>();
        for (const TexturePtr& texture : sampled)
        {
            bindings->textures.push_back({0, texture, std::nullopt});
        }
        DrawCommand draw;
        draw.setup = static_cast<std::uint32_t>(m_Frame.setups.size());
        m_Frame.setups.emplace_back().bindings = std::move(bindings);
        draw.vertexCount = 3;
        draw.firstInstance = number;
        return Add(std::move(draw));
    }
    /// @param number  what Describe calls the dispatch
    FrameBuilder& Dispatch(std::uint32_t number, const std::vector<TexturePtr>& sampled,
                           const std::vector<RenderTexturePtr>& written,
                           const std::vector<BufferSlot>& buffers = {}, bool isKept = false)
    {
        auto bindings = std::make_shared<DrawBindings>();
        for (const TexturePtr& texture : sampled)
        {
            bindings->textures.push_back({0, texture, std::nullopt});
        }
        for (const RenderTexturePtr& texture : written)
        {
            bindings->storageTextures.push_back({0, texture});
        }
        bindings->buffers = buffers;
        DispatchCommand dispatch;
        dispatch.setup = static_cast<std::uint32_t>(m_Frame.dispatchSetups.size());
        m_Frame.dispatchSetups.emplace_back().bindings = std::move(bindings);
        dispatch.groups = {number, 1, 1};
        dispatch.isKept = isKept;
        return Add(dispatch);
    }
    static BufferSlot Read(std::shared_ptr<const GraphicsBuffer> buffer,
                           ShaderStage stages = ShaderStage::Compute)
    {
        return {0, std::move(buffer), 0, 4, stages, false, false};
    }
    static BufferSlot Write(std::shared_ptr<const GraphicsBuffer> buffer)
    {
        return {0, std::move(buffer), 0, 4, ShaderStage::Compute, false, true};
    }
    /// A full-screen pass. @param promise  "" = none, "True", "copy" of the first texture, or a
    /// zero
    ///     in any texture gives "0 0 0 1 where"
    FrameBuilder& Blit(std::uint32_t number, const std::vector<TexturePtr>& sampled,
                       const std::string& promise, const RenderTargetBlendState& blend = {},
                       float reach = -1.0f)
    {
        Draw(number, sampled);
        DrawSetup& draw = last();
        draw.state.zTest = CompareFunction::Always;
        draw.state.zWrite = false;
        draw.state.targets[0] = blend;
        if (promise.empty())
        {
            return *this;
        }
        auto says = std::make_shared<FullScreenPromise>();
        if (promise == "copy")
        {
            says->copied = sampled.at(0);
        }
        else if (promise != "True")
        {
            says->zeroTextures.assign(sampled.begin(), sampled.end());
            says->output = {0, 0, 0, 1};
        }
        says->reach = reach;
        draw.fullScreen = std::move(says);
        return *this;
    }
    /// Adds the colour, keeps the alpha: Blend One SrcAlpha, Zero One.
    static RenderTargetBlendState Additive()
    {
        RenderTargetBlendState blend;
        blend.destinationColorBlendMode = BlendMode::SrcAlpha;
        blend.sourceAlphaBlendMode = BlendMode::Zero;
        blend.destinationAlphaBlendMode = BlendMode::One;
        return blend;
    }
    /// What the draw that was added last is set up with.
    DrawSetup& last() { return m_Frame.setups.back(); }
    DrawCommand& lastDraw() { return std::get<DrawCommand>(m_Frame.commands.back()); }
    FrameBuilder& Begin(std::string name) { return Add(BeginSampleCommand{SampleName(name)}); }
    FrameBuilder& End() { return Add(EndSampleCommand{}); }

    /// What was added since the last call.
    FrameCommands Take() { return std::exchange(m_Frame, {}); }

private:
    FrameBuilder& Add(FrameCommand command)
    {
        m_Frame.commands.push_back(std::move(command));
        return *this;
    }

    FrameCommands m_Frame;
};

/// Compiles frame after frame, each with the states that the one before left.
class FrameCompiler
{
public:
    /// @param leavesOut  off: what was recorded is seen whether anything reads it or not
    explicit FrameCompiler(bool leavesOut = false) { m_Options.leavesOut = leavesOut; }

    CompiledFrame Compile(FrameCommands commands, const std::vector<RenderTexturePtr>& outputs = {})
    {
        CompiledFrame frame = CompileFrame(std::move(commands), m_States, outputs, m_Options);
        m_States = frame.states;
        return frame;
    }

private:
    FrameCompilerOptions m_Options;
    TextureStates m_States;
};

inline std::string Describe(const PassCommand& command)
{
    return std::visit(
        [](const auto& c) -> std::string
        {
            using Command = std::decay_t<decltype(c)>;
            if constexpr (std::is_same_v<Command, ClearCommand>)
            {
                return "clear " + std::to_string(static_cast<int>(c.flags));
            }
            else if constexpr (std::is_same_v<Command, SetViewportCommand>)
            {
                return "viewport " + std::to_string(c.rect.x) + " " + std::to_string(c.rect.y) +
                       " " + std::to_string(c.rect.width) + " " + std::to_string(c.rect.height);
            }
            else if constexpr (std::is_same_v<Command, DrawCommand>)
            {
                return "draw " + std::to_string(c.firstInstance);
            }
            else if constexpr (std::is_same_v<Command, DispatchCommand>)
            {
                return "dispatch " + std::to_string(c.groups[0]);
            }
            else if constexpr (std::is_same_v<Command, BeginSampleCommand>)
            {
                return "begin " + c.name.name();
            }
            else
            {
                return "end";
            }
        },
        command);
}

/// The pass's commands as words: "viewport 0 0 8 4", "clear 7", "draw 1", "begin x", "end".
inline std::vector<std::string> CommandsOf(const CompiledRenderPass& pass)
{
    std::vector<std::string> texts;
    for (const PassCommand& command : pass.commands)
    {
        texts.push_back(Describe(command));
    }
    return texts;
}

} // namespace limn::test
