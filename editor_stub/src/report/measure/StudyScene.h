#pragma once

#include "report/measure/Study.h"
#include "report/truth/OutlineReference.h"
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
GameObject& AddShape(SceneAsset& picture, const std::string& name, const ScreenTriangles& triangles,
                     AssetContext& assets);

/// Puts what the scene's first outline feature that is active would outline, and the camera draws,
/// into the rendering layer k_OutlinedLayer, and nothing else.
/// @throws AssetError if there is no such feature, or it takes no object
void MarkOutlined(SceneAsset& asset);

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

/// The scene that the study is about; every other subject is made up.
inline constexpr const char* k_SceneSubject = "scene";
/// As many balls as the variant says, "100 objects".
inline constexpr const char* k_BallsSubject = "balls";

/// The flat shapes that can be outlined: "disc", "ring", "star", "needle", "two".
const std::vector<std::string>& ShapeNames();
bool IsShape(const std::string& subject);

/// A shape in the middle of a picture, its size going by the picture's height.
/// @throws ContractError for another name
ScreenTriangles ShapeTriangles(const std::string& name, int width, int height);

/// The cell's subject, its objects in the rendering layer k_OutlinedLayer.
/// @param isBlack  everything black on black
/// @throws AssetError as LoadScene and MarkOutlined, for the scene
SceneAsset MakeSubject(const CellId& id, bool isBlack, const std::filesystem::path& scene,
                       AssetContext& assets);

} // namespace limn::study
