#include <limn/features/FeatureRegistry.h>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::full_screen_pass
{

void Register(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<FullScreenPassRendererFeature>("FullScreenPassRendererFeature");
}

} // namespace limn::full_screen_pass
