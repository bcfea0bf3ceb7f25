#include <limn/features/Features.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>

namespace limn::screen_space_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<ScreenSpaceOutlineRenderFeature>(
        "ScreenSpaceOutlineRenderFeature",
        {{.name = "Screen space",
          .summary = "the first article: mask of half the size, Roberts cross",
          .isArticle = true,
          .place = 60,
          .component = "ScreenSpaceOutline",
          .settings = {"Outline.m_ScreenSpaceOutlineShader=Hidden/ScreenSpaceOutline",
                       "Outline.m_LayerMask=Everything"},
          .widestOutline = 10.0}});
    components.Register<ScreenSpaceOutline>("ScreenSpaceOutline");
}

} // namespace limn::screen_space_outline
