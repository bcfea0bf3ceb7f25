#include "graph/RenderGraphCamera.h"
#include "passes/CameraUniforms.h"
#include "passes/RunPassCode.h"

#include <algorithm>
#include <exception>
#include <limn/core/CoreUtils.h>
#include <limn/core/CurrentCamera.h>
#include <limn/core/PluginCallSite.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ShaderSource.h>

namespace limn
{

namespace
{

/// Runs a function when the scope ends, however it ends.
template <typename Function>
class AtExit
{
public:
    explicit AtExit(Function function) : m_Function(std::move(function)) {}
    ~AtExit() { m_Function(); }
    AtExit(const AtExit&) = delete;
    AtExit& operator=(const AtExit&) = delete;

private:
    Function m_Function;
};

bool HasSamples(const CameraData& data)
{
    return data.cameraTargetDescriptor.msaaSamples > 1;
}

bool ClearsNothing(const CameraData& data)
{
    return data.camera->clearFlags == CameraClearFlags::Nothing;
}

/// Several samples a texel are not kept from frame to frame, as in Unity.
ClearFlag CameraClearFlag(const CameraData& data)
{
    if (data.renderType == CameraRenderType::Overlay)
    {
        return data.clearDepth ? ClearFlag::DepthStencil : ClearFlag::None;
    }
    return ClearsNothing(data) && !HasSamples(data) ? ClearFlag::DepthStencil : ClearFlag::All;
}

Color BackgroundOf(const CameraData& data)
{
    return ClearsNothing(data) && HasSamples(data)
               ? Color::black
               : CoreUtils::ConvertSRGBToActiveColorSpace(data.camera->backgroundColor);
}

/// Lets each of the passes clean up, also behind one that cannot.
/// @param isLast  nothing follows in the camera's stack
/// @return what was thrown first
std::exception_ptr CleanUp(const ScriptableRenderer& renderer,
                           std::span<ScriptableRenderPass* const> passes, CommandBuffer& cmd,
                           bool isLast) noexcept
{
    std::exception_ptr failure;
    const auto call = [&](const char* function, auto method)
    {
        for (ScriptableRenderPass* pass : passes)
        {
            try
            {
                RunPassCode(renderer, *pass, function, [&] { (pass->*method)(cmd); });
            }
            catch (...)
            {
                failure = failure ? failure : std::current_exception();
            }
        }
    };
    call("OnCameraCleanup", &ScriptableRenderPass::FrameCleanup);
    if (isLast)
    {
        call("OnFinishCameraStackRendering", &ScriptableRenderPass::OnFinishCameraStackRendering);
    }
    return failure;
}

/// Gives the draws since `first` to a feature, with a sentence for every one of them whose filter
/// let nothing through, each sentence once. The renderer's own may well have nothing to do.
///
/// @param fromEnd  the feature's place in the report, from the end: 1 is the last
void TakeFeatureDraws(RenderReport& report, std::size_t first, std::size_t fromEnd)
{
    for (std::size_t i = first; i < report.draws.size(); ++i)
    {
        DrawRenderersReport& draw = report.draws[i];
        draw.feature = report.features.size() - fromEnd;
        if (draw.counts[static_cast<std::size_t>(FilterVerdict::Drawn)] > 0)
        {
            continue;
        }
        std::string note = draw.pass.name() + ": " + Describe(draw.counts, draw.filtering);
        const auto& notes = report.notes;
        if (std::find(notes.begin(), notes.end(), note) == notes.end())
        {
            report.notes.push_back(std::move(note));
        }
    }
}

/// Gives the filters since `first` to the feature that is reported next. A feature that hands its
/// work to another one's pass asks the same filter twice, and is reported once.
void NameFilters(RenderReport& report, std::size_t first, SampleName feature)
{
    for (std::size_t i = first; i < report.filters.size(); ++i)
    {
        report.filters[i].pass = feature;
        report.filters[i].feature = report.features.size();
        if (i > first && report.filters[i].filtering == report.filters[i - 1].filtering)
        {
            report.filters.erase(report.filters.begin() + static_cast<std::ptrdiff_t>(i--));
        }
    }
}

/// Calls code of a feature.
template <typename Work>
decltype(auto) RunFeature(const ScriptableRendererFeature& feature, const char* member, Work&& work)
{
    return RunPluginCode(typeid(feature), feature.name, member, std::forward<Work>(work));
}

/// Sorts the passes by their events. Passes of one event keep their order.
void Sort(std::vector<ScriptableRenderPass*>& passes)
{
    // Few: std::stable_sort would ask for memory in each frame.
    for (auto pass = passes.begin(); pass != passes.end(); ++pass)
    {
        const auto place = std::ranges::upper_bound(passes.begin(), pass, (*pass)->renderPassEvent,
                                                    {}, &ScriptableRenderPass::renderPassEvent);
        std::rotate(place, pass, pass + 1);
    }
}

/// Returns whether a pass's target is the camera's, by itself or by an identifier.
bool Is(const RTHandle& target, const RTHandle& camera)
{
    if (target.rt() || !target)
    {
        return target == camera;
    }
    const RenderTargetIdentifier identifier = target.nameID();
    return identifier == BuiltinRenderTextureType::CameraTarget ||
           identifier == BuiltinRenderTextureType::CameraColor || identifier == camera.nameID();
}

/// Returns whether a colour that is bound alone brings the camera's depth along.
bool BringsDepth(const RTHandle& color, const RTHandle& cameraColor, const RTHandle& cameraDepth)
{
    const RenderTargetIdentifier identifier = color.nameID();
    const auto texture =
        identifier == BuiltinRenderTextureType::CameraColor ? cameraColor.rt() : color.rt();
    return identifier == BuiltinRenderTextureType::CameraTarget ||
           (texture && texture->depthBuffer() && texture->depthBuffer() == cameraDepth.rt());
}

/// Their number where it is none of them.
std::size_t IndexOf(const RTHandle& camera, std::span<const RTHandle> colors)
{
    const auto isCamera = [&](const RTHandle& color)
    {
        return Is(color, camera);
    };
    return static_cast<std::size_t>(std::ranges::find_if(colors, isCamera) - colors.begin());
}

void ExpectExecuting(bool isExecuting, const char* handle)
{
    if (!isExecuting)
    {
        throw ContractError(std::string(handle) +
                            " exists only while passes are set up and executed; read it in "
                            "OnCameraSetup, not in AddRenderPasses");
    }
}

} // namespace

ScriptableRenderer::~ScriptableRenderer()
{
    for (const auto& feature : m_Features)
    {
        try
        {
            feature->Dispose();
        }
        catch (...) // there is nobody left to tell
        {
        }
    }
}

ScriptableRendererFeature&
ScriptableRenderer::AddFeature(std::unique_ptr<ScriptableRendererFeature> feature)
{
    if (!feature)
    {
        throw ContractError("AddFeature: the feature is null");
    }
    const ShaderSourceScope shaders(m_ShaderSource);
    RunFeature(*feature, "Create", [&] { feature->Create(); });
    m_Features.push_back(std::move(feature));
    return *m_Features.back();
}

float ScriptableRenderer::cullingMargin(const VolumeStackPointer& volumeStack) const
{
    float margin = 0.0f;
    for (const auto& feature : m_Features)
    {
        if (feature->isActive())
        {
            margin =
                std::max(margin, RunFeature(*feature, "cullingMargin",
                                            [&] { return feature->cullingMargin(volumeStack); }));
        }
    }
    return margin;
}

void ScriptableRenderer::EnqueuePass(ScriptableRenderPass& pass)
{
    if (pass.profilingSampler.name() == k_UnnamedPass)
    {
        const std::string type = TypeName(typeid(pass));
        pass.profilingSampler = ProfilingSampler(type.substr(type.rfind(':') + 1));
    }
    m_Queue.push_back(&pass);
}

const ScriptableRendererFeature*
ScriptableRenderer::FeatureOf(const ScriptableRenderPass& pass) const
{
    const std::size_t index = FeatureIndexOf(pass);
    return index < m_FeaturePassEnds.size() ? m_Features[index].get() : nullptr;
}

std::size_t ScriptableRenderer::FeatureIndexOf(const ScriptableRenderPass& pass) const
{
    const auto place = static_cast<std::size_t>(std::ranges::find(m_FeaturePasses, &pass) -
                                                m_FeaturePasses.begin());
    return static_cast<std::size_t>(std::ranges::upper_bound(m_FeaturePassEnds, place) -
                                    m_FeaturePassEnds.begin());
}

const RTHandle& ScriptableRenderer::cameraColorTargetHandle() const
{
    ExpectExecuting(m_Executing, "cameraColorTargetHandle");
    return m_CameraColor;
}

const RTHandle& ScriptableRenderer::cameraDepthTargetHandle() const
{
    ExpectExecuting(m_Executing, "cameraDepthTargetHandle");
    return m_CameraDepth;
}

void ScriptableRenderer::ConfigureCameraTarget(RTHandle color, RTHandle depth)
{
    m_CameraColor = std::move(color);
    m_CameraDepth = std::move(depth);
}

const RTHandle& ScriptableRenderer::GetCameraColorFrontBuffer()
{
    throw ContractError("Blit(cmd, renderingData, material): the renderer has no second colour to "
                        "draw into");
}

void ScriptableRenderer::SwapColorBuffer(CommandBuffer& cmd)
{
    SetCameraColor(cmd, GetCameraColorFrontBuffer());
}

void ScriptableRenderer::SetCameraColor(CommandBuffer& cmd, const RTHandle& color)
{
    m_CameraColor = color;
    cmd.SetCameraColor(color);
}

void ScriptableRenderer::RenderCamera(ScriptableRenderContext& context,
                                      RenderingData& renderingData)
{
    const AtExit reset(
        [this]
        {
            m_Queue.clear();
            m_Executing = false;
            if (m_RenderGraph)
            {
                m_RenderGraph->End();
            }
        });
    const ShaderSourceScope shaders(m_ShaderSource);
    const CurrentCamera current(renderingData);
    // An overlay's colour is what the cameras before it have drawn.
    m_FirstColor = renderingData.cameraData.renderType == CameraRenderType::Base;
    m_FirstDepth = true;
    AddRenderPasses(renderingData);
    m_FeaturePasses = m_Queue;
    Setup(context, renderingData);
    Execute(context, renderingData);
}

void ScriptableRenderer::AddRenderPasses(RenderingData& renderingData)
{
    m_FeaturePassEnds.clear();
    for (const auto& feature : m_Features)
    {
        RenderReport& report = *renderingData.report;
        const std::size_t passes = m_Queue.size();
        const std::size_t filters = report.filters.size();
        const std::size_t notes = report.notes.size();
        if (feature->isActive())
        {
            RunFeature(*feature, "AddRenderPasses",
                       [&] { feature->AddRenderPasses(*this, renderingData); });
        }
        else if (renderingData.cameraData.renderType == CameraRenderType::Base)
        {
            report.notes.push_back(feature->name + ": it is not drawn; the feature is inactive");
        }
        m_FeaturePassEnds.push_back(m_Queue.size());
        const SampleName name(feature->name);
        NameFilters(report, filters, name);
        report.features.push_back(
            {name, m_Queue.size() - passes, notes, report.notes.size() - notes});
    }
}

void ScriptableRenderer::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    m_Executing = true;
    const AtExit end([&] { context.EndCamera(); });
    context.BeginCamera(
        {m_CameraColor, m_CameraDepth, renderingData.temporaryTextures, copyMaterial()});
    for (const auto& feature : m_Features)
    {
        if (feature->isActive() && !renderingData.cameraData.isPreviewCamera())
        {
            RunFeature(*feature, "SetupRenderPasses",
                       [&] { feature->SetupRenderPasses(*this, renderingData); });
        }
    }
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    std::size_t setUp = 0; // this many of the queue are to be cleaned up, whatever happens
    std::exception_ptr failure;
    try
    {
        while (setUp < m_Queue.size())
        {
            ScriptableRenderPass& pass = *m_Queue[setUp++];
            RunPassCode(*this, pass, "OnCameraSetup",
                        [&] { pass.OnCameraSetup(*cmd, renderingData); });
        }
        ExecutePasses(context, renderingData, *cmd);
    }
    catch (...)
    {
        failure = std::current_exception();
    }
    const bool isLast = failure || renderingData.cameraData.resolveFinalTarget;
    const std::exception_ptr second = CleanUp(*this, std::span(m_Queue).first(setUp), *cmd, isLast);
    if (failure || second)
    {
        std::rethrow_exception(failure ? failure : second);
    }
    context.ExecuteCommandBuffer(*cmd);
}

