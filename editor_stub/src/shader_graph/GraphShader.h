#pragma once

#include "shader_graph/GraphCode.h"

#include <limn/shaderlab/ShaderLabParser.h>

namespace limn
{

/// A shader graph as ShaderLab.
struct TranslatedGraph
{
    std::string shaderLab;
    /// The textures that the graph itself names, each the default of a property. A material that
    /// has saved another one keeps that.
    std::vector<GraphTexture> textures;
};

/// Translates a .shadergraph file with a target for URP: Lit, Unlit, Sprite Lit, Sprite Unlit,
/// Sprite Custom Lit (drawn unlit) or Fullscreen. Its passes include what Unity's generated shaders
/// include. Unity: Shader Graph 4 to 17 (2018.3 to 6).
/// @param files  finds sub graphs and the files of custom functions
/// @throws AssetError with all reasons if it cannot be read or has nodes that limn does not know
TranslatedGraph TranslateGraph(const std::filesystem::path& path, const GraphFiles& files);

/// Returns whether a file is a shader graph, by its name.
bool IsShaderGraph(const std::filesystem::path& path);

/// Reads a .shader file, or translates a .shadergraph with the files of the project around it.
/// @throws AssetError as LoadShaderLabWithDiagnostics and TranslateGraph
ShaderLabParseResult LoadShaderFile(const std::filesystem::path& path);

} // namespace limn
