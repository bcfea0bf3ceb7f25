#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/ShaderProgram.h>

#include <string>
#include <vector>

namespace limn
{

enum class ProgramLanguage
{
    Hlsl, ///< HLSLPROGRAM: includes nothing by itself
    Cg,   ///< CGPROGRAM: HLSLSupport, UnityShaderVariables and UnityShaderUtilities come first
    Glsl  ///< GLSLPROGRAM: kept as text, never compiled
};

/// The text of a program as it is in the file, from behind the opening keyword to the closing one.
struct SourceChunk
{
    std::string text;
    int firstLine = 1; ///< the line of the file in which `text` starts

    bool operator==(const SourceChunk&) const = default;
};

/// A `#pragma multi_compile…` or `shader_feature…` line: exactly one of `keywords` is on at a time.
/// A shortcut such as `multi_compile_fwdbase` makes several sets from one line.
struct KeywordSet
{
    SourceLocation location;
    std::string directive;             ///< as written, e.g. "shader_feature_local_fragment"
    std::vector<std::string> keywords; ///< "" = no keyword; the first entry is the default
    /// The stages that the suffix names. Like Unity for Vulkan, limn nevertheless defines the
    /// keyword in all stages. None stands for a stage that limn does not have.
    ShaderStage stages = ShaderStage::Both;
    bool isLocal = false;
    bool isFeature = false; ///< shader_feature: built only if a material uses it
    /// If true, it makes no variants; its keywords are uniforms, see k_DynamicKeywordBuffer.
    bool isDynamic = false;

    bool operator==(const KeywordSet&) const = default;
};

/// A function name from `#pragma vertex`, `fragment`, `geometry` or `kernel`; "" = no such pragma.
struct EntryPoint
{
    std::string name;
    SourceLocation location;

    bool operator==(const EntryPoint&) const = default;
};

/// A pragma that is kept but has no field of its own, e.g. {"instancing_options",
/// "renderinglayer"}. `#include_with_pragmas "x"` counts as one.
struct ProgramPragma
{
    SourceLocation location;
    std::string name;
    std::string arguments;

    bool operator==(const ProgramPragma&) const = default;
};

/// Everything that is needed to compile the program of a pass (the include blocks in scope, then
/// its own text) or one kernel of a compute shader. A pragma counts if the `#if` around it holds by
/// the program's own macros and the platform's. Pragmas of files behind `#include_with_pragmas` are
/// missing; ShaderCompiler::ReadPragmas adds them.
struct PassProgram
{
    std::string file; ///< path of the .shader file; relative includes start from its folder
    SourceLocation location;
    ProgramLanguage language = ProgramLanguage::Hlsl;
    std::vector<SourceChunk> chunks;
    EntryPoint vertex;
    EntryPoint fragment;
    EntryPoint geometry;
    EntryPoint kernel; ///< the only function of a compute shader's program (ComputeDocument.h)
    int target = 25;   ///< `#pragma target` times ten
    /// The LightMode tag of its pass, "" without one. The tags of the built-in pipeline define a
    /// macro: "ShadowCaster" defines UNITY_PASS_SHADOWCASTER.
    std::string lightMode;
    std::vector<KeywordSet> keywordSets;
    std::vector<ProgramPragma> pragmas;

    bool operator==(const PassProgram&) const = default;
};

} // namespace limn
