#pragma once

#include <limn/core/ComputeShader.h>

namespace limn
{

/// Makes a kernel that copies words from one buffer to another, of any targets, for
/// DrawRecorder::Copy.
std::shared_ptr<const ComputeShader> MakeCopyKernel(std::shared_ptr<ShaderCompiler> compiler);

} // namespace limn
