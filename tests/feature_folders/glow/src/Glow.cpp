#include <limn/features/FeatureRegistry.h>
#include <limn/features/Glow.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn
{

void RegisterGlow(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<GlowFeature>("GlowFeature", {{.name = "Glow", .component = "Glow"}});
    components.Register<Glow>("Glow");
}

} // namespace limn
