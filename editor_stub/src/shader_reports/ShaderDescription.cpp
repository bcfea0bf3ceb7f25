#include "shader_reports/ShaderDescription.h"

#include "console/Texts.h"

#include <algorithm>
#include <cmath>
#include <limn/base/TerminalText.h>
#include <limn/shaderlab/PrintShaderLab.h>

namespace limn
{

namespace
{

/// A line of its own, whatever the names in it.
std::string Line(std::string_view text)
{
    return OneLine(text) + "\n";
}

std::string TagsText(const ShaderTags& tags)
{
    return Joined(tags.items, ", ", [](const ShaderTag& tag) { return tag.key + "=" + tag.value; });
}

std::string MemberText(const UniformMember& member)
{
    return TypeText(member.type, member.components, member.arraySize) + " " + member.name + " @" +
           std::to_string(member.offset);
}

std::string Place(std::uint32_t binding, ShaderStage stages)
{
    return ", binding " + std::to_string(binding) + ", " + StagesText(stages);
}

std::string LayoutText(const PropertyLayout& layout, const std::string& indent)
{
    std::string text;
    for (const UniformBuffer& buffer : layout.buffers)
    {
        text += Line(indent + "buffer " + buffer.name + Place(buffer.binding, buffer.stages) +
                     ", " + std::to_string(buffer.size) +
                     " bytes: " + Joined(buffer.members, ", ", MemberText));
    }
    for (const StorageBufferBinding& buffer : layout.storageBuffers)
    {
        const bool isOfBytes = buffer.stride == 0;
        text += Line(indent + (isOfBytes ? "byte address buffer " : "structured buffer ") +
                     buffer.name + Place(buffer.binding, buffer.stages) +
                     (isOfBytes ? "" : ", " + std::to_string(buffer.stride) + " bytes an element"));
    }
    for (const TextureBinding& texture : layout.textures)
    {
        text += Line(indent + "texture " + texture.name + Place(texture.binding, texture.stages));
    }
    for (const SamplerBinding& sampler : layout.samplers)
    {
        text += Line(indent + "sampler " + sampler.name + Place(sampler.binding, sampler.stages));
    }
    for (const VertexInput& input : layout.vertexInputs)
    {
        text += Line(indent + "vertex input " + TypeText(input.type, input.components) + " " +
                     input.semantic + ", location " + std::to_string(input.location));
    }
    return text;
}

std::string KindText(const ShaderLabPass& pass)
{
    switch (pass.kind)
    {
    case ShaderLabPassKind::UsePass:
        return "UsePass \"" + pass.usePass + "\"";
    case ShaderLabPassKind::GrabPass:
        return "GrabPass, which limn does not draw";
    case ShaderLabPassKind::Pass:
        break;
    }
    return pass.legacyCommands.empty() ? "no program: it draws the mesh in white"
                                       : "no program: limn makes none of fixed-function commands";
}

/// ": 'Hull' at library.shader:12, compiled"
std::string UseText(const CheckedPass& use)
{
    const ShaderLabPass& pass = *use.pass;
    const std::string file = pass.program ? pass.program->file + ":" : "line ";
    return ": '" + pass.name + "' at " + file + std::to_string(pass.location.line) + ", " +
           (pass.program ? ToString(use.outcome) : "no program");
}

std::string SizesText(const ShaderProgram& program, const std::string& indent)
{
    const std::size_t geometry = program.geometrySpirv.size();
    return Line(indent + "SPIR-V: vertex " + std::to_string(program.vertexSpirv.size()) +
                " words, " +
                (geometry == 0 ? "" : "geometry " + std::to_string(geometry) + " words, ") +
                "fragment " + std::to_string(program.fragmentSpirv.size()) + " words, " +
                CountText(static_cast<std::size_t>(program.layout.colorOutputs), "colour output"));
}

std::string PassText(const CheckedPass& checked, std::size_t index)
{
    const ShaderLabPass& pass = *checked.pass;
    const std::string indent = "      ";
    std::string text = Line("    pass " + std::to_string(index) + " '" + pass.name +
                            "', LightMode " + std::string(pass.lightMode())) +
                       Line(indent + StateText(pass.state));
    if (!pass.program)
    {
        return text + Line(indent + KindText(pass) + (checked.use ? UseText(*checked.use) : ""));
    }
    for (const KeywordSet& set : pass.program->keywordSets)
    {
        text += Line(indent + KeywordsText(set));
    }
    if (pass.program->keywordSets.size() > 0)
    {
        text += Line(indent + checked.variants.ToString() + " variants");
    }
    if (!checked.reason.empty())
    {
        text += Line(indent + ToString(checked.outcome) + ": " + checked.reason);
    }
    if (checked.compiled)
    {
        text += SizesText(*checked.compiled, indent) +
                LayoutText(checked.compiled->layout, indent) +
                Line(indent + (checked.srpBatcherProblem.empty()
                                   ? "SRP Batcher: compatible"
                                   : "SRP Batcher: not compatible, " + checked.srpBatcherProblem));
    }
    return text;
}

/// " (98.4 %)"; nothing where there is nothing to compare with. Rounded down, so that 100.0 means
/// all.
std::string Rate(int part, int whole)
{
    if (whole == 0)
    {
        return {};
    }
    const int tenths = static_cast<int>(std::floor(1000.0 * part / whole));
    return " (" + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %)";
}

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

std::string TypeText(const ShaderProperty& property)
{
    return property.type == ShaderPropertyType::Texture ? "Texture" : PropertyTypeText(property);
}

std::string DefaultText(const ShaderProperty& property)
{
    return property.type == ShaderPropertyType::Texture ? "\"" + property.defaultTexture + "\""
                                                        : PropertyDefaultText(property);
}

std::string TypeText(UniformType type, int components, int arraySize)
{
    static constexpr const char* k_Names[] = {"float", "int", "uint"};
    std::string text =
        type == UniformType::Matrix4x4 ? "float4x4" : k_Names[static_cast<std::size_t>(type)];
    text += type != UniformType::Matrix4x4 && components > 1 ? std::to_string(components) : "";
    return arraySize > 0 ? text + "[" + std::to_string(arraySize) + "]" : text;
}

std::string StagesText(ShaderStage stages)
{
    std::string text;
    for (const auto& [stage, name] :
         {std::pair(ShaderStage::Vertex, "vertex"), std::pair(ShaderStage::Geometry, "geometry"),
          std::pair(ShaderStage::Fragment, "fragment")})
    {
        if (stages & stage)
        {
            text += (text.empty() ? "" : " and ") + std::string(name);
        }
    }
    return text.empty() ? "no stage" : text;
}

std::string KeywordsText(const KeywordSet& set)
{
    return set.directive + ":" +
           Joined(set.keywords, "",
                  [](const std::string& keyword)
                  { return " " + (keyword.empty() ? "(none)" : keyword); });
}

const char* ToString(PassOutcome outcome)
{
    constexpr std::array k_Names{"not tried", "compiled", "refused", "missing include", "failed"};
    return k_Names.at(static_cast<std::size_t>(outcome));
}

std::string DescribeVariants(const std::vector<ShaderCheck>& checks)
{
    std::string text;
    VariantCount total;
    for (const ShaderCheck& check : checks)
    {
        for (const CheckedSubShader& subShader : check.subShaders)
        {
            for (const CheckedPass& pass : subShader.passes)
            {
                total += pass.variants;
                if (pass.pass->program)
                {
                    text +=
                        Line(check.file.string() + ":" + std::to_string(pass.pass->location.line) +
                             ": pass '" + pass.pass->name + "': " + pass.variants.ToString());
                }
            }
        }
    }
    return text + "total: " + total.ToString() + "\n";
}

std::string DescribeShader(const ShaderCheck& check)
{
    if (!check.isParsed)
    {
        return {};
    }
    std::string text =
        Line("Shader \"" + check.document->name + "\" (" + check.file.string() + ")");
    for (const ShaderProperty& property : check.document->properties)
    {
        text += Line("  property " + property.name + " " + TypeText(property) + " = " +
                     DefaultText(property));
    }
    if (!check.drawnFallback.empty())
    {
        text += Line("  drawn with its Fallback \"" + check.drawnFallback + "\"");
    }
    for (std::size_t i = 0; i < check.subShaders.size(); ++i)
    {
        const CheckedSubShader& subShader = check.subShaders[i];
        const std::string tags = TagsText(subShader.subShader->tags);
        text += Line("  SubShader " + std::to_string(i) + (subShader.isUsed ? ", used" : "") +
                     (tags.empty() ? "" : ": " + tags));
        for (std::size_t pass = 0; pass < subShader.passes.size(); ++pass)
        {
            text += PassText(subShader.passes[pass], pass);
        }
    }
    return text;
}

ShaderSummary Summarize(const std::vector<ShaderCheck>& checks)
{
    ShaderSummary summary;
    for (const ShaderCheck& check : checks)
    {
        ++summary.files;
        summary.parsed += check.isParsed ? 1 : 0;
        summary.errors += static_cast<int>(
            std::ranges::count(check.diagnostics, Severity::Error, &Diagnostic::severity));
        for (const CheckedSubShader& subShader : check.subShaders)
        {
            for (const CheckedPass& pass : subShader.passes)
            {
                ++summary.passes[static_cast<std::size_t>(pass.outcome)];
            }
        }
    }
    return summary;
}

std::string ToString(const ShaderSummary& summary)
{
    std::string text = CountText(static_cast<std::size_t>(summary.files), "file") + ": " +
                       std::to_string(summary.parsed) + " parsed" +
                       Rate(summary.parsed, summary.files);
    if (summary.errors > 0)
    {
        text += ", " + CountText(static_cast<std::size_t>(summary.errors), "error");
    }
    const int tried = summary.passesTried();
    text += "; " + std::to_string(summary.passesOf(PassOutcome::Compiled)) + " of " +
            std::to_string(tried) + (tried == 1 ? " pass" : " passes") + " compiled" +
            Rate(summary.passesOf(PassOutcome::Compiled), tried);
    const std::pair<PassOutcome, const char*> others[] = {
        {PassOutcome::Failed, " failed"},
        {PassOutcome::Refused, " refused"},
        {PassOutcome::MissingInclude, " with a missing include"}};
    for (const auto& [outcome, words] : others)
    {
        if (summary.passesOf(outcome) > 0)
        {
            text += ", " + std::to_string(summary.passesOf(outcome)) + words;
        }
    }
    return text;
}

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
