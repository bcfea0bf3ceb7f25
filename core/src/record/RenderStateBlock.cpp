#include <limn/base/Diagnostic.h>
#include <limn/core/RenderStateBlock.h>
#include <string>

namespace limn
{

namespace
{

void ExpectWithin(const char* what, int value, int highest)
{
    if (value < 0 || value > highest)
    {
        throw ContractError(std::string("RenderStateBlock: ") + what + " is " +
                            std::to_string(value) + "; it must be within 0..." +
                            std::to_string(highest));
    }
}

void OverrideBlend(PipelineState& state, const BlendState& blend)
{
    state.alphaToMask = blend.alphaToMask;
    for (std::size_t i = 0; i < state.targets.size(); ++i)
    {
        const auto& target = blend.blendStates[blend.separateMRTBlendStates ? i : 0];
        ExpectWithin("a blend state's writeMask", target.writeMask, ColorWriteMask::All);
        state.targets[i] = target;
    }
}

void OverrideStencil(PipelineState& state, const StencilState& stencil, int reference)
{
    ExpectWithin("stencilReference", reference, 255);
    ExpectWithin("stencilState.readMask", stencil.readMask, 255);
    ExpectWithin("stencilState.writeMask", stencil.writeMask, 255);
    state.stencilEnabled = stencil.enabled;
    state.stencilReference = reference;
    state.stencilReadMask = stencil.readMask;
    state.stencilWriteMask = stencil.writeMask;
    state.stencilFront = stencil.front;
    state.stencilBack = stencil.back;
}

} // namespace

PipelineState Override(const PipelineState& state, const RenderStateBlock& block)
{
    PipelineState result = state;
    if (block.mask & RenderStateMask::Blend)
    {
        OverrideBlend(result, block.blendState);
    }
    if (block.mask & RenderStateMask::Raster)
    {
        result.cull = block.rasterState.cullingMode;
        result.offsetUnits = block.rasterState.offsetUnits;
        result.offsetFactor = block.rasterState.offsetFactor;
        result.zClip = block.rasterState.depthClip;
        result.conservative = block.rasterState.conservative;
    }
    if (block.mask & RenderStateMask::Depth)
    {
        result.zWrite = block.depthState.writeEnabled;
        result.zTest = block.depthState.compareFunction;
    }
    if (block.mask & RenderStateMask::Stencil)
    {
        OverrideStencil(result, block.stencilState, block.stencilReference);
    }
    return result;
}

} // namespace limn
