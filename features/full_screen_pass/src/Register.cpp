#include <limn/features/Features.h>
#include <limn/features/FullScreenPassRendererFeature.h>

namespace limn::full_screen_pass
{

void Register(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<FullScreenPassRendererFeature>("FullScreenPassRendererFeature");
}

} // namespace limn::full_screen_pass
