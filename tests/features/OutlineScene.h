#pragma once

#include "core/scene/TestScene.h"

#include <limn/core/BuiltinShaders.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/Features.h>
#include <limn/features/OutlineDrawingRenderPass.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeStack.h>

namespace limn::test
{

inline constexpr int k_FurnitureLayer = 6;
inline constexpr int k_SelectedLayer = 8; ///< rendering layer

inline std::shared_ptr<const Shader> OutlineShader()
{
    static const auto shader = FindShippedShader("Hidden/ScreenSpaceOutline", Compiler());
    return shader;
}

/// Feature settings that outline opaque furniture in the selected rendering layer.
inline ScreenSpaceOutlineSettings Settings()
{
    ScreenSpaceOutlineSettings settings;
    settings.m_ScreenSpaceOutlineShader = OutlineShader();
    settings.m_LayerMask = LayerMask::FromIndex(k_FurnitureLayer);
    settings.m_RenderingLayerMask = k_SelectedLayer;
    return settings;
}

/// A torus and a cube, both selected, with a sphere that is not in front of them.
struct OutlineScene
{
    Scene scene;
    Camera camera;

    OutlineScene()
    {
        const auto material =
            std::make_shared<const Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()));
        Add("Torus", PrimitiveType::Torus, {-0.4f, 0.1f, 0.0f}, material, true);
        Add("Cube", PrimitiveType::Cube, {0.6f, -0.2f, 0.5f}, material, true);
        Add("Sphere", PrimitiveType::Sphere, {0.2f, 0.0f, -1.2f}, material, false);
        scene.Find("Torus")->transform.localRotation = EulerToRotation({60.0f, 20.0f, 10.0f});
        scene.Find("Cube")->transform.localRotation = EulerToRotation({15.0f, 40.0f, 5.0f});
        camera.transform.localPosition = {0.0f, 0.0f, -3.0f};
        camera.fieldOfView = 50.0f;
    }

    void Add(const char* name, PrimitiveType type, const glm::vec3& position,
             const std::shared_ptr<const Material>& material, bool selected)
    {
        GameObject& object = scene.Add(name);
        object.layer = k_FurnitureLayer;
        object.transform.localPosition = position;
        MeshRenderer renderer;
        renderer.mesh = CreatePrimitive(type);
        renderer.sharedMaterials = {material};
        if (selected)
        {
            renderer.renderingLayerMask =
                RenderingLayerMask::FromIndex(0) | RenderingLayerMask::FromIndex(k_SelectedLayer);
        }
        object.renderer = std::move(renderer);
    }
};

/// One global volume with the outline's values, blended.
class BlendedOutline
{
public:
    BlendedOutline()
    {
        RegisterVolumeComponents(m_Registry);
        m_Manager = std::make_unique<VolumeManager>(m_Registry);
        m_Stack = std::make_unique<VolumeStack>(m_Manager->CreateStack());
    }

    const VolumeStack& With(bool enable, const Color& color, float width)
    {
        auto profile = std::make_shared<VolumeProfile>();
        auto& outline = profile->Add<ScreenSpaceOutline>();
        outline.m_Enable.Override(enable);
        outline.m_OutlineColor.Override(color);
        outline.m_OutlineWidth.Override(width);
        m_Volume.sharedProfile = std::move(profile);
        m_Manager->Register(&m_Volume);
        return Update();
    }

    const VolumeStack& WithoutVolumes()
    {
        m_Manager->Unregister(&m_Volume);
        return Update();
    }

private:
    const VolumeStack& Update()
    {
        m_Manager->Update(*m_Stack, glm::vec3(0.0f), LayerMask::FromIndex(0));
        return *m_Stack;
    }

    VolumeComponentRegistry m_Registry;
    std::unique_ptr<VolumeManager> m_Manager;
    std::unique_ptr<VolumeStack> m_Stack;
    Volume m_Volume;
};

/// Adds an outline feature under the name the sample uses.
inline ScreenSpaceOutlineRenderFeature& AddOutline(UniversalRenderer& renderer,
                                                   ScreenSpaceOutlineSettings settings = Settings())
{
    auto feature = std::make_unique<ScreenSpaceOutlineRenderFeature>(std::move(settings));
    feature->name = "Screen Space Outline";
    return static_cast<ScreenSpaceOutlineRenderFeature&>(renderer.AddFeature(std::move(feature)));
}

} // namespace limn::test
