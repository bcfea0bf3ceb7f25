#pragma once

#include "report/truth/SeenOutline.h"

#include <limn/editor_stub/SceneFile.h>

namespace limn::study
{

/// A black picture seen by an orthographic camera: a unit is a pixel, x to the right and y up from
/// the middle.
SceneAsset EmptyPicture(int width, int height);

/// A black, outlined object at the origin.
GameObject& AddOutlined(SceneAsset& picture, const std::string& name,
                        std::shared_ptr<const Mesh> mesh, AssetContext& assets);
/// A black, flat, outlined object from pixels of an EmptyPicture.
/// @param offset  pixels it is moved by, y downwards
GameObject& AddShape(SceneAsset& picture, const std::string& name, const ScreenTriangles& triangles,
                     AssetContext& assets, const glm::dvec2& offset = glm::dvec2(0.0));

/// Puts what the scene's first outline feature that is active would outline, and the camera draws,
/// into the rendering layer k_OutlinedLayer, and nothing else.
/// @returns the objects
/// @throws AssetError if there is no such feature, or it takes no object
std::vector<GameObject*> MarkOutlined(SceneAsset& asset);

/// @throws AssetError if nothing in the rendering layer k_OutlinedLayer is in the picture
void RequireOutlineInPicture(const SceneAsset& asset);

/// Makes everything black, lit by nothing, before a black background, so that a white outline is
/// its own alpha. The picture gets the size that the camera draws in, which renderScale may make
/// another than the scene's; cameras that draw over this one are left out, as are objects that are
/// transparent and not outlined, which hide nothing.
void MakeBlack(SceneAsset& asset, AssetContext& assets);

/// What the outlined objects cover in the scene's picture, whatever is in front of them; in double
/// precision, from their triangles.
Silhouette OutlinedSilhouette(const SceneAsset& asset);

/// The surfaces of a scene that MarkOutlined has been called for: those that are outlined, and the
/// opaque ones that the camera draws besides and that may stand in front of them.
struct SceneSurfaces
{
    Surfaces outlined;
    Surfaces others;
    std::vector<std::string> names; ///< of the objects, by the owner of a surface
};
SceneSurfaces SurfacesOf(const SceneAsset& asset);

/// Returns whether an object hides a place of the outlined objects' border that is in the picture.
bool IsPartlyHidden(const SceneAsset& asset);

} // namespace limn::study
