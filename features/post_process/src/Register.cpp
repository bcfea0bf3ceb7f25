#include <limn/features/Bloom.h>
#include <limn/features/ColorAdjustments.h>
#include <limn/features/Features.h>
#include <limn/features/PostProcessRendererFeature.h>
#include <limn/features/Tonemapping.h>
#include <limn/features/Vignette.h>

namespace limn::post_process
{

void Register(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<PostProcessRendererFeature>("PostProcessRendererFeature");
    components.Register<Bloom>("Bloom");
    components.Register<ColorAdjustments>("ColorAdjustments");
    components.Register<Tonemapping>("Tonemapping");
    components.Register<Vignette>("Vignette");
}

} // namespace limn::post_process
