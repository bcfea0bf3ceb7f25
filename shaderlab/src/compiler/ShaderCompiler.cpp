#include <limn/shaderlab/ShaderCompiler.h>

#include <limn/base/FileCache.h>
#include <limn/shaderlab/ProgramRequirements.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "compiler/ProgramBytes.h"
#include "compiler/ProgramCompiler.h"
#include "compiler/RecentPrograms.h"
#include "keywords/DirectiveConditions.h"
#include "keywords/PragmaScanner.h"
#include "spirv/ScalarLayout.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace limn
{

namespace
{

/// Raised whenever the same text compiles to something else than before.
constexpr int k_CompilerVersion = 25;

std::string CacheKey(const PassProgram& program, std::span<const std::string> keywords,
                     const ShaderCompilerOptions& options)
{
    std::vector<std::string> parts = {
        std::to_string(k_CompilerVersion),
        std::to_string(HashLibrary()),
        std::filesystem::absolute(program.file).string(),
        std::to_string(HashFilesBeside(FilesBesideShader(program.file))),
        options.projectRoot.string(),
        PackagesAround(options, program.file),
        program.language == ProgramLanguage::Cg ? "cg" : "hlsl",
        program.vertex.name,
        program.fragment.name,
        program.geometry.name,
        program.kernel.name,
        std::to_string(program.target)};
    for (const auto& [name, folder] : options.packages)
    {
        parts.push_back(name + "=" + folder.string());
    }
    for (const std::filesystem::path& folder : options.includeFolders)
    {
        parts.push_back("include=" + folder.string());
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
    return std::to_string(HashContent(all));
}

/// A pass with warnings holds lines of the .shader file: it is another one once it moves.
std::string PlacedKey(const std::string& key, const PassProgram& program)
{
    std::string placed = key;
    for (const SourceChunk& chunk : program.chunks)
    {
        placed += "-" + std::to_string(chunk.firstLine);
    }
    return std::to_string(HashContent(placed));
}

/// Returns the macros that tell the library the platform and the pass.
std::vector<std::string> WithPlatform(const PassProgram& program,
                                      std::span<const std::string> keywords,
                                      const ShaderCompilerOptions& options)
{
    std::vector<std::string> all(keywords.begin(), keywords.end());
    if (const std::string_view macro = PassMacro(program.lightMode); !macro.empty())
    {
        all.emplace_back(macro);
    }
    if (!options.usesReversedZBuffer)
    {
        all.emplace_back(k_StandardZMacro);
    }
    if (options.halfIs16Bit)
    {
        all.emplace_back(k_RealHalfMacro);
    }
    return all;
}

/// @throws UnsupportedProgramError  the program has structured buffers that the device cannot read
///                                  as they lie
void RefuseScalarLayout(const PassProgram& program, const ShaderProgram& compiled,
                        const std::vector<std::string>& missingFeatures)
{
    if (compiled.layout.storageBuffers.empty() ||
        std::ranges::count(missingFeatures, k_ScalarLayoutFeature) == 0)
    {
        return;
    }
    for (const auto* spirv : {&compiled.vertexSpirv, &compiled.geometrySpirv,
                              &compiled.fragmentSpirv, &compiled.computeSpirv})
    {
        if (const std::string names = ScalarBuffers(*spirv); !names.empty())
        {
            throw UnsupportedProgramError(
                {Severity::Error, program.file, program.location,
                 "program: the device lacks scalarBlockLayout, without which it cannot read the "
                 "elements of " +
                     names +
                     " as HLSL packs them; let no vector straddle 16 bytes and pad the struct to a "
                     "multiple of 16"});
        }
    }
}

void RequireConsistent(const ShaderCompilerOptions& options)
{
    const std::string core = "com.unity.render-pipelines.core";
    if (!options.usesReversedZBuffer && options.packages.contains(core))
    {
        throw ContractError(
            "ShaderCompilerOptions: usesReversedZBuffer is false, but the package " + core +
            " is read from " + options.packages.at(core).string() +
            ", where it is always true on Vulkan; leave one of them out");
    }
    if (options.halfIs16Bit && std::ranges::count(options.missingFeatures, "native16bit") > 0)
    {
        throw ContractError("ShaderCompilerOptions: halfIs16Bit is true, but the device lacks "
                            "native16bit, shaderFloat16 and shaderInt16 in Vulkan; without them "
                            "half is float");
    }
}

/// Returns the program stored under `key`, if every file from which it was compiled is still the
/// same.
/// @param dependencies  is set to these files
std::optional<ShaderProgram> LoadProgram(const FileCache& cache, const std::string& key,
                                         std::vector<IncludeDependency>& dependencies)
{
    dependencies.clear();
    const std::optional<FileCache::Entry> entry = cache.Load(key);
    if (!entry)
    {
        return std::nullopt;
    }
    try
    {
        ByteReader reader(entry->payload());
        TransferDependencies(reader, dependencies);
        if (!std::ranges::all_of(dependencies, [](const IncludeDependency& file)
                                 { return HashFile(file.path) == file.contentHash; }))
        {
            return std::nullopt;
        }
        ShaderProgram program;
        TransferProgram(reader, program);
        cache.Touch(key);
        return program;
    }
    catch (const std::out_of_range&)
    {
        return std::nullopt; // an entry of another format with a good hash: rebuilt like a torn one
    }
}

void StoreProgram(const FileCache& cache, const std::string& key, const ShaderProgram& program,
                  const std::vector<IncludeDependency>& dependencies)
{
    if (cache.isEnabled())
    {
        ByteWriter payload;
        TransferDependencies(payload, dependencies);
        TransferProgram(payload, program);
        cache.Store(key, payload.bytes());
    }
}

} // namespace

struct ShaderCompiler::State
{
    explicit State(ShaderCompilerOptions value)
        : options(std::move(value)),
          cache(options.cacheFolder, ".limnpass", "limn pass 6\n", options.cacheLimit)
    {
        RequireConsistent(options);
    }

    const ShaderCompilerOptions options;
    const FileCache cache;
    RecentPrograms recent;
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

const ShaderCompilerOptions& ShaderCompiler::options() const
{
    return m_State->options;
}

bool ShaderCompiler::usesReversedZBuffer() const
{
    return m_State->options.usesReversedZBuffer;
}

PassProgram ShaderCompiler::ReadPragmas(const PassProgram& program) const
{
    PassProgram complete = program;
    if (std::ranges::count(program.pragmas, "include_with_pragmas", &ProgramPragma::name) > 0)
    {
        IncludeResolver resolver(m_State->options, program.file);
        ScanPragmas(complete, [&](std::string_view include, std::string_view includer)
                    { return resolver.Find(include, includer); });
    }
    return complete;
}

std::shared_ptr<const ShaderProgram> ShaderCompiler::Compile(const PassProgram& written,
                                                             std::span<const std::string> chosen)
{
    const std::vector<std::string> keywords = WithPlatform(written, chosen, m_State->options);
    const PassProgram program = ReadPragmas(written);
    if (auto reason = ReasonNotSupported(program, m_State->options.missingFeatures))
    {
        throw UnsupportedProgramError(std::move(*reason));
    }
    const std::string key = CacheKey(program, keywords, m_State->options);
    const std::string placedKey = PlacedKey(key, program);
    std::vector<IncludeDependency> dependencies;
    auto compiled = LoadProgram(m_State->cache, key, dependencies);
    if (!compiled)
    {
        compiled = LoadProgram(m_State->cache, placedKey, dependencies);
    }
    if (compiled)
    {
        ++m_State->loadedFromCache;
        m_State->Remember(dependencies);
    }
    else
    {
        IncludeResolver resolver(m_State->options, program.file);
        try
        {
            compiled = m_State->options.process
                           ? CompileInWorker(program, keywords, m_State->options, resolver)
                           : CompileProgram(program, keywords, resolver);
        }
        catch (...)
        {
            // A missing or wrong include is what a person mends next.
            m_State->Remember(resolver.dependencies());
            throw;
        }
        ++m_State->compiled;
        m_State->Remember(resolver.dependencies());
        StoreProgram(m_State->cache, compiled->diagnostics.empty() ? key : placedKey, *compiled,
                     resolver.dependencies());
    }
    RefuseScalarLayout(program, *compiled, m_State->options.missingFeatures);
    return m_State->recent.Share(key, std::move(*compiled));
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
