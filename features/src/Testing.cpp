#include <limn/testing.h>

#include <algorithm>
#include <limn/core/FeatureFilters.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/features/Features.h>
#include <limn/volume/VolumeProfileLoader.h>

namespace limn
{

namespace
{

/// Returns why the filters do not take what the camera sees of an object; "" if one does.
std::string ReasonOf(const RenderReport& report,
                     const std::vector<const DrawRenderersReport*>& filters,
                     const CullingResults& seen, const GameObject& object)
{
    std::string reason = "the camera does not see it";
    for (const RendererItem& item : seen.items)
    {
        for (const DrawRenderersReport* filter : filters)
        {
            if (item.object != &object)
            {
                continue;
            }
            const FilterVerdict verdict = Judge(item.filter, filter->filtering, filter->drawing);
            const bool isIdle = filter->feature < report.features.size() &&
                                report.features[filter->feature].passes == 0;
            if (verdict == FilterVerdict::Drawn && !isIdle)
            {
                return "";
            }
            reason = verdict == FilterVerdict::Drawn
                         ? WhyIdle(report, report.features[filter->feature])
                         : std::string(ToString(verdict));
        }
    }
    return reason;
}

} // namespace

ARenderer& ARenderer::OnLayer(int index)
{
    static_cast<void>(LayerMask::FromIndex(index)); // throws where there is no such layer
    layer = index;
    return *this;
}

ARenderer& ARenderer::WithRenderingLayer(int index)
{
    renderingLayerMask = renderingLayerMask | RenderingLayerMask::FromIndex(index);
    return *this;
}

ARenderer& ARenderer::WithQueue(int renderQueue)
{
    queue = renderQueue;
    return *this;
}

ARenderer& ARenderer::At(const glm::vec3& worldPosition)
{
    position = worldPosition;
    return *this;
}

CheckResult Takes(const FilteringSettings& filter, const ARenderer& renderer)
{
    FilterItem item;
    item.renderQueue = renderer.queue;
    item.layer = renderer.layer;
    item.renderingLayerMask = renderer.renderingLayerMask;
    const FilterVerdict verdict = JudgeMasks(item, filter);
    const bool isTaken = verdict == FilterVerdict::Drawn;
    return {isTaken, "the filter takes " + renderer.name +
                         (isTaken ? "" : std::string(": it is left out: ") + ToString(verdict))};
}

TestScene::TestScene()
    : renderer(std::make_shared<ShaderCompiler>()), m_Volumes(components), m_Pipeline(m_Device)
{
    RegisterVolumeComponents(components);
    camera.transform.localPosition = {0.0f, 0.0f, -10.0f};
}

GameObject& TestScene::Add(const ARenderer& added)
{
    GameObject& object = scene.Add(added.name);
    auto material = std::make_shared<Material>(FindShader("Universal Render Pipeline/Unlit"));
    material->SetRenderQueue(added.queue);
    object.layer = added.layer;
    object.transform.localPosition = added.position;
    object.renderer = MeshRenderer{
        CreatePrimitive(PrimitiveType::Cube), {std::move(material)}, added.renderingLayerMask};
    return object;
}

void TestScene::AddVolume(std::string_view profile)
{
    auto volume = std::make_unique<Volume>();
    volume->sharedProfile = ParseVolumeProfile(profile, "AddVolume", components).profile;
    m_Volumes.Register(volume.get());
    m_OwnVolumes.push_back(std::move(volume));
}

std::shared_ptr<const Shader> TestScene::FindShader(std::string_view name) const
{
    return FindShippedShader(name, renderer.shaderCompiler());
}

TestFrame TestScene::Render()
{
    VolumeStack stack = m_Volumes.CreateStack();
    m_Volumes.Update(stack, camera.transform.position(), camera.volumeLayerMask);
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = size.x;
    request.height = size.y;
    request.volumeStack = &stack;
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    return {m_Pipeline.RenderSingleCamera(renderer, request), &scene, Cull(scene, camera, aspect)};
}

CheckResult DrawnBy(const TestFrame& frame, std::string_view feature, std::string_view renderer)
{
    const RenderReport& report = frame.result.report;
    bool isKnown = std::ranges::any_of(report.passes, [&](const ExecutedPassReport& pass)
                                       { return pass.name.name() == feature; });
    std::string idle;
    for (const FeatureReport& one : report.features)
    {
        if (one.name.name() == feature)
        {
            isKnown = true;
            idle = one.passes == 0 ? WhyIdle(report, one) : "";
        }
    }
    std::vector<const DrawRenderersReport*> filters = DecidingFilters(report);
    const auto isOther = [&](const DrawRenderersReport* filter)
    {
        const bool isOfFeature = filter->feature < report.features.size() &&
                                 report.features[filter->feature].name.name() == feature;
        return !isOfFeature && filter->pass.name() != feature;
    };
    filters.erase(std::remove_if(filters.begin(), filters.end(), isOther), filters.end());
    bool isFound = false;
    for (const auto& object : frame.scene->objects())
    {
        if (!object->renderer || object->name != renderer)
        {
            continue;
        }
        isFound = true;
        const std::string reason = !filters.empty() ? ReasonOf(report, filters, frame.seen, *object)
                                   : !idle.empty()  ? idle
                                                    : "it asks for no renderers";
        if (isKnown && !reason.empty())
        {
            return {false, "drawn by " + std::string(feature) + ": " + object->name +
                               " is left out: " + reason};
        }
    }
    if (!isFound || !isKnown)
    {
        throw ContractError(isKnown ? "the scene has no renderer '" + std::string(renderer) + "'"
                                    : "the frame has no feature or pass '" + std::string(feature) +
                                          "'");
    }
    return {true, "drawn by " + std::string(feature) + ": " + std::string(renderer)};
}

} // namespace limn
