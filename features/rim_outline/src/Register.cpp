#include <limn/features/FeatureRegistry.h>
#include <limn/features/RimOutline.h>
#include <limn/features/RimOutlineRendererFeature.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::rim_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<RimOutlineRendererFeature>("RimOutlineRendererFeature");
    components.Register<RimOutline>("RimOutline");
}

} // namespace limn::rim_outline
