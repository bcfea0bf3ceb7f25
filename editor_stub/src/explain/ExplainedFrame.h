#pragma once

#include <filesystem>
#include <limn/core/CompiledFrame.h>

namespace limn
{

/// What a pass does with one texture that it draws into, or that its kernels may write to.
struct ExplainedAttachment
{
    std::size_t texture = 0; ///< index into ExplainedFrame::textures
    std::string load;        ///< "load", "clear" or "-"
    std::string store;       ///< "store", "resolve", "store and resolve" or "-"
};

struct ExplainedBarrier
{
    std::size_t texture = 0; ///< index into ExplainedFrame::textures
    std::string before;      ///< a TextureUsage
    std::string after;
};

/// A pass as the device runs it.
struct ExplainedPass
{
    std::size_t place = 0; ///< among those recorded, with those that are left out
    std::string name;      ///< of all that was recorded into it, in order: "Opaque + Sky"
    int width = 0;         ///< texels
    int height = 0;
    std::vector<ExplainedAttachment> targets;
    std::vector<std::size_t> reads; ///< indices into ExplainedFrame::textures
    std::vector<ExplainedBarrier> barriers;
    int instances = 0; ///< draws before instancing
    int draws = 0;
    int limited = 0;        ///< draws that reach a part of the targets only
    int dispatches = 0;     ///< of kernels; then there are no draws, and no size
    int bufferBarriers = 0; ///< beside `barriers`
    int indirect = 0;       ///< draws or dispatches that find their counts in a buffer
};

/// A texture that passes draw into or sample.
struct ExplainedTexture
{
    std::string name;
    std::string size; ///< "640x360"
    std::string format;
    int samples = 1;
    std::uint64_t bytes = 0;               ///< without what a device adds
    int first = 0;                         ///< the pass that uses it first, from 1
    int last = 0;                          ///< and last
    bool isDrawn = false;                  ///< into; else it comes from a file
    bool isOutput = false;                 ///< it is read after the frame
    std::vector<std::string> sharedWith{}; ///< names of textures that have the same memory in turn
};

/// A compiled frame as people read it.
struct ExplainedFrame
{
    std::vector<ExplainedPass> passes;
    std::vector<ExplainedTexture> textures; ///< in the order of first use
    std::vector<ExplainedBarrier> finalBarriers;
    std::vector<LeftOut> leftOut; ///< in the order of recording
};

ExplainedFrame ExplainFrame(const CompiledFrame& frame);

/// "370 → 159 draws", "2 draws, 1 of them in a part" of the targets, or "2 dispatches"; ", 1 of
/// them by a buffer's counts" behind them.
std::string DrawsText(const ExplainedPass& pass);

/// "3.5 MiB"
std::string BytesText(std::uint64_t bytes);

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
