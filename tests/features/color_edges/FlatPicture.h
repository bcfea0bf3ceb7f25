#pragma once

#include "core/scene/TestScene.h"

#include <functional>
#include <glm/vec2.hpp>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/Features.h>
#include <limn/volume/Volume.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeStack.h>

namespace limn::test
{

/// A profile in a global volume, blended.
class BlendedProfile
{
public:
    BlendedProfile()
    {
        RegisterVolumeComponents(m_Registry);
        m_Manager = std::make_unique<VolumeManager>(m_Registry);
        m_Stack = std::make_unique<VolumeStack>(m_Manager->CreateStack());
        m_Manager->Register(&m_Volume);
    }

    const VolumeStack& With(const std::function<void(VolumeProfile&)>& fill)
    {
        auto profile = std::make_shared<VolumeProfile>();
        fill(*profile);
        m_Volume.sharedProfile = std::move(profile);
        m_Manager->Update(*m_Stack, glm::vec3(0.0f), LayerMask::FromIndex(0));
        return *m_Stack;
    }

private:
    VolumeComponentRegistry m_Registry;
    std::unique_ptr<VolumeManager> m_Manager;
    std::unique_ptr<VolumeStack> m_Stack;
    Volume m_Volume;
};

/// The same with one component.
template <typename Component>
class BlendedComponent
{
public:
    /// @param set  overrides what differs from the defaults, beside m_Enable
    const VolumeStack& With(const std::function<void(Component&)>& set)
    {
        return m_Profile.With(
            [&](VolumeProfile& profile)
            {
                auto& component = profile.template Add<Component>();
                component.m_Enable.Override(true);
                set(component);
            });
    }

private:
    BlendedProfile m_Profile;
};

/// A material of one linear colour, whatever the light, of any size.
inline std::shared_ptr<Material> Plain(const glm::vec3& linear)
{
    static const auto shader = FindBuiltinShader("Universal Render Pipeline/Unlit", Compiler());
    const auto material = std::make_shared<Material>(shader);
    material->SetVector(ShaderPropertyId("_BaseColor"), glm::vec4(linear, 1.0f));
    return material;
}

/// A material that gives what no material holds.
/// @param value  HLSL of a float
inline std::shared_ptr<Material> Strange(const std::string& value)
{
    return std::make_shared<Material>(ShaderOf(
        "Shader \"Test/Strange\" { SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" "
        "}\nHLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "float4 Vert(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }\n"
        "float4 Frag() : SV_Target { float x = " +
        value + "; return float4(x, x, x, 1); }\nENDHLSL\n} } }"));
}

/// Rectangles seen straight from in front, placed in pixels: y runs down from the top left corner
/// of the picture, as it does in images. The background is black.
struct FlatScene
{
    Scene scene;
    Camera camera;
    glm::vec2 size;

    FlatScene(int width, int height) : size(width, height)
    {
        camera.orthographic = true;
        camera.orthographicSize = size.y * 0.5f;
        camera.nearClipPlane = 1.0f;
        camera.farClipPlane = 11.0f;
        camera.backgroundColor = Color::black;
    }

    /// What follows is seen in perspective, at the same pixels.
    void MakePerspective()
    {
        camera.orthographic = false;
        camera.fieldOfView = 53.13010235f; // as high as far away
    }

    /// @param low, high  its top left and bottom right corner, pixels
    /// @param depth      distance from the camera, 1...11
    GameObject& Add(const glm::vec2& low, const glm::vec2& high, float depth,
                    std::shared_ptr<const Material> material)
    {
        GameObject& object = scene.Add("Rectangle " + std::to_string(scene.objects().size()));
        const glm::vec2 middle = (low + high) * 0.5f - size * 0.5f;
        const float unit = camera.orthographic ? 1.0f : depth / size.y; // a pixel
        object.transform.localPosition = {middle.x * unit, -middle.y * unit, depth};
        object.transform.localScale = {(high.x - low.x) * unit, (high.y - low.y) * unit, 1.0f};
        object.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Quad), {material}};
        return object;
    }
};

} // namespace limn::test
