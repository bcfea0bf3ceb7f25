#pragma once

#include <limn/core/ComputeShader.h>
#include <memory>
#include <string_view>

namespace limn
{

/// A compute shader that a loaded plug-in holds, by the name of its file: "Blur.compute"; null for
/// any other name.
/// @throws AssetError if it does not parse
std::shared_ptr<ComputeShader> FindShippedComputeShader(std::string_view fileName,
                                                        std::shared_ptr<ShaderCompiler> compiler);

} // namespace limn
