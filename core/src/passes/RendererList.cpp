#include "passes/MakeDrawingSettings.h"

#include <limn/core/Camera.h>
#include <limn/core/RendererList.h>

namespace limn
{

RendererListDesc::RendererListDesc(ShaderTagId passName, const CullingResults& results,
                                   const Camera& camera)
    : RendererListDesc(std::span(&passName, 1), results, camera)
{
}

RendererListDesc::RendererListDesc(std::span<const ShaderTagId> passNames,
                                   const CullingResults& results, const Camera& camera)
    : m_Results(&results), m_Camera(&camera)
{
    if (passNames.empty() || passNames.size() > DrawingSettings::maxShaderPasses)
    {
        throw ContractError("RendererListDesc: it has " + std::to_string(passNames.size()) +
                            " pass names; it must have 1 to 16");
    }
    m_PassNames.assign(passNames.begin(), passNames.end());
}

RendererListParams RendererListDesc::ToParams() const
{
    DrawingSettings drawing = MakeDrawingSettings(std::span(m_PassNames.begin(), m_PassNames.end()),
                                                  *m_Camera, sortingCriteria);
    drawing.overrideMaterial = overrideMaterial;
    drawing.overrideMaterialPassIndex = overrideMaterialPassIndex;
    drawing.overrideShader = overrideShader;
    drawing.overrideShaderPassIndex = overrideShaderPassIndex;
    RendererListParams params(*m_Results, std::move(drawing),
                              FilteringSettings(renderQueueRange, layerMask, renderingLayerMask));
    if (stateBlock)
    {
        params.stateBlock = *stateBlock;
    }
    return params;
}

} // namespace limn
