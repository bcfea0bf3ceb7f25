#include <algorithm>
#include <cmath>
#include <limits>
#include <limn/base/NumberText.h>
#include <limn/core/CommandBuffer.h>

#include "material/PropertyValues.h"
#include "record/MatrixIds.h"
#include "record/RecordedCommands.h"

namespace limn
{

namespace
{

void ExpectSameSize(const RenderTexture& first, const RenderTexture& other)
{
    if (!first.HasSizeOf(other))
    {
        const auto text = [](const RenderTexture& t)
        {
            return "'" + t.name() + "' is " + t.DescribeSize() + " with " +
                   CountText(static_cast<std::size_t>(t.descriptor().msaaSamples), "sample");
        };
        throw ContractError(
            "SetRenderTarget: all targets must have one size and sample count, but " + text(first) +
            " and " + text(other));
    }
}

void ExpectColor(const RTHandle& target)
{
    if (!target)
    {
        throw ContractError("SetRenderTarget: a colour target is an empty handle");
    }
    if (IsDepthFormat(target.rt()->graphicsFormat()))
    {
        throw ContractError("SetRenderTarget: the colour target '" + target.rt()->name() +
                            "' has the format " + ToString(target.rt()->graphicsFormat()) +
                            "; give it as depth");
    }
}

void ExpectDepth(const RTHandle& target)
{
    if (target && !IsDepthFormat(target.rt()->graphicsFormat()))
    {
        throw ContractError("SetRenderTarget: the depth target '" + target.rt()->name() +
                            "' has the format " + ToString(target.rt()->graphicsFormat()) +
                            "; it needs a depth format");
    }
}

/// Returns what is bound as depth beside the colours: a colour that is given as depth means the one
/// that it has, and a colour that is alone brings its own along.
RTHandle DepthFor(std::span<const RTHandle> colors, const RTHandle& depth)
{
    if (depth)
    {
        const auto& own = depth.rt()->depthBuffer();
        return own ? RTHandle(own) : depth;
    }
    return colors.size() == 1 && colors[0] ? RTHandle(colors[0].rt()->depthBuffer()) : RTHandle();
}

bool Wraps(const RTHandle& target)
{
    return target && !target.rt();
}

void ExpectNoClear(RenderBufferLoadAction action)
{
    if (action == RenderBufferLoadAction::Clear)
    {
        throw ContractError("SetRenderTarget: RenderBufferLoadAction::Clear names no colour to "
                            "clear to; call ClearRenderTarget");
    }
}

/// @param least  the smallest size allowed
void ExpectRect(const char* call, const ViewportRect& rect, int least)
{
    const auto size = std::to_string(rect.width) + "x" + std::to_string(rect.height);
    if (rect.width < least || rect.height < least)
    {
        throw ContractError(std::string(call) + ": the size is " + size + "; both must be " +
                            (least > 0 ? "greater than 0" : "0 or more"));
    }
    constexpr int k_Most = std::numeric_limits<int>::max();
    if (rect.x > k_Most - rect.width || rect.y > k_Most - rect.height)
    {
        throw ContractError(std::string(call) + ": " + size + " at (" + std::to_string(rect.x) +
                            ", " + std::to_string(rect.y) + ") ends beyond texel " +
                            std::to_string(k_Most));
    }
}

} // namespace

CommandBuffer::CommandBuffer() = default;
CommandBuffer::~CommandBuffer() = default;
CommandBuffer::CommandBuffer(const CommandBuffer& other) = default;
CommandBuffer::CommandBuffer(CommandBuffer&& other) noexcept = default;
CommandBuffer& CommandBuffer::operator=(const CommandBuffer& other) = default;
CommandBuffer& CommandBuffer::operator=(CommandBuffer&& other) noexcept = default;

void CommandBuffer::SetRenderTarget(const RTHandle& color, const RTHandle& depth)
{
    if (color.rt() && !depth && IsDepthFormat(color.rt()->graphicsFormat()))
    {
        SetRenderTarget(std::span<const RTHandle>(), color);
        return;
    }
    SetRenderTarget(std::span(&color, color ? 1u : 0u), depth);
}

void CommandBuffer::SetRenderTarget(std::span<const RTHandle> colors, const RTHandle& depth)
{
    if (colors.size() > k_MostColors)
    {
        throw ContractError("SetRenderTarget: it was given " + std::to_string(colors.size()) +
                            " colour targets; a pass has at most " + std::to_string(k_MostColors));
    }
    if (Wraps(depth) || std::any_of(colors.begin(), colors.end(), Wraps))
    {
        const std::vector<RenderTargetIdentifier> identifiers(colors.begin(), colors.end());
        SetRenderTarget(identifiers, depth.nameID());
        return;
    }
    SetRenderTargetCommand command;
    for (const RTHandle& color : colors)
    {
        ExpectColor(color);
        command.colors.push_back(color.rt());
    }
    const RTHandle boundDepth = DepthFor(colors, depth);
    ExpectDepth(boundDepth);
    command.depth = boundDepth.rt();
    const RenderTexture* first =
        command.colors.empty() ? command.depth.get() : command.colors.front().get();
    if (first == nullptr)
    {
        throw ContractError("SetRenderTarget: both colour and depth are empty handles");
    }
    for (const auto& color : command.colors)
    {
        ExpectSameSize(*first, *color);
    }
    if (command.depth)
    {
        ExpectSameSize(*first, *command.depth);
    }
    m_Commands.emplace_back(std::move(command));
}

void CommandBuffer::ClearRenderTarget(ClearFlag flags, const Color& color, float depth, int stencil)
{
    if (!(depth >= 0.0f && depth <= 1.0f))
    {
        throw ContractError("ClearRenderTarget: the depth is " +
                            NumberText(static_cast<double>(depth)) +
                            "; it must be from 0 (near) to 1 (far)");
    }
    if (!isFinite(color))
    {
        throw ContractError("ClearRenderTarget: the colour is not finite; NaN and infinity are no "
                            "colours");
    }
    m_Commands.emplace_back(ClearCommand{flags, color, depth, stencil});
}

void CommandBuffer::SetViewport(const ViewportRect& rect)
{
    ExpectRect("SetViewport", rect, 1);
    m_Commands.emplace_back(SetViewportCommand{rect});
}

void CommandBuffer::EnableScissorRect(const ViewportRect& scissor)
{
    ExpectRect("EnableScissorRect", scissor, 0);
    m_Commands.emplace_back(SetScissorCommand{scissor});
}

void CommandBuffer::SetGlobalDepthBias(float bias, float slopeBias)
{
    if (!std::isfinite(bias) || !std::isfinite(slopeBias))
    {
        throw ContractError("SetGlobalDepthBias: the bias is " +
                            NumberText(static_cast<double>(bias)) + ", " +
                            NumberText(static_cast<double>(slopeBias)) + "; both must be finite");
    }
    m_Commands.emplace_back(SetGlobalDepthBiasCommand{bias, slopeBias});
}

void CommandBuffer::Record(RecordedCommand command)
{
    m_Commands.push_back(std::move(command));
}

std::uint32_t CommandBuffer::Keep(const MaterialPropertyBlock& properties)
{
    if (properties.isEmpty())
    {
        return RecordedDraw::k_NoProperties;
    }
    if (m_BlockCount == m_Blocks.size())
    {
        m_Blocks.emplace_back();
    }
    m_Blocks[m_BlockCount].SetAll(properties);
    return m_BlockCount++;
}

const MaterialPropertyBlock* CommandBuffer::PropertiesOf(const RecordedDraw& draw) const
{
    return draw.properties == RecordedDraw::k_NoProperties ? nullptr : &m_Blocks[draw.properties];
}

void CommandBuffer::Clear()
{
    m_Commands.clear();
    for (; m_BlockCount > 0; --m_BlockCount)
    {
        m_Blocks[m_BlockCount - 1].Clear();
    }
}

void CommandBuffer::SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth)
{
    SetRenderTarget(std::span(&color, 1), std::move(depth));
}

