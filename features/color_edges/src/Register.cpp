#include <limn/features/ColorEdges.h>
#include <limn/features/ColorEdgesRendererFeature.h>
#include <limn/features/FeatureRegistry.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::color_edges
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<ColorEdgesRendererFeature>("ColorEdgesRendererFeature");
    components.Register<ColorEdges>("ColorEdges");
}

} // namespace limn::color_edges
