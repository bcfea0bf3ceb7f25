#pragma once

#include <limn/shaderlab/ShaderLabDocument.h>

#include <string>

namespace limn
{

/// The document as canonical ShaderLab text: one command a line, four spaces of indentation, LF,
/// Unity's documented spelling, only what differs from ShaderLab's defaults. State that scopes
/// around a pass set stands in the pass; the include blocks in scope of a program stand in front of
/// it in the same block. Parsing the text gives a document with the SameContent.
std::string PrintShaderLab(const ShaderLabDocument& document);

/// Whether two documents say the same; places and file names do not count, and neither does how
/// the text of a program is divided into include blocks.
bool SameContent(const ShaderLabDocument& a, const ShaderLabDocument& b);

/// An operation as a BlendOp command writes it: "RevSub".
/// @throws ContractError if it is none
std::string BlendOpName(BlendOp op);

} // namespace limn
