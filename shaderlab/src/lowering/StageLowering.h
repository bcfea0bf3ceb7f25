#pragma once

#include "hlsl/Globals.h"
#include "stages/EntryPointWriter.h"

#include <map>
#include <string>
#include <vector>

namespace limn
{

/// Preprocessed HLSL, parsed as far as rewriting needs it.
struct HlslSource
{
    /// @param lines  see HlslTokens
    explicit HlslSource(std::string preprocessed, ColumnFinder* lines = nullptr);
    HlslSource(const HlslSource&) = delete;
    HlslSource& operator=(const HlslSource&) = delete;

    const std::string text;
    const HlslTokens tokens;             ///< into text
    const HlslDeclarations declarations; ///< into text
    const HlslGlobals globals;           ///< into declarations
};

struct RewrittenHlsl
{
    /// The text of TokenEdits::AssembleByToken(), and the entry function.
    std::string text;
    /// The notes "it uses X, which limn does not have: Y" for each function that the entry function
    /// reaches and that the ShaderLibrary marks `[limn_Lacks("X", "Y")]`, because it does less than
    /// Unity's function of that name.
    std::vector<std::string> standIns;
    /// The tokens of types and names that are not declared, and the messages about the names. They
    /// are mistakes if the compiler finds any; it stops at the first unknown name.
    std::vector<std::size_t> unknownTypes;
    std::map<std::size_t, std::string> unknownNames;
    /// The expressions and statements of the source that were rewritten.
    HlslNodes nodes;
};

/// Returns the HLSL for the compiler: only functions that the entry function reaches, writable
/// copies of uniforms that the code assigns to, and a generated entry function k_EntryName at the
/// end.
///
/// Functions out of reach must be removed because they may use what only the other stage has (ddx,
/// clip).
///
/// @throws UnsupportedProgramError  if the stage uses a texture or buffer that can be written to
RewrittenHlsl RewriteStage(const HlslSource& source, ShaderStage stage,
                           const StageInterface& interface, const StageLinkage& linkage);

/// Returns the HLSL of a kernel like RewriteStage, with everything that it may write to.
///
/// @throws AssetError  if it reads what only draws have, or lacks its [numthreads(x, y, z)]
RewrittenHlsl RewriteKernel(const HlslSource& source, const HlslFunction& kernel);

} // namespace limn
