#include <limn/features/FeatureRegistry.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::outline
{

/// What techniques share has no feature of its own.
void Register(FeatureRegistry&, VolumeComponentRegistry&) {}

} // namespace limn::outline
