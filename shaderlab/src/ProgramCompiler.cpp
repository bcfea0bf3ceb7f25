#include "ProgramCompiler.h"

#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/ProgramSupport.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "DiagnosticColumns.h"
#include "HlslPreprocessor.h"
#include "HlslRewriter.h"
#include "SpirvBuilder.h"
#include "SpirvReflection.h"

#include <algorithm>
#include <tuple>

namespace limn
{

namespace
{

const EntryPoint& EntryOf(const PassProgram& program, ShaderStage stage)
{
    return stage == ShaderStage::Vertex ? program.vertex : program.fragment;
}

std::string_view StageName(ShaderStage stage)
{
    return stage == ShaderStage::Vertex ? "vertex" : "fragment";
}

void RequireEntryPoints(const PassProgram& program)
{
    std::vector<Diagnostic> missing;
    for (const ShaderStage stage : {ShaderStage::Vertex, ShaderStage::Fragment})
    {
        if (EntryOf(program, stage).name.empty())
        {
            const std::string name(StageName(stage));
            missing.push_back(
                {Severity::Error, program.file, program.location,
                 "program: '#pragma " + name + "' is missing; it names the " + name + " function"});
        }
    }
    if (!missing.empty())
    {
        throw AssetError(std::move(missing));
    }
}

const HlslFunction& FindEntry(const PassProgram& program, const StageSource& source)
{
    const EntryPoint& entry = EntryOf(program, source.stage);
    if (const HlslFunction* function = source.declarations.FindDefinition(entry.name))
    {
        return *function;
    }
    std::vector<std::string_view> known;
    for (const HlslFunction& function : source.declarations.functions)
    {
        known.push_back(function.name);
    }
    const std::string_view nearest = NearestName(entry.name, known);
    throw AssetError(program.file, entry.location,
                     "#pragma " + std::string(StageName(source.stage)) +
                         ": there is no function '" + entry.name + "'" +
                         (nearest.empty() ? "" : "; did you mean '" + std::string(nearest) + "'?"));
}

StageInterface InterfaceOf(const StageSource& source, const HlslFunction& function)
{
    try
    {
        return ReadStageInterface(source.declarations, function, source.stage);
    }
    catch (const StageInterfaceError& error)
    {
        const std::size_t token = function.begin;
        const HlslPlace place = PlaceOf(source.text, source.tokens[token].Begin(source.text));
        throw AssetError(place.file, place.location,
                         std::string(function.name) + ": " + error.message);
    }
}

StageLinkage Link(const PassProgram& program, const StageInterface& vertex,
                  const StageInterface& fragment)
{
    try
    {
        return LinkStages(vertex, fragment);
    }
    catch (const StageInterfaceError& error)
    {
        throw AssetError(program.file, program.fragment.location,
                         program.fragment.name + ": " + error.message);
    }
}

/// Adds what is not there yet. Mistakes that show in the generated entry function only are in the
/// signature of the author's.
void AddDiagnostics(std::vector<Diagnostic>& diagnostics, const AssetError& error,
                    const PassProgram& program, const EntryPoint& entry)
{
    for (Diagnostic diagnostic : error.diagnostics())
    {
        if (diagnostic.file == k_EntryFile)
        {
            diagnostic.file = program.file;
            diagnostic.location = entry.location;
            diagnostic.message = entry.name + ": it cannot be called; " + diagnostic.message;
        }
        if (diagnostic.location.line == 0)
        {
            diagnostic.location = program.location;
        }
        if (std::find(diagnostics.begin(), diagnostics.end(), diagnostic) == diagnostics.end())
        {
            diagnostics.push_back(std::move(diagnostic));
        }
    }
}

/// SPIR-V of both stages; the mistakes of both are reported together, each once.
void BuildStages(CompiledPass& pass, const PassProgram& program, const std::string& vertex,
                 const std::string& fragment)
{
    std::vector<Diagnostic> diagnostics;
    for (const auto& [stage, hlsl, spirv] :
         {std::tuple{ShaderStage::Vertex, &vertex, &pass.vertexSpirv},
          std::tuple{ShaderStage::Fragment, &fragment, &pass.fragmentSpirv}})
    {
        try
        {
            *spirv = BuildSpirv(*hlsl, stage, program.file, pass.diagnostics);
        }
        catch (const AssetError& error)
        {
            AddDiagnostics(diagnostics, error, program, EntryOf(program, stage));
        }
    }
    if (!diagnostics.empty())
    {
        throw AssetError(std::move(diagnostics));
    }
}

void ThrowMessages(const std::vector<std::string>& messages, const PassProgram& program)
{
    std::vector<Diagnostic> diagnostics;
    for (const std::string& message : messages)
    {
        diagnostics.push_back({Severity::Error, program.file, program.location, message});
    }
    if (!diagnostics.empty())
    {
        throw AssetError(std::move(diagnostics));
    }
}

CompiledPass Build(const PassProgram& program, std::span<const std::string> keywords,
                   IncludeResolver& resolver)
{
    CompiledPass pass;
    const StageSource vertex(
        PreprocessHlsl(program, ShaderStage::Vertex, keywords, resolver, pass.diagnostics),
        ShaderStage::Vertex);
    const StageSource fragment(
        PreprocessHlsl(program, ShaderStage::Fragment, keywords, resolver, pass.diagnostics),
        ShaderStage::Fragment);
    const StageInterface vertexInterface = InterfaceOf(vertex, FindEntry(program, vertex));
    const StageInterface fragmentInterface = InterfaceOf(fragment, FindEntry(program, fragment));
    const StageLinkage linkage = Link(program, vertexInterface, fragmentInterface);
    for (const std::string& semantic : linkage.unwritten)
    {
        pass.diagnostics.push_back({Severity::Warning, program.file, program.fragment.location,
                                    program.fragment.name + ": it reads '" + semantic +
                                        "', which the vertex function does not write; it is 0"});
    }
    BuildStages(pass, program, RewriteStage(vertex, vertexInterface, linkage),
                RewriteStage(fragment, fragmentInterface, linkage));
    std::vector<std::string> messages;
    std::vector<HlslVariable> objects = vertex.declarations.objects;
    objects.insert(objects.end(), fragment.declarations.objects.begin(),
                   fragment.declarations.objects.end());
    ReflectLayout(pass, linkage, objects, messages);
    ThrowMessages(messages, program);
    return pass;
}

/// What both stages say is said once.
void RemoveRepeated(std::vector<Diagnostic>& diagnostics)
{
    std::vector<Diagnostic> once;
    for (Diagnostic& diagnostic : diagnostics)
    {
        if (std::find(once.begin(), once.end(), diagnostic) == once.end())
        {
            once.push_back(std::move(diagnostic));
        }
    }
    diagnostics = std::move(once);
}

} // namespace

CompiledPass CompileProgram(const PassProgram& program, std::span<const std::string> keywords,
                            IncludeResolver& resolver)
{
    RequireEntryPoints(program);
    try
    {
        CompiledPass pass = Build(program, keywords, resolver);
        const std::vector<Diagnostic> warnings = CheckPragmas(program);
        pass.diagnostics.insert(pass.diagnostics.begin(), warnings.begin(), warnings.end());
        RemoveRepeated(pass.diagnostics);
        AddColumns(pass.diagnostics, program, resolver);
        return pass;
    }
    catch (const UnsupportedProgramError&)
    {
        throw;
    }
    catch (const MissingIncludeError& error)
    {
        std::vector<Diagnostic> diagnostics = error.diagnostics();
        AddColumns(diagnostics, program, resolver);
        throw MissingIncludeError(std::move(diagnostics));
    }
    catch (const AssetError& error)
    {
        std::vector<Diagnostic> diagnostics = error.diagnostics();
        AddColumns(diagnostics, program, resolver);
        throw AssetError(std::move(diagnostics));
    }
}

} // namespace limn
