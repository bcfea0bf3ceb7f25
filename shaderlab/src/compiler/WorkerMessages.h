#pragma once

#include "includes/IncludeResolver.h"
#include <limn/base/ByteStream.h>

#include <limn/shaderlab/ShaderCompiler.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

// What a CompilerProcess and its workers send to each other.

/// What a worker is to compile.
struct CompilerRequest
{
    PassProgram program;
    std::vector<std::string> keywords;
    ShaderCompilerOptions options; ///< what includes are found by, and the time limit
    FilesBeside filesBeside;
};

void Transfer(ByteWriter& stream, const CompilerRequest& request);
void Transfer(ByteReader& stream, CompilerRequest& request);

enum class CompilerOutcome : char
{
    Compiled,
    Unsupported,
    MissingInclude,
    Failed,
    Ended ///< the worker did, without an answer
};

struct CompilerAnswer
{
    CompilerOutcome outcome = CompilerOutcome::Failed;
    bool isLast = false; ///< the worker takes no further request
    int waitStatus = 0;  ///< of a worker that ended, as waitpid gives it
    std::vector<IncludeDependency> dependencies;
    ShaderProgram program; ///< only its diagnostics unless it is compiled
};

void Transfer(ByteWriter& stream, const CompilerAnswer& answer);
void Transfer(ByteReader& stream, CompilerAnswer& answer);

/// Sends the number of bytes and the bytes. Returns false where the other side is gone.
bool SendMessage(int socket, std::string_view bytes);
/// Returns nothing where the other side is gone.
std::optional<std::string> ReceiveMessage(int socket);

/// Sends a file descriptor to another process. Returns false where the other side is gone.
bool SendDescriptor(int socket, int descriptor);
/// Returns -1 where the other side is gone.
int ReceiveDescriptor(int socket);

} // namespace limn
