#include "spirv/SpirvBuilder.h"

#include "hlsl/TokenEdits.h"
#include "preprocess/GlslangSession.h"
#include "spirv/Arithmetic.h"
#include "spirv/HalfPrecision.h"
#include "spirv/StorageAccess.h"
#include "stages/EntryPointWriter.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <glslang/SPIRV/spirv.hpp>
#include <limn/base/WordList.h>
#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace limn
{

namespace
{

[[noreturn]] void ThrowLog(std::string_view log, const std::string& file, std::string_view step)
{
    std::vector<Diagnostic> diagnostics = ReadGlslangLog(log, file);
    if (diagnostics.empty())
    {
        diagnostics.push_back({Severity::Error,
                               file,
                               {},
                               "program: " + std::string(step) + " failed: " + std::string(log)});
    }
    throw AssetError(std::move(diagnostics));
}

/// Inlining and dead-code removal decide which resources and inputs a pass really has. These passes
/// leave as little as all of spirv-opt's for legal and fast SPIR-V, in half the time.
constexpr std::string_view k_FewPasses =
    "--wrap-opkill --eliminate-dead-branches --merge-return --inline-entry-points-exhaustive "
    "--eliminate-dead-functions --private-to-local --scalar-replacement=0 --ssa-rewrite --ccp "
    "--loop-unroll --eliminate-dead-branches --convert-local-access-chains "
    "--eliminate-local-single-block --eliminate-local-single-store --copy-propagate-arrays "
    "--redundancy-elimination --simplify-instructions --merge-blocks";

/// The optimizer's pass before which arrays are split once more, because their indices are known by
/// then.
constexpr std::string_view k_PassBehindKnownIndices = "--convert-local-access-chains";

/// The passes that make textures in structs and parameters legal for Vulkan.
constexpr std::string_view k_AllPasses = "--legalize-hlsl -O";

/// Returns whether the module has variables of its own that are arrays or hold some.
bool hasArrayVariables(const SpirvWords& spirv)
{
    std::set<Id> arrays; // types
    bool found = false;
    ForEachDeclaration(
        spirv,
        [&](std::uint32_t op, std::span<const std::uint32_t> words)
        {
            const auto isArray = [&](Id type)
            {
                return arrays.contains(type);
            };
            if (op == spv::OpTypeArray ||
                (op == spv::OpTypeStruct && std::ranges::any_of(words.subspan(2), isArray)))
            {
                arrays.insert(words[1]);
            }
            found =
                found ||
                (op == spv::OpTypePointer && isArray(words[3]) &&
                 (words[2] == spv::StorageClassFunction || words[2] == spv::StorageClassPrivate));
        });
    return found;
}

/// Gives the module without RelaxedPrecision at variables: those of min16 types have it. spirv-opt
/// does not split such variables, and crashes (2023.1) on an array that is put together in parts of
/// different depth. What is computed keeps its own RelaxedPrecision.
SpirvWords WithoutRelaxedVariables(const SpirvWords& spirv)
{
    std::set<Id> variables;
    ForEachInstruction(spirv,
                       [&](std::uint32_t op, std::span<const std::uint32_t> words)
                       {
                           if (op == spv::OpVariable)
                           {
                               variables.insert(words[2]);
                           }
                       });
    SpirvWords result(spirv.begin(), spirv.begin() + k_SpirvHeaderSize);
    ForEachInstruction(spirv,
                       [&](std::uint32_t op, std::span<const std::uint32_t> words)
                       {
                           if (op != spv::OpDecorate ||
                               words[2] != spv::DecorationRelaxedPrecision ||
                               !variables.contains(words[1]))
                           {
                               result.insert(result.end(), words.begin(), words.end());
                           }
                       });
    return result;
}

SpirvWords Optimize(const SpirvWords& spirv, std::string_view passes, const std::string& file)
{
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    std::string messages;
    optimizer.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t&, const char* message)
        { messages.append(message).append("\n"); });
    for (const std::string_view pass : SplitWords(passes))
    {
        if (pass == k_PassBehindKnownIndices && hasArrayVariables(spirv))
        {
            optimizer.RegisterPassFromFlag("--scalar-replacement=0");
        }
        optimizer.RegisterPassFromFlag(std::string(pass));
    }
    optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass());
    optimizer.RegisterPass(spvtools::CreateRemoveUnusedInterfaceVariablesPass());
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    SpirvWords optimized;
    if (!optimizer.Run(spirv.data(), spirv.size(), &optimized, options))
    {
        ThrowLog(messages, file, "optimising");
    }
    return optimized;
}

struct SpirvProblem
{
    std::string message;
    std::size_t instruction = 0; ///< 1 = the first
};

/// glslang 12 takes some HLSL that it has no valid SPIR-V for; drivers may do anything with it.
///
/// @param isOptimised  before that, textures may travel through variables and parameters
/// @param withNames    for what is wrong; looking all of them up takes a quarter of the time
std::optional<SpirvProblem> FindProblem(const SpirvWords& spirv, bool isOptimised,
                                        bool withNames = false)
{
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_1);
    SpirvProblem problem;
    tools.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t& position, const char* message)
        {
            problem.message.append(problem.message.empty() ? "" : "; ").append(message);
            problem.instruction = position.index;
        });
    spvtools::ValidatorOptions options;
    options.SetBeforeHlslLegalization(!isOptimised);
    options.SetScalarBlockLayout(true); // see PackStructuredBuffers
    options.SetFriendlyNames(withNames);
    if (tools.Validate(spirv.data(), spirv.size(), options))
    {
        return std::nullopt;
    }
    if (!withNames)
    {
        return FindProblem(spirv, isOptimised, true);
    }
    problem.message.resize(std::min(problem.message.find('\n'), problem.message.size()));
    return problem;
}

