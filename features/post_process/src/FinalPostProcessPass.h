#pragma once

#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// Smooths the finished picture, behind the passes that features add after post-processing.
/// Unity: PostProcessPass, as the renderer's finalPostProcessPass (URP 14).
class FinalPostProcessPass final : public ScriptableRenderPass
{
public:
    FinalPostProcessPass(const std::string& featureName, std::shared_ptr<const Shader> finalPost);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    std::shared_ptr<Material> m_Material;
};

} // namespace limn
