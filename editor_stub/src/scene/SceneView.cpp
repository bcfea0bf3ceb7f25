#include "scene/SceneView.h"

#include "console/Texts.h"
#include "plugins/LoadPlugin.h"
#include "shaders/UsedShaders.h"

#include <algorithm>
#include <functional>
#include <limn/base/Lists.h>
#include <limn/core/DynamicGI.h>

namespace limn
{

std::vector<std::string> NotesOf(const RenderReport& report)
{
    static const ShaderTagId k_ShadowCaster{"ShadowCaster"};
    std::vector<std::string> notes;
    for (const std::string& note : report.notes)
    {
        AddOnce(note, notes);
    }
    FilterCounts counts{};
    for (const auto* filters : {&report.draws, &report.filters})
    {
        for (const DrawRenderersReport& filter : *filters)
        {
            if (filter.drawing.GetShaderPassName(0) == k_ShadowCaster)
            {
                continue; // a shadow is no picture of the object that throws it
            }
            std::ranges::transform(filter.counts, counts, counts.begin(), std::plus());
        }
    }
    const auto countOf = [&](FilterVerdict verdict)
    {
        return counts[static_cast<std::size_t>(verdict)];
    };
    const bool isAny = std::ranges::any_of(counts, [](int count) { return count > 0; });
    if (isAny && countOf(FilterVerdict::Drawn) == 0)
    {
        notes.push_back(std::string("no pass draws any of the objects that the camera sees: ") +
                        (countOf(FilterVerdict::NoMatchingPass) > 0
                             ? "their shaders have no pass with a LightMode that is drawn"
                             : "layer masks and render queues leave all of them out") +
                        "; 'limn explain SCENE' says for each pass what it leaves out");
    }
    return notes;
}

void MakeOpaque(Image& image)
{
    for (std::size_t i = 3; i < image.texels.size(); i += 4)
    {
        image.texels[i] = std::byte{255};
    }
}

SceneView::SceneView(SceneAsset asset, const AssetContext& assets)
    : m_Asset(std::move(asset)),
      m_Renderer(assets.compiler()),
      m_Volumes(assets.volumeComponents()),
      m_Stack(m_Volumes.CreateStack())
{
    m_Renderer.SetShaderSource(assets.shaderSource());
    m_Renderer.opaqueLayerMask = m_Asset.renderer.opaqueLayerMask;
    m_Renderer.transparentLayerMask = m_Asset.renderer.transparentLayerMask;
    for (std::unique_ptr<ScriptableRendererFeature>& feature : m_Asset.renderer.features)
    {
        m_Renderer.AddFeature(std::move(feature));
    }
    m_Asset.renderer.features.clear();
    for (const Volume& volume : m_Asset.volumes)
    {
        m_Volumes.Register(&volume);
    }
}

RenderResult SceneView::Render(UniversalRenderPipeline& pipeline, double time, bool isLast,
                               Timeline* timeline)
{
    RenderRequest request;
    request.time = time;
    request.compile.isLast = isLast;
    request.compile.leavesOut = leavesOut;
    request.timeline = timeline;
    RenderResult result;
    Render(pipeline, request, result);
    return result;
}

void SceneView::Render(UniversalRenderPipeline& pipeline, RenderRequest& request,
                       RenderResult& result)
{
    if (!m_HasEnvironment && DynamicGI::NeedsEnvironment(m_Asset.scene))
    {
        m_HasEnvironment = true; // also where it fails: pictures without are better than none
        Measure(request.timeline, "environment",
                [&]
                {
                    DynamicGI::UpdateEnvironment(pipeline.device(), m_Renderer.shaderCompiler(),
                                                 m_Asset.scene, request.time);
                });
    }
    TurnObjects(m_Asset.turns, request.time);
    request.scene = &m_Asset.scene;
    request.camera = &m_Asset.camera;
    request.width = m_Asset.width;
    request.height = m_Asset.height;
    request.blendVolumes = [this, timeline = request.timeline](const Camera& camera)
    {
        Measure(timeline, "volumes",
                [&]
                {
                    m_Volumes.Update(m_Stack,
                                     camera.volumeTrigger.value_or(camera.transform.position()),
                                     camera.volumeLayerMask);
                });
        return &m_Stack;
    };
    pipeline.msaaSampleCount = m_Asset.msaaSampleCount;
    pipeline.supportsHDR = m_Asset.supportsHDR;
    pipeline.hdrColorBufferPrecision = m_Asset.hdrColorBufferPrecision;
    pipeline.renderScale = m_Asset.renderScale;
    pipeline.maxAdditionalLightsCount = m_Asset.maxAdditionalLightsCount;
    pipeline.pipelineVersion = m_Asset.pipelineVersion;
    pipeline.shadows = m_Asset.shadows;
    for (bool isDrawn = false; !isDrawn;)
    {
        try
        {
            Draw(pipeline, request, result);
            isDrawn = true;
        }
        catch (const AssetError& error)
        {
            const std::vector<Diagnostic> errors =
                m_Asset.isUnityScene ? LeaveOut(error) : std::vector<Diagnostic>();
            if (errors.empty())
            {
                throw;
            }
            std::ranges::transform(errors, std::back_inserter(m_Notes),
                                   [](Diagnostic found)
                                   {
                                       found.severity = Severity::Note;
                                       return Replaced(ToString(found), ": note: ", ": ");
                                   });
        }
    }
    std::ranges::copy(m_Notes, std::back_inserter(result.report.notes));
}

std::vector<Diagnostic> SceneView::LeaveOut(const AssetError& error)
{
    const auto* ofPlugin = dynamic_cast<const PluginError*>(&error);
    bool isFeature = false;
    for (const auto& feature : m_Renderer.rendererFeatures())
    {
        if (ofPlugin && feature->isActive() && feature->name == ofPlugin->feature)
        {
            feature->SetActive(false); // which the frame's own notes say
            isFeature = true;
        }
    }
    // Passes for shadows and depth are compiled by their first draw.
    return isFeature ? error.diagnostics() : ReplaceBrokenShaders(m_Asset);
}

void SceneView::Draw(UniversalRenderPipeline& pipeline, const RenderRequest& request,
                     RenderResult& result)
{
    std::vector<RenderResult> textures;
    if (!m_Asset.textureCameras.empty())
    {
        textures = RenderTextures(pipeline, request);
    }
    pipeline.RenderSingleCamera(m_Renderer, request, result);
    for (const RenderResult& texture : textures)
    {
        std::ranges::copy(texture.report.notes, std::back_inserter(result.report.notes));
    }
}

std::vector<RenderResult> SceneView::RenderTextures(UniversalRenderPipeline& pipeline,
                                                    RenderRequest request)
{
    std::vector<const Camera*> cameras;
    for (const Camera& camera : m_Asset.textureCameras)
    {
        cameras.push_back(&camera);
    }
    request.compile.isLast = false; // the picture reads what they draw
    return pipeline.Render(m_Renderer, request, cameras);
}

} // namespace limn
