#include "shaders/ShaderDescription.h"

#include <limn/shaderlab/PrintShaderLab.h>

namespace limn
{

namespace
{

std::string TargetText(const PassBlendState& target)
{
    const PassBlendState plain;
    std::string text = "Blend " + BlendText(target);
    if (target.enabled && BlendOpText(target) != BlendOpText(plain))
    {
        text += ", BlendOp " + BlendOpText(target);
    }
    if (target.writeMask != plain.writeMask)
    {
        text += ", ColorMask " + ColorMaskText(target.writeMask);
    }
    return text;
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
        text += ", " + index + TargetText(state.targets[i]);
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
