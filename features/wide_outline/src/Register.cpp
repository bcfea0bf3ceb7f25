#include <limn/features/FeatureRegistry.h>
#include <limn/features/WideOutlineRendererFeature.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::wide_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<WideOutlineRendererFeature>("WideOutlineRendererFeature");
    components.Register<WideOutline>("WideOutline");
}

} // namespace limn::wide_outline
