#pragma once

#include <limn/core/ComputeShader.h>
#include <memory>
#include <string_view>

namespace limn
{

/// Returns the compute shader of a loaded plug-in with that file name ("Blur.compute"), or null if
/// there is none.
/// @throws AssetError if it does not parse
std::shared_ptr<ComputeShader> FindShippedComputeShader(std::string_view fileName,
                                                        std::shared_ptr<ShaderCompiler> compiler);

} // namespace limn
