#include "document/PrintState.h"

#include "document/StateNames.h"

#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/PrintShaderLab.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace limn
{

namespace
{

using Lines = std::vector<std::string>;

template <typename T>
std::string NameOf(std::span<const EnumName<T>> names, const StateValue<T>& value)
{
    if (!value.property.empty())
    {
        return "[" + value.property + "]";
    }
    const auto found =
        std::find_if(names.begin(), names.end(),
                     [&](const EnumName<T>& name) { return name.value == value.value; });
    if (found == names.end())
    {
        throw ContractError("PrintShaderLab: a state has a value that ShaderLab has no name for");
    }
    return std::string(found->name);
}

template <typename T>
void Add(Lines& lines, const char* command, const StateValue<T>& value, const StateValue<T>& base)
{
    if (value != base)
    {
        lines.push_back(std::string(command) + " " + StateText(value));
    }
}

std::string WriteMaskText(const PassBlendState& target)
{
    return ColorMaskText(target.writeMask);
}

/// The text of one command for each of the eight targets.
using TargetTexts = std::array<std::string, 8>;

TargetTexts TextsOf(const RenderState& state, std::string (*text)(const PassBlendState&))
{
    TargetTexts texts;
    std::transform(state.targets.begin(), state.targets.end(), texts.begin(), text);
    return texts;
}

bool areEqual(const TargetTexts& texts)
{
    return std::all_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text == texts[0]; });
}

/// The text that most targets have; of several, the one that comes first.
const std::string& MostFrequent(const TargetTexts& texts)
{
    return *std::max_element(texts.begin(), texts.end(),
                             [&](const std::string& a, const std::string& b) {
                                 return std::count(texts.begin(), texts.end(), a) <
                                        std::count(texts.begin(), texts.end(), b);
                             });
}

/// One line for all targets where that helps, then one for each target that differs from it.
template <typename Line>
void AddTargets(Lines& lines, const TargetTexts& texts, TargetTexts base, const Line& line)
{
    if (areEqual(base) && MostFrequent(texts) != base[0])
    {
        base.fill(MostFrequent(texts));
        lines.push_back(line(base[0], ""));
    }
    for (std::size_t i = 0; i < texts.size(); ++i)
    {
        if (texts[i] != base[i])
        {
            lines.push_back(line(texts[i], std::to_string(i)));
        }
    }
}

void AddBlend(Lines& lines, const RenderState& state, const RenderState& base)
{
    const auto lineOf = [](const char* command)
    {
        return [command](const std::string& text, const std::string& target)
        {
            return std::string(command) + " " + target + (target.empty() ? "" : " ") + text;
        };
    };
    AddTargets(lines, TextsOf(state, BlendText), TextsOf(base, BlendText), lineOf("Blend"));
    AddTargets(lines, TextsOf(state, BlendOpText), TextsOf(base, BlendOpText), lineOf("BlendOp"));
    // Only ColorMask names its target last.
    AddTargets(lines, TextsOf(state, WriteMaskText), TextsOf(base, WriteMaskText),
               [](const std::string& text, const std::string& target)
               { return "ColorMask " + text + (target.empty() ? "" : " ") + target; });
}

template <typename T>
void AddFaces(Lines& lines, const std::string& command, const StateValue<T>& front,
              const StateValue<T>& back, const StateValue<T>& base)
{
    if (front == back)
    {
        Add(lines, ("    " + command).c_str(), front, base);
        return;
    }
    Add(lines, ("    " + command + "Front").c_str(), front, base);
    Add(lines, ("    " + command + "Back").c_str(), back, base);
}

void AddStencil(Lines& lines, const PassStencilState& stencil)
{
    const PassStencilState none;
    const StencilFaceState& front = stencil.front;
    const StencilFaceState& back = stencil.back;
    lines.push_back("Stencil");
    lines.push_back("{");
    Add(lines, "    Ref", stencil.reference, none.reference);
    Add(lines, "    ReadMask", stencil.readMask, none.readMask);
    Add(lines, "    WriteMask", stencil.writeMask, none.writeMask);
    AddFaces(lines, "Comp", front.compare, back.compare, none.front.compare);
    AddFaces(lines, "Pass", front.pass, back.pass, none.front.pass);
    AddFaces(lines, "Fail", front.fail, back.fail, none.front.fail);
    AddFaces(lines, "ZFail", front.zFail, back.zFail, none.front.zFail);
    lines.push_back("}");
}

} // namespace

