#pragma once

#include "shader_graph/GraphCode.h"

namespace limn
{

/// Returns the lines of the Properties block for a graph, its keywords and the textures that it
/// names.
std::string GraphPropertiesText(const GraphFile& file, const GraphSurroundings& around);

/// Returns the declarations of the same in HLSL. Properties that materials do not have are global.
std::string GraphUniformsText(const GraphFile& file, const GraphSurroundings& around);

/// Returns the #pragma lines of the graph's keywords.
std::string GraphKeywordsText(const GraphSurroundings& around);

} // namespace limn
