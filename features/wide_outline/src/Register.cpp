#include <limn/features/Features.h>
#include <limn/features/WideOutlineRendererFeature.h>

namespace limn::wide_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<WideOutlineRendererFeature>(
        "WideOutlineRendererFeature",
        {{.name = "Separable",
          .summary = "distance to the edge, by columns and then by rows",
          .place = 20,
          .component = "WideOutline",
          .settings = {"Outline.m_Method=Separable"}},
         {.name = "Jump flood",
          .summary = "distance to the edge, by jump flooding",
          .place = 30,
          .component = "WideOutline",
          .settings = {"Outline.m_Method=JumpFlood"}}});
    components.Register<WideOutline>("WideOutline");
}

} // namespace limn::wide_outline
