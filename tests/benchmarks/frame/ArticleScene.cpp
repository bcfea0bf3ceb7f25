#include "frame/ArticleScene.h"

#include <algorithm>
#include <cmath>
#include <limn/core/BuiltinShaders.h>
#include <limn/features/Features.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <map>

namespace limn::benchmarks
{

namespace
{

/// The side of the square that holds an object: all of them fill the picture.
float CellSize(const ArticleSettings& settings)
{
    const float height =
        2.0f * k_CameraDistance * std::tan(k_CameraFieldOfView * 0.5f * 3.14159265f / 180.0f);
    if (settings.size > 0.0f)
    {
        return height * settings.size;
    }
    const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
    const float area = height * height * aspect;
    return std::min(0.5f * height, std::sqrt(area / static_cast<float>(settings.objects)) * 0.85f);
}

} // namespace

ArticleScene::ArticleScene(const ArticleSettings& settings, GraphicsDevice& device)
    : m_Pipeline(device)
{
    RegisterVolumeComponents(m_Components);
    m_Volumes = std::make_unique<VolumeManager>(m_Components);
    m_Stack = std::make_unique<VolumeStack>(m_Volumes->CreateStack());
    m_Camera.transform.localPosition = {0.0f, 0.0f, -k_CameraDistance};
    m_Camera.fieldOfView = k_CameraFieldOfView;
    AddObjects(settings);
    if (settings.hasOutline)
    {
        AddOutline();
    }
    m_Request.scene = &m_Scene;
    m_Request.camera = &m_Camera;
    m_Request.width = settings.width;
    m_Request.height = settings.height;
    m_Request.volumeStack = m_Stack.get();
    m_Request.compile.limitsRegions = settings.limitsRegions;
    m_Request.compile.leavesOut = settings.leavesOut;
}

void ArticleScene::AddObjects(const ArticleSettings& settings)
{
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (int i = 0; i < settings.meshes; ++i)
    {
        meshes.push_back(CreatePrimitive(
            settings.shape.value_or(i % 2 == 0 ? PrimitiveType::Cube : PrimitiveType::Quad)));
    }
    std::vector<std::shared_ptr<const Material>> materials;
    const auto lit = FindShippedShader("Limn/Half Lambert", m_Compiler);
    for (int i = 0; i < settings.materials; ++i)
    {
        auto material = std::make_shared<Material>(lit);
        const float shade =
            0.3f + 0.7f * static_cast<float>(i + 1) / static_cast<float>(settings.materials);
        material->SetColor(ShaderPropertyId("_BaseColor"), {shade, 0.6f, 1.0f - shade, 1.0f});
        materials.push_back(std::move(material));
    }
    const float cell = CellSize(settings);
    const auto columns =
        static_cast<int>(std::ceil(std::sqrt(static_cast<float>(settings.objects * settings.width) /
                                             static_cast<float>(settings.height))));
    const int rows = (settings.objects + columns - 1) / columns;
    for (int i = 0; i < settings.objects; ++i)
    {
        GameObject& object = m_Scene.Add("object " + std::to_string(i));
        const auto x = static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1);
        const auto y = static_cast<float>(i / columns) - 0.5f * static_cast<float>(rows - 1);
        const auto turn = static_cast<float>(i);
        object.transform.localPosition = {cell * x, cell * y, 0.0f};
        object.transform.localScale = glm::vec3((settings.shape ? 1.0f : 0.6f) * cell);
        if (!settings.shape)
        {
            object.transform.localRotation =
                EulerToRotation({20.0f + turn, 30.0f + 0.3f * turn, 0.1f * turn});
        }
        MeshRenderer renderer;
        renderer.mesh = meshes[static_cast<std::size_t>(i % settings.meshes)];
        renderer.sharedMaterials = {
            materials[static_cast<std::size_t>(i / settings.meshes % settings.materials)]};
        renderer.renderingLayerMask = i % 10 == 0
                                          ? RenderingLayerMask::FromIndex(0) | k_OutlinedLayers
                                          : RenderingLayerMask::FromIndex(0);
        object.renderer = std::move(renderer);
    }
}

void ArticleScene::Move(Movement what, int step)
{
    const float x = step % 2 != 0 ? k_Step : 0.0f;
    if (what == Movement::Camera)
    {
        m_Camera.transform.localPosition.x = x;
    }
    const auto& objects = m_Scene.objects();
    for (std::size_t i = 0; i < MovedCount(what, objects.size()); ++i)
    {
        objects[i]->transform.localPosition.z = x;
    }
}

