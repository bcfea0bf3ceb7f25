#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderProgram.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace limn
{

class WorkerProcess;

struct ShaderCompilerOptions
{
    /// The folder in which compiled passes are cached. It is created on first use; empty = no
    /// cache. Entries are found by content, so the folder may be shared, copied or deleted at any
    /// time.
    std::filesystem::path cacheFolder;
    /// The folders searched before limn's own ShaderLibrary: "com.unity.render-pipelines.core" →
    /// DIR.
    std::map<std::string, std::filesystem::path> packages;
    /// The folder from which "Assets/…" and "Packages/…" includes start; empty = none, whatever the
    /// working directory is. Files that are not there are searched in the Unity project around the
    /// .shader file.
    std::filesystem::path projectRoot;
    /// Further folders in which includes may lie, beside the project, the packages, the .shader
    /// file's folder and those below, the Unity project around it (the folder that holds `Assets`),
    /// and the package that it is part of (with a package.json). They may lie nowhere else, not
    /// even through a symbolic link.
    std::vector<std::filesystem::path> includeFolders = {};
    /// The RequiredFeatures (ProgramRequirements.h) that the device lacks.
    std::vector<std::string> missingFeatures = {};
    /// The bytes that the entries of the cache folder may take; if there are more, those not used
    /// for longest are removed. 0 = no limit.
    std::uintmax_t cacheLimit = std::uintmax_t{256} << 20;
    /// Workers of this process compile passes: a crash, a hang or more than 2 GiB of memory of the
    /// HLSL compiler is an AssetError of the pass that causes it. If it is null, the caller's own
    /// process compiles, and a crash ends it. Several compilers may share one.
    std::shared_ptr<WorkerProcess> process = nullptr;
    /// The longest time that the compilation of a pass in `process` may take.
    std::chrono::milliseconds timeLimit = std::chrono::seconds{30};
    /// The direction of depth. If true, depth is 1 near ... 0 far, UNITY_REVERSED_Z is defined and
    /// UNITY_NEAR_CLIP_VALUE is 1. If false, it is the other way round, as on OpenGL, to study
    /// precision. The whole pipeline uses the setting of its renderer's compiler.
    /// Unity: SystemInfo.usesReversedZBuffer (2022.3).
    bool usesReversedZBuffer = true;
    /// Makes half and min16float 16-bit values where they are assigned, passed, returned and
    /// computed only from halves and constants, as on phones, to study precision. If false, they
    /// are floats, as on Unity's desktop targets. Buffers, textures, values passed between the
    /// stages of a program, and matrices always have 32 bits.
    bool halfIs16Bit = false;
};

/// Turns the HLSL of a pass into SPIR-V and its layout. All members may be called from several
/// threads at once.
class ShaderCompiler
{
public:
    /// @throws ContractError  if the depth is not reversed and `packages` holds a shader library,
    ///     because the library defines the direction of depth on Vulkan; or if halfIs16Bit is set
    ///     and `missingFeatures` has native16bit
    explicit ShaderCompiler(ShaderCompilerOptions options = {});
    ~ShaderCompiler();
    ShaderCompiler(const ShaderCompiler&) = delete;
    ShaderCompiler& operator=(const ShaderCompiler&) = delete;

    /// Compiles a pass for one set of keywords, or takes the result of an equal earlier call from
    /// the cache folder. If one of the last 128 results is equal, Compile returns that object.
    ///
    /// @param keywords  the keywords that are on, in any order; each becomes a macro with value 1
    /// @throws UnsupportedProgramError if limn does not support what the program asks for
    /// @throws AssetError with every message of the compiler at the line of the .shader file, or of
    ///         the included file, that causes it
    std::shared_ptr<const ShaderProgram> Compile(const PassProgram& program,
                                                 std::span<const std::string> keywords = {});

    /// Returns the program with the pragmas of the files behind its `#include_with_pragmas`, which
    /// parsing a .shader file omits. Compile does this by itself; keywords and variants are
    /// complete only then. Missing files are skipped; Compile reports them.
    PassProgram ReadPragmas(const PassProgram& program) const;

    bool usesReversedZBuffer() const;
    /// Returns the options with which it was made.
    const ShaderCompilerOptions& options() const;

    struct Statistics
    {
        int compiled = 0;        ///< calls that ran the HLSL compiler
        int loadedFromCache = 0; ///< calls answered from the cache folder
    };
    Statistics statistics() const;

    /// Returns the files outside limn that includes were searched in, found or not, over all calls.
    /// A change of one may change the result of Compile.
    std::set<std::filesystem::path> includeFiles() const;

private:
    struct State;
    std::unique_ptr<State> m_State;
};

} // namespace limn
