#pragma once

#include <limn/shaderlab/ShaderLabDocument.h>

#include <string>

namespace limn
{

/// Returns the document as canonical ShaderLab text: one command per line, four spaces of
/// indentation, LF, Unity's documented spelling, and only what differs from ShaderLab's defaults.
/// State set by scopes around a pass is written in the pass; the include blocks in scope of a
/// program are written in front of it in the same block. Parsing the text gives a document with the
/// SameContent.
std::string PrintShaderLab(const ShaderLabDocument& document);

/// Returns whether two documents have the same content. Places, file names, and the division of a
/// program's text into include blocks do not count.
bool SameContent(const ShaderLabDocument& a, const ShaderLabDocument& b);

// These return a value of a pass's state as ShaderLab writes it: "LEqual", "On", "0.5", or
// "[_Property]". They throw ContractError if ShaderLab has no name for the value.
std::string StateText(const StateValue<CullMode>& value);
std::string StateText(const StateValue<CompareFunction>& value);
std::string StateText(const StateValue<bool>& value);
std::string StateText(const StateValue<BlendMode>& value);
std::string StateText(const StateValue<BlendOp>& value);
std::string StateText(const StateValue<StencilOp>& value);
std::string StateText(const StateValue<int>& value);
std::string StateText(const StateValue<float>& value);
std::string ColorMaskText(const StateValue<int>& mask); ///< "RGB", "0"
std::string BlendText(const PassBlendState& target);    ///< "Off", "One Zero, SrcAlpha One"
std::string BlendOpText(const PassBlendState& target);  ///< "Max", "Add, Max"

// These return a property's type and default as a Properties block has them.
std::string PropertyTypeText(const ShaderProperty& property);    ///< "Range(0, 1)", "2D"
std::string PropertyDefaultText(const ShaderProperty& property); ///< "(1, 1, 1, 1)", "\"white\" {}"

/// Returns an operation as a BlendOp command writes it: "RevSub".
/// @throws ContractError if it is no blend operation
std::string BlendOpName(BlendOp op);

} // namespace limn
