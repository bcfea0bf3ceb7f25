#pragma once

#include "CachedCompiler.h"
#include "Paths.h"
#include "PortedUnit.h"

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/features/Features.h>
#include <limn/features/Plugin.h>
#include <limn/volume/VolumeManager.h>
#include <memory>
#include <string>

#include "blurred_glass/BlurredGlassFeature.h"
#include "blurred_glass/BlurredGlassUnity6Feature.h"
#include "distance_outline/DistanceOutlineFeature.h"
#include "distance_outline/DistanceOutlineUnity6Feature.h"
#include "height_fog/HeightFogFeature.h"
#include "height_fog/HeightFogUnity6Feature.h"
#include "ink_lines/InkLinesFeature.h"
#include "ink_lines/InkLinesUnity6Feature.h"
#include "selection_glow/SelectionGlowFeature.h"
#include "selection_glow/SelectionGlowUrp14Feature.h"
#include "xray/XRayFeature.h"
#include "xray/XRayUnity6Feature.h"

namespace limn::test
{

/// A feature of samples/porting in the style of its time and in a newer one.
struct PortedSample
{
    const char* name;    ///< of its folder and scene
    const char* feature; ///< the type that its scene names, and its file in the style of its time
    const char* newer;   ///< its file in the newer style
    void (*registerOld)(FeatureRegistry&, const char* as);
    void (*registerNew)(FeatureRegistry&, const char* as);
};

/// The C++ that draws a sample: written by hand in one style or the other, or by `limn port`.
enum class PortedBy
{
    HandOld,
    HandNew,
    LimnOld,
    LimnNew
};

template <typename Feature>
void RegisterAs(FeatureRegistry& features, const char* as)
{
    features.Register<Feature>(as);
}

inline constexpr PortedSample k_PortedSamples[] = {
    {"blurred_glass", "BlurredGlassFeature", "BlurredGlassUnity6Feature",
     &RegisterAs<porting::BlurredGlassFeature>, &RegisterAs<porting::BlurredGlassUnity6Feature>},
    {"distance_outline", "DistanceOutlineFeature", "DistanceOutlineUnity6Feature",
     &RegisterAs<porting::DistanceOutlineFeature>,
     &RegisterAs<porting::DistanceOutlineUnity6Feature>},
    {"height_fog", "HeightFogFeature", "HeightFogUnity6Feature",
     &RegisterAs<porting::HeightFogFeature>, &RegisterAs<porting::HeightFogUnity6Feature>},
    {"ink_lines", "InkLinesFeature", "InkLinesUnity6Feature", &RegisterAs<porting::InkLinesFeature>,
     &RegisterAs<porting::InkLinesUnity6Feature>},
    {"selection_glow", "SelectionGlowFeature", "SelectionGlowUrp14Feature",
     &RegisterAs<porting::SelectionGlowFeature>, &RegisterAs<porting::SelectionGlowUrp14Feature>},
    {"xray", "XRayFeature", "XRayUnity6Feature", &RegisterAs<porting::XRayFeature>,
     &RegisterAs<porting::XRayUnity6Feature>},
};

inline std::ostream& operator<<(std::ostream& stream, const PortedSample& sample)
{
    return stream << sample.name;
}

/// A sample's scene, drawn by one of its features.
class PortedScene
{
public:
    PortedScene(const PortedSample& sample, GraphicsDevice& device, PortedBy by)
        : m_Pipeline(device)
    {
        FeatureRegistry others; // a scene names one type, whichever C++ that is
        VolumeComponentRegistry otherComponents;
        const bool isByLimn = by == PortedBy::LimnOld || by == PortedBy::LimnNew;
        AddPlugin(limn_plugin, others, isByLimn ? otherComponents : m_Assets.volumeComponents());
        if (isByLimn)
        {
            RegisterPorted(by == PortedBy::LimnNew ? sample.newer : sample.feature,
                           m_Assets.features(), m_Assets.volumeComponents(), sample.feature);
        }
        else
        {
            (by == PortedBy::HandNew ? sample.registerNew : sample.registerOld)(m_Assets.features(),
                                                                                sample.feature);
        }
        const std::string folder = std::string("samples/porting/") + sample.name + "/";
        m_Scene = LoadScene(SourcePath(folder + sample.name + ".scene.yaml"), m_Assets);
        m_Renderer = std::make_unique<UniversalRenderer>(m_Assets.compiler());
        m_Renderer->SetShaderSource(m_Assets.shaderSource());
        m_Pipeline.pipelineVersion = m_Scene.pipelineVersion;
        for (auto& feature : m_Scene.renderer.features)
        {
            m_Renderer->AddFeature(std::move(feature));
        }
        m_Volumes = std::make_unique<VolumeManager>(m_Assets.volumeComponents());
        m_Stack = std::make_unique<VolumeStack>(m_Volumes->CreateStack());
        for (const Volume& volume : m_Scene.volumes)
        {
            m_Volumes->Register(&volume);
        }
    }

    RenderResult Render()
    {
        m_Volumes->Update(*m_Stack, m_Scene.camera.transform.position(),
                          m_Scene.camera.volumeLayerMask);
        RenderRequest request;
        request.scene = &m_Scene.scene;
        request.camera = &m_Scene.camera;
        request.width = 96;
        request.height = 54;
        request.volumeStack = m_Stack.get();
        return m_Pipeline.RenderSingleCamera(*m_Renderer, request);
    }
    void SetActive(bool isActive) { m_Renderer->rendererFeatures().at(0)->SetActive(isActive); }
    SceneAsset& asset() { return m_Scene; }

private:
    AssetContext m_Assets{CachedCompiler()};
    SceneAsset m_Scene;
    UniversalRenderPipeline m_Pipeline;
    std::unique_ptr<UniversalRenderer> m_Renderer;
    std::unique_ptr<VolumeManager> m_Volumes;
    std::unique_ptr<VolumeStack> m_Stack;
};

} // namespace limn::test
