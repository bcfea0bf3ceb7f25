#include "explain/pixel/PassProbe.h"

#include "explain/ExplainedFrame.h"
#include "shaders/UsedShaders.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Returns whether instances differ in what shaders get to know of them: then each can be drawn
/// alone.
bool IsDivisible(const DrawCommand& draw, const FrameTables& tables)
{
    return draw.instanceCount > 1 && tables.Setup(draw).bindings->arguments() == nullptr &&
           (draw.drawsObjects ||
            tables.Element(draw.firstInstance) != tables.Element(draw.firstInstance + 1));
}

RenderTargetBlendState Writing(int writeMask, BlendMode source)
{
    RenderTargetBlendState blend;
    blend.writeMask = writeMask;
    blend.sourceColorBlendMode = source;
    blend.sourceAlphaBlendMode = source;
    return blend;
}

bool HasColorOutput(const ShaderProgram& program)
{
    const PropertyLayout& layout = program.layout;
    return layout.colorOutputs > 0 &&
           (layout.outputTypes.empty() || layout.outputTypes.front() == UniformType::Float);
}

/// Returns a pass's steps in their order.
std::vector<PassStep> StepsOf(const CompiledRenderPass& pass, const FrameTables& tables)
{
    std::vector<PassStep> steps;
    std::vector<std::string> samples;
    PassStep step;
    for (step.command = 0; step.command < pass.commands.size(); ++step.command)
    {
        const PassCommand& command = pass.commands[step.command];
        step.firstInstance = 0;
        step.instanceCount = 1;
        step.sample = samples.empty() ? pass.name : samples.back();
        if (const auto* begun = std::get_if<BeginSampleCommand>(&command))
        {
            samples.push_back(begun->name.name());
        }
        else if (std::holds_alternative<EndSampleCommand>(command) && !samples.empty())
        {
            samples.pop_back();
        }
        else if (const auto* viewport = std::get_if<SetViewportCommand>(&command))
        {
            step.viewport = viewport->rect;
        }
        else if (std::holds_alternative<ClearCommand>(command))
        {
            steps.push_back(step);
        }
        else if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            const bool isDivisible = IsDivisible(*draw, tables);
            step.instanceCount = isDivisible ? 1 : draw->instanceCount;
            for (; step.firstInstance < draw->instanceCount;
                 step.firstInstance += step.instanceCount)
            {
                steps.push_back(step);
            }
        }
    }
    return steps;
}

} // namespace

CoverPrograms::CoverPrograms(const std::shared_ptr<ShaderCompiler>& compiler)
    : m_WhiteSpirv(MakePlainShader("1, 1, 1, 1", compiler)->Compile(0)->fragmentSpirv)
{
}

DrawSetup CoverPrograms::Cover(const DrawSetup& draw)
{
    const auto readsBefore = [](ShaderStage stages)
    {
        return (stages & ShaderStage::Vertex) || (stages & ShaderStage::Geometry);
    };
    std::shared_ptr<const ShaderProgram>& program = m_Programs[draw.program.get()];
    if (!program)
    {
        auto made = std::make_shared<ShaderProgram>(*draw.program);
        made->fragmentSpirv = m_WhiteSpirv;
        made->layout.colorOutputs = 1;
        made->layout.outputTypes = {UniformType::Float};
        std::erase_if(made->layout.textures,
                      [&](const TextureBinding& texture) { return !readsBefore(texture.stages); });
        program = std::move(made);
    }
    auto bindings = std::make_shared<DrawBindings>(*draw.bindings);
    std::erase_if(bindings->textures,
                  [&](const TextureSlot& slot)
                  {
                      return std::ranges::find(program->layout.textures, slot.binding,
                                               &TextureBinding::binding) ==
                             program->layout.textures.end();
                  });
    DrawSetup cover = draw;
    cover.program = program;
    cover.bindings = std::move(bindings);
    cover.fullScreen = nullptr;
    cover.state.alphaToMask = false;
    cover.state.stencilEnabled = false;
    cover.state.targets.fill(Writing(ColorWriteMask::All, BlendMode::One));
    return cover;
}

PassProbe::PassProbe(const CompiledFrame& frame, std::size_t pass, int x, int y,
                     VulkanDevice& device, CoverPrograms& covers)
    : m_Frame(frame),
      m_Pass(pass),
      m_X(x),
      m_Y(y),
      m_Device(device),
      m_Covers(covers),
      m_Steps(StepsOf(frame.passes[pass], frame))
{
    FindReaching();
}

const DrawCommand& PassProbe::DrawOf(const PassStep& step) const
{
    return std::get<DrawCommand>(pass().commands[step.command]);
}

DrawCommand PassProbe::AtTexel(const PassStep& step) const
{
    DrawCommand draw = DrawOf(step);
    draw.firstInstance += step.firstInstance;
    draw.instanceCount = step.instanceCount;
    draw.bounds.reset();
    draw.scissor = TexelRect();
    return draw;
}