void CommandBuffer::SetRenderTarget(std::span<const RenderTargetIdentifier> colors,
                                    RenderTargetIdentifier depth)
{
    m_Commands.emplace_back(
        SetIdentifiedTargetCommand{{colors.begin(), colors.end()}, std::move(depth)});
}

void CommandBuffer::SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction loadAction,
                                    RenderBufferStoreAction)
{
    ExpectNoClear(loadAction);
    SetRenderTarget(std::move(rt));
}

void CommandBuffer::SetRenderTarget(RenderTargetIdentifier color,
                                    RenderBufferLoadAction colorLoadAction, RenderBufferStoreAction,
                                    RenderTargetIdentifier depth,
                                    RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction)
{
    ExpectNoClear(colorLoadAction);
    ExpectNoClear(depthLoadAction);
    SetRenderTarget(std::move(color), std::move(depth));
}

void CommandBuffer::SetRenderTarget(const RTHandle& rt, RenderBufferLoadAction loadAction,
                                    RenderBufferStoreAction)
{
    ExpectNoClear(loadAction);
    SetRenderTarget(rt);
}

void CommandBuffer::SetRenderTarget(const RTHandle& color, RenderBufferLoadAction colorLoadAction,
                                    RenderBufferStoreAction, const RTHandle& depth,
                                    RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction)
{
    ExpectNoClear(colorLoadAction);
    ExpectNoClear(depthLoadAction);
    SetRenderTarget(color, depth);
}

void CommandBuffer::GetTemporaryRT(ShaderPropertyId nameID, int width, int height, int depthBuffer,
                                   FilterMode filter, RenderTextureFormat format,
                                   RenderTextureReadWrite readWrite, int antiAliasing)
{
    RenderTextureDescriptor descriptor(
        width, height, ToGraphicsFormat(format, readWrite != RenderTextureReadWrite::Linear),
        depthBuffer);
    descriptor.msaaSamples = antiAliasing;
    GetTemporaryRT(nameID, descriptor, filter);
}

