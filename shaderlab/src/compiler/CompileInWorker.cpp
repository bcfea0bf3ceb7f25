#include "compiler/CompileInWorker.h"

#include <limn/base/WorkerProcess.h>
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "compiler/ProgramCompiler.h"
#include "compiler/WorkerMessages.h"
#include "preprocess/GlslangSession.h"

#include <cstdlib>
#include <string_view>

namespace limn
{

namespace
{

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
    IncludeResolver resolver(request.options, request.program.file);
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
    Transfer(reader, request);
    AbortForTest(request.program.file);
    ByteWriter writer;
    Transfer(writer, Compile(request));
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
    ByteWriter writer;
    Transfer(writer,
             CompilerRequest{
                 program, {keywords.begin(), keywords.end()}, options, resolver.filesBeside()});
    const WorkerAnswer bytes =
        options.process->Run({Work, StartGlslang, options.timeLimit}, writer.bytes());
    if (bytes.ending != WorkerAnswer::Ending::Answered)
    {
        throw AssetError({ProgramError(program, ReasonOfEnd(bytes, options.timeLimit))});
    }
    CompilerAnswer answer;
    ByteReader reader(bytes.bytes);
    Transfer(reader, answer);
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
