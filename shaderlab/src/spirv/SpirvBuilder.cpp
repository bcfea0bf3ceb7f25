#include "spirv/SpirvBuilder.h"

#include "hlsl/rewrites/Conversions.h"
#include "spirv/GlslangLog.h"
#include "spirv/GlslangSession.h"
#include "stages/EntryPointWriter.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

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

/// Inlining and dead-code removal decide which resources and inputs a pass really has, and make
/// textures that travel through function parameters legal for Vulkan.
void Optimize(std::vector<std::uint32_t>& spirv, const std::string& file)
{
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    std::string messages;
    optimizer.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t&, const char* message)
        { messages.append(message).append("\n"); });
    optimizer.RegisterLegalizationPasses();
    optimizer.RegisterPerformancePasses();
    optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass());
    optimizer.RegisterPass(spvtools::CreateRemoveUnusedInterfaceVariablesPass());
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    std::vector<std::uint32_t> optimized;
    if (!optimizer.Run(spirv.data(), spirv.size(), &optimized, options))
    {
        ThrowLog(messages, file, "optimising");
    }
    spirv = std::move(optimized);
}

/// glslang 12 takes some HLSL that it has no valid SPIR-V for; drivers may do anything with it.
void RequireValid(const std::vector<std::uint32_t>& spirv, const std::string& file)
{
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_1);
    std::string messages;
    tools.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t&, const char* message)
        { messages.append(messages.empty() ? "" : "; ").append(message); });
    if (!tools.Validate(spirv))
    {
        throw AssetError(file, {},
                         "program: the HLSL compiler makes invalid SPIR-V of it: " +
                             messages.substr(0, messages.find('\n')));
    }
}

/// The functions that glslang has found no overload of.
std::set<std::string> UnmatchedCalls(const std::vector<Diagnostic>& diagnostics)
{
    constexpr std::string_view k_Reason = "': no matching overloaded function found";
    std::set<std::string> names;
    for (const Diagnostic& diagnostic : diagnostics)
    {
        const std::size_t reason = diagnostic.message.find(k_Reason);
        if (reason != std::string::npos && diagnostic.message[0] == '\'')
        {
            names.insert(diagnostic.message.substr(1, reason - 1));
        }
    }
    return names;
}

std::vector<std::uint32_t> Build(const std::string& hlsl, ShaderStage stage,
                                 const std::string& file, std::vector<Diagnostic>& warnings)
{
    StartGlslang();
    const char* const text = hlsl.c_str();
    const char* const name = file.c_str();
    const int size = static_cast<int>(hlsl.size());
    glslang::TShader shader(GlslangStage(stage));
    shader.setStringsWithLengthsAndNames(&text, &size, &name, 1);
    SetEnvironment(shader, stage);
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
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    std::vector<std::uint32_t> spirv;
    glslang::GlslangToSpv(*program.getIntermediate(GlslangStage(stage)), spirv, &options);
    Optimize(spirv, file);
    RequireValid(spirv, file);
    return spirv;
}

} // namespace

std::vector<std::uint32_t> BuildSpirv(const std::string& hlsl, ShaderStage stage,
                                      const std::string& file, std::vector<Diagnostic>& warnings)
{
    // glslang stops at the first call that it cannot make.
    std::set<std::string> unmatched;
    for (std::string text = hlsl;;)
    {
        try
        {
            return Build(text, stage, file, warnings);
        }
        catch (const AssetError& error)
        {
            unmatched.merge(UnmatchedCalls(error.diagnostics()));
            std::string converted = AddConversions(hlsl, unmatched);
            if (converted == text)
            {
                throw;
            }
            text = std::move(converted);
        }
    }
}

} // namespace limn
