#pragma once

#include <limn/core/Camera.h>
#include <limn/core/Image.h>
#include <limn/volume/Volume.h>
#include <span>

namespace limn
{

/// Draws the local volumes over a finished picture, as lines that nothing hides: the surface of
/// each enabled collider in green, the surface at which the volume has faded out dashed, and the
/// camera's volumeTrigger, if it has one, as a magenta cross of half a metre. Unity draws such
/// gizmos in its editor.
/// @param picture  R8G8B8A8, drawn by `camera`
/// @return the number of colliders that were drawn, in the picture or beside it
int DrawVolumes(Image& picture, const Camera& camera, std::span<const Volume> volumes);

} // namespace limn