void ArticleScene::AddOutline()
{
    ScreenSpaceOutlineSettings outline;
    outline.m_ScreenSpaceOutlineShader = FindShippedShader("Hidden/ScreenSpaceOutline", m_Compiler);
    outline.m_LayerMask = LayerMask::Everything();
    outline.m_RenderingLayerMask = k_OutlinedLayer;
    auto feature = std::make_unique<ScreenSpaceOutlineRenderFeature>(std::move(outline));
    feature->name = "Outline";
    m_Renderer.AddFeature(std::move(feature));

    auto profile = std::make_shared<VolumeProfile>();
    auto& component = profile->Add<ScreenSpaceOutline>();
    component.m_Enable.Override(true);
    component.m_OutlineColor.Override({1.0f, 0.8f, 0.2f, 1.0f});
    component.m_OutlineWidth.Override(4.0f);
    m_Volume.sharedProfile = std::move(profile);
    m_Volumes->Register(&m_Volume);
    m_Volumes->Update(*m_Stack, m_Camera.transform.position(), m_Camera.volumeLayerMask);
}

namespace
{

/// Sorts a frame's draws by what they are for.
class NumberTaker
{
public:
    NumberTaker(const Scene& scene, const CompiledFrame& frame) : m_Frame(frame)
    {
        for (const auto& object : scene.objects())
        {
            const glm::vec3& place = object->transform.localPosition;
            m_ObjectAt[{place.x, place.y}] = m_Result.objects.size();
            m_Result.objects.push_back(
                {object->transform, object->renderer->renderingLayerMask, 0});
        }
    }

    ArticleNumbers Take()
    {
        for (const CompiledRenderPass& pass : m_Frame.passes)
        {
            for (const PassCommand& command : pass.commands)
            {
                if (const auto* draw = std::get_if<DrawCommand>(&command))
                {
                    Take(pass, *draw);
                }
            }
        }
        m_Result.uniforms = m_Frame.uniformData;
        return std::move(m_Result);
    }

private:
    void Take(const CompiledRenderPass& pass, const DrawCommand& draw)
    {
        const DrawSetup& setup = m_Frame.Setup(draw);
        if (setup.shader->name() == "Limn/Half Lambert")
        {
            TakeLit(pass, draw);
        }
        else if (setup.shader->name() != "Hidden/ScreenSpaceOutline")
        {
            m_Result.final = {setup.program, setup.bindings};
        }
        else if (setup.shaderPass == 0)
        {
            m_Result.mask = setup.program;
            m_Result.maskBindings = setup.bindings;
        }
        else
        {
            (setup.shaderPass == 1 ? m_Result.edge : m_Result.composite) = {setup.program,
                                                                            setup.bindings};
        }
    }

    void TakeLit(const CompiledRenderPass& pass, const DrawCommand& draw)
    {
        const DrawSetup& setup = m_Frame.Setup(draw);
        m_Result.width = pass.width;
        m_Result.height = pass.height;
        m_Result.background = pass.colors.at(0).clearColor;
        m_Result.lit = setup.program;
        auto& materials = m_Result.materials;
        const auto found = std::find(materials.begin(), materials.end(), setup.bindings);
        const auto material = static_cast<std::size_t>(found - materials.begin());
        if (found == materials.end())
        {
            materials.push_back(setup.bindings);
        }
        const ArticleGroup group{m_Frame.MeshOf(draw), material, 0, 0, 0};
        const auto known = std::ranges::find(m_Result.groups, group);
        const std::size_t number = static_cast<std::size_t>(known - m_Result.groups.begin());
        if (known == m_Result.groups.end())
        {
            m_Result.groups.push_back(group);
        }
        for (std::uint32_t i = 0; i < draw.instanceCount; ++i)
        {
            const PerDrawData object = m_Frame.PerDraw(draw, i);
            const float* place = object.objectToWorld + 12;
            m_Result.objects[m_ObjectAt.at({place[0], place[1]})].group = number;
        }
    }

    const CompiledFrame& m_Frame;
    ArticleNumbers m_Result;
    std::map<std::pair<float, float>, std::size_t> m_ObjectAt; ///< each is at another place
};

} // namespace

ArticleNumbers NumbersOf(ArticleScene& scene)
{
    ArticleNumbers numbers = NumberTaker(scene.scene(), *scene.Render().frame).Take();
    scene.Move(Movement::Camera, 1);
    numbers.uniformsOfMovedCamera = scene.Render().frame->uniformData;
    scene.Move(Movement::Camera, 0);
    return numbers;
}

} // namespace limn::benchmarks
