#pragma once

#include "frame/FrameNode.h"

namespace limn
{

/// Forgets what is in textures that no next frame reads: only their use counts.
void ForgetContents(TextureStates& states);

/// Returns whether a next frame may read what this one leaves in the texture: whoever has it may,
/// however often frames before have overwritten it first.
bool OutlivesFrame(const RenderTexture& texture, const TextureStates& states);

} // namespace limn
