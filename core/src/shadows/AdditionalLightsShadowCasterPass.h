#pragma once

#include "shadows/ShadowConstants.h"
#include "shadows/ShadowSquares.h"

#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// Draws the shadow map of spot and point lights and sets it for shaders, in frames in which
/// something that receives such shadows is seen and something throws them. It has a square for each
/// spot light and for each of a point light's six sides.
/// Unity: UnityEngine.Rendering.Universal.Internal.AdditionalLightsShadowCasterPass (URP 14).
class AdditionalLightsShadowCasterPass final : public ScriptableRenderPass
{
public:
    AdditionalLightsShadowCasterPass();

    /// Finds what throws shadows onto what is seen.
    /// @return whether the pass has anything to draw; else shaders need no shadows
    bool Setup(const RenderingData& renderingData);

    /// Removes the shadows from here on, as at the beginning of a frame.
    static void Forget(CommandBuffer& cmd);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    /// The part of a scene that a square of the map sees.
    struct Slice
    {
        std::size_t light = 0;  ///< index in LightData::additionalLights
        glm::dmat4 view{1.0};   ///< world to light space, right-handed, looking along -z
        double halfAngle = 0.0; ///< of the light, radians, from the middle to a side
        double slope = 0.0;     ///< of the square's view: metres across per metre away
        double texelSize = 0.0; ///< metres, at the light's range
        ViewportRect tile;
        ShadowCasters casters;
    };

    void FindSlices(const RenderingData& renderingData);
    void PlaceSlices(const RenderingData& renderingData);
    void DrawSlice(ScriptableRenderContext& context, RenderingData& renderingData,
                   const Slice& slice) const;
    void SetReceiverConstants(CommandBuffer& cmd, const RenderingData& renderingData) const;

    RTHandle m_ShadowMap;
    std::vector<Slice> m_Slices;
    /// The requests of lights, which are kept for their memory, as the next one is.
    std::vector<ShadowSquares> m_Requests;
    std::vector<ViewportRect> m_Tiles;
};

} // namespace limn
