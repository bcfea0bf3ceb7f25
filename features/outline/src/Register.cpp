#include <limn/features/Features.h>

namespace limn::outline
{

/// Registers nothing: the code that techniques share has no feature of its own.
void Register(FeatureRegistry&, VolumeComponentRegistry&) {}

} // namespace limn::outline
