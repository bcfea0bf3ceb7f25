#include <limn/features/FeatureRegistry.h>
#include <limn/features/RenderObjects.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::render_objects
{

void Register(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<RenderObjects>("RenderObjects");
}

} // namespace limn::render_objects
