#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include "hlsl/Declarations.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A scalar or vector that crosses the border of a stage. Structs, arrays and matrices of an entry
/// function's parameter are split into such values.
struct StageValue
{
    std::string expression; ///< the value in the author's function: "limn_a0.uvs[1]"
    std::string semantic;   ///< upper case, without index
    int index = 0;
    std::string scalar; ///< "float", "int", "uint" or "bool"
    int components = 1;
    std::string interpolation; ///< modifiers, "" or with a blank at the end
    /// The token of its parameter or member; 0 = the function's return value.
    std::size_t token = 0;
    /// The pipeline writes or reads it, so it is no attribute and no varying.
    bool isSystemValue = false;

    std::string semanticName() const; ///< "TEXCOORD0", "POSITION", "COLOR1"
};

/// The parameters of a geometry function that hold vertices: an array, or several of one primitive,
/// and the stream.
struct GeometrySignature
{
    std::string_view primitive;  ///< "triangle"
    int inputVertices = 0;       ///< size of the array
    std::string_view stream;     ///< "TriangleStream"
    std::string_view outputType; ///< the type of the vertices that the stream takes
};

/// All inputs and outputs of the author's entry function. For a geometry function, `inputs` and
/// `outputs` are those of one vertex: of element k_InputIndex of the array, and of k_OutputVertex.
struct StageInterface
{
    const HlslFunction* function = nullptr;
    std::vector<StageValue> inputs;
    std::vector<StageValue> outputs;
    /// The inputs of geometry functions that all vertices share.
    std::vector<StageValue> primitiveInputs;
    std::optional<GeometrySignature> geometry;
};

/// An error about the interface of a function, one line; the caller adds the place.
struct StageInterfaceError
{
    std::string message;
    std::size_t token = 0; ///< the token of the wrong parameter or member; 0 = the function
    /// The function with the error, for errors of LinkStages.
    const HlslFunction* function = nullptr;
};

/// Reads the signature of an entry function. Old semantics get their modern names here: a vertex
/// function's POSITION output is SV_POSITION, a fragment function's COLOR output is SV_TARGET, VPOS
/// is SV_POSITION, VFACE is SV_ISFRONTFACE; POSITION is SV_POSITION on both sides of a geometry
/// function.
///
/// @throws StageInterfaceError
StageInterface ReadStageInterface(const HlslDeclarations& declarations,
                                  const HlslFunction& function, ShaderStage stage);

/// Returns the name of the local variable in which the generated code keeps parameter `index`.
std::string ArgumentName(std::size_t index);
inline constexpr std::string_view k_ResultName = "limn_result";
inline constexpr std::string_view k_InputIndex = "limn_i";
inline constexpr std::string_view k_OutputVertex = "limn_vertex";

/// Returns whether a type without its template argument is a stream, to which a geometry function
/// appends.
bool isStream(std::string_view type);

/// Returns the name of a type: "float3" for "float" and 3.
std::string TypeName(const std::string& scalar, int components);

} // namespace limn
