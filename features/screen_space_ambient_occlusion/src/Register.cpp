#include <limn/features/Features.h>
#include <limn/features/ScreenSpaceAmbientOcclusion.h>

namespace limn::screen_space_ambient_occlusion
{

void Register(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<ScreenSpaceAmbientOcclusion>("ScreenSpaceAmbientOcclusion");
}

} // namespace limn::screen_space_ambient_occlusion
