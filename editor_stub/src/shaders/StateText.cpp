#include "shaders/StateText.h"

#include <limn/shaderlab/PrintShaderLab.h>

namespace limn
{

namespace
{

std::string BlendText(const PassBlendState& target)
{
    if (!target.enabled)
    {
        return "Blend Off";
    }
    std::string text = "Blend " + StateText(target.sourceColorBlendMode) + " " +
                       StateText(target.destinationColorBlendMode);
    if (target.sourceAlphaBlendMode != target.sourceColorBlendMode ||
        target.destinationAlphaBlendMode != target.destinationColorBlendMode)
    {
        text += ", " + StateText(target.sourceAlphaBlendMode) + " " +
                StateText(target.destinationAlphaBlendMode);
    }
    if (target.colorBlendOperation != BlendOp::Add || target.alphaBlendOperation != BlendOp::Add)
    {
        text += ", BlendOp " + StateText(target.colorBlendOperation) + ", " +
                StateText(target.alphaBlendOperation);
    }
    return text;
}

std::string MaskText(const PassBlendState& target)
{
    if (target.writeMask == StateValue<int>(ColorWriteMask::All))
    {
        return {};
    }
    return ", ColorMask " + ColorMaskText(target.writeMask);
}

std::string FaceText(const StencilFaceState& face)
{
    return "Comp " + StateText(face.compare) + " Pass " + StateText(face.pass) + " Fail " +
           StateText(face.fail) + " ZFail " + StateText(face.zFail);
}

std::string StencilText(const PassStencilState& stencil)
{
    if (!stencil.enabled)
    {
        return {};
    }
    const std::string faces = stencil.front == stencil.back ? FaceText(stencil.front)
                                                            : "Front " + FaceText(stencil.front) +
                                                                  " Back " + FaceText(stencil.back);
    return ", Stencil {Ref " + StateText(stencil.reference) + " ReadMask " +
           StateText(stencil.readMask) + " WriteMask " + StateText(stencil.writeMask) + " " +
           faces + "}";
}

} // namespace

std::string StateText(const RenderState& state)
{
    std::string text = "Cull " + StateText(state.cull) + ", ZTest " + StateText(state.zTest) +
                       ", ZWrite " + StateText(state.zWrite);
    const std::size_t targets = state.separateBlend ? state.targets.size() : 1;
    for (std::size_t i = 0; i < targets; ++i)
    {
        const std::string index = targets > 1 ? "target " + std::to_string(i) + ": " : "";
        text += ", " + index + BlendText(state.targets[i]) + MaskText(state.targets[i]);
    }
    if (state.zClip != StateValue<bool>(true))
    {
        text += ", ZClip " + StateText(state.zClip);
    }
    if (state.offsetFactor != StateValue<float>(0.0f) ||
        state.offsetUnits != StateValue<float>(0.0f))
    {
        text += ", Offset " + StateText(state.offsetFactor) + ", " + StateText(state.offsetUnits);
    }
    if (state.alphaToMask != StateValue<bool>(false))
    {
        text += ", AlphaToMask " + StateText(state.alphaToMask);
    }
    if (state.conservative != StateValue<bool>(false))
    {
        text += ", Conservative " + StateText(state.conservative);
    }
    return text + StencilText(state.stencil);
}

} // namespace limn
