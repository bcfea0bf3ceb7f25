#pragma once

#include <limn/shaderlab/CompiledPass.h>

#include "StageInterface.h"

#include <string>
#include <vector>

namespace limn
{

/// A value that goes from the vertex to the fragment function; both sides declare it alike.
struct Varying
{
    std::string semantic; ///< with index
    std::string scalar;
    int components = 1;
    int location = 0;
};

/// How the two stages of a pass fit together.
struct StageLinkage
{
    std::vector<Varying> varyings;
    std::vector<VertexInput> vertexInputs; ///< all that the vertex function declares
    /// Semantics that the fragment function reads and the vertex function does not write: 0.
    std::vector<std::string> unwritten;
    int colorOutputs = 0;
};

/// @throws StageInterfaceError where a semantic is given to two values
StageLinkage LinkStages(const StageInterface& vertex, const StageInterface& fragment);

} // namespace limn
