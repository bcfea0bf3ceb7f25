#include "spirv/SpirvBuilder.h"

#include "hlsl/TokenEdits.h"
#include "preprocess/GlslangLog.h"
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

/// Calls a function with each instruction's number, opcode and operands until it returns false.
template <typename F>
void ForEachInstruction(const std::vector<std::uint32_t>& spirv, F&& each)
{
    constexpr std::size_t k_Header = 5; // words
    std::size_t number = 0;
    for (std::size_t word = k_Header; word < spirv.size();)
    {
        const std::size_t size = std::clamp<std::size_t>(spirv[word] >> 16, 1, spirv.size() - word);
        const auto operands = std::span(spirv).subspan(word + 1, size - 1);
        if (!each(++number, spirv[word] & 0xffff, operands))
        {
            return;
        }
        word += size;
    }
}

/// Returns whether any id of the module is decorated with RelaxedPrecision: only those of min16
/// types.
bool hasRelaxedPrecision(const std::vector<std::uint32_t>& spirv)
{
    bool found = false;
    ForEachInstruction(
        spirv,
        [&](std::size_t, std::uint32_t operation, std::span<const std::uint32_t> operands)
        {
            found = found || (operation == spv::OpDecorate &&
                              operands[1] == spv::DecorationRelaxedPrecision);
            return !found && operation != spv::OpFunction;
        });
    return found;
}

/// Returns whether the module has variables of its own that are arrays or hold some.
bool hasArrayVariables(const std::vector<std::uint32_t>& spirv)
{
    std::set<std::uint32_t> arrays; // types
    bool found = false;
    ForEachInstruction(
        spirv,
        [&](std::size_t, std::uint32_t operation, std::span<const std::uint32_t> operands)
        {
            const auto isArray = [&](std::uint32_t type)
            {
                return arrays.contains(type);
            };
            if (operation == spv::OpTypeArray ||
                (operation == spv::OpTypeStruct && std::ranges::any_of(operands, isArray)))
            {
                arrays.insert(operands[0]);
            }
            found = found || (operation == spv::OpTypePointer && isArray(operands[2]) &&
                              (operands[1] == spv::StorageClassFunction ||
                               operands[1] == spv::StorageClassPrivate));
            return !found && operation != spv::OpFunction;
        });
    return found;
}

/// Gives the module without RelaxedPrecision at variables. spirv-opt does not split those that have
/// it, and crashes (2023.1) on an array that is put together in parts of different depth. What is
/// computed keeps its own RelaxedPrecision.
std::vector<std::uint32_t> WithoutRelaxedVariables(const std::vector<std::uint32_t>& spirv)
{
    std::set<std::uint32_t> variables;
    ForEachInstruction(
        spirv,
        [&](std::size_t, std::uint32_t operation, std::span<const std::uint32_t> operands)
        {
            if (operation == spv::OpVariable)
            {
                variables.insert(operands[1]);
            }
            return true;
        });
    constexpr std::ptrdiff_t k_Header = 5; // words
    std::vector<std::uint32_t> result(spirv.begin(), spirv.begin() + k_Header);
    ForEachInstruction(
        spirv,
        [&](std::size_t, std::uint32_t operation, std::span<const std::uint32_t> operands)
        {
            const bool isLeftOut = operation == spv::OpDecorate &&
                                   operands[1] == spv::DecorationRelaxedPrecision &&
                                   variables.contains(operands[0]);
            if (!isLeftOut)
            {
                const auto size = static_cast<std::uint32_t>(operands.size() + 1);
                result.push_back(size << 16 | operation);
                result.insert(result.end(), operands.begin(), operands.end());
            }
            return true;
        });
    return result;
}

std::vector<std::uint32_t> Optimize(const std::vector<std::uint32_t>& spirv,
                                    std::string_view passes, const std::string& file)
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
    std::vector<std::uint32_t> optimized;
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
std::optional<SpirvProblem> Validate(const std::vector<std::uint32_t>& spirv, bool isOptimised,
                                     bool withNames)
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
    problem.message.resize(std::min(problem.message.find('\n'), problem.message.size()));
    return problem;
}

std::optional<SpirvProblem> FindProblem(const std::vector<std::uint32_t>& spirv, bool isOptimised)
{
    const bool isValid = !Validate(spirv, isOptimised, false);
    return isValid ? std::nullopt : Validate(spirv, isOptimised, true);
}

/// Returns the place of an instruction in the HLSL, by the OpLine before it.
HlslPlace PlaceOfInstruction(const std::vector<std::uint32_t>& spirv, std::size_t instruction)
{
    std::map<std::uint32_t, std::string> strings;
    HlslPlace place;
    ForEachInstruction(
        spirv,
        [&](std::size_t number, std::uint32_t operation, std::span<const std::uint32_t> operands)
        {
            if (operation == spv::OpString && operands.size() > 1)
            {
                const auto* text = reinterpret_cast<const char*>(&operands[1]);
                strings[operands[0]] = std::string(text, strnlen(text, (operands.size() - 1) * 4));
            }
            else if (operation == spv::OpLine && operands.size() == 3)
            {
                place = {strings[operands[0]], {static_cast<int>(operands[1]), 0}};
            }
            return number < instruction;
        });
    return place;
}

/// SPIR-V has no matrices of integers, and glslang makes them all the same.
bool hasIntegerMatrices(const std::vector<std::uint32_t>& spirv)
{
    std::set<std::uint32_t> floats; // types: scalars and vectors
    bool found = false;
    ForEachInstruction(
        spirv,
        [&](std::size_t, std::uint32_t operation, std::span<const std::uint32_t> operands)
        {
            const bool isVector = operation == spv::OpTypeVector;
            if (operation == spv::OpTypeFloat || (isVector && floats.count(operands[1]) > 0))
            {
                floats.insert(operands[0]);
            }
            found = found || (operation == spv::OpTypeMatrix && floats.count(operands[1]) == 0);
            return !found && operation != spv::OpFunction;
        });
    return found;
}

std::vector<std::uint32_t> Generate(const glslang::TProgram& program, ShaderStage stage,
                                    bool withLines)
{
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    options.generateDebugInfo = withLines;
    std::vector<std::uint32_t> spirv;
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
std::optional<SpirvProblem> OptimizeChecked(std::vector<std::uint32_t>& spirv,
                                            const std::string& file)
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
    if (hasRelaxedPrecision(spirv))
    {
        spirv = WithoutRelaxedVariables(spirv);
    }
    std::vector<std::uint32_t> optimized = Optimize(spirv, k_FewPasses, file);
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
    std::vector<std::uint32_t> spirv = Generate(program, stage, true);
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
    for (Diagnostic& warning : ReadGlslangLog(shader.getInfoLog(), file))
    {
        warnings.push_back(std::move(warning));
    }
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(k_GlslangMessages) || !program.mapIO())
    {
        ThrowLog(program.getInfoLog(), file, "linking");
    }
    std::vector<std::uint32_t> spirv = Generate(program, stage, false);
    if (halfIs16Bit)
    {
        spirv = UseHalfPrecision(spirv);
    }
    if (const auto problem = OptimizeChecked(spirv, file))
    {
        ThrowInvalid(program, stage, file, *problem);
    }
    return spirv;
}

} // namespace limn
