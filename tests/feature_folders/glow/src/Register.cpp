#include <limn/features/FeatureRegistry.h>
#include <limn/features/Glow.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::glow
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<GlowFeature>("GlowFeature", {{.name = "Glow", .component = "Glow"}});
    components.Register<Glow>("Glow");
}

} // namespace limn::glow
