#pragma once

#include "frame/PassSplitter.h"

#include <limn/core/FrameCompiler.h>

namespace limn
{

/// Puts a twin of format D32_SFloat in place of every transient depth-stencil texture that no draw
/// of the frame uses the stencil of: less memory, less traffic. Textures that are sampled or are
/// outputs stay, since others know them by identity.
/// @param twins  remembered, so that a texture has the same twin in every frame
void LeaveOutUnusedStencil(std::vector<OpenPass>& passes,
                           std::span<const std::shared_ptr<const RenderTexture>> outputs,
                           DepthTwins& twins);

} // namespace limn
