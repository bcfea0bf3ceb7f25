#pragma once

#include "unity/UnityObjects.h"

#include <limn/core/RenderTexture.h>
#include <memory>

namespace limn
{

/// Reads a texture that Unity saved as text in an .asset file: a Texture2D, a Texture3D or a
/// Texture2DArray of any format that is not compressed. Of its mip levels the first is read; the
/// device makes the others. Unity: the classes Texture2D (28), Texture3D (117) and Texture2DArray
/// (187) of 5.6 and later.
/// @param fields  the map below the class's name
/// @param file    the file's name in errors
/// @throws AssetError  naming the line, if a number does not fit the data, the data lie in another
///     file, or limn does not read the format
std::shared_ptr<const Texture> ReadTextTexture(UnityClass classID, const UnityNode& fields,
                                               const std::string& file);

/// Reads a texture that cameras draw into, of a .renderTexture file. It has no depth, since cameras
/// bring their own. Of 2 samples per texel and of 8 it makes 4. Unity: the class RenderTexture (84)
/// of 5.6 and later.
/// @throws AssetError  naming the line, if its size, samples or colour format are out of range, or
///     it is no 2D texture
std::shared_ptr<const RenderTexture> ReadRenderTexture(const UnityNode& fields,
                                                       const std::string& file);

} // namespace limn
