#pragma once

#include "core/scene/TestScene.h"
#include "report/truth/OutlineReference.h"

#include <limn/core/BuiltinShaders.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/Features.h>
#include <limn/features/WideOutlineRendererFeature.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeStack.h>

namespace limn::test
{

using namespace study; // the exact outline

/// A mesh that shows these triangles where they are, before a camera that sees a unit a pixel.
inline std::shared_ptr<const Mesh> MeshOf(const ScreenTriangles& triangles, int width, int height)
{
    MeshData data;
    for (const auto& triangle : triangles)
    {
        for (const glm::dvec2& corner : triangle)
        {
            data.triangles.push_back(static_cast<std::uint32_t>(data.vertices.size()));
            data.vertices.emplace_back(corner.x - 0.5 * width, 0.5 * height - corner.y, 0.0);
        }
    }
    return std::make_shared<const Mesh>("shape", std::move(data));
}

/// Black objects on black, with a white wide outline: what the picture shows is its alpha.
class WideOutlineScene
{
public:
    WideOutlineScene(GraphicsDevice& device, int width, int height,
                     const WideOutlineSettings& settings = {})
        : m_Pipeline(device), m_Device(device)
    {
        camera.orthographic = true;
        SetPicture(width, height);
        camera.transform.localPosition = {0.0f, 0.0f, -10.0f};
        camera.backgroundColor = Color::clear;
        m_Request.scene = &scene;
        m_Request.camera = &camera;
        RegisterVolumeComponents(m_Registry);
        m_Manager = std::make_unique<VolumeManager>(m_Registry);
        m_Stack = std::make_unique<VolumeStack>(m_Manager->CreateStack());
        const auto profile = std::make_shared<VolumeProfile>();
        outline = &profile->Add<WideOutline>();
        outline->m_Enable.Override(true);
        m_Volume.sharedProfile = profile;
        m_Manager->Register(&m_Volume);
        m_Material = std::make_shared<Material>(
            FindBuiltinShader("Universal Render Pipeline/Unlit", Compiler()));
        m_Material->SetColor(Shader::PropertyToID("_BaseColor"), Color::black);
        auto added = std::make_unique<WideOutlineRendererFeature>(settings);
        added->name = "Wide Outline";
        feature = static_cast<WideOutlineRendererFeature*>(&renderer.AddFeature(std::move(added)));
    }

    GameObject& Add(const ScreenTriangles& triangles)
    {
        return Add(MeshOf(triangles, m_Request.width, m_Request.height));
    }
    GameObject& Add(std::shared_ptr<const Mesh> mesh)
    {
        GameObject& object = scene.Add("shape");
        object.renderer = MeshRenderer{std::move(mesh), {m_Material}};
        return object;
    }

    /// A pixel of it is a unit of the world.
    void SetPicture(int width, int height)
    {
        m_Request.width = width;
        m_Request.height = height;
        camera.orthographicSize = 0.5f * static_cast<float>(height);
    }
    /// In place of what was there.
    GameObject& Show(const ScreenTriangles& triangles)
    {
        scene = Scene();
        return Add(triangles);
    }
    void SetSamples(int count) { m_Pipeline.msaaSampleCount = count; }
    void Set(const OutlineBand& band)
    {
        outline->m_OutlineWidth.Override(static_cast<float>(band.width));
        outline->m_Gap.Override(static_cast<float>(band.gap));
        outline->m_Side.Override(band.side == OutlineSide::Outer   ? WideOutlineSide::Outer
                                 : band.side == OutlineSide::Inner ? WideOutlineSide::Inner
                                                                   : WideOutlineSide::Centred);
    }

    RenderResult Render()
    {
        m_Manager->Update(*m_Stack, glm::vec3(0.0f), LayerMask::FromIndex(0));
        m_Request.volumeStack = m_Stack.get();
        return m_Pipeline.RenderSingleCamera(renderer, m_Request);
    }

    /// The camera's colour before it goes to the output.
    Image Draw()
    {
        m_Request.alsoReadBack.clear();
        m_Request.compile.leavesOut = false;
        const RenderResult first = Render();
        m_Request.compile.leavesOut = true;
        m_Request.alsoReadBack = {RTHandle(first.frame->passes.at(0).colors.at(0).texture)};
        Render();
        return m_Device.ReadBack(*m_Request.alsoReadBack.at(0).rt());
    }
    Coverage DrawAlpha() { return ChannelOf(Draw(), 1); }

    Scene scene;
    Camera camera;
    UniversalRenderer renderer{Compiler()};
    WideOutline* outline = nullptr;
    WideOutlineRendererFeature* feature = nullptr;

private:
    UniversalRenderPipeline m_Pipeline;
    GraphicsDevice& m_Device;
    VolumeComponentRegistry m_Registry;
    std::unique_ptr<VolumeManager> m_Manager;
    std::unique_ptr<VolumeStack> m_Stack;
    Volume m_Volume;
    std::shared_ptr<Material> m_Material;
    RenderRequest m_Request;
};

} // namespace limn::test