void ScriptableRenderer::ExecutePasses(ScriptableRenderContext& context,
                                       RenderingData& renderingData, CommandBuffer& cmd)
{
    Sort(m_Queue);
    renderingData.report->passes.reserve(m_Queue.size());
    for (ScriptableRenderPass* pass : m_Queue)
    {
        RunPassCode(*this, *pass, "Configure",
                    [&] { pass->Configure(cmd, renderingData.cameraData.cameraTargetDescriptor); });
    }
    context.ExecuteCommandBuffer(cmd);
    cmd.Clear();

    bool cameraIsSet = false;
    for (ScriptableRenderPass* pass : m_Queue)
    {
        if (!cameraIsSet && BlockOf(pass->renderPassEvent) != RenderPassBlock::BeforeRendering)
        {
            SetCameraUniforms(cmd, renderingData.cameraData);
            context.ExecuteCommandBuffer(cmd);
            cmd.Clear();
            cameraIsSet = true;
        }
        BeforePass(context, renderingData, pass,
                   {context.MarkPlace(), renderingData.report->passes.size()});
        const std::size_t drawsBefore = renderingData.report->draws.size();
        ExecuteRenderPass(context, *pass, renderingData);
        if (const std::size_t feature = FeatureIndexOf(*pass); feature < m_Features.size())
        {
            TakeFeatureDraws(*renderingData.report, drawsBefore, m_Features.size() - feature);
        }
    }
    BeforePass(context, renderingData, nullptr,
               {context.MarkPlace(), renderingData.report->passes.size()});
}

