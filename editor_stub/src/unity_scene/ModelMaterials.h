#pragma once

#include "models/ModelFile.h"
#include "unity/UnityProject.h"

namespace limn
{

/// Gives a model's materials the references that Unity gives them by the model's import settings:
/// External ones to the .mat files that have their names, and with None all to Unity's default
/// material. Those that the settings name already, and those for which there is no file, stay as
/// they are.
/// @param path  of the model
/// @source Unity: ModelImporter.SearchAndRemapMaterials (2022.3)
void FindModelMaterials(Model& model, const std::filesystem::path& path,
                        const UnityProject& project);

} // namespace limn
