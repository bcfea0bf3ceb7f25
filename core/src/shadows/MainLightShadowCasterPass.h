#pragma once

#include "shadows/ShadowCascades.h"
#include "shadows/ShadowConstants.h"

#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// Draws the main light's shadow map and sets it for shaders, in frames in which something that
/// receives shadows is seen and something throws them.
/// Unity: UnityEngine.Rendering.Universal.Internal.MainLightShadowCasterPass (URP 14).
class MainLightShadowCasterPass final : public ScriptableRenderPass
{
public:
    MainLightShadowCasterPass();

    /// Finds what throws shadows onto what is seen.
    /// @return whether the pass has anything to draw; else shaders need no shadows
    bool Setup(const RenderingData& renderingData);

    /// Removes the shadows from here on, as at the beginning of a frame.
    static void Forget(CommandBuffer& cmd);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    bool FindCascades(const RenderingData& renderingData);
    void DrawCascade(ScriptableRenderContext& context, RenderingData& renderingData,
                     std::size_t cascade) const;
    void SetReceiverConstants(CommandBuffer& cmd, const RenderingData& renderingData) const;

    RTHandle m_ShadowMap;
    ShadowCascades m_Cascades;
    std::array<ShadowCasters, k_MostCascades> m_Casters; ///< by cascade
};

} // namespace limn