/// ZTest is off by the name of Unity's enum, which no other list has.
std::string StateText(const StateValue<CullMode>& value)
{
    return NameOf<CullMode>(k_CullModes, value);
}
std::string StateText(const StateValue<CompareFunction>& value)
{
    return NameOf<CompareFunction>(k_DepthTests, value);
}
std::string StateText(const StateValue<bool>& value)
{
    return NameOf<bool>(k_Bools, value);
}
std::string StateText(const StateValue<BlendMode>& value)
{
    return NameOf<BlendMode>(k_BlendModes, value);
}
std::string StateText(const StateValue<BlendOp>& value)
{
    return NameOf<BlendOp>(k_BlendOps, value);
}
std::string StateText(const StateValue<StencilOp>& value)
{
    return NameOf<StencilOp>(k_StencilOps, value);
}
std::string StateText(const StateValue<int>& value)
{
    return value.property.empty() ? std::to_string(value.value) : "[" + value.property + "]";
}

std::string ColorMaskText(const StateValue<int>& mask)
{
    if (!mask.property.empty())
    {
        return "[" + mask.property + "]";
    }
    std::string letters;
    letters += (mask.value & ColorWriteMask::Red) != 0 ? "R" : "";
    letters += (mask.value & ColorWriteMask::Green) != 0 ? "G" : "";
    letters += (mask.value & ColorWriteMask::Blue) != 0 ? "B" : "";
    letters += (mask.value & ColorWriteMask::Alpha) != 0 ? "A" : "";
    return letters.empty() ? "0" : letters;
}

std::string StateText(const StateValue<float>& value)
{
    return value.property.empty() ? NumberToShaderLab(value.value) : "[" + value.property + "]";
}

std::string BlendText(const PassBlendState& target)
{
    if (!target.enabled)
    {
        return "Off";
    }
    std::string text =
        StateText(target.sourceColorBlendMode) + " " + StateText(target.destinationColorBlendMode);
    if (target.sourceAlphaBlendMode != target.sourceColorBlendMode ||
        target.destinationAlphaBlendMode != target.destinationColorBlendMode)
    {
        text += ", " + StateText(target.sourceAlphaBlendMode) + " " +
                StateText(target.destinationAlphaBlendMode);
    }
    return text;
}

std::string BlendOpText(const PassBlendState& target)
{
    const std::string color = StateText(target.colorBlendOperation);
    return target.alphaBlendOperation == target.colorBlendOperation
               ? color
               : color + ", " + StateText(target.alphaBlendOperation);
}

std::string NumberToShaderLab(float number)
{
    std::array<char, 128> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                      std::chars_format::fixed);
    return {buffer.data(), result.ptr};
}

std::vector<std::string> StateCommands(const RenderState& state, const RenderState& base)
{
    Lines lines;
    Add(lines, "Cull", state.cull, base.cull);
    Add(lines, "ZClip", state.zClip, base.zClip);
    Add(lines, "ZTest", state.zTest, base.zTest);
    Add(lines, "ZWrite", state.zWrite, base.zWrite);
    if (state.offsetFactor != base.offsetFactor || state.offsetUnits != base.offsetUnits)
    {
        lines.push_back("Offset " + StateText(state.offsetFactor) + ", " +
                        StateText(state.offsetUnits));
    }
    Add(lines, "Conservative", state.conservative, base.conservative);
    AddBlend(lines, state, base);
    Add(lines, "AlphaToMask", state.alphaToMask, base.alphaToMask);
    if (state.stencil != base.stencil)
    {
        AddStencil(lines, state.stencil);
    }
    return lines;
}

std::string BlendOpName(BlendOp op)
{
    return NameOf<BlendOp>(k_BlendOps, op);
}

} // namespace limn
