#pragma once

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/volume/VolumeManager.h>
#include <memory>
#include <string_view>
#include <utility>

namespace limn
{

/// The parts that a picture of a scene needs besides the scene and its camera: a global volume with
/// its own profile, the manager that blends it, and a renderer. A program can get and change every
/// part by reference, as if it had made the part itself.
class RenderSetup
{
public:
    /// @param device  must outlive this
    explicit RenderSetup(GraphicsDevice& device);
    RenderSetup(const RenderSetup&) = delete;
    RenderSetup& operator=(const RenderSetup&) = delete;

    /// Blends the volumes for each camera, and draws.
    /// @param width, height  the size of the picture in pixels, > 0
    /// @throws ContractError, AssetError (a shader), VulkanError
    RenderResult Render(const Scene& scene, const Camera& camera, int width, int height);
    /// Renders like the other Render, with all options of a request.
    /// @param request  its volumeStack and blendVolumes are ignored
    RenderResult Render(RenderRequest request);

    /// Returns a new material with a shader that comes with limn; this setup's compiler compiles
    /// it.
    /// @throws ContractError with the nearest name if no such shader has that name
    std::shared_ptr<Material> CreateMaterial(std::string_view shader) const;

    const std::shared_ptr<ShaderCompiler>& compiler() const { return m_Compiler; }
    /// The components that come with limn.
    VolumeComponentRegistry& components() { return m_Components; }
    VolumeProfile& profile() { return *m_Profile; } ///< the profile of volume(); empty at first
    Volume& volume() { return m_Volume; }           ///< global, registered
    VolumeManager& volumes() { return m_Volumes; }
    VolumeStack& stack() { return m_Stack; } ///< as the last Render blended it
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

/// Draws pictures with an outline:
///
///     Outline<StrokeOutlineRendererFeature> outline(device);
///     outline.component().m_OutlineWidth.Override(6.0f);
///     WritePng("picture.png", device.ReadBack(*outline.Render(scene, camera, 640,
///     360).output.rt()));
///
/// The feature outlines the objects that its settings select: by default those in rendering layer
/// 0, which every new renderer has.
/// @tparam Feature  a technique: AutoOutlineRendererFeature, StrokeOutlineRendererFeature,
///                  WideOutlineRendererFeature ...
template <typename Feature>
class Outline : public RenderSetup
{
public:
    using Component = typename Feature::Component;
    using Settings = typename Feature::Settings;

    /// @param device    must outlive this
    /// @param settings  the settings of the feature for its whole life
    explicit Outline(GraphicsDevice& device, Settings settings = {})
        : RenderSetup(device), m_Component(profile().template Add<Component>())
    {
        m_Component.m_Enable.Override(true);
        auto feature = std::make_unique<Feature>(std::move(settings));
        m_Feature = feature.get();
        renderer().AddFeature(std::move(feature));
    }

    /// Returns the outline's volume component, which is already switched on:
    /// `component().m_OutlineWidth.Override(6.0f)`.
    Component& component() { return m_Component; }
    Feature& feature() { return *m_Feature; }
    const Settings& settings() const { return m_Feature->settings(); }

private:
    Component& m_Component;
    Feature* m_Feature;
};

} // namespace limn
