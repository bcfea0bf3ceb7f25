#include <limn/features/FeatureRegistry.h>
#include <limn/features/MaskDifferenceOutlineRendererFeature.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::mask_difference_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<MaskDifferenceOutlineRendererFeature>("MaskDifferenceOutlineRendererFeature");
    components.Register<MaskDifferenceOutline>("MaskDifferenceOutline");
}

} // namespace limn::mask_difference_outline
