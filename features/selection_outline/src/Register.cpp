#include <limn/features/FeatureRegistry.h>
#include <limn/features/SelectionOutlineRendererFeature.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::selection_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<SelectionOutlineRendererFeature>("SelectionOutlineRendererFeature");
    components.Register<SelectionOutline>("SelectionOutline");
}

} // namespace limn::selection_outline
