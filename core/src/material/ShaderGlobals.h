#pragma once

#include <functional>
#include <limn/core/MaterialPropertyBlock.h>
#include <optional>

namespace limn
{

/// The values that Shader::SetGlobalFloat and its like have set in the process; any thread may use
/// it.
namespace ShaderGlobals
{

/// Returns a number that grows with every change; 0 = there was none.
std::uint64_t version();
std::optional<ShaderPropertyValue> Find(ShaderPropertyId id);
void ForEach(const std::function<void(ShaderPropertyId, const ShaderPropertyValue&)>& function);

} // namespace ShaderGlobals

} // namespace limn
