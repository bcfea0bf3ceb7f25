#include <limn/features/Features.h>
#include <limn/features/InflatedOutlineRendererFeature.h>

namespace limn::inflated_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<InflatedOutlineRendererFeature>(
        "InflatedOutlineRendererFeature", {{.name = "Inflated",
                                            .summary = "vertices moved outwards in pixels",
                                            .place = 50,
                                            .component = "InflatedOutline",
                                            .settings = {"Outline.m_Grouping=Together"},
                                            .hiddenAt = HiddenAt::Point}});
    components.Register<InflatedOutline>("InflatedOutline");
}

} // namespace limn::inflated_outline
