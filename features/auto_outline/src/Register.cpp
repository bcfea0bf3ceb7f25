#include <limn/features/AutoOutlineRendererFeature.h>
#include <limn/features/Features.h>

namespace limn::auto_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<AutoOutlineRendererFeature>(
        "AutoOutlineRendererFeature", {{.name = "Auto",
                                        .summary = "strokes or distances, whichever is cheaper",
                                        .place = 40,
                                        .component = "AutoOutline",
                                        .settings = {"Outline.m_Grouping=Together"}}});
    components.Register<AutoOutline>("AutoOutline");
}

} // namespace limn::auto_outline
