#pragma once

#include "unity/UnityProject.h"

#include <limn/editor_stub/AssetContext.h>

namespace limn
{

/// Makes the shader of a shader graph's file. Throws AssetError if limn cannot.
using GraphTranslator = std::function<std::shared_ptr<const Shader>(
    const std::filesystem::path& graph, AssetContext& assets)>;

/// Lets Shader::Find and Resources::Load of the features that `assets` loads find the project's
/// shaders and shader graphs and the files of its folders Resources, until another project's are
/// set.
/// @param graph  null: no graphs
void UseShadersOf(const UnityProject& project, AssetContext& assets, GraphTranslator graph);

} // namespace limn
