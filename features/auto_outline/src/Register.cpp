#include <limn/features/AutoOutlineRendererFeature.h>
#include <limn/features/FeatureRegistry.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::auto_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<AutoOutlineRendererFeature>("AutoOutlineRendererFeature");
    components.Register<AutoOutline>("AutoOutline");
}

} // namespace limn::auto_outline
