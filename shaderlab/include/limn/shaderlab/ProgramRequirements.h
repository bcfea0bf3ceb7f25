#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/PassProgram.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limn
{

/// Returns the features that `#pragma target` and `#pragma require` ask for, in Unity's names,
/// lower case, sorted, each once: "2darray", "compute", "derivatives" …. Features that a pragma
/// restricts to some keywords do not count. `#pragma geometry` counts as target 4.0, hull and
/// domain as 4.6. For a kernel they are "compute" and those of `#pragma require`.
std::vector<std::string> RequiredFeatures(const PassProgram& program);

/// Returns why limn does not compile this program although it is well formed: it is GLSL, has a
/// surface function or a stage other than vertex, geometry and fragment, its renderers are neither
/// Vulkan nor Direct3D 11, or a feature is missing. Returns nullopt if it can be compiled. The
/// severity is Error, and the message is one sentence.
///
/// @param missingFeatures  the RequiredFeatures that the device lacks; names such as "compute
///     wavebasic" are features that it lacks in kernels
std::optional<Diagnostic> ReasonNotSupported(const PassProgram& program,
                                             std::span<const std::string> missingFeatures = {});

/// Returns warnings for unknown pragmas, features and renderers, with the nearest known name.
/// Pragmas that are obsolete or concern other tools are known. Also returns warnings for `#if` and
/// similar directives that test a keyword of a dynamic_branch.
std::vector<Diagnostic> CheckPragmas(const PassProgram& program);

} // namespace limn
