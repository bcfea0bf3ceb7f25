#include <limn/shaderlab/ShaderCompiler.h>

#include "HlslPreprocessor.h"
#include "HlslRewriter.h"
#include "ShaderCache.h"
#include "SpirvBuilder.h"
#include "SpirvReflection.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <tuple>

namespace limn
{

namespace
{

/// Raised whenever the same text compiles to something else than before.
constexpr int k_CompilerVersion = 1;

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
    for (const ProgramPragma& pragma : program.pragmas)
    {
        if (pragma.name == "surface")
        {
            throw AssetError(program.file, pragma.location,
                             "#pragma surface: surface shaders are not supported; write a vertex "
                             "and a fragment function");
        }
    }
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
            *spirv = BuildSpirv(*hlsl, stage, program.file);
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

CompiledPass CompileProgram(const PassProgram& program, std::span<const std::string> keywords,
                            IncludeResolver& resolver)
{
    RequireEntryPoints(program);
    const StageSource vertex(PreprocessHlsl(program, ShaderStage::Vertex, keywords, resolver),
                             ShaderStage::Vertex);
    const StageSource fragment(PreprocessHlsl(program, ShaderStage::Fragment, keywords, resolver),
                               ShaderStage::Fragment);
    const StageInterface vertexInterface = InterfaceOf(vertex, FindEntry(program, vertex));
    const StageInterface fragmentInterface = InterfaceOf(fragment, FindEntry(program, fragment));
    const StageLinkage linkage = Link(program, vertexInterface, fragmentInterface);
    CompiledPass pass;
    BuildStages(pass, program, RewriteStage(vertex, vertexInterface, linkage),
                RewriteStage(fragment, fragmentInterface, linkage));
    std::vector<std::string> messages;
    std::vector<HlslVariable> objects = vertex.declarations.objects;
    objects.insert(objects.end(), fragment.declarations.objects.begin(),
                   fragment.declarations.objects.end());
    ReflectLayout(pass, linkage, objects, messages);
    if (!messages.empty())
    {
        std::vector<Diagnostic> diagnostics;
        for (std::string& message : messages)
        {
            diagnostics.push_back(
                {Severity::Error, program.file, program.location, std::move(message)});
        }
        throw AssetError(std::move(diagnostics));
    }
    return pass;
}

std::string CacheKey(const PassProgram& program, std::span<const std::string> keywords,
                     const ShaderCompilerOptions& options)
{
    std::vector<std::string> parts = {std::to_string(k_CompilerVersion),
                                      std::to_string(HashLibrary()),
                                      std::filesystem::absolute(program.file).string(),
                                      options.projectRoot.string(),
                                      program.language == ProgramLanguage::Cg ? "cg" : "hlsl",
                                      program.vertex.name,
                                      program.fragment.name,
                                      std::to_string(program.target)};
    for (const auto& [name, folder] : options.packages)
    {
        parts.push_back(name + "=" + folder.string());
    }
    std::vector<std::string> sorted(keywords.begin(), keywords.end());
    std::sort(sorted.begin(), sorted.end());
    parts.insert(parts.end(), sorted.begin(), sorted.end());
    for (const SourceChunk& chunk : program.chunks)
    {
        parts.push_back(chunk.text);
    }
    std::string all;
    for (const std::string& part : parts)
    {
        all += std::to_string(part.size()) + ":" + part;
    }
    char name[20];
    std::snprintf(name, sizeof(name), "%016llx", static_cast<unsigned long long>(HashContent(all)));
    return name;
}

} // namespace

struct ShaderCompiler::State
{
    explicit State(ShaderCompilerOptions value)
        : options(std::move(value)), cache(options.cacheFolder)
    {
    }

    const ShaderCompilerOptions options;
    const ShaderCache cache;
    std::atomic<int> compiled{0};
    std::atomic<int> loadedFromCache{0};

    void Remember(const std::vector<IncludeDependency>& dependencies)
    {
        const std::lock_guard lock(mutex);
        for (const IncludeDependency& dependency : dependencies)
        {
            includeFiles.insert(dependency.path);
        }
    }

    std::mutex mutex;
    std::set<std::filesystem::path> includeFiles;
};

ShaderCompiler::ShaderCompiler(ShaderCompilerOptions options)
    : m_State(std::make_unique<State>(std::move(options)))
{
}

ShaderCompiler::~ShaderCompiler() = default;

std::shared_ptr<const CompiledPass> ShaderCompiler::Compile(const PassProgram& program,
                                                            std::span<const std::string> keywords)
{
    const std::string key = CacheKey(program, keywords, m_State->options);
    std::vector<IncludeDependency> cachedDependencies;
    if (auto pass = m_State->cache.Load(key, cachedDependencies))
    {
        ++m_State->loadedFromCache;
        m_State->Remember(cachedDependencies);
        return std::make_shared<const CompiledPass>(std::move(*pass));
    }
    IncludeResolver resolver(m_State->options);
    try
    {
        auto pass =
            std::make_shared<const CompiledPass>(CompileProgram(program, keywords, resolver));
        ++m_State->compiled;
        m_State->Remember(resolver.dependencies());
        m_State->cache.Store(key, *pass, resolver.dependencies());
        return pass;
    }
    catch (...)
    {
        // A missing or wrong include is what a person mends next.
        m_State->Remember(resolver.dependencies());
        throw;
    }
}

std::set<std::filesystem::path> ShaderCompiler::includeFiles() const
{
    const std::lock_guard lock(m_State->mutex);
    return m_State->includeFiles;
}

ShaderCompiler::Statistics ShaderCompiler::statistics() const
{
    return {m_State->compiled, m_State->loadedFromCache};
}

} // namespace limn