RenderTextureDescriptor PassProbe::ProbeDescriptor(GraphicsFormat format) const
{
    const RenderTextureDescriptor target = TargetTextures(pass()).front()->descriptor();
    RenderTextureDescriptor descriptor(pass().width, pass().height, format);
    descriptor.msaaSamples = target.msaaSamples;
    descriptor.isTopRowFirst = target.isTopRowFirst;
    return descriptor;
}

/// Returns the texel as scissors have it, by rows as they lie in memory.
ViewportRect PassProbe::TexelRect() const
{
    const bool isTopRowFirst = ProbeDescriptor(GraphicsFormat::None).isTopRowFirst;
    return {m_X, isTopRowFirst ? m_Y : pass().height - 1 - m_Y, 1, 1};
}

void PassProbe::Split(const Range& range, std::vector<Range>& ranges)
{
    const std::size_t count = range.end - range.begin;
    for (std::size_t i = 0; i < k_Channels; ++i)
    {
        const Range part{range.begin + count * i / k_Channels,
                         range.begin + count * (i + 1) / k_Channels};
        if (part.begin < part.end)
        {
            ranges.push_back(part);
        }
    }
}

void PassProbe::FindReaching()
{
    for (std::size_t i = 0; i < m_Steps.size(); ++i)
    {
        const PassStep& step = m_Steps[i];
        if (IsClear(step) && (!step.viewport || LiesIn(*step.viewport)))
        {
            m_Reaching.push_back(i);
        }
    }
    std::vector<Range> ranges;
    Split({0, m_Steps.size()}, ranges);
    while (!ranges.empty())
    {
        const std::size_t count = std::min(ranges.size(), k_Channels);
        const std::vector<Range> tried(ranges.end() - static_cast<std::ptrdiff_t>(count),
                                       ranges.end());
        ranges.resize(ranges.size() - count);
        const Reached reached = Cover(tried, CullMode::Off);
        for (std::size_t i = 0; i < count; ++i)
        {
            if (reached.at(i) && tried[i].end - tried[i].begin == 1)
            {
                m_Reaching.push_back(tried[i].begin);
            }
            else if (reached.at(i))
            {
                Split(tried[i], ranges);
            }
        }
    }
    std::ranges::sort(m_Reaching);
}

PassProbe::Reached PassProbe::Cover(std::span<const Range> ranges, CullMode cull) const
{
    // One bit of the mask each.
    constexpr std::array<int, k_Channels> k_Masks{ColorWriteMask::Red, ColorWriteMask::Green,
                                                  ColorWriteMask::Blue, ColorWriteMask::Alpha};
    const auto target = std::make_shared<const RenderTexture>(
        "Covered", ProbeDescriptor(GraphicsFormat::R8G8B8A8_UNorm));
    FrameReplay replay = BeforePass();
    replay.Add(SetRenderTargetCommand{{target}, nullptr});
    replay.Add(ClearCommand{ClearFlag::Color, Color::clear});
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
        AddCover(replay, ranges[i], k_Masks.at(i), cull);
    }
    const std::vector<std::byte> texel = TexelAfter(replay, target);
    Reached reached{};
    std::ranges::transform(texel, reached.begin(), [](std::byte b) { return b != std::byte{0}; });
    return reached;
}

void PassProbe::AddCover(FrameReplay& replay, const Range& range, int channel, CullMode cull) const
{
    for (std::size_t i = range.begin; i < range.end;)
    {
        const PassStep& step = m_Steps[i++];
        if (IsClear(step))
        {
            continue;
        }
        DrawCommand draw = AtTexel(step);
        for (; i < range.end && m_Steps[i].command == step.command; ++i)
        {
            draw.instanceCount += m_Steps[i].instanceCount;
        }
        DrawSetup setup = m_Covers.Cover(m_Frame.Setup(draw));
        setup.state.cull = cull;
        setup.state.zTest = CompareFunction::Always;
        setup.state.zWrite = false;
        setup.state.targets.fill(Writing(channel, BlendMode::One));
        const ViewportRect whole{0, 0, pass().width, pass().height};
        replay.Add(SetViewportCommand{step.viewport.value_or(whole)});
        replay.AddDraw(draw, std::move(setup));
    }
}

/// Adds the passes before this one; those that nothing behind them reads are left out when it runs.
FrameReplay PassProbe::BeforePass() const
{
    FrameReplay replay(m_Frame);
    for (std::size_t i = 0; i < m_Pass; ++i)
    {
        replay.AddPass(m_Frame.passes[i]);
    }
    return replay;
}

FrameReplay PassProbe::Begin(std::size_t count) const
{
    FrameReplay replay = BeforePass();
    replay.BindTargets(pass(), true);
    for (std::size_t i = 0; i < count; ++i)
    {
        const PassStep& step = Step(i);
        if (!IsClear(step) && LiesInScissor(i))
        {
            AddAtTexel(replay, step, SetupOf(i));
        }
        else if (IsClear(step))
        {
            AddViewport(replay, step);
            replay.Add(std::get<ClearCommand>(pass().commands[step.command]));
        }
    }
    return replay;
}

