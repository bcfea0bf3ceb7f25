#include <limn/features/FeatureRegistry.h>
#include <limn/features/Glow.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::glow
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<GlowFeature>("GlowFeature");
    components.Register<Glow>("Glow");
}

} // namespace limn::glow
