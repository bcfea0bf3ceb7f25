#include <limn/features/FeatureRegistry.h>
#include <limn/features/StrokeOutlineRendererFeature.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::stroke_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<StrokeOutlineRendererFeature>("StrokeOutlineRendererFeature");
    components.Register<StrokeOutline>("StrokeOutline");
}

} // namespace limn::stroke_outline
