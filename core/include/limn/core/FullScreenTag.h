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
/// promised lets limn leave such draws out, or draw a part of them; the value is one of
///
///     True
///     0 0 0 1 where _BlitTexture or _OutlineWidth is 0
///     0 0 0 1 where _BlitTexture or _OutlineWidth is 0 within _OutlineWidth texels
///     _BlitTexture with alpha 1
///
/// The second: the fragment function gives (0, 0, 0, 1) where every component of every texel of one
/// of these textures, or of a vector or number, is 0. The third: so many texels of the texture
/// around its own place are enough for that (a number or a property; what bilinear filtering takes
/// besides need not be counted). The last: it gives the texture's texel at its own place.
struct FullScreenTag
{
    std::vector<ShaderPropertyId> zeroes;
    Color output; ///< linear
    std::optional<ShaderPropertyId> copied;
    /// Of "within … texels": a number, or else a property; neither = it may look anywhere.
    std::optional<float> reach;
    std::optional<ShaderPropertyId> reachProperty;
};

/// The tag "LimnWithinMesh" = "True": the vertex function moves no vertex from where the object's
/// transform and the camera put it, so that nothing is drawn outside of the object's bounds.
bool StaysWithinMesh(const ShaderLabPass& pass);

/// Nothing where the pass has no such tag.
/// @param file  for the message
/// @throws AssetError if the tag says something else, at its place
std::optional<FullScreenTag> ReadFullScreenTag(const ShaderLabPass& pass, const std::string& file);

} // namespace limn
