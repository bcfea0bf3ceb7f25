#pragma once

#include "frame/FrameNode.h"

namespace limn
{

/// Forgets the contents of textures that no next frame reads; only their use is kept.
void ForgetContents(TextureStates& states);

/// Returns whether a next frame may read what this one leaves in the texture: anything that holds
/// it may, even if each earlier frame overwrote it first.
bool OutlivesFrame(const RenderTexture& texture, const TextureStates& states);

} // namespace limn
