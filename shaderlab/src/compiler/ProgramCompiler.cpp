#include "compiler/ProgramCompiler.h"

#include <limn/base/Lists.h>
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/ProgramRequirements.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "compiler/CompilerMessages.h"
#include "keywords/PragmaScanner.h"
#include "lowering/GlslangGuards.h"
#include "lowering/StageLowering.h"
#include "preprocess/Preprocessor.h"
#include "spirv/SpirvBuilder.h"
#include "spirv/SpirvReflection.h"
#include "tokens/ColumnFinder.h"

#include <algorithm>
#include <functional>
#include <future>
#include <memory>
#include <utility>

namespace limn
{

namespace
{

const EntryPoint& EntryOf(const PassProgram& program, ShaderStage stage)
{
    return stage == ShaderStage::Vertex     ? program.vertex
           : stage == ShaderStage::Geometry ? program.geometry
           : stage == ShaderStage::Compute  ? program.kernel
                                            : program.fragment;
}

std::string_view StageName(ShaderStage stage)
{
    return stage == ShaderStage::Vertex     ? "vertex"
           : stage == ShaderStage::Geometry ? "geometry"
           : stage == ShaderStage::Compute  ? "kernel"
                                            : "fragment";
}

/// Returns errors for the missing ones of the files that pragmas include. Such a file may hold
/// whatever else seems to be missing.
std::vector<Diagnostic> MissingPragmaFiles(const PassProgram& program, IncludeResolver& resolver)
{
    std::vector<Diagnostic> missing;
    for (const ProgramPragma& pragma : program.pragmas)
    {
        if (pragma.name == "include_with_pragmas" && !resolver.Find(pragma.arguments, program.file))
        {
            missing.push_back({Severity::Error, program.file, pragma.location,
                               "#include_with_pragmas: " +
                                   ReasonNotIncluded(pragma.arguments, resolver.refusal())});
        }
    }
    return missing;
}

/// Returns the program as if it included all files with their pragmas.
PassProgram WithAllPragmas(PassProgram program, IncludeResolver& resolver)
{
    constexpr std::string_view k_Include = "#include";
    for (SourceChunk& chunk : program.chunks)
    {
        for (std::size_t at = chunk.text.find(k_Include); at != chunk.text.npos;
             at = chunk.text.find(k_Include, at + 1))
        {
            const std::size_t end = at + k_Include.size();
            chunk.text.insert(end, chunk.text.compare(end, 1, "_") == 0 ? "" : "_with_pragmas");
        }
    }
    ScanPragmas(program, [&](std::string_view include, std::string_view includer)
                { return resolver.Find(include, includer); });
    return program;
}

bool isKernel(const PassProgram& program)
{
    return !program.kernel.name.empty();
}

void RequireEntryPoints(const PassProgram& program, IncludeResolver& resolver)
{
    if (isKernel(program))
    {
        return;
    }
    std::vector<Diagnostic> missing;
    for (const ShaderStage stage : {ShaderStage::Vertex, ShaderStage::Fragment})
    {
        if (EntryOf(program, stage).name.empty())
        {
            const std::string name(StageName(stage));
            const bool isIncluded = !EntryOf(WithAllPragmas(program, resolver), stage).name.empty();
            missing.push_back(
                {Severity::Error, program.file, program.location,
                 "program: '#pragma " + name + "' is missing; " +
                     (isIncluded ? "an included file has it, but only #include_with_pragmas takes "
                                   "pragmas from a file"
                                 : "it names the " + name + " function")});
        }
    }
    if (missing.empty())
    {
        return;
    }
    if (auto files = MissingPragmaFiles(program, resolver); !files.empty())
    {
        throw MissingIncludeError(std::move(files));
    }
    throw AssetError(std::move(missing));
}

const HlslFunction& FindEntry(const PassProgram& program, const HlslSource& source,
                              ShaderStage stage)
{
    const EntryPoint& entry = EntryOf(program, stage);
    if (const HlslFunction* function = source.declarations.FindDefinition(entry.name))
    {
        return *function;
    }
    std::vector<std::string_view> known;
    for (const HlslFunction& function : source.declarations.functions)
    {
        if (function.name == entry.name)
        {
            const HlslPlace place = source.tokens.Place(function.token);
            throw AssetError(program.file, entry.location,
                             "#pragma " + std::string(StageName(stage)) + ": the function '" +
                                 entry.name + "' is only declared, at " + place.file + ":" +
                                 std::to_string(place.location.line) + "; write its body");
        }
        known.push_back(function.hasBody ? function.name : std::string_view());
    }
    throw AssetError(program.file, entry.location,
                     "#pragma " + std::string(StageName(stage)) + ": there is no function '" +
                         entry.name + "'" + DidYouMean(entry.name, known));
}

[[noreturn]] void ThrowInterface(const HlslSource& source, const HlslFunction& function,
                                 const StageInterfaceError& error)
{
    const HlslPlace place = source.tokens.Place(error.token > 0 ? error.token : function.token);
    throw AssetError(place.file, place.location, std::string(function.name) + ": " + error.message);
}

/// Returns the inputs and outputs of a function; a kernel has none.
StageInterface InterfaceOf(const HlslSource& source, const HlslFunction& function,
                           ShaderStage stage)
{
    if (stage == ShaderStage::Compute)
    {
        StageInterface interface;
        interface.function = &function;
        return interface;
    }
    try
    {
        return ReadStageInterface(source.declarations, function, stage);
    }
    catch (const StageInterfaceError& error)
    {
        ThrowInterface(source, function, error);
    }
}

/// The sources from which a program is compiled.
struct Sources
{
    const PassProgram& program;
    std::span<const std::string> keywords;
    IncludeResolver& resolver;
    ColumnFinder& lines;
};

/// One stage on its way to SPIR-V.
struct Stage
{
    ShaderStage stage = ShaderStage::None;
    std::shared_ptr<const HlslSource> source; ///< other stages may have the same
    StageInterface interface;                 ///< into source
};

/// Vertex first, fragment last; or a kernel alone.
using Stages = std::vector<Stage>;

Stages ReadStages(const Sources& sources, std::vector<Diagnostic>& warnings)
{
    const PassProgram& program = sources.program;
    Stages stages;
    std::shared_ptr<const HlslSource> shared;
    for (const ShaderStage stage :
         {ShaderStage::Vertex, ShaderStage::Geometry, ShaderStage::Fragment, ShaderStage::Compute})
    {
        const bool isOther = isKernel(program) && stage != ShaderStage::Compute;
        if (isOther || EntryOf(program, stage).name.empty())
        {
            continue; // RequireEntryPoints has asked for those that must be there
        }
        auto source = shared;
        if (!source)
        {
            PreprocessedHlsl hlsl = PreprocessHlsl(program, stage, sources.keywords,
                                                   sources.resolver, sources.lines, warnings);
            source = std::make_shared<const HlslSource>(std::move(hlsl.text), &sources.lines);
            RequireSound(*source);
            shared = hlsl.namesStages ? nullptr : source;
        }
        StageInterface interface = InterfaceOf(*source, FindEntry(program, *source, stage), stage);
        stages.push_back({stage, std::move(source), std::move(interface)});
    }
    return stages;
}

StageLinkage Link(const Stages& stages)
{
    try
    {
        return LinkStages(stages.front().interface,
                          stages.size() > 2 ? &stages[1].interface : nullptr,
                          stages.back().interface);
    }
    catch (const StageInterfaceError& error)
    {
        const auto stage = std::ranges::find(
            stages, error.function, [](const Stage& item) { return item.interface.function; });
        ThrowInterface(*stage->source, *error.function, error);
    }
}

void WarnOfUnwritten(const PassProgram& program, const Stages& stages, const StageLinkage& linkage,
                     std::vector<Diagnostic>& warnings)
{
    for (std::size_t i = 1; i < stages.size(); ++i)
    {
        const EntryPoint& entry = EntryOf(program, stages[i].stage);
        for (const std::string& semantic : linkage.Before(stages[i].stage).unwritten)
        {
            if (semantic == "PSIZE")
            {
                continue; // it ends at the rasteriser, but stands in the struct of both functions
            }
            warnings.push_back({Severity::Warning, program.file, entry.location,
                                entry.name + ": it reads '" + semantic + "', which the " +
                                    std::string(StageName(stages[i - 1].stage)) +
                                    " function does not write; it is 0"});
        }
    }
}

/// Removes messages that several stages repeat.
void RemoveRepeated(std::vector<Diagnostic>& diagnostics)
{
    std::vector<Diagnostic> once;
    for (Diagnostic& diagnostic : diagnostics)
    {
        AddOnce(diagnostic, once);
    }
    diagnostics = std::move(once);
}

/// The HLSL compiler's result for a rewritten stage, with places in the rewritten text.
struct BuiltStage
{
    std::vector<std::uint32_t> spirv; ///< empty if there are errors
    std::vector<Diagnostic> warnings;
    std::vector<Diagnostic> errors;
};

/// Reads nothing but its arguments, so that two stages can be built at a time.
BuiltStage BuildStage(const std::string& hlsl, ShaderStage stage, const std::string& file,
                      bool halfIs16Bit)
{
    BuiltStage built;
    try
    {
        built.spirv = BuildSpirv(hlsl, stage, file, halfIs16Bit, built.warnings);
    }
    catch (const AssetError& error)
    {
        built.errors = error.diagnostics();
    }
    return built;
}

/// Adds what was said of a built stage, at the author's places. Mistakes that show in the generated
/// entry function only are in the signature of the author's.
void PlaceDiagnostics(const BuiltStage& built, const PassProgram& program, const HlslSource& source,
                      const RewrittenHlsl& hlsl, const EntryPoint& entry,
                      std::vector<Diagnostic>& warnings, std::vector<Diagnostic>& errors)
{
    const std::vector<Diagnostic> placed = PlaceMessages(built.warnings, source, hlsl);
    warnings.insert(warnings.end(), placed.begin(), placed.end());
    if (built.errors.empty())
    {
        return;
    }
    std::vector<Diagnostic> found = PlaceMessages(built.errors, source, hlsl);
    const std::vector<Diagnostic> undeclared = DescribeUndeclared(source, hlsl);
    found.insert(found.end(), undeclared.begin(), undeclared.end());
    const bool hasOther = std::ranges::any_of(
        found, [](const Diagnostic& diagnostic)
        { return diagnostic.severity == Severity::Error && diagnostic.file != k_EntryFile; });
    for (Diagnostic& diagnostic : found)
    {
        if (diagnostic.file == k_EntryFile && hasOther)
        {
            continue; // the entry function is wrong only because of it
        }
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
        errors.push_back(std::move(diagnostic));
    }
}

std::vector<std::uint32_t>& SpirvOf(ShaderProgram& pass, ShaderStage stage)
{
    return stage == ShaderStage::Vertex     ? pass.vertexSpirv
           : stage == ShaderStage::Geometry ? pass.geometrySpirv
           : stage == ShaderStage::Compute  ? pass.computeSpirv
                                            : pass.fragmentSpirv;
}

/// Builds the stages at the same time, the last of them on this thread: most of an import is spent
/// here, and a machine with two cores imports a pass in little more than half of the time.
std::vector<std::future<BuiltStage>> BuildAtOnce(const Sources& sources, const Stages& stages,
                                                 const std::vector<RewrittenHlsl>& rewritten)
{
    const bool halfIs16Bit = std::ranges::count(sources.keywords, k_RealHalfMacro) > 0;
    std::vector<std::future<BuiltStage>> built;
    for (std::size_t i = 0; i < stages.size(); ++i)
    {
        // Others are built on this thread too where there can be no other.
        const std::launch others = std::launch::async | std::launch::deferred;
        const bool isLast = i + 1 == stages.size();
        built.push_back(std::async(isLast ? std::launch::deferred : others, BuildStage,
                                   std::cref(rewritten[i].text), stages[i].stage,
                                   std::cref(sources.program.file), halfIs16Bit));
    }
    built.back().wait();
    return built;
}

/// SPIR-V of all stages; their mistakes are reported together, each once.
void BuildStages(ShaderProgram& pass, const Sources& sources, const Stages& stages,
                 const StageLinkage& linkage)
{
    std::vector<RewrittenHlsl> rewritten;
    for (const Stage& stage : stages)
    {
        rewritten.push_back(
            stage.stage == ShaderStage::Compute
                ? RewriteKernel(*stage.source, *stage.interface.function)
                : RewriteStage(*stage.source, stage.stage, stage.interface, linkage));
        for (const std::string& standIn : rewritten.back().standIns)
        {
            pass.diagnostics.push_back({Severity::Note, sources.program.file, {}, standIn});
        }
    }
    auto building = BuildAtOnce(sources, stages, rewritten);
    std::vector<Diagnostic> errors;
    for (std::size_t i = 0; i < stages.size(); ++i)
    {
        BuiltStage built = building[i].get();
        PlaceDiagnostics(built, sources.program, *stages[i].source, rewritten[i],
                         EntryOf(sources.program, stages[i].stage), pass.diagnostics, errors);
        SpirvOf(pass, stages[i].stage) = std::move(built.spirv);
    }
    if (!errors.empty())
    {
        RemoveRepeated(errors);
        throw AssetError(std::move(errors));
    }
}

GeometryInput GeometryInputOf(const StageInterface& interface)
{
    using Input = std::pair<std::string_view, GeometryInput>;
    static constexpr Input k_Inputs[] = {{"point", GeometryInput::Point},
                                         {"line", GeometryInput::Line},
                                         {"lineadj", GeometryInput::LineAdjacency},
                                         {"triangle", GeometryInput::Triangle},
                                         {"triangleadj", GeometryInput::TriangleAdjacency}};
    return std::ranges::find(k_Inputs, interface.geometry->primitive, &Input::first)->second;
}

ShaderProgram Build(const Sources& sources)
{
    ShaderProgram pass;
    const PassProgram& program = sources.program;
    const Stages stages = ReadStages(sources, pass.diagnostics);
    std::vector<HlslVariable> objects;
    for (const Stage& stage : stages)
    {
        const std::vector<HlslVariable>& declared = stage.source->declarations.objects;
        objects.insert(objects.end(), declared.begin(), declared.end());
    }
    const StageLinkage linkage = Link(stages);
    WarnOfUnwritten(program, stages, linkage, pass.diagnostics);
    BuildStages(pass, sources, stages, linkage);
    std::vector<std::string> messages;
    ReflectLayout(pass, linkage, objects, messages);
    if (stages.size() > 2)
    {
        pass.layout.geometryInput = GeometryInputOf(stages[1].interface);
    }
    if (!messages.empty())
    {
        std::vector<Diagnostic> errors;
        for (const std::string& message : messages)
        {
            errors.push_back({Severity::Error, program.file, program.location, message});
        }
        throw AssetError(std::move(errors));
    }
    return pass;
}

std::vector<Diagnostic> WithColumns(const AssetError& error, ColumnFinder& lines)
{
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    lines.AddColumns(diagnostics);
    return diagnostics;
}

} // namespace

ShaderProgram CompileProgram(const PassProgram& program, std::span<const std::string> keywords,
                             IncludeResolver& resolver)
{
    RequireEntryPoints(program, resolver);
    ColumnFinder lines(program, resolver);
    const Sources sources{program, keywords, resolver, lines};
    try
    {
        ShaderProgram pass = Build(sources);
        const std::vector<Diagnostic> warnings = CheckPragmas(program);
        pass.diagnostics.insert(pass.diagnostics.begin(), warnings.begin(), warnings.end());
        RemoveRepeated(pass.diagnostics);
        lines.AddColumns(pass.diagnostics);
        return pass;
    }
    catch (const UnsupportedProgramError& error)
    {
        throw UnsupportedProgramError(WithColumns(error, lines).front());
    }
    catch (const MissingIncludeError& error)
    {
        throw MissingIncludeError(WithColumns(error, lines));
    }
    catch (const AssetError& error)
    {
        throw AssetError(WithColumns(error, lines));
    }
}

} // namespace limn
