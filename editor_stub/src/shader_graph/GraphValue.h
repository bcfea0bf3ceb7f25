#pragma once

#include "shader_graph/GraphFile.h"

namespace limn
{

/// An expression in HLSL and its type: "float3", "bool", "UnityTexture2D".
struct GraphValue
{
    std::string type;
    std::string text;
};

/// Returns how many numbers a vector has, how many rows a matrix, 1 for bool, 0 for other types.
int GraphWidth(const std::string& type);
bool IsGraphMatrix(const std::string& type);
/// Returns "float", "float2" ...
std::string GraphVectorType(int width);
/// Returns the type of a slot that has one of its own: "float2" for "UV". Returns "" for others.
std::string GraphTypeOfKind(const std::string& kind);

/// Returns an expression of another type, as Shader Graph converts it: a number fills a vector, a
/// longer vector is cut, and what is missing is 0, but 1 for the fourth.
std::string ConvertGraphValue(const GraphValue& value, const std::string& type);

/// Returns the m_Value of a slot or property as a constant.
std::string GraphConstant(const std::string& type, const Json& fields);

/// Returns the constant of a gradient: of one that Unity has saved, or of a node. Its colours are
/// linear, as SampleGradient takes them since version 1.
std::string GraphGradient(const Json& value);
std::string GraphGradientOfNode(const Json& node);

/// Returns a property's name in the shader.
std::string GraphReferenceName(const Json& property);

/// Returns the name of a sampler with a graph's filter and wrap mode: "SamplerState_Point_Clamp".
std::string GraphSamplerName(const Json& fields);

/// Returns the dimension in ShaderLab of a texture's property or slot: "Cube" for "Cubemap".
/// Returns
/// "" for other kinds.
std::string GraphTextureDimension(std::string_view kind);

/// Returns the name of the picture that stands for a missing one: "white".
std::string GraphDefaultTexture(const Json& fields);

/// A reference to a file of the project.
struct GraphAsset
{
    std::string guid;
    std::int64_t fileID = 0;
};

/// Reads a m_SerializedTexture and the like, which is JSON in a string: {"texture": {...}}.
GraphAsset ReadGraphAsset(const std::string& serialized);

/// Returns the texture that a slot or a node names itself.
/// @param kind    the kind of the slot
/// @param fields  of the node for an output, else of the slot
GraphAsset ReadGraphTexture(std::string_view kind, const Json& fields);

/// Returns the letters, digits and underscores from a place on.
std::string GraphWordAt(const std::string& text, std::size_t at);

/// Returns a line of a program.
std::string GraphLine(const std::string& text);

} // namespace limn
