#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include "stages/StageInterface.h"

#include <string>
#include <vector>

namespace limn
{

/// A value that goes from one function to the next; both sides declare it alike.
struct Varying
{
    std::string semantic; ///< with index
    std::string scalar;
    int components = 1;
    int location = 0;
};

/// What crosses from one stage to the next.
struct StageBorder
{
    std::vector<Varying> varyings;
    /// Semantics that the later function reads and the earlier one does not write: 0.
    std::vector<std::string> unwritten;

    const Varying& Find(const std::string& semantic) const;
};

/// How the stages of a pass fit together.
struct StageLinkage
{
    std::vector<VertexInput> vertexInputs; ///< all that the vertex function declares
    StageBorder behindVertex;
    StageBorder beforeFragment; ///< another one only where a geometry function lies between
    int colorOutputs = 0;

    /// What a stage reads from the one before it. Vertex functions read `vertexInputs`.
    const StageBorder& Before(ShaderStage stage) const;
    const StageBorder& Behind(ShaderStage stage) const;
};

/// @param geometry  null where the pass has no such function
/// @throws StageInterfaceError where a semantic is given to two values
StageLinkage LinkStages(const StageInterface& vertex, const StageInterface* geometry,
                        const StageInterface& fragment);

} // namespace limn
