#include "console/Json.h"
#include "shaders/ShaderDescription.h"
#include "shaders/ShaderSummary.h"

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

Json BuffersJson(const PropertyLayout& layout)
{
    Json buffers = Json::array();
    for (const UniformBuffer& buffer : layout.buffers)
    {
        Json members = Json::array();
        for (const UniformMember& member : buffer.members)
        {
            members.push_back({{"name", member.name},
                               {"type", TypeText(member.type, member.components, member.arraySize)},
                               {"offset", member.offset},
                               {"size", member.size}});
        }
        buffers.push_back({{"name", buffer.name},
                           {"binding", buffer.binding},
                           {"stages", StagesText(buffer.stages)},
                           {"size", buffer.size},
                           {"members", std::move(members)}});
    }
    return buffers;
}

/// Textures, samplers or structured buffers: what has a name and a binding.
template <typename Bindings>
Json BindingsJson(const Bindings& bindings)
{
    Json json = Json::array();
    for (const auto& binding : bindings)
    {
        json.push_back({{"name", binding.name},
                        {"binding", binding.binding},
                        {"stages", StagesText(binding.stages)}});
    }
    return json;
}

Json LayoutJson(const PropertyLayout& layout)
{
    Json inputs = Json::array();
    for (const VertexInput& input : layout.vertexInputs)
    {
        inputs.push_back({{"semantic", input.semantic},
                          {"type", TypeText(input.type, input.components)},
                          {"location", input.location}});
    }
    return {{"buffers", BuffersJson(layout)},
            {"structuredBuffers", BindingsJson(layout.storageBuffers)},
            {"textures", BindingsJson(layout.textures)},
            {"samplers", BindingsJson(layout.samplers)},
            {"vertexInputs", std::move(inputs)},
            {"colorOutputs", layout.colorOutputs}};
}

/// Where a UsePass leads.
Json UseJson(const CheckedUse& use)
{
    Json json{{"name", use.pass.name},
              {"file", use.pass.program ? use.pass.program->file : ""},
              {"line", use.pass.location.line},
              {"lightMode", use.pass.lightMode()},
              {"outcome", ToString(use.check.outcome)}};
    if (!use.check.reason.empty())
    {
        json["reason"] = use.check.reason;
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
    Json keywords = Json::array();
    if (pass.program)
    {
        for (const KeywordSet& set : pass.program->keywordSets)
        {
            keywords.push_back({{"directive", set.directive}, {"keywords", set.keywords}});
        }
    }
    json["keywords"] = std::move(keywords);
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

Json SubShadersJson(const ShaderCheck& check)
{
    Json subShaders = Json::array();
    for (const CheckedSubShader& checked : check.subShaders)
    {
        Json passes = Json::array();
        for (const CheckedPass& pass : checked.passes)
        {
            passes.push_back(PassJson(pass));
        }
        subShaders.push_back({{"used", checked.isUsed},
                              {"lod", checked.subShader->lod},
                              {"tags", TagsJson(checked.subShader->tags)},
                              {"passes", std::move(passes)}});
    }
    return subShaders;
}

Json PropertiesJson(const ShaderLabDocument& document)
{
    Json properties = Json::array();
    for (const ShaderProperty& property : document.properties)
    {
        properties.push_back({{"name", property.name},
                              {"displayName", property.displayName},
                              {"type", TypeText(property)},
                              {"default", DefaultText(property)}});
    }
    return properties;
}

const char* SeverityName(Severity severity)
{
    return severity == Severity::Error     ? "error"
           : severity == Severity::Warning ? "warning"
                                           : "note";
}

Json ShaderJson(const ShaderCheck& check)
{
    Json diagnostics = Json::array();
    for (const Diagnostic& diagnostic : check.diagnostics)
    {
        diagnostics.push_back({{"severity", SeverityName(diagnostic.severity)},
                               {"file", diagnostic.file},
                               {"line", diagnostic.location.line},
                               {"column", diagnostic.location.column},
                               {"message", diagnostic.message}});
    }
    Json json{{"file", check.file.string()},
              {"parsed", check.isParsed},
              {"diagnostics", std::move(diagnostics)}};
    if (check.isParsed)
    {
        json["name"] = check.document->name;
        json["properties"] = PropertiesJson(*check.document);
        json["subShaders"] = SubShadersJson(check);
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
    Json files = Json::array();
    for (const ShaderCheck& check : checks)
    {
        files.push_back(ShaderJson(check));
    }
    const Json json{{"files", std::move(files)}, {"summary", SummaryJson(Summarize(checks))}};
    return JsonText(json);
}

} // namespace limn
