#pragma once

#include "explain/ExplainedFrame.h"

#include <filesystem>

namespace limn
{

/// The frame as a picture in Graphviz's language: passes in their order with what they draw, the
/// textures between them with size, format and bytes, load and store on the arrows; passes that are
/// left out in grey with the reason.
std::string FrameGraph(const ExplainedFrame& frame);

/// Whether WriteGraph knows the ending: .dot, .svg, .png or .pdf.
bool IsGraphFile(const std::filesystem::path& path);

/// Writes the graph: as it is where the file ends in .dot, else drawn by the program `dot`.
/// @throws AssetError         if the file cannot be written, or `dot` fails
/// @throws std::system_error  if there is no `dot`
void WriteGraph(const std::filesystem::path& path, const std::string& graph);

} // namespace limn
