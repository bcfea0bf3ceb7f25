#include "console/Console.h"
#include "console/Json.h"
#include "shader_reports/ShaderDescription.h"

namespace limn
{

namespace
{

Json TagsJson(const ShaderTags& tags)
{
    Json json = Json::object();
    for (const ShaderTag& tag : tags.items)
    {
        json[tag.key] = tag.value;
    }
    return json;
}

Json BufferJson(const UniformBuffer& buffer)
{
    const auto memberJson = [](const UniformMember& member) -> Json
    {
        return {{"name", member.name},
                {"type", TypeText(member.type, member.components, member.arraySize)},
                {"offset", member.offset},
                {"size", member.size}};
    };
    return {{"name", buffer.name},
            {"binding", buffer.binding},
            {"stages", StagesText(buffer.stages)},
            {"size", buffer.size},
            {"members", JsonList(buffer.members, memberJson)}};
}

/// A texture, a sampler or a structured buffer: what has a name and a binding.
template <typename Binding>
Json BindingJson(const Binding& binding)
{
    return {{"name", binding.name},
            {"binding", binding.binding},
            {"stages", StagesText(binding.stages)}};
}

Json InputJson(const VertexInput& input)
{
    return {{"semantic", input.semantic},
            {"type", TypeText(input.type, input.components)},
            {"location", input.location}};
}

Json LayoutJson(const PropertyLayout& layout)
{
    return {
        {"buffers", JsonList(layout.buffers, BufferJson)},
        {"structuredBuffers", JsonList(layout.storageBuffers, BindingJson<StorageBufferBinding>)},
        {"textures", JsonList(layout.textures, BindingJson<TextureBinding>)},
        {"samplers", JsonList(layout.samplers, BindingJson<SamplerBinding>)},
        {"vertexInputs", JsonList(layout.vertexInputs, InputJson)},
        {"colorOutputs", layout.colorOutputs}};
}

/// Returns the pass to which a UsePass leads.
Json UseJson(const CheckedPass& use)
{
    Json json{{"name", use.pass->name},
              {"file", use.pass->program ? use.pass->program->file : ""},
              {"line", use.pass->location.line},
              {"lightMode", use.pass->lightMode()},
              {"outcome", ToString(use.outcome)}};
    if (!use.reason.empty())
    {
        json["reason"] = use.reason;
    }
    return json;
}

Json PassJson(const CheckedPass& checked)
{
    const ShaderLabPass& pass = *checked.pass;
    Json json{{"name", pass.name},
              {"line", pass.location.line},
              {"lightMode", pass.lightMode()},
              {"tags", TagsJson(pass.tags)},
              {"state", StateText(pass.state)}};
    const auto setJson = [](const KeywordSet& set) -> Json
    {
        return {{"directive", set.directive}, {"keywords", set.keywords}};
    };
    json["keywords"] = pass.program ? JsonList(pass.program->keywordSets, setJson) : Json::array();
    json["variants"] = checked.variants.ToString();
    json["outcome"] = ToString(checked.outcome);
    if (!checked.reason.empty())
    {
        json["reason"] = checked.reason;
    }
    if (checked.compiled)
    {
        json["vertexWords"] = checked.compiled->vertexSpirv.size();
        json["geometryWords"] = checked.compiled->geometrySpirv.size();
        json["fragmentWords"] = checked.compiled->fragmentSpirv.size();
        json["enabledKeywords"] = checked.keywords;
        json["layout"] = LayoutJson(checked.compiled->layout);
        json["srpBatcherProblem"] = checked.srpBatcherProblem;
    }
    if (checked.use)
    {
        json["use"] = UseJson(*checked.use);
    }
    return json;
}

Json SubShaderJson(const CheckedSubShader& checked)
{
    return {{"used", checked.isUsed},
            {"lod", checked.subShader->lod},
            {"tags", TagsJson(checked.subShader->tags)},
            {"passes", JsonList(checked.passes, PassJson)}};
}

Json PropertyJson(const ShaderProperty& property)
{
    return {{"name", property.name},
            {"displayName", property.displayName},
            {"type", TypeText(property)},
            {"default", DefaultText(property)}};
}

Json DiagnosticJson(const Diagnostic& diagnostic)
{
    return {{"severity", SeverityName(diagnostic.severity)},
            {"file", diagnostic.file},
            {"line", diagnostic.location.line},
            {"column", diagnostic.location.column},
            {"message", diagnostic.message}};
}

Json ShaderJson(const ShaderCheck& check)
{
    Json json{{"file", check.file.string()},
              {"parsed", check.isParsed},
              {"diagnostics", JsonList(check.diagnostics, DiagnosticJson)}};
    if (check.isParsed)
    {
        json["name"] = check.document->name;
        json["properties"] = JsonList(check.document->properties, PropertyJson);
        json["subShaders"] = JsonList(check.subShaders, SubShaderJson);
        json["fallback"] = check.document->fallback;
        json["drawnFallback"] = check.drawnFallback;
    }
    return json;
}

Json SummaryJson(const ShaderSummary& summary)
{
    return {{"files", summary.files},
            {"parsed", summary.parsed},
            {"errors", summary.errors},
            {"passesTried", summary.passesTried()},
            {"passesCompiled", summary.passesOf(PassOutcome::Compiled)},
            {"passesFailed", summary.passesOf(PassOutcome::Failed)},
            {"passesRefused", summary.passesOf(PassOutcome::Refused)},
            {"passesWithMissingIncludes", summary.passesOf(PassOutcome::MissingInclude)},
            {"text", ToString(summary)}};
}

} // namespace

std::string ShadersAsJson(const std::vector<ShaderCheck>& checks)
{
    return JsonText(
        {{"files", JsonList(checks, ShaderJson)}, {"summary", SummaryJson(Summarize(checks))}});
}

} // namespace limn