void PassProbe::AddViewport(FrameReplay& replay, const PassStep& step) const
{
    if (step.viewport)
    {
        replay.Add(SetViewportCommand{*step.viewport});
    }
}

void PassProbe::AddAtTexel(FrameReplay& replay, const PassStep& step, DrawSetup setup) const
{
    AddViewport(replay, step);
    setup.fullScreen = nullptr; // of one texel it would promise too much
    replay.AddDraw(AtTexel(step), std::move(setup));
}

std::vector<std::byte> PassProbe::TexelAfter(FrameReplay& replay, const Target& target) const
{
    return TexelOf(replay.Run(m_Device, std::span(&target, 1)).front());
}

TargetTexels PassProbe::After(std::size_t count) const
{
    const std::vector<Image> images = Begin(count).Run(m_Device, TargetTextures(pass()));
    TargetTexels texels;
    for (std::size_t i = 0; i < pass().colors.size(); ++i)
    {
        texels.colors.push_back(TexelOf(images[i]));
    }
    if (pass().depth)
    {
        const RenderTexture& depth = *pass().depth->texture;
        texels.depth = TexelOf(images.back());
        texels.stencil = HasStencil(depth.graphicsFormat())
                             ? TexelOf(m_Device.ReadBackStencil(depth))
                             : std::vector<std::byte>();
    }
    return texels;
}

DrawSetup PassProbe::SetupOf(std::size_t which) const
{
    return m_Frame.Setup(DrawOf(Step(which)));
}

bool PassProbe::LiesInScissor(std::size_t which) const
{
    const std::optional<ViewportRect>& scissor = DrawOf(Step(which)).scissor;
    return !scissor || LiesIn(*scissor);
}

bool PassProbe::LiesIn(const ViewportRect& rect) const
{
    const ViewportRect texel = TexelRect();
    return texel.x >= rect.x && texel.y >= rect.y && texel.x - rect.x < rect.width &&
           texel.y - rect.y < rect.height;
}

bool PassProbe::Reaches(std::size_t which, CullMode cull) const
{
    const Range range{m_Reaching[which], m_Reaching[which] + 1};
    return Cover(std::span(&range, 1), cull).front();
}

std::vector<std::byte> PassProbe::Draw(std::size_t which, const PipelineState& state,
                                       GraphicsFormat format) const
{
    FrameReplay replay = Begin(which);
    const auto target = std::make_shared<const RenderTexture>("Probe", ProbeDescriptor(format));
    replay.Add(SetRenderTargetCommand{{target}, pass().depth ? pass().depth->texture : nullptr});
    replay.Add(ClearCommand{ClearFlag::Color, Color::white});
    DrawSetup setup = SetupOf(which);
    setup = HasColorOutput(*setup.program) ? setup : m_Covers.Cover(setup);
    setup.state = state;
    AddAtTexel(replay, Step(which), std::move(setup));
    return TexelAfter(replay, target);
}

bool PassProbe::Passes(std::size_t which, const PipelineState& state) const
{
    // Whatever the shader gives, what passes is black.
    PipelineState black = state;
    black.targets.fill(Writing(ColorWriteMask::All, BlendMode::Zero));
    return std::ranges::any_of(Draw(which, black, GraphicsFormat::R8G8B8A8_UNorm),
                               [](std::byte b) { return b != std::byte{255}; });
}

std::optional<std::vector<float>> PassProbe::OutputOf(std::size_t which) const
{
    if (!HasColorOutput(*SetupOf(which).program))
    {
        return std::nullopt;
    }
    constexpr GraphicsFormat k_Format = GraphicsFormat::R16G16B16A16_SFloat;
    PipelineState plain = SetupOf(which).state;
    plain.targets.fill(Writing(ColorWriteMask::All, BlendMode::One));
    return TexelValue(Draw(which, plain, k_Format), k_Format);
}

float PassProbe::DepthOf(std::size_t which) const
{
    RenderTextureDescriptor descriptor = ProbeDescriptor(GraphicsFormat::None);
    descriptor.depthBufferBits = 16;
    const auto depth = std::make_shared<const RenderTexture>("Probe depth", descriptor);
    FrameReplay replay = BeforePass();
    replay.Add(SetRenderTargetCommand{{}, depth});
    replay.Add(ClearCommand{ClearFlag::Depth, Color()});
    DrawSetup setup = m_Covers.Cover(SetupOf(which));
    setup.state.zTest = CompareFunction::LessEqual;
    setup.state.zWrite = true;
    AddAtTexel(replay, Step(which), std::move(setup));
    return TexelValue(TexelAfter(replay, depth), GraphicsFormat::D32_SFloat).front();
}

} // namespace limn
