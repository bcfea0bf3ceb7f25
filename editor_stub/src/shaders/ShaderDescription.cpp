#include "shaders/ShaderDescription.h"

#include <limn/shaderlab/PrintShaderLab.h>

namespace limn
{

namespace
{

std::string TagsText(const ShaderTags& tags)
{
    std::string text;
    for (const ShaderTag& tag : tags.items)
    {
        text += (text.empty() ? "" : ", ") + tag.key + "=" + tag.value;
    }
    return text;
}

std::string MembersText(const UniformBuffer& buffer)
{
    std::string text;
    for (const UniformMember& member : buffer.members)
    {
        text += (text.empty() ? "" : ", ") +
                TypeText(member.type, member.components, member.arraySize) + " " + member.name +
                " @" + std::to_string(member.offset);
    }
    return text;
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
        text += indent + "buffer " + buffer.name + Place(buffer.binding, buffer.stages) + ", " +
                std::to_string(buffer.size) + " bytes: " + MembersText(buffer) + "\n";
    }
    for (const StorageBufferBinding& buffer : layout.storageBuffers)
    {
        text += indent + "structured buffer " + buffer.name + Place(buffer.binding, buffer.stages) +
                ", " + std::to_string(buffer.stride) + " bytes an element\n";
    }
    for (const TextureBinding& texture : layout.textures)
    {
        text += indent + "texture " + texture.name + Place(texture.binding, texture.stages) + "\n";
    }
    for (const SamplerBinding& sampler : layout.samplers)
    {
        text += indent + "sampler " + sampler.name + Place(sampler.binding, sampler.stages) + "\n";
    }
    for (const VertexInput& input : layout.vertexInputs)
    {
        text += indent + "vertex input " + TypeText(input.type, input.components) + " " +
                input.semantic + ", location " + std::to_string(input.location) + "\n";
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
    return pass.legacyCommands.empty() ? "no program"
                                       : "no program: fixed-function commands, not synthesised";
}

/// ": 'Hull' at library.shader:12, compiled"
std::string UseText(const CheckedUse& use)
{
    const std::string file = use.pass.program ? use.pass.program->file + ":" : "line ";
    return ": '" + use.pass.name + "' at " + file + std::to_string(use.pass.location.line) + ", " +
           (use.pass.program ? ToString(use.check.outcome) : "no program");
}

std::string PassText(const CheckedPass& checked, std::size_t index)
{
    const ShaderLabPass& pass = *checked.pass;
    const std::string indent = "      ";
    std::string text = "    pass " + std::to_string(index) + " '" + pass.name + "', LightMode " +
                       std::string(pass.lightMode()) + "\n" + indent + StateText(pass.state) + "\n";
    if (!pass.program)
    {
        return text + indent + KindText(pass) + (checked.use ? UseText(*checked.use) : "") + "\n";
    }
    for (const KeywordSet& set : pass.program->keywordSets)
    {
        text += indent + KeywordsText(set) + "\n";
    }
    if (pass.program->keywordSets.size() > 0)
    {
        text += indent + checked.variants.ToString() + " variants\n";
    }
    if (!checked.reason.empty())
    {
        text += indent + ToString(checked.outcome) + ": " + checked.reason + "\n";
    }
    if (checked.compiled)
    {
        text += indent + "SPIR-V: vertex " + std::to_string(checked.compiled->vertexSpirv.size()) +
                " words, " +
                (checked.compiled->geometrySpirv.empty()
                     ? ""
                     : "geometry " + std::to_string(checked.compiled->geometrySpirv.size()) +
                           " words, ") +
                "fragment " + std::to_string(checked.compiled->fragmentSpirv.size()) + " words, " +
                std::to_string(checked.compiled->layout.colorOutputs) + " colour output(s)\n" +
                LayoutText(checked.compiled->layout, indent) + indent +
                (checked.srpBatcherProblem.empty()
                     ? "SRP Batcher: compatible"
                     : "SRP Batcher: not compatible, " + checked.srpBatcherProblem) +
                "\n";
    }
    return text;
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
    std::string text = set.directive + ":";
    for (const std::string& keyword : set.keywords)
    {
        text += " " + (keyword.empty() ? "(none)" : keyword);
    }
    return text;
}

const char* ToString(PassOutcome outcome)
{
    switch (outcome)
    {
    case PassOutcome::NotTried:
        return "not tried";
    case PassOutcome::Compiled:
        return "compiled";
    case PassOutcome::Refused:
        return "refused";
    case PassOutcome::MissingInclude:
        return "missing include";
    case PassOutcome::Failed:
        break;
    }
    return "failed";
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
                    text += check.file.string() + ":" + std::to_string(pass.pass->location.line) +
                            ": pass '" + pass.pass->name + "': " + pass.variants.ToString() + "\n";
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
    std::string text = "Shader \"" + check.document->name + "\" (" + check.file.string() + ")\n";
    for (const ShaderProperty& property : check.document->properties)
    {
        text += "  property " + property.name + " " + TypeText(property) + " = " +
                DefaultText(property) + "\n";
    }
    if (!check.drawnFallback.empty())
    {
        text += "  drawn with its Fallback \"" + check.drawnFallback + "\"\n";
    }
    for (std::size_t i = 0; i < check.subShaders.size(); ++i)
    {
        const CheckedSubShader& subShader = check.subShaders[i];
        const std::string tags = TagsText(subShader.subShader->tags);
        text += "  SubShader " + std::to_string(i) + (subShader.isUsed ? ", used" : "") +
                (tags.empty() ? "" : ": " + tags) + "\n";
        for (std::size_t pass = 0; pass < subShader.passes.size(); ++pass)
        {
            text += PassText(subShader.passes[pass], pass);
        }
    }
    return text;
}

} // namespace limn
