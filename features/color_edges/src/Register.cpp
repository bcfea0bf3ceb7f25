#include <limn/features/ColorEdgesRendererFeature.h>
#include <limn/features/Features.h>

namespace limn::color_edges
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<ColorEdgesRendererFeature>(
        "ColorEdgesRendererFeature", {{.name = "Color edges",
                                       .summary = "steps of the picture's brightness",
                                       .noWidth = "its lines lie on both sides of an edge",
                                       .place = 110,
                                       .component = "ColorEdges"}});
    components.Register<ColorEdges>("ColorEdges");
}

} // namespace limn::color_edges
