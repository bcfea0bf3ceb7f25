#include "shaders/StateText.h"

#include <limn/shaderlab/PrintShaderLab.h>
#include <span>
#include <string_view>

namespace limn
{

namespace
{

constexpr std::string_view k_Cull[] = {"Off", "Front", "Back"};
constexpr std::string_view k_Compare[] = {"Disabled", "Never",    "Less",   "Equal", "LEqual",
                                          "Greater",  "NotEqual", "GEqual", "Always"};
constexpr std::string_view k_Factors[] = {"Zero",
                                          "One",
                                          "DstColor",
                                          "SrcColor",
                                          "OneMinusDstColor",
                                          "SrcAlpha",
                                          "OneMinusSrcColor",
                                          "DstAlpha",
                                          "OneMinusDstAlpha",
                                          "SrcAlphaSaturate",
                                          "OneMinusSrcAlpha"};
constexpr std::string_view k_StencilOps[] = {"Keep",    "Zero",   "Replace",  "IncrSat",
                                             "DecrSat", "Invert", "IncrWrap", "DecrWrap"};

template <typename Enum>
std::string Name(const StateValue<Enum>& value, std::span<const std::string_view> names)
{
    return value.property.empty() ? std::string(names[static_cast<std::size_t>(value.value)])
                                  : "[" + value.property + "]";
}

std::string Name(const StateValue<BlendOp>& op)
{
    return op.property.empty() ? BlendOpName(op.value) : "[" + op.property + "]";
}

std::string Switch(const StateValue<bool>& value)
{
    const char* text = value.value ? "On" : "Off";
    return value.property.empty() ? text : "[" + value.property + "]";
}

template <typename Number>
std::string NumberOf(const StateValue<Number>& value)
{
    std::string text = std::to_string(value.value);
    if (text.find('.') != std::string::npos)
    {
        text.erase(text.find_last_not_of('0') + 1);
        text.erase(text.find_last_not_of('.') + 1);
    }
    return value.property.empty() ? text : "[" + value.property + "]";
}

std::string BlendText(const PassBlendState& target)
{
    if (!target.enabled)
    {
        return "Blend Off";
    }
    std::string text =
        "Blend " + Name(target.srcColor, k_Factors) + " " + Name(target.dstColor, k_Factors);
    if (target.srcAlpha != target.srcColor || target.dstAlpha != target.dstColor)
    {
        text += ", " + Name(target.srcAlpha, k_Factors) + " " + Name(target.dstAlpha, k_Factors);
    }
    if (target.colorOp != BlendOp::Add || target.alphaOp != BlendOp::Add)
    {
        text += ", BlendOp " + Name(target.colorOp) + ", " + Name(target.alphaOp);
    }
    return text;
}

std::string MaskText(const PassBlendState& target)
{
    if (target.writeMask == StateValue<int>(ColorWriteMask::All))
    {
        return {};
    }
    std::string letters;
    for (int i = 0; i < 4; ++i)
    {
        letters += ((target.writeMask.value << i) & ColorWriteMask::Red) != 0
                       ? std::string(1, "RGBA"[i])
                       : std::string();
    }
    const bool isProperty = !target.writeMask.property.empty();
    return ", ColorMask " + (isProperty        ? "[" + target.writeMask.property + "]"
                             : letters.empty() ? "0"
                                               : letters);
}

std::string FaceText(const StencilFaceState& face)
{
    return "Comp " + Name(face.compare, k_Compare) + " Pass " + Name(face.pass, k_StencilOps) +
           " Fail " + Name(face.fail, k_StencilOps) + " ZFail " + Name(face.zFail, k_StencilOps);
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
    return ", Stencil {Ref " + NumberOf(stencil.reference) + " ReadMask " +
           NumberOf(stencil.readMask) + " WriteMask " + NumberOf(stencil.writeMask) + " " + faces +
           "}";
}

} // namespace

std::string StateText(const RenderState& state)
{
    std::string text = "Cull " + Name(state.cull, k_Cull) + ", ZTest " +
                       Name(state.zTest, k_Compare) + ", ZWrite " + Switch(state.zWrite);
    const std::size_t targets = state.separateBlend ? state.targets.size() : 1;
    for (std::size_t i = 0; i < targets; ++i)
    {
        const std::string index = targets > 1 ? "target " + std::to_string(i) + ": " : "";
        text += ", " + index + BlendText(state.targets[i]) + MaskText(state.targets[i]);
    }
    if (state.zClip != StateValue<bool>(true))
    {
        text += ", ZClip " + Switch(state.zClip);
    }
    if (state.offsetFactor != StateValue<float>(0.0f) ||
        state.offsetUnits != StateValue<float>(0.0f))
    {
        text += ", Offset " + NumberOf(state.offsetFactor) + ", " + NumberOf(state.offsetUnits);
    }
    if (state.alphaToMask != StateValue<bool>(false))
    {
        text += ", AlphaToMask " + Switch(state.alphaToMask);
    }
    if (state.conservative != StateValue<bool>(false))
    {
        text += ", Conservative " + Switch(state.conservative);
    }
    return text + StencilText(state.stencil);
}

} // namespace limn
