#include "compiler/ProgramCompiler.h"

#include <limn/base/WorkerProcess.h>
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "compiler/ProgramBytes.h"
#include "preprocess/GlslangSession.h"

#include <cstdlib>
#include <string_view>

namespace limn
{

namespace
{

/// The program that a worker must compile, and what its includes are found by.
struct CompilerRequest
{
    PassProgram program;
    std::vector<std::string> keywords;
    std::vector<std::pair<std::string, std::string>> packages; ///< name and folder
    std::string projectRoot;
    std::vector<std::string> includeFolders;
    FilesBeside filesBeside;
};

template <typename Stream, typename Request>
void TransferRequest(Stream& stream, Request& request)
{
    TransferSource(stream, request.program);
    stream.List(request.keywords, [&](auto& keyword) { stream.Value(keyword); });
    stream.List(request.packages,
                [&](auto& package) { stream.Values(package.first, package.second); });
    stream.Value(request.projectRoot);
    stream.List(request.includeFolders, [&](auto& folder) { stream.Value(folder); });
    stream.List(request.filesBeside, [&](auto& file) { stream.Values(file.name, file.text); });
}

enum class CompilerOutcome : char
{
    Compiled,
    Unsupported,
    MissingInclude,
    Failed
};

struct CompilerAnswer
{
    CompilerOutcome outcome = CompilerOutcome::Failed;
    std::vector<IncludeDependency> dependencies;
    ShaderProgram program; ///< only its diagnostics unless it is compiled
};

template <typename Stream, typename Answer>
void TransferAnswer(Stream& stream, Answer& answer)
{
    stream.Value(answer.outcome);
    TransferDependencies(stream, answer.dependencies);
    TransferProgram(stream, answer.program);
}

Diagnostic ProgramError(const PassProgram& program, const std::string& reason)
{
    return {Severity::Error, program.file, program.location, "program: " + reason};
}

CompilerAnswer Compile(const CompilerRequest& request)
{
    CompilerAnswer answer;
    const auto fail = [&](CompilerOutcome outcome, std::vector<Diagnostic> diagnostics)
    {
        answer.outcome = outcome;
        answer.program.diagnostics = std::move(diagnostics);
    };
    ShaderCompilerOptions options;
    options.packages.insert(request.packages.begin(), request.packages.end());
    options.projectRoot = request.projectRoot;
    options.includeFolders.assign(request.includeFolders.begin(), request.includeFolders.end());
    IncludeResolver resolver(options, request.program.file);
    resolver.SetFilesBeside(request.filesBeside);
    try
    {
        answer.program = CompileProgram(request.program, request.keywords, resolver);
        answer.outcome = CompilerOutcome::Compiled;
    }
    catch (const UnsupportedProgramError& error)
    {
        fail(CompilerOutcome::Unsupported, error.diagnostics());
    }
    catch (const MissingIncludeError& error)
    {
        fail(CompilerOutcome::MissingInclude, error.diagnostics());
    }
    catch (const AssetError& error)
    {
        fail(CompilerOutcome::Failed, error.diagnostics());
    }
    catch (const std::bad_alloc&)
    {
        fail(CompilerOutcome::Failed,
             {ProgramError(request.program, "compiling it takes more memory than there is for it, "
                                            "2 GiB at most; make it smaller")});
    }
    catch (const std::exception& error)
    {
        fail(CompilerOutcome::Failed,
             {ProgramError(request.program,
                           "the HLSL compiler failed: " + std::string(error.what()))});
    }
    answer.dependencies = resolver.dependencies();
    return answer;
}

void AbortForTest(const std::string& file)
{
    const char* const name = std::getenv("LIMN_TEST_ABORT");
    if (name && *name && file.ends_with(name))
    {
        std::abort();
    }
}

std::string Work(std::string_view bytes)
{
    CompilerRequest request;
    ByteReader reader(bytes);
    TransferRequest(reader, request);
    AbortForTest(request.program.file);
    const CompilerAnswer answer = Compile(request);
    ByteWriter writer;
    TransferAnswer(writer, answer);
    return writer.bytes();
}

std::string ReasonOfEnd(const WorkerAnswer& answer, std::chrono::milliseconds limit)
{
    switch (answer.ending)
    {
    case WorkerAnswer::Ending::OutOfTime:
        return "compiling it takes longer than " + std::to_string(limit.count()) +
               " ms; make it smaller";
    case WorkerAnswer::Ending::NotStarted:
        return "no process for the HLSL compiler can be started";
    case WorkerAnswer::Ending::Signal:
        return "the HLSL compiler crashes on it: " + SignalText(answer.number);
    default:
        return "the HLSL compiler ends with exit code " + std::to_string(answer.number);
    }
}

} // namespace

ShaderProgram CompileInWorker(const PassProgram& program, std::span<const std::string> keywords,
                              const ShaderCompilerOptions& options, IncludeResolver& resolver)
{
    CompilerRequest request{program, {keywords.begin(), keywords.end()},
                            {},      options.projectRoot.string(),
                            {},      resolver.filesBeside()};
    for (const auto& [name, folder] : options.packages)
    {
        request.packages.emplace_back(name, folder.string());
    }
    for (const std::filesystem::path& folder : options.includeFolders)
    {
        request.includeFolders.push_back(folder.string());
    }
    ByteWriter writer;
    TransferRequest(writer, request);
    const WorkerAnswer bytes =
        options.process->Run({Work, StartGlslang, options.timeLimit}, writer.bytes());
    if (bytes.ending != WorkerAnswer::Ending::Answered)
    {
        throw AssetError({ProgramError(program, ReasonOfEnd(bytes, options.timeLimit))});
    }
    CompilerAnswer answer;
    ByteReader reader(bytes.bytes);
    TransferAnswer(reader, answer);
    resolver.SetDependencies(std::move(answer.dependencies));
    std::vector<Diagnostic>& diagnostics = answer.program.diagnostics;
    switch (answer.outcome)
    {
    case CompilerOutcome::Compiled:
        return std::move(answer.program);
    case CompilerOutcome::Unsupported:
        throw UnsupportedProgramError(diagnostics.at(0));
    case CompilerOutcome::MissingInclude:
        throw MissingIncludeError(std::move(diagnostics));
    case CompilerOutcome::Failed:
        break;
    }
    throw AssetError(std::move(diagnostics));
}

} // namespace limn
