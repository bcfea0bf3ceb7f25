#pragma once

#include "core/scene/TestScene.h"
#include "report/truth/OutlineReference.h"

#include <limn/core/BuiltinShaders.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/Features.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeStack.h>

namespace limn::test
{

using namespace study; // the exact outline

/// Black objects on black, so that a white outline is its own alpha. In the camera that it begins
/// with a unit is a pixel, x to the right and y up from the middle of the picture.
class TechniquePicture
{
public:
    /// @param device  must outlive this
    TechniquePicture(GraphicsDevice& device, int width, int height)
        : m_Device(&device), m_Pipeline(device)
    {
        camera.orthographic = true;
        camera.orthographicSize = static_cast<float>(height) / 2.0f;
        camera.nearClipPlane = 1.0f;
        camera.farClipPlane = 1000.0f;
        camera.transform.localPosition = {0.0f, 0.0f, -100.0f};
        camera.backgroundColor = Color::black;
        RegisterVolumeComponents(m_Registry);
        m_Manager = std::make_unique<VolumeManager>(m_Registry);
        m_Stack = std::make_unique<VolumeStack>(m_Manager->CreateStack());
        m_Request.scene = &scene;
        m_Request.camera = &camera;
        m_Request.width = width;
        m_Request.height = height;
    }

    Scene scene;
    Camera camera;
    GraphicsDevice& device() { return *m_Device; }
    int width() const { return m_Request.width; }
    int height() const { return m_Request.height; }
    void SetSamples(int count) { m_Pipeline.msaaSampleCount = count; }

    template <typename Feature, typename Settings>
    Feature& AddFeature(Settings settings)
    {
        auto feature = std::make_unique<Feature>(std::move(settings));
        feature->name = "Outline";
        return static_cast<Feature&>(m_Renderer.AddFeature(std::move(feature)));
    }

    /// The component of a global volume; switched on, with a white outline.
    template <typename Component>
    Component& Enable(float outlineWidth)
    {
        if (!m_Volume.sharedProfile)
        {
            m_Profile = std::make_shared<VolumeProfile>();
            m_Volume.sharedProfile = m_Profile;
            m_Manager->Register(&m_Volume);
        }
        auto& component = m_Profile->Add<Component>();
        component.m_Enable.Override(true);
        component.m_OutlineColor.Override(Color::white);
        component.m_OutlineWidth.Override(outlineWidth);
        return component;
    }

    GameObject& Add(const char* name, std::shared_ptr<const Mesh> mesh,
                    const Color& color = Color::black)
    {
        static const auto shader = // compiled once for all pictures
            FindBuiltinShader("Universal Render Pipeline/Unlit", Compiler());
        auto material = std::make_shared<Material>(shader);
        material->SetColor(ShaderPropertyId("_BaseColor"), color);
        GameObject& object = scene.Add(name);
        object.renderer = MeshRenderer{std::move(mesh), {std::move(material)}};
        return object;
    }

    /// A flat object from pixels of the picture.
    GameObject& Add(const char* name, const ScreenTriangles& triangles, float z = 0.0f,
                    const Color& color = Color::black)
    {
        MeshData data;
        for (const auto& triangle : triangles)
        {
            for (const glm::dvec2& p : triangle)
            {
                data.triangles.push_back(static_cast<std::uint32_t>(data.vertices.size()));
                data.vertices.emplace_back(p.x - 0.5 * width(), 0.5 * height() - p.y, z);
            }
        }
        return Add(name, std::make_shared<const Mesh>(name, std::move(data)), color);
    }

    const RenderResult& Render()
    {
        m_Manager->Update(*m_Stack, glm::vec3(0.0f), LayerMask::FromIndex(0));
        m_Request.volumeStack = m_Stack.get();
        m_Result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        return m_Result;
    }

    /// The camera's colour of a new frame before it is rounded to 8 bits.
    Image Colors()
    {
        m_Request.alsoReadBack.clear();
        m_Request.compile.leavesOut = false;
        Render();
        for (const CompiledRenderPass& pass : m_Result.frame->passes)
        {
            if (!pass.colors.empty() && pass.colors.front().texture->name() == k_CameraColor)
            {
                m_Request.alsoReadBack = {RTHandle(pass.colors.front().texture)};
            }
        }
        Render();
        m_Request.compile.leavesOut = true;
        return m_Device->ReadBack(*m_Request.alsoReadBack.at(0).rt());
    }
    Coverage Alpha() { return ChannelOf(Colors(), 0); }
    Image Output()
    {
        Render();
        return m_Device->ReadBack(*m_Result.output.rt());
    }
    /// The same with everything run that is recorded.
    Image OutputOfAll()
    {
        m_Request.compile.leavesOut = false;
        Image output = Output();
        m_Request.compile.leavesOut = true;
        return output;
    }
    const RenderResult& result() const { return m_Result; } ///< of the last frame

private:
    static constexpr const char* k_CameraColor = "_CameraColorAttachmentA";

    GraphicsDevice* m_Device;
    UniversalRenderPipeline m_Pipeline;
    UniversalRenderer m_Renderer{Compiler()};
    VolumeComponentRegistry m_Registry;
    std::unique_ptr<VolumeManager> m_Manager;
    std::unique_ptr<VolumeStack> m_Stack;
    std::shared_ptr<VolumeProfile> m_Profile;
    Volume m_Volume;
    RenderRequest m_Request;
    RenderResult m_Result;
};

} // namespace limn::test
