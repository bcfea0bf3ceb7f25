#pragma once

#include "material/FrameGlobals.h"

#include <limn/core/Material.h>

namespace limn
{

/// Returns a pass's state with the material's values in place of its property references; a name
/// that the material lacks is looked up in `globals`.
/// @param readsGlobals  set to true if a global was looked for; may be null
/// @param unset         gets "Cull [_Cull]" for each reference to a property that nothing sets,
///                      whose value is 0 then, as in Unity; may be null
/// @throws ContractError naming material, shader and property, if a value is no member of the enum
PipelineState ResolveState(const RenderState& state, const Material& material,
                           const FrameGlobals& globals, bool* readsGlobals = nullptr,
                           std::vector<std::string>* unset = nullptr);

} // namespace limn
