#pragma once

#include "report/measure/Study.h"
#include "report/truth/OutlineReference.h"

#include <limn/editor_stub/SceneFile.h>

namespace limn::study
{

/// The rendering layer that the outlined objects of a study are in, and no others.
inline constexpr int k_OutlinedLayer = 31;

/// @throws ContractError for an unknown name
const Technique& RequireTechnique(const AssetContext& assets, const std::string& name);

/// Makes a white outline of that width the scene's only feature, with the name "Outline", and
/// removes the scene's volumes.
/// @param width  in pixels; NaN is refused, as it would be if a person typed it
/// @throws AssetError if the feature or its component refuses the width
void UseTechnique(SceneAsset& asset, const Technique& technique, double width,
                  AssetContext& assets);

/// Returns a black scene with an orthographic camera. A unit is a pixel, x to the right and y up
/// from the middle.
SceneAsset EmptyPicture(int width, int height);

/// Adds a black, outlined object at the origin.
GameObject& AddOutlined(SceneAsset& picture, const std::string& name,
                        std::shared_ptr<const Mesh> mesh, AssetContext& assets);
/// Adds a black, flat, outlined object, given in pixels of an EmptyPicture.
GameObject& AddShape(SceneAsset& picture, const std::string& name, const ScreenTriangles& triangles,
                     AssetContext& assets);

/// Puts the objects that the scene's first active outline feature would outline, and that the
/// camera draws, into the rendering layer k_OutlinedLayer, and no others.
/// @throws AssetError if there is no such feature, or if it takes no object
void MarkOutlined(SceneAsset& asset);

/// @throws AssetError if nothing in the rendering layer k_OutlinedLayer is in the picture
void RequireOutlineInPicture(const SceneAsset& asset);

/// Makes everything black and unlit on a black background, so that a white outline is its own
/// alpha. The picture gets the size that the camera draws in, which differs from the scene's if
/// renderScale is set. Cameras that draw over this one are removed, and so are objects that are
/// transparent and not outlined, which hide nothing.
void MakeBlack(SceneAsset& asset, AssetContext& assets);

/// Returns what the outlined objects cover in the scene's picture, whatever is in front of them. It
/// is computed in double precision from their triangles.
Silhouette OutlinedSilhouette(const SceneAsset& asset);

/// The surfaces of a scene after MarkOutlined: those that are outlined, and the other opaque ones
/// that the camera draws and that may be in front of them.
struct SceneSurfaces
{
    Surfaces outlined;
    Surfaces others;
    std::vector<std::string> names; ///< the names of the objects, by the owner of a surface
};
SceneSurfaces SurfacesOf(const SceneAsset& asset);

/// Returns whether an object hides a place of the outlined objects' border that is in the picture.
bool IsPartlyHidden(const SceneAsset& asset);

/// The subject that is the scene of the study. All other subjects are synthetic.
inline constexpr const char* k_SceneSubject = "scene";
/// The subject with as many balls as the variant names, "100 objects".
inline constexpr const char* k_BallsSubject = "balls";

/// The names of the flat shapes that can be outlined.
inline constexpr std::array k_ShapeNames{"disc", "ring", "star", "needle", "two"};
bool IsShape(const std::string& subject);

/// Returns a shape in the middle of a picture. Its size depends on the picture's height.
/// @throws ContractError for any other name
ScreenTriangles ShapeTriangles(const std::string& name, int width, int height);

/// Makes the cell's subject, with its objects in the rendering layer k_OutlinedLayer.
/// @param isBlack  makes everything black on black
/// @throws AssetError as LoadScene and MarkOutlined, for the scene
SceneAsset MakeSubject(const CellId& id, bool isBlack, const std::filesystem::path& scene,
                       AssetContext& assets);

} // namespace limn::study
