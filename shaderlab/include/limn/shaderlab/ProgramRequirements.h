#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/PassProgram.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limn
{

/// The features that `#pragma target` and `#pragma require` ask for, in Unity's names, lower case,
/// sorted, each once: "2darray", "compute", "derivatives" …. What a pragma restricts to some
/// keywords does not count. `#pragma geometry` counts as target 4.0, hull and domain as 4.6. Of a
/// kernel it is "compute" and what `#pragma require` asks for.
std::vector<std::string> RequiredFeatures(const PassProgram& program);

/// Why limn does not compile this program although it is well formed: it is GLSL, has a surface
/// function or a stage other than vertex, geometry and fragment, its renderers leave Vulkan out, or
/// it needs a feature that is missing. Nothing where it can be tried. The severity is Error, the
/// message one sentence.
///
/// @param missingFeatures  those of RequiredFeatures that the device lacks; "compute wavebasic" and
///     its like are what it lacks in kernels
std::optional<Diagnostic> ReasonNotSupported(const PassProgram& program,
                                             std::span<const std::string> missingFeatures = {});

/// Warnings for pragmas, features and renderers that nobody knows, with the nearest known name.
/// Pragmas that are obsolete or concern other tools are known. Likewise for `#if` and its kin that
/// ask for a keyword of a dynamic_branch.
std::vector<Diagnostic> CheckPragmas(const PassProgram& program);

} // namespace limn
