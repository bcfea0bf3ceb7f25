#pragma once

#include <limn/core/LayerMask.h>
#include <limn/core/RenderQueueRange.h>

namespace limn
{

/// Which renderers a DrawRenderers call takes; all conditions must hold. A default-made one takes
/// everything: Unity's FilteringSettings.defaultValue, not its zero-filled `new
/// FilteringSettings()`. Unity: UnityEngine.Rendering.FilteringSettings (2022.3).
struct FilteringSettings
{
    RenderQueueRange renderQueueRange = RenderQueueRange::all; ///< of the material
    LayerMask layerMask = LayerMask::Everything();             ///< of the game object
    RenderingLayerMask renderingLayerMask = RenderingLayerMask::Everything(); ///< of the renderer

    constexpr FilteringSettings() = default;
    constexpr explicit FilteringSettings(
        RenderQueueRange queues, LayerMask layers = LayerMask::Everything(),
        RenderingLayerMask renderingLayers = RenderingLayerMask::Everything())
        : renderQueueRange(queues), layerMask(layers), renderingLayerMask(renderingLayers)
    {
    }

    constexpr bool operator==(const FilteringSettings&) const = default;
};

} // namespace limn
