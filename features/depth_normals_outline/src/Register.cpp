#include <limn/features/DepthNormalsOutlineRendererFeature.h>
#include <limn/features/Features.h>

namespace limn::depth_normals_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<DepthNormalsOutlineRendererFeature>(
        "DepthNormalsOutlineRendererFeature",
        {{.name = "Depth and normals (article)",
          .summary = "the article on depth and normals, its formula",
          .isArticle = true,
          .noWidth = "its lines lie on both sides of an edge",
          .place = 90,
          .component = "DepthNormalsOutline",
          .settings = {"DepthNormalsOutline.m_Technique=Article"}},
         {.name = "Depth and normals",
          .summary = "depth and normals by metres and degrees",
          .noWidth = "its lines lie on both sides of an edge",
          .place = 100,
          .component = "DepthNormalsOutline"}});
    components.Register<DepthNormalsOutline>("DepthNormalsOutline");
}

} // namespace limn::depth_normals_outline
