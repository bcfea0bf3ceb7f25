#include <limn/features/Features.h>
#include <limn/features/MaskDifferenceOutlineRendererFeature.h>

namespace limn::mask_difference_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<MaskDifferenceOutlineRendererFeature>(
        "MaskDifferenceOutlineRendererFeature",
        {{.name = "Mask difference",
          .summary = "the article on post-processing: five samples of a mask",
          .isArticle = true,
          .place = 80,
          .component = "MaskDifferenceOutline",
          .settings = {"Outline.m_Grouping=Together"}}});
    components.Register<MaskDifferenceOutline>("MaskDifferenceOutline");
}

} // namespace limn::mask_difference_outline
