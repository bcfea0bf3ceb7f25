#include "FinalPostProcessPass.h"

#include <limn/core/CoreUtils.h>

namespace limn
{

FinalPostProcessPass::FinalPostProcessPass(const std::string& featureName,
                                           std::shared_ptr<const Shader> finalPost)
    : m_Material(CoreUtils::CreateEngineMaterial(std::move(finalPost)))
{
    profilingSampler = ProfilingSampler(featureName + " FXAA");
    renderPassEvent = RenderPassEvent::AfterRenderingPostProcessing;
}

void FinalPostProcessPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    Blit(*cmd, renderingData, m_Material);
    context.ExecuteCommandBuffer(*cmd);
}

} // namespace limn