void CommandBuffer::SetCameraColor(RTHandle color)
{
    Record(SetCameraColorCommand{std::move(color)});
}

void CommandBuffer::GetTemporaryRT(ShaderPropertyId nameID, const RenderTextureDescriptor& desc,
                                   FilterMode filter)
{
    Record(GetTemporaryRTCommand{nameID, desc, filter});
}

void CommandBuffer::ReleaseTemporaryRT(ShaderPropertyId nameID)
{
    Record(ReleaseTemporaryRTCommand{nameID});
}

void CommandBuffer::DisableScissorRect()
{
    Record(SetScissorCommand{});
}

void CommandBuffer::SetInvertCulling(bool invertCulling)
{
    Record(SetInvertCullingCommand{invertCulling});
}

void CommandBuffer::DrawCopy(CopyDrawCommand copy)
{
    Record(std::move(copy));
}

void CommandBuffer::CopyTexture(RenderTargetIdentifier source, RenderTargetIdentifier dest)
{
    Record(CopyTextureCommand{std::move(source), std::move(dest)});
}

void CommandBuffer::GenerateMips(RenderTargetIdentifier rt)
{
    Record(GenerateMipsCommand{std::move(rt)});
}

void CommandBuffer::SetGlobalTexture(ShaderPropertyId id, RenderTargetIdentifier value)
{
    Record(SetGlobalIdentifierCommand{id, std::move(value)});
}

void CommandBuffer::SetKeyword(const GlobalKeyword& keyword, bool value)
{
    Record(SetKeywordCommand{keyword, value});
}

void CommandBuffer::BeginSample(SampleName sample)
{
    Record(BeginSampleCommand{sample});
}

void CommandBuffer::EndSample()
{
    Record(EndSampleCommand{});
}

void CommandBuffer::SetViewProjectionMatrices(const glm::dmat4& view,
                                              const glm::mat4& gpuProjection,
                                              bool setInverseMatrices)
{
    const glm::mat4 viewProjection(glm::dmat4(gpuProjection) * view);
    RequireFinite(glm::mat4(view), unity_MatrixV, "global ");
    RequireFinite(viewProjection, unity_MatrixVP, "global ");
    m_Commands.emplace_back(SetViewProjectionCommand{view, gpuProjection, setInverseMatrices});
}

void CommandBuffer::SetViewMatrix(const glm::dmat4& view)
{
    RequireFinite(glm::mat4(view), unity_MatrixV, "global ");
    m_Commands.emplace_back(SetViewCommand{view});
}

void CommandBuffer::SetProjectionMatrix(const glm::dmat4& proj)
{
    RequireFinite(glm::mat4(proj), glstate_matrix_projection, "global ");
    m_Commands.emplace_back(SetProjectionCommand{proj});
}

void CommandBuffer::EndSample(std::string_view sample)
{
    int ended = 0;
    for (auto command = m_Commands.rbegin(); command != m_Commands.rend(); ++command)
    {
        ended += std::holds_alternative<EndSampleCommand>(*command) ? 1 : 0;
        const auto* begin = std::get_if<BeginSampleCommand>(&*command);
        if (begin != nullptr && --ended < 0)
        {
            if (begin->name != sample)
            {
                throw ContractError("EndSample: '" + std::string(sample) +
                                    "' is not the innermost open sample; end '" +
                                    begin->name.name() + "' first");
            }
            break;
        }
    }
    EndSample();
}

void CommandBuffer::SetKeyword(const std::shared_ptr<Material>& material,
                               const LocalKeyword& keyword, bool value)
{
    if (!material)
    {
        throw ContractError("SetKeyword '" + keyword.name() + "' needs a material, but it is null");
    }
    m_Commands.emplace_back(SetMaterialKeywordCommand{material, keyword, value});
}

void CommandBuffer::SetGlobal(ShaderPropertyId id, ShaderPropertyValue value)
{
    RequireFinite(value, id, "global ");
    m_Commands.emplace_back(SetGlobalCommand{id, std::move(value)});
}

namespace CommandBufferPool
{

namespace
{

std::vector<std::unique_ptr<CommandBuffer>>& FreeBuffers()
{
    thread_local std::vector<std::unique_ptr<CommandBuffer>> buffers;
    return buffers;
}

constexpr std::size_t k_MostKept = 16;

} // namespace

void Recycle::operator()(CommandBuffer* buffer) const noexcept
{
    std::unique_ptr<CommandBuffer> owned(buffer);
    auto& free = FreeBuffers();
    if (free.size() < free.capacity())
    {
        owned->Clear();
        owned->name.clear();
        free.push_back(std::move(owned));
    }
}

Pooled Get()
{
    auto& free = FreeBuffers();
    free.reserve(k_MostKept);
    if (free.empty())
    {
        return Pooled(new CommandBuffer);
    }
    Pooled buffer(free.back().release());
    free.pop_back();
    return buffer;
}

Pooled Get(std::string_view name)
{
    Pooled buffer = Get();
    buffer->name = name;
    return buffer;
}

} // namespace CommandBufferPool

} // namespace limn
