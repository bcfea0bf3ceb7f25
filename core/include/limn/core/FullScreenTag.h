#pragma once

#include <limn/core/Color.h>
#include <limn/core/ShaderId.h>
#include <limn/shaderlab/ShaderLabDocument.h>
#include <optional>
#include <vector>

namespace limn
{

/// What a pass promises of its draws without a mesh by the tag "LimnFullScreen", which Unity passes
/// over: they cover their target, and leave no texel as it was but by blending. Only what is
/// promised lets limn leave such draws out; one of
///
///     "LimnFullScreen" = "True"
///     "LimnFullScreen" = "0 0 0 1 where _BlitTexture or _OutlineWidth is 0"
///     "LimnFullScreen" = "_BlitTexture with alpha 1"
///
/// the second: that the fragment function gives (0, 0, 0, 1) where every component of every texel
/// of one of these textures, or of a vector or number, is 0; the third: that it gives the texture's
/// texel at its own place.
struct FullScreenTag
{
    std::vector<ShaderPropertyId> zeroes;
    Color output; ///< linear
    std::optional<ShaderPropertyId> copied;
};

/// Nothing where the pass has no such tag.
/// @param file  for the message
/// @throws AssetError if the tag says something else, at its place
std::optional<FullScreenTag> ReadFullScreenTag(const ShaderLabPass& pass, const std::string& file);

} // namespace limn
