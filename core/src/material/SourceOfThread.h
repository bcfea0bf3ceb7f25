#pragma once

#include <limn/core/ShaderSource.h>

namespace limn
{

/// Returns the source of the ShaderSourceScope that this thread is in; null = none.
std::shared_ptr<ShaderSource>& ShaderSourceOfThread();

} // namespace limn
