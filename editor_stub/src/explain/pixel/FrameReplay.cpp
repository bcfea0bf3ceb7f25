#include "explain/pixel/FrameReplay.h"

#include <algorithm>
#include <cstring>
#include <unordered_map>

namespace limn
{

namespace
{

/// Makes a buffer of what SetData set, with nothing of what kernels wrote.
std::shared_ptr<GraphicsBuffer> CopyAsSet(const GraphicsBuffer& buffer)
{
    auto copy = std::make_shared<GraphicsBuffer>(buffer.target(), buffer.count(), buffer.stride());
    copy->SetName(buffer.name());
    copy->Set({buffer.bytes().first(buffer.size()), 0});
    if (buffer.hasCounter())
    {
        std::uint32_t counter = 0;
        std::memcpy(&counter, buffer.bytes().data() + buffer.counterOffset(), sizeof(counter));
        copy->SetCounterValue(counter);
    }
    return copy;
}

/// Puts copies in place of the buffers that the frame writes to.
void CopyWrittenBuffers(FrameTables& tables)
{
    const auto forEachBindings = [&tables](const auto& function)
    {
        std::ranges::for_each(tables.setups, function, &DrawSetup::bindings);
        std::ranges::for_each(tables.dispatchSetups, function, &DispatchSetup::bindings);
    };
    std::unordered_map<const GraphicsBuffer*, std::shared_ptr<const GraphicsBuffer>> copies;
    forEachBindings(
        [&copies](const auto& bindings)
        {
            for (const BufferSlot& slot : bindings->buffers)
            {
                if (slot.isWritten && !copies.contains(slot.buffer.get()))
                {
                    copies[slot.buffer.get()] = CopyAsSet(*slot.buffer);
                }
            }
        });
    if (copies.empty())
    {
        return;
    }
    forEachBindings(
        [&copies](auto& bindings)
        {
            auto replaced = std::make_shared<DrawBindings>(*bindings);
            for (BufferSlot& slot : replaced->buffers)
            {
                const auto copy = copies.find(slot.buffer.get());
                slot.buffer = copy == copies.end() ? slot.buffer : copy->second;
            }
            bindings = std::move(replaced);
        });
}

} // namespace

FrameReplay::FrameReplay(const CompiledFrame& recorded)
{
    static_cast<FrameTables&>(m_Commands) = recorded;
    m_Commands.uniformData = recorded.uniformData;
    CopyWrittenBuffers(m_Commands);
}

void FrameReplay::AddPass(const CompiledRenderPass& pass)
{
    if (!pass.isCompute())
    {
        BindTargets(pass);
    }
    for (const PassCommand& command : pass.commands)
    {
        std::visit([this](const auto& alternative) { Add(alternative); }, command);
    }
}

void FrameReplay::BindTargets(const CompiledRenderPass& pass, bool clearsUndefined)
{
    const auto isCleared = [&](LoadOp load)
    {
        return load == LoadOp::Clear || (load == LoadOp::DontCare && clearsUndefined);
    };
    for (const ColorAttachment& color : pass.colors)
    {
        if (isCleared(color.load)) // each to its own colour
        {
            Add(SetRenderTargetCommand{{color.texture}, nullptr});
            Add(ClearCommand{ClearFlag::Color,
                             color.load == LoadOp::Clear ? color.clearColor : Color::clear});
        }
    }
    SetRenderTargetCommand targets;
    for (const ColorAttachment& color : pass.colors)
    {
        targets.colors.push_back(color.texture);
        targets.generatesMips = targets.generatesMips || color.generatesMips;
    }
    targets.depth = pass.depth ? pass.depth->texture : nullptr;
    Add(targets);
    if (pass.depth)
    {
        const DepthAttachment& depth = *pass.depth;
        const ClearFlag flags =
            (isCleared(depth.load) ? ClearFlag::Depth : ClearFlag::None) |
            (isCleared(depth.stencilLoad) ? ClearFlag::Stencil : ClearFlag::None);
        Add(ClearCommand{flags, Color(), depth.clearDepth, depth.clearStencil});
    }
}

void FrameReplay::AddDraw(DrawCommand draw, DrawSetup setup)
{
    draw.setup = static_cast<std::uint32_t>(m_Commands.setups.size());
    m_Commands.setups.push_back(std::move(setup));
    Add(draw);
}

std::vector<Image> FrameReplay::Run(GraphicsDevice& device,
                                    std::span<const std::shared_ptr<const RenderTexture>> outputs)
{
    device.Execute(Compile(outputs));
    std::vector<Image> images;
    std::ranges::transform(outputs, std::back_inserter(images),
                           [&](const auto& output) { return device.ReadBack(*output); });
    return images;
}

CompiledFrame FrameReplay::Compile(std::span<const std::shared_ptr<const RenderTexture>> outputs)
{
    FrameCompilerOptions options;
    options.isLast = true;
    return CompileFrame(std::move(m_Commands), {}, outputs, options);
}

} // namespace limn
