#include <limn/features/Features.h>
#include <limn/features/RenderObjects.h>

namespace limn::render_objects
{

void Register(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<RenderObjects>("RenderObjects");
}

} // namespace limn::render_objects