void ScriptableRenderer::BeforePass(ScriptableRenderContext&, RenderingData&,
                                    const ScriptableRenderPass*, const PassPlace&)
{
}

void ScriptableRenderer::ExecuteAt(const PassPlace& place, ScriptableRenderContext& context,
                                   ScriptableRenderPass& pass, RenderingData& renderingData)
{
    const auto record = [&]
    {
        ExecuteRenderPass(context, pass, renderingData);
    };
    context.RecordAt(place.commands, std::ref(record)); // a copy would need memory
    auto& passes = renderingData.report->passes;
    std::rotate(passes.begin() + static_cast<std::ptrdiff_t>(place.pass), passes.end() - 1,
                passes.end());
}

void ScriptableRenderer::ExecuteRenderPass(ScriptableRenderContext& context,
                                           ScriptableRenderPass& pass, RenderingData& renderingData)
{
    const SampleName name = pass.profilingSampler.sampleName();
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    cmd->BeginSample(name);
    BindTargets(*cmd, pass, renderingData.cameraData);
    context.ExecuteCommandBuffer(*cmd);
    context.SetPassName(name);
    renderingData.report->passes.push_back({name, pass.renderPassEvent});
    if (pass.m_RecordsGraph && !renderingData.enableRenderCompatibilityMode)
    {
        RecordRenderGraph(pass, context, renderingData);
    }
    if (!pass.m_RecordsGraph || renderingData.enableRenderCompatibilityMode)
    {
        RunPassCode(*this, pass, "Execute", [&] { pass.Execute(context, renderingData); });
    }
    cmd->Clear();
    cmd->EndSample();
    context.ExecuteCommandBuffer(*cmd);
}

