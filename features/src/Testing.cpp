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

/// Returns why a filter does not take a renderer, as a clause.
std::string ReasonOf(FilterVerdict verdict)
{
    return verdict == FilterVerdict::NoMatchingPass
               ? "the renderer has no pass with a LightMode that is asked for"
               : std::string("the filter's ") + ToString(verdict) +
                     (verdict == FilterVerdict::QueueOutOfRange ? " range" : "") + " leaves it out";
}

/// Returns a clause with the reason why a feature is idle; "" if it has none.
std::string WithFeature(const std::string& why)
{
    return why.empty() ? why : "the feature draws nothing: " + why;
}

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
            reason = verdict == FilterVerdict::Drawn ? WithFeature(ObstacleOf(report, *filter))
                                                     : ReasonOf(verdict);
            if (reason.empty())
            {
                return "";
            }
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

CheckResult Takes(const FilteringSettings& filter, const ARenderer& renderer)
{
    FilterItem item;
    item.renderQueue = renderer.queue;
    item.layer = renderer.layer;
    item.renderingLayerMask = renderer.renderingLayerMask;
    const FilterVerdict verdict = JudgeMasks(item, filter);
    const bool isTaken = verdict == FilterVerdict::Drawn;
    return {isTaken, isTaken
                         ? "the filter takes " + renderer.name
                         : "the filter must take " + renderer.name + ", but " + ReasonOf(verdict)};
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
    const auto isNamed = [&](const auto& one)
    {
        return one.name.name() == feature;
    };
    const auto own = std::ranges::find_if(report.features, isNamed);
    const bool isFeature = own != report.features.end();
    if (!isFeature && std::ranges::none_of(report.passes, isNamed))
    {
        throw ContractError("the frame has no feature or pass '" + std::string(feature) + "'");
    }
    std::vector<const DrawRenderersReport*> filters;
    for (const DrawRenderersReport* filter : DecidingFilters(report))
    {
        const bool isOther =
            filter->feature >= report.features.size() || !isNamed(report.features[filter->feature]);
        if (!isOther || filter->pass.name() == feature)
        {
            filters.push_back(filter);
        }
    }
    const std::string idle = isFeature ? WhyIdle(report, *own) : "";
    bool isFound = false;
    for (const auto& object : frame.scene->objects())
    {
        if (object->renderer && object->name == renderer)
        {
            isFound = true;
            const std::string reason = !filters.empty()
                                           ? ReasonOf(report, filters, frame.seen, *object)
                                       : idle.empty() ? "the feature asks for no renderers"
                                                      : WithFeature(idle);
            if (!reason.empty())
            {
                return {false, std::string(feature) + " must draw " + std::string(renderer) +
                                   ", but " + reason};
            }
        }
    }
    if (!isFound)
    {
        throw ContractError("the scene has no renderer '" + std::string(renderer) + "'");
    }
    return {true, std::string(feature) + " draws " + std::string(renderer)};
}

} // namespace limn
