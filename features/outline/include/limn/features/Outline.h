#pragma once

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/core/UniversalRenderer.h>
#include <limn/volume/Volume.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeStack.h>
#include <memory>
#include <string_view>
#include <utility>

namespace limn
{

/// The parts that a picture of a scene takes, besides the scene and its camera, put together: a
/// global volume with an own profile, the manager that blends it, and a renderer. Every part can be
/// had by reference and changed, as if the program had made it itself.
class RenderSetup
{
public:
    /// @param device  must outlive this
    explicit RenderSetup(GraphicsDevice& device);
    RenderSetup(const RenderSetup&) = delete;
    RenderSetup& operator=(const RenderSetup&) = delete;

    /// Blends the volumes for each camera, and draws.
    /// @param width, height  of the picture, pixels, > 0
    /// @throws ContractError, AssetError (a shader), VulkanError
    RenderResult Render(const Scene& scene, const Camera& camera, int width, int height);
    /// The same with everything that a request can say.
    /// @param request  its volumeStack and blendVolumes are not looked at
    RenderResult Render(RenderRequest request);

    /// Returns a new material of a shader that comes with limn, which this setup's compiler
    /// compiles.
    /// @throws ContractError for a name that no such shader has, with the nearest one
    std::shared_ptr<Material> CreateMaterial(std::string_view shader) const;

    const std::shared_ptr<ShaderCompiler>& compiler() const { return m_Compiler; }
    VolumeComponentRegistry& components() { return m_Components; } ///< those that come with limn
    VolumeProfile& profile() { return *m_Profile; }                ///< of volume(); empty at first
    Volume& volume() { return m_Volume; }                          ///< global, registered
    VolumeManager& volumes() { return m_Volumes; }
    VolumeStack& stack() { return m_Stack; } ///< as Render blended it last
    UniversalRenderer& renderer() { return m_Renderer; }
    UniversalRenderPipeline& pipeline() { return m_Pipeline; }

private:
    std::shared_ptr<ShaderCompiler> m_Compiler;
    VolumeComponentRegistry m_Components;
    std::shared_ptr<VolumeProfile> m_Profile;
    Volume m_Volume;
    VolumeManager m_Volumes;
    VolumeStack m_Stack;
    UniversalRenderer m_Renderer;
    UniversalRenderPipeline m_Pipeline;
};

/// An outline in a picture, ready to draw:
///
///     Outline<StrokeOutlineRendererFeature> outline(device);
///     outline.component().m_OutlineWidth.Override(6.0f);
///     WritePng("picture.png", device.ReadBack(*outline.Render(scene, camera, 640,
///     360).output.rt()));
///
/// The feature outlines what its settings let through, by default all that is in rendering layer 0,
/// in which every new renderer is.
/// @tparam Feature  a technique: AutoOutlineRendererFeature, StrokeOutlineRendererFeature,
///                  WideOutlineRendererFeature ...
template <typename Feature>
class Outline : public RenderSetup
{
public:
    using Component = typename Feature::Component;
    using Settings = typename Feature::Settings;

    /// @param device    must outlive this
    /// @param settings  of the feature, for as long as it lives
    explicit Outline(GraphicsDevice& device, Settings settings = {})
        : RenderSetup(device), m_Component(profile().template Add<Component>())
    {
        m_Component.m_Enable.Override(true);
        auto feature = std::make_unique<Feature>(std::move(settings));
        m_Feature = feature.get();
        renderer().AddFeature(std::move(feature));
    }

    /// What the volume sets of the outline, as `component().m_OutlineWidth.Override(6.0f)`;
    /// switched on already.
    Component& component() { return m_Component; }
    Feature& feature() { return *m_Feature; }
    const Settings& settings() const { return m_Feature->settings(); }

private:
    Component& m_Component;
    Feature* m_Feature;
};

} // namespace limn
