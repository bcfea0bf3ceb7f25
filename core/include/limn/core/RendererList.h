#pragma once

#include <limn/core/Culling.h>
#include <limn/core/DrawingSettings.h>
#include <limn/core/FilteringSettings.h>
#include <limn/core/PooledAllocator.h>
#include <limn/core/RenderStateBlock.h>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace limn
{

struct Camera;

/// Describes a list of renderers and how they are drawn.
/// Unity: UnityEngine.Rendering.RendererListParams (2022.3), with one state block for all.
struct RendererListParams
{
    /// @param results  must outlive the camera's frame, as those of the frame data do
    RendererListParams(const CullingResults& results, DrawingSettings drawing,
                       FilteringSettings filtering)
        : cullingResults(&results),
          drawSettings(std::move(drawing)),
          filteringSettings(std::move(filtering))
    {
    }

    const CullingResults* cullingResults; ///< never null
    DrawingSettings drawSettings;
    FilteringSettings filteringSettings;
    RenderStateBlock stateBlock{RenderStateMask::Nothing};
};

/// A shorter description of the same. It takes everything that has a pass of the tags, unless a
/// member limits it (Unity: nothing but render queue 0, until renderQueueRange is set).
/// Unity: UnityEngine.Rendering.RendererUtils.RendererListDesc (2022.3).
struct RendererListDesc
{
    /// @param results  as those of RendererListParams
    /// @param camera   sorts by distances from it; must outlive the call that takes this
    RendererListDesc(ShaderTagId passName, const CullingResults& results, const Camera& camera);
    /// @throws ContractError for no pass name, and for more than 16
    RendererListDesc(std::span<const ShaderTagId> passNames, const CullingResults& results,
                     const Camera& camera);

    SortingCriteria sortingCriteria = SortingCriteria::None;
    RenderQueueRange renderQueueRange = RenderQueueRange::all;
    std::optional<RenderStateBlock> stateBlock;
    std::shared_ptr<const Material> overrideMaterial;
    int overrideMaterialPassIndex = 0;
    std::shared_ptr<const Shader> overrideShader;
    int overrideShaderPassIndex = 0;
    LayerMask layerMask = LayerMask::Everything();
    RenderingLayerMask renderingLayerMask = RenderingLayerMask::Everything();

    RendererListParams ToParams() const;
    bool IsValid() const { return true; } ///< the constructors take nothing else

private:
    const CullingResults* m_Results; ///< never null
    const Camera* m_Camera;          ///< never null
    FixedList<ShaderTagId, DrawingSettings::maxShaderPasses> m_PassNames;
};

/// A list of renderers for CommandBuffer::DrawRendererList, or none. It is cheap to copy.
/// Unity: UnityEngine.Rendering.RendererList (2022.3).
class RendererList
{
public:
    RendererList() = default;
    /// Makes a list, as ScriptableRenderContext::CreateRendererList does.
    explicit RendererList(RendererListParams params)
        : m_Params(std::allocate_shared<const RendererListParams>(
              PooledAllocator<RendererListParams>(), std::move(params)))
    {
    }

    bool isValid() const { return m_Params != nullptr; }
    const std::shared_ptr<const RendererListParams>& params() const { return m_Params; }

private:
    std::shared_ptr<const RendererListParams> m_Params;
};

} // namespace limn
