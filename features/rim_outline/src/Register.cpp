#include <limn/features/Features.h>
#include <limn/features/RimOutlineRendererFeature.h>

namespace limn::rim_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<RimOutlineRendererFeature>(
        "RimOutlineRendererFeature",
        {{.name = "Rim",
          .summary = "where normal and view are at right angles",
          .noWidth = "its rim lies within the object and is as wide as the object is curved",
          .place = 120,
          .component = "RimOutline"}});
    components.Register<RimOutline>("RimOutline");
}

} // namespace limn::rim_outline
