#pragma once

#include "graph/RenderGraphPass.h"

#include <limn/core/ScriptableRenderContext.h>
#include <limn/core/UniversalFrameData.h>

namespace limn
{

class ScriptableRenderPass;

/// The render graph of a renderer's cameras, one after the other.
class RenderGraphCamera
{
public:
    struct Targets
    {
        RTHandle color;
        RTHandle depth;
        std::shared_ptr<const Material> copy; ///< see CameraTargets
    };

    /// Makes the pass record, and runs what it recorded.
    /// @return the camera's colour from then on
    RTHandle Record(ScriptableRenderPass& pass, ScriptableRenderContext& context,
                    const RenderingData& renderingData, const Targets& targets);
    /// Ends the camera, whose handles and frame data are gone then.
    void End();

private:
    void FillFrameData(const ScriptableRenderContext& context, const RenderingData& renderingData,
                       const Targets& targets);
    /// @param handle  the name that a feature uses for it
    TextureHandle Import(const RTHandle& texture, std::string_view handle);
    /// Sets what GetTextureDesc returns for a texture of the camera that the pipeline itself has
    /// cleared: a texture that a feature makes like it begins cleared, as in Unity.
    /// @param color  linear
    void SayCleared(const RTHandle& texture, bool isCleared, const Color& color);

    RenderGraph m_Graph;
    ContextContainer m_FrameData;
    bool m_HasRecorded = false; ///< for this camera
};

} // namespace limn
