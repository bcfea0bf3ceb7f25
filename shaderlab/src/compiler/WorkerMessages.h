#pragma once

#include "includes/IncludeResolver.h"
#include <limn/base/ByteStream.h>

#include <limn/shaderlab/ShaderCompiler.h>

#include <string>
#include <vector>

namespace limn
{

// The messages between CompileInWorker and its workers.

/// The program that a worker must compile.
struct CompilerRequest
{
    PassProgram program;
    std::vector<std::string> keywords;
    ShaderCompilerOptions options; ///< the options by which includes are found, and the time limit
    FilesBeside filesBeside;
};

void Transfer(ByteWriter& stream, const CompilerRequest& request);
void Transfer(ByteReader& stream, CompilerRequest& request);

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

void Transfer(ByteWriter& stream, const CompilerAnswer& answer);
void Transfer(ByteReader& stream, CompilerAnswer& answer);

} // namespace limn
