#pragma once

#include <cstddef>
#include <limn/core/LayerMask.h>
#include <limn/core/RenderQueueRange.h>
#include <optional>

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
    /// @param queues  std::nullopt for all, as null in Unity
    constexpr explicit FilteringSettings(
        std::optional<RenderQueueRange> queues, LayerMask layers = LayerMask::Everything(),
        RenderingLayerMask renderingLayers = RenderingLayerMask::Everything())
        : renderQueueRange(queues.value_or(RenderQueueRange::all)),
          layerMask(layers),
          renderingLayerMask(renderingLayers)
    {
    }
    constexpr explicit FilteringSettings(
        std::nullptr_t, LayerMask layers = LayerMask::Everything(),
        RenderingLayerMask renderingLayers = RenderingLayerMask::Everything())
        : FilteringSettings(std::nullopt, layers, renderingLayers)
    {
    }

    constexpr bool operator==(const FilteringSettings&) const = default;
};

} // namespace limn
