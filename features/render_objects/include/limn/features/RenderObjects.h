#pragma once

#include <glm/vec4.hpp>
#include <limn/core/LayerMask.h>
#include <limn/core/RenderPassEvent.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/Shader.h>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace limn
{

struct EnumEntry;
class Material;
class RenderObjectsPass;

/// Unity: UnityEngine.Experimental.Rendering.Universal.RenderQueueType (URP 14).
enum class RenderQueueType
{
    Opaque,
    Transparent
};
/// Returns its members, for settings of this type. The span lives as long as the program.
std::span<const EnumEntry> RenderQueueTypeEntries();

/// Unity: UnityEngine.Rendering.Universal.StencilStateData (URP 14). It applies to both faces, with
/// masks of 255.
struct StencilStateData
{
    bool overrideStencilState = false;
    int stencilReference = 0; ///< 0...255
    CompareFunction stencilCompareFunction = CompareFunction::Always;
    StencilOp passOperation = StencilOp::Keep;
    StencilOp failOperation = StencilOp::Keep;
    StencilOp zFailOperation = StencilOp::Keep;

    void Describe(Inspector& inspector);
};

/// The settings of RenderObjects, with the names Unity serialises.
/// Unity: RenderObjects.RenderObjectsSettings (URP 14).
struct RenderObjectsSettings
{
    struct FilterSettings
    {
        limn::RenderQueueType RenderQueueType = limn::RenderQueueType::Opaque;
        limn::LayerMask LayerMask; ///< Nothing until it is set, so a new feature draws nothing
        /// LightMode names; empty = SRPDefaultUnlit, UniversalForward, UniversalForwardOnly
        std::vector<std::string> PassNames;
    };

    enum class OverrideMaterialMode
    {
        None,
        Material,
        Shader
    };

    struct CustomCameraSettings
    {
        bool overrideCamera = false;
        bool restoreCamera = true;       ///< restores the camera's own matrices afterwards
        glm::vec4 offset{0.0f};          ///< view space, metres: +z brings objects nearer
        float cameraFieldOfView = 60.0f; ///< vertical, degrees
    };

    std::string passTag = "RenderObjectsFeature"; ///< for captures and timings
    RenderPassEvent Event = RenderPassEvent::AfterRenderingOpaques;
    FilterSettings filterSettings;

    OverrideMaterialMode overrideMode = OverrideMaterialMode::Material;
    std::shared_ptr<Material> overrideMaterial; ///< null = no override
    int overrideMaterialPassIndex = 0;
    std::shared_ptr<const Shader> overrideShader; ///< fed with each object's own properties
    int overrideShaderPassIndex = 0;

    bool overrideDepthState = false;
    CompareFunction depthCompareFunction = CompareFunction::LessEqual;
    bool enableWrite = true; ///< depth

    StencilStateData stencilSettings;
    CustomCameraSettings cameraSettings;

    void Describe(Inspector& inspector);
};

/// Draws a filtered part of the scene once more (or for the first time), with state, material,
/// shader or camera overridden: one DrawRenderers call into the camera's colour and depth.
/// Unity: UnityEngine.Experimental.Rendering.Universal.RenderObjects (URP 14).
class RenderObjects final : public ScriptableRendererFeature
{
public:
    explicit RenderObjects(RenderObjectsSettings renderObjectsSettings = {});
    ~RenderObjects() override;

    RenderObjectsSettings settings;

    /// Creates the pass. An event before BeforeRenderingPrePasses becomes BeforeRenderingPrePasses,
    /// as in Unity.
    /// @throws ContractError naming feature and setting, if the shader of an override has no pass
    ///     with its pass index
    void Create() override;
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override;
    void Describe(Inspector& inspector) override { settings.Describe(inspector); }

private:
    std::unique_ptr<RenderObjectsPass> m_RenderObjectsPass;
};

} // namespace limn
