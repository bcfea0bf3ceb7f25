#include <limn/features/Features.h>
#include <limn/features/SelectionOutlineRendererFeature.h>

namespace limn::selection_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<SelectionOutlineRendererFeature>(
        "SelectionOutlineRendererFeature",
        {{.name = "Selection",
          .summary = "the article on selection: blurred mask, composite",
          .isArticle = true,
          .place = 70,
          .component = "SelectionOutline",
          .settings = {"SelectionOutline.m_VaryingColor=false"}}});
    components.Register<SelectionOutline>("SelectionOutline");
}

} // namespace limn::selection_outline
