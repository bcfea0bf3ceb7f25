#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include "stages/StageInterface.h"

#include <string>
#include <vector>

namespace limn
{

/// A value that one function passes to the next; both declare it in the same way.
struct Varying
{
    std::string semantic; ///< with index
    std::string scalar;
    int components = 1;
    int location = 0;
};

/// The values that pass from one stage to the next.
struct StageBorder
{
    std::vector<Varying> varyings;
    /// The semantics that the later function reads and the earlier one does not write; they are 0.
    std::vector<std::string> unwritten;

    const Varying& Find(const std::string& semantic) const;
};

/// The connection of the stages of a pass.
struct StageLinkage
{
    std::vector<VertexInput> vertexInputs; ///< all that the vertex function declares
    StageBorder behindVertex;
    /// Different from behindVertex only if there is a geometry function.
    StageBorder beforeFragment;
    int colorOutputs = 0;

    /// Returns the values that a stage reads from the one before it. Vertex functions read
    /// `vertexInputs`.
    const StageBorder& Before(ShaderStage stage) const;
    const StageBorder& Behind(ShaderStage stage) const;
};

/// @param geometry  null if the pass has no such function
/// @throws StageInterfaceError if two values have the same semantic
StageLinkage LinkStages(const StageInterface& vertex, const StageInterface* geometry,
                        const StageInterface& fragment);

} // namespace limn
