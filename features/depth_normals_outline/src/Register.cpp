#include <limn/features/DepthNormalsOutline.h>
#include <limn/features/DepthNormalsOutlineRendererFeature.h>
#include <limn/features/FeatureRegistry.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::depth_normals_outline
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<DepthNormalsOutlineRendererFeature>("DepthNormalsOutlineRendererFeature");
    components.Register<DepthNormalsOutline>("DepthNormalsOutline");
}

} // namespace limn::depth_normals_outline
