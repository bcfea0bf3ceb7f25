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
    /// Where compiled passes are kept; created on first use; empty = nowhere. Entries are found by
    /// content, so the folder may be shared, copied or deleted at any time.
    std::filesystem::path cacheFolder;
    /// Folders searched before limn's own ShaderLibrary: "com.unity.render-pipelines.core" → DIR.
    std::map<std::string, std::filesystem::path> packages;
    /// Folder that "Assets/…" and "Packages/…" includes start from; empty = none, whatever the
    /// working directory is. Where they are not there, they start from the Unity project around the
    /// .shader file.
    std::filesystem::path projectRoot;
    /// Includes may lie in the project, in the packages, beside or below the .shader file, in the
    /// Unity project around it (the folder that holds `Assets`), in the package that it is part of
    /// (with a package.json), and in these; nowhere else, not even by way of a symbolic link.
    std::vector<std::filesystem::path> includeFolders = {};
    /// What the device lacks of RequiredFeatures (ProgramRequirements.h).
    std::vector<std::string> missingFeatures = {};
    /// Bytes that the entries of the cache folder may take; those not used for longest are removed
    /// when there are more. 0 = no limit.
    std::uintmax_t cacheLimit = std::uintmax_t{256} << 20;
    /// Workers of this process compile passes: a crash, a hang or more than 2 GiB of memory of the
    /// HLSL compiler is an AssetError of the pass that causes it. If it is null, the caller's own
    /// process compiles, and a crash ends it. Several compilers may share one.
    std::shared_ptr<WorkerProcess> process = nullptr;
    /// The compilation of a pass in `process` may take so long.
    std::chrono::milliseconds timeLimit = std::chrono::seconds{30};
    /// Whether depth is 1 near ... 0 far, UNITY_REVERSED_Z is defined and UNITY_NEAR_CLIP_VALUE is
    /// 1; else the other way round, as on OpenGL, to study precision. The whole pipeline goes by
    /// what its renderer's compiler has. Unity: SystemInfo.usesReversedZBuffer (2022.3).
    bool usesReversedZBuffer = true;
    /// Whether half and min16float have 16 bits where values are assigned, passed, returned and
    /// computed from nothing but halves and constants, as on phones, to study precision; else they
    /// are floats, as on Unity's desktop targets. Buffers, textures, what functions of a program
    /// hand to each other, and matrices have 32 bits in any case.
    bool halfIs16Bit = false;
};

/// Turns the HLSL of a pass into SPIR-V and its layout. All members may be called from several
/// threads at once.
class ShaderCompiler
{
public:
    /// @throws ContractError  if the depth is not reversed and `packages` holds a shader library:
    ///                        which way round it is on Vulkan stands in there; or if halfIs16Bit
    ///                        and `missingFeatures` has native16bit
    explicit ShaderCompiler(ShaderCompilerOptions options = {});
    ~ShaderCompiler();
    ShaderCompiler(const ShaderCompiler&) = delete;
    ShaderCompiler& operator=(const ShaderCompiler&) = delete;

    /// Compiles a pass for one set of keywords, or takes the result of an equal earlier call from
    /// the cache folder. Results are not kept in memory: callers hold on to what they use.
    ///
    /// @param keywords  those that are on, in any order; each becomes a macro of value 1
    /// @throws UnsupportedProgramError where limn does not do what the program asks for
    /// @throws AssetError with every message of the compiler at the line of the .shader file, or of
    ///         the included file, that causes it
    std::shared_ptr<const ShaderProgram> Compile(const PassProgram& program,
                                                 std::span<const std::string> keywords = {});

    /// The program with the pragmas of the files behind its `#include_with_pragmas` taken in, which
    /// parsing a .shader file leaves out. Compile does this by itself; keywords and variants are
    /// complete only then. Files that are missing are passed over: Compile names them.
    PassProgram ReadPragmas(const PassProgram& program) const;

    /// As in the options.
    const std::vector<std::string>& missingFeatures() const;
    bool usesReversedZBuffer() const;
    /// As it was made with.
    const ShaderCompilerOptions& options() const;

    struct Statistics
    {
        int compiled = 0;        ///< calls that ran the HLSL compiler
        int loadedFromCache = 0; ///< calls answered from the cache folder
    };
    Statistics statistics() const;

    /// The files outside limn that includes were looked for in, found or not, over all calls: a
    /// change of one may change what Compile gives.
    std::set<std::filesystem::path> includeFiles() const;

private:
    struct State;
    std::unique_ptr<State> m_State;
};

} // namespace limn
