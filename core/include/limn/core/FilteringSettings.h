#pragma once

#include <cstddef>
#include <limn/base/Diagnostic.h>
#include <limn/core/LayerMask.h>
#include <optional>
#include <string>

namespace limn
{

/// Unity: UnityEngine.Rendering.RenderQueue.
enum class RenderQueue
{
    Background = 1000,
    Geometry = 2000,
    AlphaTest = 2450,
    GeometryLast = 2500, ///< the last queue that counts as opaque
    Transparent = 3000,
    Overlay = 4000
};

/// A range of material render queues from a lower to an upper bound, both included.
/// Unity: UnityEngine.Rendering.RenderQueueRange (2022.3).
class RenderQueueRange
{
public:
    static constexpr int minimumBound = 0;
    static constexpr int maximumBound = 5000;

    static const RenderQueueRange all;         ///< 0...5000
    static const RenderQueueRange opaque;      ///< 0...2500
    static const RenderQueueRange transparent; ///< 2501...5000

    /// @throws ContractError if a bound is outside 0...5000
    constexpr RenderQueueRange(int lowerBound, int upperBound)
        : m_LowerBound(Checked(lowerBound)), m_UpperBound(Checked(upperBound))
    {
    }

    constexpr int lowerBound() const { return m_LowerBound; }
    constexpr int upperBound() const { return m_UpperBound; }
    constexpr bool Contains(int queue) const
    {
        return queue >= m_LowerBound && queue <= m_UpperBound;
    }

    constexpr bool operator==(const RenderQueueRange&) const = default;

private:
    static constexpr int Checked(int bound)
    {
        if (bound < minimumBound || bound > maximumBound)
        {
            throw ContractError("render queue bound " + std::to_string(bound) +
                                " is outside 0...5000");
        }
        return bound;
    }

    int m_LowerBound;
    int m_UpperBound;
};

inline constexpr RenderQueueRange RenderQueueRange::all{0, 5000};
inline constexpr RenderQueueRange RenderQueueRange::opaque{0, 2500};
inline constexpr RenderQueueRange RenderQueueRange::transparent{2501, 5000};

/// Selects the renderers that a DrawRenderers call takes; all conditions must hold. A
/// default-constructed one takes everything: it is Unity's FilteringSettings.defaultValue, not its
/// zero-filled `new FilteringSettings()`. Unity: UnityEngine.Rendering.FilteringSettings (2022.3).
struct FilteringSettings
{
    RenderQueueRange renderQueueRange = RenderQueueRange::all; ///< of the material
    LayerMask layerMask = LayerMask::Everything();             ///< of the game object
    RenderingLayerMask renderingLayerMask = RenderingLayerMask::Everything(); ///< of the renderer

    constexpr FilteringSettings() = default;
    /// @param queues  std::nullopt = all queues, as null in Unity
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
