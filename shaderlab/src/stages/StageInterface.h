#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include "hlsl/Declarations.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A scalar or vector that crosses the border of a stage: one value of an entry function's
/// parameter, structs, arrays and matrices taken apart.
struct StageValue
{
    std::string expression; ///< where the author's function has it: "limn_a0.uvs[1]"
    std::string semantic;   ///< upper case, without index
    int index = 0;
    std::string scalar; ///< "float", "int", "uint" or "bool"
    int components = 1;
    std::string interpolation;  ///< modifiers, "" or with a blank at the end
    std::size_t token = 0;      ///< of its parameter or member; 0 = what the function returns
    bool isSystemValue = false; ///< made or taken by the pipeline: no attribute and no varying

    std::string semanticName() const; ///< "TEXCOORD0", "POSITION", "COLOR1"
};

/// The parameters of a geometry function that hold vertices: an array, or several of one primitive,
/// and the stream.
struct GeometrySignature
{
    std::string_view primitive; ///< "triangle"
    int inputVertices = 0;      ///< size of the array
    std::size_t streamParameter = 0;
    std::string_view stream;     ///< "TriangleStream"
    std::string_view outputType; ///< of the vertices that the stream takes
};

/// Everything the author's entry function takes and gives. Of a geometry function, `inputs` and
/// `outputs` are those of one vertex: of element k_InputIndex of the array, and of k_OutputVertex.
struct StageInterface
{
    const HlslFunction* function = nullptr;
    std::vector<StageValue> inputs;
    std::vector<StageValue> outputs;
    std::vector<StageValue> primitiveInputs; ///< of geometry functions: once for all vertices
    std::optional<GeometrySignature> geometry;
};

/// One line of complaint about the interface of a function; the caller adds the place.
struct StageInterfaceError
{
    std::string message;
    std::size_t token = 0; ///< of the parameter or member that it is about; 0 = the function
    const HlslFunction* function = nullptr; ///< of LinkStages: whose it is
};

/// Takes the signature of an entry function apart. Old semantics get their modern names here:
/// a vertex function's POSITION output is SV_POSITION, a fragment function's COLOR output is
/// SV_TARGET, VPOS is SV_POSITION, VFACE is SV_ISFRONTFACE; POSITION is SV_POSITION on both sides
/// of a geometry function.
///
/// @throws StageInterfaceError
StageInterface ReadStageInterface(const HlslDeclarations& declarations,
                                  const HlslFunction& function, ShaderStage stage);

/// Name of the local variable that the generated code keeps parameter `index` in.
std::string ArgumentName(std::size_t index);
inline constexpr std::string_view k_ResultName = "limn_result";
inline constexpr std::string_view k_InputIndex = "limn_i";
inline constexpr std::string_view k_OutputVertex = "limn_vertex";

/// Whether a type without its template argument is what a geometry function appends to.
bool isStream(std::string_view type);

/// "float" and 3: "float3".
std::string TypeName(const std::string& scalar, int components);

} // namespace limn
