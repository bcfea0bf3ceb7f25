#pragma once

#include <limn/editor_stub/SceneFile.h>

namespace limn
{

/// Compiles what rendering a scene needs: the passes of objects' shaders that the renderer draws
/// and every pass of the shaders of active features. Different shaders compile at the same time.
/// @throws AssetError with the errors of all shaders
void CompileUsedShaders(const SceneAsset& asset);

} // namespace limn
