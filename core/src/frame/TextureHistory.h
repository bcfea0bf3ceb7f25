#pragma once

#include "frame/FrameNode.h"

namespace limn
{

/// Returns what is known of a texture; nothing is known of a new one.
TextureState& StateOf(TextureStates& states, const std::shared_ptr<const Texture>& texture);
const TextureState* FindState(const TextureStates& states, const Texture& texture); ///< null = new

bool Contains(OutputSpan outputs, const RenderTexture& texture);

/// Forgets the contents of textures that no next frame reads; only their use is kept.
void ForgetContents(TextureStates& states);

/// Returns whether a next frame may read what this one leaves in the texture: anything that holds
/// it may, even if each earlier frame overwrote it first.
bool OutlivesFrame(const RenderTexture& texture, const TextureStates& states);

} // namespace limn