/// Returns the place of an instruction in the HLSL, by the OpLine before it.
HlslPlace PlaceOfInstruction(const SpirvWords& spirv, std::size_t instruction)
{
    std::map<Id, std::string> strings;
    HlslPlace place;
    std::size_t number = 0;
    ForEachInstruction(spirv,
                       [&](std::uint32_t op, std::span<const std::uint32_t> words)
                       {
                           if (number++ >= instruction)
                           {
                               return;
                           }
                           if (op == spv::OpString && words.size() > 2)
                           {
                               const auto* text = reinterpret_cast<const char*>(&words[2]);
                               strings[words[1]] =
                                   std::string(text, strnlen(text, (words.size() - 2) * 4));
                           }
                           else if (op == spv::OpLine && words.size() == 4)
                           {
                               place = {strings[words[1]], {static_cast<int>(words[2]), 0}};
                           }
                       });
    return place;
}

/// SPIR-V has no matrices of integers, and glslang makes them all the same.
bool hasIntegerMatrices(const SpirvWords& spirv)
{
    std::set<Id> floats; // types: scalars and vectors
    bool found = false;
    ForEachDeclaration(spirv,
                       [&](std::uint32_t op, std::span<const std::uint32_t> words)
                       {
                           if (op == spv::OpTypeFloat ||
                               (op == spv::OpTypeVector && floats.contains(words[2])))
                           {
                               floats.insert(words[1]);
                           }
                           found = found || (op == spv::OpTypeMatrix && !floats.contains(words[2]));
                       });
    return found;
}

SpirvWords Generate(const glslang::TProgram& program, ShaderStage stage, bool withLines)
{
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    options.generateDebugInfo = withLines;
    SpirvWords spirv;
    glslang::GlslangToSpv(*program.getIntermediate(GlslangStage(stage)), spirv, &options);
    PackStructuredBuffers(spirv);
    UseDirect3DArithmetic(spirv);
    if (stage == ShaderStage::Compute)
    {
        ConvertAtomicValues(spirv);
        LeaveImageFormatsOpen(spirv);
    }
    return spirv;
}

/// @param spirv  is optimised where that is how far it gets
std::optional<SpirvProblem> OptimizeChecked(SpirvWords& spirv, const std::string& file)
{
    // The code is checked before it is optimised, because the optimiser may remove a fault together
    // with the effect that the code was to have. Constant matrices of integers are valid once they
    // are removed.
    auto problem = hasIntegerMatrices(spirv) ? std::nullopt : FindProblem(spirv, false);
    if (problem && MergeComparedTextures(spirv))
    {
        problem = FindProblem(spirv, false);
    }
    if (problem)
    {
        return problem;
    }
    spirv = WithoutRelaxedVariables(spirv);
    SpirvWords optimized = Optimize(spirv, k_FewPasses, file);
    problem = FindProblem(optimized, true);
    if (problem)
    {
        optimized = Optimize(spirv, k_AllPasses, file);
        problem = FindProblem(optimized, true);
    }
    spirv = std::move(optimized);
    return problem;
}

[[noreturn]] void ThrowInvalid(const glslang::TProgram& program, ShaderStage stage,
                               const std::string& file, const SpirvProblem& problem)
{
    SpirvWords spirv = Generate(program, stage, true);
    const auto placed = OptimizeChecked(spirv, file);
    const HlslPlace place = placed ? PlaceOfInstruction(spirv, placed->instruction) : HlslPlace();
    const bool hasPlace = !place.file.empty() && place.location.line > 0;
    throw AssetError(hasPlace ? place.file : file, hasPlace ? place.location : SourceLocation(),
                     "program: the HLSL compiler turns this code into invalid SPIR-V: " +
                         problem.message);
}

} // namespace

std::vector<std::uint32_t> BuildSpirv(const std::string& hlsl, ShaderStage stage,
                                      const std::string& file, bool halfIs16Bit,
                                      std::vector<Diagnostic>& warnings)
{
    StartGlslang();
    const char* const text = hlsl.c_str();
    const char* const name = k_TokenFile;
    const int size = static_cast<int>(hlsl.size());
    glslang::TShader shader(GlslangStage(stage));
    shader.setStringsWithLengthsAndNames(&text, &size, &name, 1);
    SetEnvironment(shader, stage);
    shader.setPreamble(HalfPreamble(halfIs16Bit));
    shader.setEntryPoint("main");
    shader.setSourceEntryPoint(std::string(k_EntryName).c_str());
    shader.setAutoMapBindings(true);
    if (!shader.parse(GetDefaultResources(), 500, false, k_GlslangMessages))
    {
        ThrowLog(shader.getInfoLog(), file, "compiling");
    }
    const std::vector<Diagnostic> found = ReadGlslangLog(shader.getInfoLog(), file);
    warnings.insert(warnings.end(), found.begin(), found.end());
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(k_GlslangMessages) || !program.mapIO())
    {
        ThrowLog(program.getInfoLog(), file, "linking");
    }
    SpirvWords spirv = Generate(program, stage, false);
    if (halfIs16Bit)
    {
        UseHalfPrecision(spirv);
    }
    if (const auto problem = OptimizeChecked(spirv, file))
    {
        ThrowInvalid(program, stage, file, *problem);
    }
    return spirv;
}

} // namespace limn