// The rules of ScriptableRenderer.SetRenderPassAttachments: whoever binds the camera's colour first
// clears it with the camera's background, whatever that pass asked for.
void ScriptableRenderer::BindTargets(CommandBuffer& cmd, const ScriptableRenderPass& pass,
                                     const CameraData& data)
{
    const bool own = pass.overrideCameraTarget();
    if (!own && BlockOf(pass.renderPassEvent) == RenderPassBlock::BeforeRendering)
    {
        return; // the camera's targets are not in use yet
    }
    const std::span<const RTHandle> colors =
        own ? pass.colorAttachmentHandles()
            : std::span<const RTHandle>(&m_CameraColor, m_CameraColor ? 1u : 0u);
    const RTHandle& depth = own ? pass.depthAttachmentHandle() : m_CameraDepth;
    if (colors.empty() && !depth)
    {
        throw ContractError("pass '" + pass.profilingSampler.name() +
                            "': ConfigureTarget was given empty handles; allocate them in "
                            "OnCameraSetup");
    }
    const ClearFlag cameraClear = CameraClearFlag(data);
    ClearFlag clear = Only(pass.clearFlag(), ClearFlag::Color);
    Color clearColor = pass.clearColor();
    if (m_FirstColor && IndexOf(m_CameraColor, colors) < colors.size())
    {
        m_FirstColor = false;
        if (colors.size() == 1)
        {
            clear = clear | Only(cameraClear, ClearFlag::Color);
            clearColor = BackgroundOf(data);
        }
        else if (clear != Only(cameraClear, ClearFlag::Color) || clearColor != BackgroundOf(data))
        {
            ClearApart(cmd, pass, data);
            clear = ClearFlag::None;
        }
    }
    // A colour that is named alone brings its own depth along.
    const bool isAlone = !depth && colors.size() == 1;
    const bool isWithCameraDepth =
        isAlone ? BringsDepth(colors[0], m_CameraColor, m_CameraDepth) : Is(depth, m_CameraDepth);
    const bool isFirstDepth = isWithCameraDepth && m_FirstDepth;
    m_FirstDepth = m_FirstDepth && !isFirstDepth;
    clear = clear | Only(isFirstDepth ? cameraClear : pass.clearFlag(), ClearFlag::DepthStencil);
    CoreUtils::SetRenderTarget(cmd, colors, depth, clear, clearColor);
}

/// The camera's colour to its background, the other ones to the pass's colour.
void ScriptableRenderer::ClearApart(CommandBuffer& cmd, const ScriptableRenderPass& pass,
                                    const CameraData& data)
{
    if (CameraClearFlag(data) & ClearFlag::Color)
    {
        CoreUtils::SetRenderTarget(cmd, m_CameraColor, ClearFlag::Color, BackgroundOf(data));
    }
    const std::span<const RTHandle> colors = pass.colorAttachmentHandles();
    std::vector<RTHandle> others(colors.begin(), colors.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(IndexOf(m_CameraColor, colors)));
    if (pass.clearFlag() & ClearFlag::Color)
    {
        CoreUtils::SetRenderTarget(cmd, others, {}, ClearFlag::Color, pass.clearColor());
    }
}

} // namespace limn
