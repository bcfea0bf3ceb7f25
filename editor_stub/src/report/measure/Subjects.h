#pragma once

#include "report/measure/Study.h"
#include "report/truth/OutlineReference.h"

#include <limn/editor_stub/SceneFile.h>

namespace limn::study
{

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
