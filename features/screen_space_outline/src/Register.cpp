#include <limn/features/FeatureRegistry.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::screen_space_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<ScreenSpaceOutlineRenderFeature>("ScreenSpaceOutlineRenderFeature");
    components.Register<ScreenSpaceOutline>("ScreenSpaceOutline");
}

} // namespace limn::screen_space_outline
