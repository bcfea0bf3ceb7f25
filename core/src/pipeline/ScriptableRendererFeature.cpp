#include <limn/core/ScriptableRendererFeature.h>

namespace limn
{

void ScriptableRendererFeature::SetupRenderPasses(ScriptableRenderer&, const RenderingData&) {}

void ScriptableRendererFeature::Describe(Inspector&) {}

} // namespace limn
