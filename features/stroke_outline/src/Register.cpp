#include <limn/features/Features.h>
#include <limn/features/StrokeOutlineRendererFeature.h>

namespace limn::stroke_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<StrokeOutlineRendererFeature>(
        "StrokeOutlineRendererFeature", {{.name = "Strokes",
                                          .summary = "silhouette edges drawn as geometry",
                                          .place = 10,
                                          .component = "StrokeOutline",
                                          .settings = {"Outline.m_Grouping=Together"},
                                          .occlusion = "Outline.m_Occlusion"}});
    components.Register<StrokeOutline>("StrokeOutline");
}

} // namespace limn::stroke_outline
