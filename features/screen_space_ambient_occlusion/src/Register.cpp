#include <limn/features/FeatureRegistry.h>
#include <limn/features/ScreenSpaceAmbientOcclusion.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::screen_space_ambient_occlusion
{

void Register(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<ScreenSpaceAmbientOcclusion>("ScreenSpaceAmbientOcclusion");
}

} // namespace limn::screen_space_ambient_occlusion
