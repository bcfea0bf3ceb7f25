#pragma once

#include "console/Json.h"

#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// An expression of nodes.txt.
struct NodeExpression
{
    std::string type; ///< of a value between, "" for an output
    std::string text;
};

/// Returns the expression that gives an output of a node, or a value between.
/// @param node    the node's type: "Multiply"
/// @param fields  the node's object in its file, which chooses between lines
/// @param output  the output's name in shaders, without spaces
std::optional<NodeExpression> FindNodeExpression(std::string_view node, const Json& fields,
                                                 std::string_view output);

/// Returns the field at a path, such as "m_Conversion.from", as HLSL: a number, the text of a mask,
/// or for `rgb` behind a colour its three numbers.
std::string GraphFieldText(const Json& fields, const std::string& path);

/// The stage that the code of a graph runs in.
enum class GraphStage
{
    Vertex,
    Fragment,
    Screen ///< the fragments of a full-screen pass
};

/// A value that each vertex or pixel has.
struct StageInput
{
    std::string type; ///< in HLSL
    std::string text; ///< an expression of `input`, the mesh's or the pixel's, and of others' IN.X
};

/// Returns how a stage gets a value, by inputs.txt. Returns nothing if it cannot.
std::optional<StageInput> FindStageInput(std::string_view name, GraphStage stage);

} // namespace limn
