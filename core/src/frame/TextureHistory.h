#pragma once

#include "frame/FrameNode.h"

namespace limn
{

/// Looks at the first thing the frame does with each texture: whether it reads what a frame before
/// left in it, which makes its history Read; or whether it is the frame itself that reads what it
/// leaves in one of Unknown history, which makes it Consumed until LeaveOutUnread.
/// @return the textures that it overwrites
std::vector<std::uint64_t> LearnHistory(const std::vector<FrameNode>& nodes, OutputSpan outputs,
                                        CompiledFrame& frame);

/// As if all frames to come overwrote all textures.
void KeepNothing(TextureStates& states);

/// Of textures that no next frame reads, only their use counts.
void ForgetContents(TextureStates& states);

/// Makes the history of what was unknown Overwritten: once the frame is made, so that it leaves out
/// what frames before it overwrote only.
void RememberOverwritten(std::span<const std::uint64_t> textures, TextureStates& states);

/// Whether a next frame may read what this one leaves in the texture.
bool OutlivesFrame(const RenderTexture& texture, const TextureStates& states);

} // namespace limn
