#include "preprocess/Preprocessor.h"

#include "tokens/Lines.h"
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "desugar/Rewrites.h"
#include "keywords/DirectiveConditions.h"
#include "keywords/DynamicKeywords.h"
#include "lowering/GlslangGuards.h"
#include "preprocess/GlslangIncluder.h"
#include "preprocess/GlslangSession.h"
#include "tokens/Tokens.h"
#include <limn/base/Text.h>

#include <glslang/Public/ResourceLimits.h>

#include <algorithm>

namespace limn
{

namespace
{

void Define(std::string& source, std::string_view name, std::string_view value = "1")
{
    source.append("#define ").append(name).append(" ").append(value).append("\n");
}

/// `#pragma instancing_options procedural:F` names the function that places an instance.
void DefineProceduralFunction(std::string& source, const PassProgram& program,
                              std::span<const std::string> keywords)
{
    constexpr std::string_view k_Option = "procedural:";
    if (std::ranges::find(keywords, k_ProceduralInstancing) == keywords.end())
    {
        return;
    }
    for (const ProgramPragma& pragma : program.pragmas)
    {
        const std::size_t begin = pragma.name == "instancing_options"
                                      ? pragma.arguments.find(k_Option)
                                      : pragma.name.npos;
        if (begin != pragma.name.npos)
        {
            const std::string name = pragma.arguments.substr(begin + k_Option.size());
            Define(source, "UNITY_INSTANCING_PROCEDURAL_FUNC",
                   name.substr(0, name.find_first_of(" \t\r")));
        }
    }
}

std::string AssembleSource(const PassProgram& program, ShaderStage stage,
                           std::span<const std::string> keywords)
{
    // glslang defines it for HLSL too, and whoever asks for it writes GLSL.
    std::string source = "#undef GL_ARB_gpu_shader5\n";
    for (const auto& [name, value] : k_PredefinedMacros)
    {
        Define(source, name, value);
    }
    Define(source, stage == ShaderStage::Vertex     ? "SHADER_STAGE_VERTEX"
                   : stage == ShaderStage::Geometry ? "SHADER_STAGE_GEOMETRY"
                   : stage == ShaderStage::Compute  ? "SHADER_STAGE_COMPUTE"
                                                    : "SHADER_STAGE_FRAGMENT");
    Define(source, "SHADER_TARGET", std::to_string(program.target));
    const bool isIdentifier = std::ranges::all_of(program.vertex.name, isNameCharacter);
    if (isIdentifier && !program.vertex.name.empty())
    {
        // A library's file tells by it for which version of the library a pass was written.
        Define(source, "limn_Vertex_" + program.vertex.name);
    }
    const auto dynamic = DynamicKeywords(program);
    for (const std::string& keyword : keywords)
    {
        if (dynamic.count(keyword) == 0)
        {
            Define(source, keyword);
        }
    }
    DefineProceduralFunction(source, program, keywords);
    source += DeclareDynamicKeywords(program);
    source += "#include \"limn/Prelude.hlsl\"\n";
    if (program.language == ProgramLanguage::Cg)
    {
        source += "#include \"HLSLSupport.cginc\"\n#include \"UnityShaderVariables.cginc\"\n"
                  "#include \"UnityShaderUtilities.cginc\"\n";
    }
    for (const SourceChunk& chunk : program.chunks)
    {
        if (const auto line = FindDeepMacros(chunk.text, chunk.firstLine))
        {
            throw AssetError(program.file, {*line, 0},
                             "HLSL: this is " + DescribeDeepMacros() + "; take it apart");
        }
        source +=
            "#line " + std::to_string(chunk.firstLine) + " \"" + SwapMarks(program.file) + "\"\n";
        source += TranslateDirectives(chunk.text);
    }
    return source;
}

void ExplainIncludes(std::vector<Diagnostic>& diagnostics)
{
    constexpr std::string_view k_Start = "'#include': ";
    constexpr std::string_view k_Unsaid = "Could not process include directive";
    constexpr std::string_view k_File = " for header name: ";
    for (Diagnostic& diagnostic : diagnostics)
    {
        const std::string_view message = diagnostic.message;
        const std::size_t file = message.rfind(k_File);
        if (!message.starts_with(k_Start) || file == message.npos)
        {
            continue;
        }
        const std::string_view reason = message.substr(k_Start.size(), file - k_Start.size());
        const std::string_view name = message.substr(file + k_File.size());
        diagnostic.message =
            "#include: " + ReasonNotIncluded(name, reason == k_Unsaid ? "" : reason);
    }
}

/// Removes errors that Unity's compilers do not report: a macro that is defined anew has its new
/// meaning from there on, and a number of more than 32 bits is cut; see RespellForGlslang.
bool AllowWhatUnityAllows(std::vector<Diagnostic>& diagnostics)
{
    // Authors write what kind of pass theirs is too.
    bool hasAny =
        std::erase_if(diagnostics,
                      [](const Diagnostic& diagnostic)
                      {
                          return diagnostic.message.starts_with("'#define': Macro redefined;") &&
                                 diagnostic.message.find(k_PassMacroStart) != std::string::npos;
                      }) > 0;
    for (Diagnostic& diagnostic : diagnostics)
    {
        if (diagnostic.message.starts_with("'#define': Macro redefined;"))
        {
            const std::size_t name = diagnostic.message.rfind(' ') + 1;
            diagnostic = {Severity::Warning, diagnostic.file, diagnostic.location,
                          "'" + diagnostic.message.substr(name) +
                              "': this #define gives the macro another meaning from here on"};
            hasAny = true;
        }
        else if (diagnostic.message == "hexadecimal literal too big")
        {
            diagnostic.severity = Severity::Warning;
            diagnostic.message = "this number has more than 32 bits; only the lowest 32 count";
            hasAny = true;
        }
    }
    return hasAny;
}

/// Blanks the pragmas that are left and reports those that stand for `#warning`.
void TakePragmas(std::string& text, std::vector<Diagnostic>& warnings)
{
    for (std::size_t line = 0; line < text.size();)
    {
        const std::size_t end = std::min(text.find('\n', line), text.size());
        const std::string_view trimmed = Trim(std::string_view(text).substr(line, end - line));
        if (const auto message = ReadWarningPragma(trimmed))
        {
            const HlslPlace place = PlaceOf(text, line);
            warnings.push_back(
                {Severity::Warning, place.file, place.location, "'#warning': " + *message});
        }
        if (trimmed.starts_with("#pragma") && trimmed.find("pack_matrix") == trimmed.npos)
        {
            text.replace(line, end - line, end - line, ' ');
        }
        line = end + 1;
    }
}

/// Sorts what glslang says into warnings and what stops the compilation.
void Judge(bool good, std::vector<Diagnostic> diagnostics, const PassProgram& program,
           bool hasMissing, std::vector<Diagnostic>& warnings)
{
    const auto errors = std::stable_partition(diagnostics.begin(), diagnostics.end(),
                                              [](const Diagnostic& diagnostic)
                                              { return diagnostic.severity != Severity::Error; });
    warnings.insert(warnings.end(), diagnostics.begin(), errors);
    diagnostics.erase(diagnostics.begin(), errors);
    if (!good && diagnostics.empty())
    {
        diagnostics.push_back({Severity::Error, program.file, program.location,
                               "program: the preprocessor failed without a message"});
    }
    if (!diagnostics.empty())
    {
        ExplainIncludes(diagnostics);
        if (hasMissing)
        {
            throw MissingIncludeError(std::move(diagnostics));
        }
        throw AssetError(std::move(diagnostics));
    }
}

} // namespace

PreprocessedHlsl PreprocessHlsl(const PassProgram& program, ShaderStage stage,
                                std::span<const std::string> keywords, IncludeResolver& resolver,
                                ColumnFinder& lines, std::vector<Diagnostic>& warnings)
{
    StartGlslang();
    const std::string source = AssembleSource(program, stage, keywords);
    const char* const text = source.c_str();
    const std::string lineName = SwapMarks(program.file);
    const char* const name = lineName.c_str();
    const int size = static_cast<int>(source.size());
    glslang::TShader shader(GlslangStage(stage));
    shader.setStringsWithLengthsAndNames(&text, &size, &name, 1);
    SetEnvironment(shader, stage);
    GlslangIncluder includer(resolver);
    std::string result;
    const bool good = shader.preprocess(GetDefaultResources(), 500, ENoProfile, false, false,
                                        k_GlslangMessages, &result, includer);
    if (includer.needsHighDefinition())
    {
        throw UnsupportedProgramError(
            {Severity::Error, program.file, program.location,
             "program: it is for the High Definition Render Pipeline, which limn does not stand in "
             "for"});
    }
    std::vector<Diagnostic> diagnostics = ReadGlslangLog(shader.getInfoLog(), program.file);
    const bool isAllowed = AllowWhatUnityAllows(diagnostics);
    Judge(good || isAllowed, std::move(diagnostics), program, includer.hasMissing(), warnings);
    TakePragmas(result, warnings);
    const bool namesStages = includer.namesStages() ||
                             std::ranges::any_of(program.chunks, NamesStages, &SourceChunk::text);
    return {RespellForGlslang(std::move(result), program, lines, warnings), namesStages};
}

} // namespace limn
