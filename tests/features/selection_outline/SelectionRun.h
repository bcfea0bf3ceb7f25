#pragma once

#include "features/OutlineGpuReference.h"
#include "features/OutlineScene.h"
#include "vulkan/GpuTestDevice.h"

#include <algorithm>
#include <filesystem>
#include <limn/features/SelectionOutlineRendererFeature.h>

namespace limn::test
{

/// Two squares before a camera for which a unit is a pixel, x to the right and y up from the middle
/// of the picture: a large one, and a small one in front of it.
struct SquareScene
{
    Scene scene;
    limn::Camera camera;
    GameObject& large = Add("Large", {0.0f, 0.0f, 10.0f}, 40.0f);
    GameObject& small = Add("Small", {4.0f, 0.0f, 5.0f}, 12.0f);

    explicit SquareScene(int height)
    {
        camera.orthographic = true;
        camera.orthographicSize = static_cast<float>(height) / 2.0f;
    }

    GameObject& Add(const char* name, const glm::vec3& position, float side)
    {
        GameObject& object = scene.Add(name);
        object.transform.localPosition = position;
        object.transform.localScale = glm::vec3(side);
        object.renderer = MeshRenderer{
            CreatePrimitive(PrimitiveType::Quad),
            {std::make_shared<Material>(
                FindBuiltinShader("Universal Render Pipeline/Unlit", Compiler()))},
            RenderingLayerMask::FromIndex(0) | RenderingLayerMask::FromIndex(k_SelectedLayer)};
        return object;
    }
};

/// Renders a scene with a selection outline, and gives the textures of the last frame.
class SelectionRun
{
public:
    SelectionRun(int width, int height, const Scene& scene, const Camera& camera,
                 SelectionOutlineSettings settings = MakeSettings())
        : m_Feature(static_cast<SelectionOutlineRendererFeature&>(m_Renderer.AddFeature(
              std::make_unique<SelectionOutlineRendererFeature>(std::move(settings)))))
    {
        m_Feature.name = "Selection";
        m_Profile = std::make_shared<VolumeProfile>();
        m_Component = &m_Profile->Add<SelectionOutline>();
        m_Component->m_Enable.Override(true);
        m_Volume.sharedProfile = m_Profile;
        m_Manager.Register(&m_Volume);
        m_Request.scene = &scene;
        m_Request.camera = &camera;
        m_Request.width = width;
        m_Request.height = height;
    }

    /// Outlines what is in the selected rendering layer.
    static SelectionOutlineSettings MakeSettings()
    {
        SelectionOutlineSettings settings;
        settings.m_RenderingLayerMask = k_SelectedLayer;
        return settings;
    }

    SelectionOutline& component() { return *m_Component; }
    SelectionOutlineRendererFeature& feature() { return m_Feature; }
    UniversalRenderer& renderer() { return m_Renderer; }
    void SetSamples(int count) { m_Pipeline.msaaSampleCount = count; }
    RenderRequest& request() { return m_Request; }

    const RenderResult& Render(double time)
    {
        m_Manager.Update(m_Stack, glm::vec3(0.0f), LayerMask::FromIndex(0));
        m_Request.volumeStack = &m_Stack;
        m_Request.time = time;
        m_Result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        return m_Result;
    }
    Image Output(double time)
    {
        Render(time);
        return SharedDevice().ReadBack(*m_Result.output.rt());
    }

    /// Renders so that all textures can be read.
    void RenderForReading(double time)
    {
        m_Request.alsoReadBack.clear();
        m_Request.compile.leavesOut = false;
        Render(time);
        for (const CompiledRenderPass& pass : m_Result.frame->passes)
        {
            const auto& texture = pass.colors.front().texture;
            const auto isThis = [&](const RTHandle& handle)
            {
                return handle.rt() == texture;
            };
            if (texture != m_Result.output.rt() &&
                std::ranges::none_of(m_Request.alsoReadBack, isThis))
            {
                m_Request.alsoReadBack.emplace_back(texture);
            }
        }
        Render(time);
        m_Request.compile.leavesOut = true;
    }
    Field Texture(const std::string& beginning) const
    {
        for (const RTHandle& handle : m_Request.alsoReadBack)
        {
            if (handle.rt()->name().starts_with(beginning))
            {
                return ToField(SharedDevice().ReadBack(*handle.rt()));
            }
        }
        throw std::runtime_error("no texture " + beginning + " in the frame");
    }
    // Of the last object or group.
    Field CameraColor() const { return Texture("_CameraColorAttachmentA"); }
    Field Stencil() const { return Texture("TempBuffer 1 "); }
    Field Blur() const { return Texture("TempBuffer 2 "); }
    Field BlurBefore() const { return Texture("TempBuffer 3 "); } ///< what the last blur read

    void Enable(bool on) { m_Component->m_Enable.Override(on); }

private:
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
    UniversalRenderer m_Renderer{Compiler()};
    SelectionOutlineRendererFeature& m_Feature;
    struct Registry : VolumeComponentRegistry
    {
        Registry() { RegisterVolumeComponents(*this); }
    };

    Registry m_Registry;
    VolumeManager m_Manager{m_Registry};
    VolumeStack m_Stack{m_Manager.CreateStack()};
    std::shared_ptr<VolumeProfile> m_Profile;
    SelectionOutline* m_Component = nullptr;
    Volume m_Volume;
    RenderRequest m_Request;
    RenderResult m_Result;
};

} // namespace limn::test
