#include "record/RecordedCommands.h"
#include "renderers/ObjectDraws.h"
#include "resolve/DrawRecorder.h"
#include "targets/RenderTargetResolver.h"

#include <algorithm>
#include <limn/core/ScriptableRenderContext.h>
#include <utility>

namespace limn
{

namespace
{

FrameCommands Emptied(FrameCommands frame)
{
    frame.commands.clear();
    frame.uniformData.clear();
    frame.setups.clear();
    frame.dispatchSetups.clear();
    frame.meshes.clear();
    frame.instances.clear();
    frame.perDraw.clear();
    frame.objects = nullptr;
    return frame;
}

/// One function for each kind of command.
template <typename... Functions>
struct Overloaded : Functions...
{
    using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>; // Clang 14 has to be told

/// Returns whether each sample that begins in the buffer ends in it, and the other way round.
bool HasWholeSamples(const CommandBuffer& commandBuffer)
{
    int open = 0;
    for (const RecordedCommand& command : commandBuffer.commands())
    {
        open += std::holds_alternative<BeginSampleCommand>(command) ? 1 : 0;
        open -= std::holds_alternative<EndSampleCommand>(command) ? 1 : 0;
        if (open < 0)
        {
            return false;
        }
    }
    return open == 0 && !commandBuffer.commands().empty();
}

} // namespace

ScriptableRenderContext::ScriptableRenderContext()
    : m_Recorder(std::make_unique<DrawRecorder>(m_Frame, m_PassName)),
      m_Identified(std::make_unique<RenderTargetResolver>(m_Frame, m_Recorder->globals()))
{
}

ScriptableRenderContext::ScriptableRenderContext(RenderReport& report, const glm::dvec3& origin)
    : ScriptableRenderContext()
{
    Begin(report, origin);
}

void ScriptableRenderContext::Begin(RenderReport& report, const glm::dvec3& origin,
                                    FrameCommands spare, bool usesReversedZBuffer)
{
    m_Report = &report;
    m_Origin = origin;
    m_PassName = {};
    m_Frame = Emptied(std::move(spare));
    m_Frame.usesReversedZBuffer = usesReversedZBuffer;
    m_Recorder->Begin(m_Report->notes, m_Origin);
    m_Identified->EndCamera();
}

void ScriptableRenderContext::SetObjectLights(std::span<const Light* const> lights, int limit)
{
    m_Recorder->objectLights().Begin(lights, limit);
}

void ScriptableRenderContext::BeginCamera(CameraTargets camera)
{
    m_Recorder->BeginCamera();
    m_Identified->BeginCamera(std::move(camera), m_Report->notes);
}

void ScriptableRenderContext::EndCamera()
{
    m_Identified->EndCamera();
}

ScriptableRenderContext::~ScriptableRenderContext() = default;

void ScriptableRenderContext::ExecuteCommandBuffer(const CommandBuffer& commandBuffer)
{
    const bool isSample = !commandBuffer.name.empty() && HasWholeSamples(commandBuffer);
    if (isSample)
    {
        m_Frame.commands.emplace_back(BeginSampleCommand{SampleName(commandBuffer.name)});
    }
    Run(commandBuffer);
    if (isSample)
    {
        m_Frame.commands.emplace_back(EndSampleCommand{});
    }
}

void ScriptableRenderContext::Run(const CommandBuffer& commandBuffer)
{
    m_Recorder->TakeShaderGlobals();
    const Overloaded run{
        [&](const RecordedDraw& c) { m_Recorder->Draw(c, commandBuffer.PropertiesOf(c)); },
        [&](const SetViewProjectionCommand& c) { m_Recorder->SetViewProjection(c); },
        [&](const SetViewCommand& c) { m_Recorder->SetMatrix(c); },
        [&](const SetProjectionCommand& c) { m_Recorder->SetMatrix(c); },
        [&](const SetBufferDataCommand& c)
        {
            m_Recorder->ExpectUnused(*c.buffer, "SetBufferData");
            c.buffer->Set({c.bytes, c.offset});
        },
        [&](const SetBufferCounterCommand& c)
        {
            m_Recorder->ExpectUnused(*c.buffer, "SetBufferCounterValue");
            c.buffer->SetCounterValue(c.value);
        },
        [&](const SetGlobalCommand& c) { m_Recorder->SetGlobal(c); },
        [&](const SetKeywordCommand& c) { m_Recorder->SetKeyword(c); },
        [&](const SetRenderTargetCommand& c) { m_Recorder->SetRenderTarget(c); },
        [&](const SetScissorCommand& c) { m_Recorder->commonState().scissor = c.rect; },
        [&](const SetInvertCullingCommand& c)
        { m_Recorder->commonState().invertsCulling = c.isInverted; },
        [&](const SetGlobalDepthBiasCommand& c)
        {
            m_Recorder->commonState().depthBias = c.bias;
            m_Recorder->commonState().slopeDepthBias = c.slopeBias;
        },
        [&](const GenerateMipsCommand& c) { GenerateMips(*m_Identified->Resolve(c)); },
        [&](const DrawRendererListCommand& c)
        {
            DrawRenderers(*c.list->cullingResults, c.list->drawSettings, c.list->filteringSettings,
                          c.list->stateBlock);
        },
        [&](const RecordedDispatch& c) { m_Recorder->Dispatch(c); },
        [&](const CopyBufferCommand& c)
        { m_Recorder->Copy(c, m_Identified->CopyKernel("CopyBuffer")); },
        [&](const SetComputeParamsCommand& c) { c.shader->SetFromMaterial(c.kernel, *c.material); },
        [&](const SetComputeParamCommand& c) { c.shader->Set(c.kernel, c.id, c.value); },
        [&](const SetComputeKeywordCommand& c) { c.shader->SetKeyword(c.keyword, c.isOn); },
        [&](const SetMaterialKeywordCommand& c) { c.material->SetKeyword(c.keyword, c.isOn); },
        [&](const SetCameraColorCommand& c) { m_Identified->SetCameraColor(c); },
        [&](const CopyTextureCommand& c)
        {
            const CommonDrawState state = std::exchange(m_Recorder->commonState(), {});
            ExecuteCommandBuffer(m_Identified->Resolve(c));
            m_Recorder->commonState() = state;
        },
        [&]<typename Command>(const Command& c)
        {
            if constexpr (std::is_constructible_v<FrameCommand, Command>)
            {
                m_Frame.commands.emplace_back(c);
            }
            else
            {
                ExecuteCommandBuffer(m_Identified->Resolve(c));
            }
        }};
    for (const RecordedCommand& command : commandBuffer.commands())
    {
        std::visit(run, command);
    }
}

void ScriptableRenderContext::DrawRenderers(const CullingResults& cullingResults,
                                            const DrawingSettings& drawingSettings,
                                            const FilteringSettings& filteringSettings,
                                            const RenderStateBlock& stateBlock)
{
    JudgedItems judged = Judge(cullingResults.items, filteringSettings, drawingSettings);
    m_Report->draws.push_back({m_PassName, filteringSettings, drawingSettings, judged.counts});
    if (!judged.drawn.empty())
    {
        m_Recorder->TakeShaderGlobals();
        const auto runs = SortIntoRuns(judged.drawn, drawingSettings.sortingSettings);
        DrawObjects(judged.drawn, runs, drawingSettings, stateBlock, *m_Recorder);
    }
}

/// When the node that drew into it last ends, or the kernel that wrote to it: whoever samples it
/// comes behind that.
void ScriptableRenderContext::GenerateMips(const RenderTexture& texture)
{
    const auto isIt = [&](const auto& other)
    {
        return other.get() == &texture;
    };
    auto& commands = m_Frame.commands;
    for (auto command = commands.rbegin(); command != commands.rend(); ++command)
    {
        auto* target = std::get_if<SetRenderTargetCommand>(&*command);
        if (target != nullptr && std::ranges::any_of(target->colors, isIt))
        {
            target->generatesMips = true;
            return;
        }
        auto* dispatch = std::get_if<DispatchCommand>(&*command);
        if (dispatch != nullptr &&
            std::ranges::any_of(m_Frame.Setup(*dispatch).bindings->storageTextures, isIt,
                                &StorageTextureSlot::texture))
        {
            dispatch->generatesMips = true;
            return;
        }
    }
    m_Report->notes.push_back("GenerateMips of '" + m_Identified->NameOf(texture) +
                              "': nothing has drawn into it in this frame, so its mip levels stay");
}

ScriptableRenderContext::Place ScriptableRenderContext::MarkPlace()
{
    return m_Recorder->MarkPlace();
}

void ScriptableRenderContext::RecordAt(const Place& place, const std::function<void()>& record)
{
    std::vector<FrameCommand>& commands = m_Frame.commands;
    const auto count = static_cast<std::ptrdiff_t>(commands.size());
    m_Recorder->WithGlobalsOf(place, record);
    std::rotate(commands.begin() + static_cast<std::ptrdiff_t>(place.command),
                commands.begin() + count, commands.end());
}

bool ScriptableRenderContext::Reads(const Texture& texture) const
{
    return m_Recorder->Reads(texture);
}

FrameCommands ScriptableRenderContext::TakeCommands()
{
    m_Recorder->End();
    m_Recorder->Begin(m_Report->notes, m_Origin);
    return std::exchange(m_Frame, {});
}

} // namespace limn
