#pragma once

#include <filesystem>
#include <limn/core/CompiledFrame.h>

namespace limn
{

/// A texture that a pass draws into, or that its kernels may write to, and what the pass does with
/// it.
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
    std::size_t place = 0; ///< the position among all recorded passes, including those left out
    std::string name;      ///< the names of all that was recorded into it, in order: "Opaque + Sky"
    int width = 0;         ///< texels
    int height = 0;
    std::vector<ExplainedAttachment> targets;
    std::vector<std::size_t> reads; ///< indices into ExplainedFrame::textures
    std::vector<ExplainedBarrier> barriers;
    int instances = 0; ///< draws before instancing
    int draws = 0;
    int limited = 0;        ///< draws that reach only a part of the targets
    int dispatches = 0;     ///< dispatches of kernels; if any, there are no draws and no size
    int bufferBarriers = 0; ///< besides `barriers`
    int indirect = 0;       ///< draws or dispatches that find their counts in a buffer
};

/// A texture that passes draw into or sample.
struct ExplainedTexture
{
    std::string name;
    std::string size; ///< "640x360"
    std::string format;
    int samples = 1;
    std::uint64_t bytes = 0; ///< without what the device adds
    int first = 0;           ///< the pass that uses it first, from 1
    int last = 0;            ///< the pass that uses it last
    bool isDrawn = false;    ///< true if passes draw into it; else it comes from a file
    bool isOutput = false;   ///< true if it is read after the frame
    std::vector<std::string> sharedWith{}; ///< names of textures that use the same memory in turn
};

/// A compiled frame in a form for people.
struct ExplainedFrame
{
    std::vector<ExplainedPass> passes;
    std::vector<ExplainedTexture> textures; ///< in the order of first use
    std::vector<ExplainedBarrier> finalBarriers;
    std::vector<LeftOut> leftOut; ///< in the order of recording
};

ExplainedFrame ExplainFrame(const CompiledFrame& frame);

/// Returns the textures that a pass draws into: its colours, and behind them its depth.
std::vector<std::shared_ptr<const RenderTexture>> TargetTextures(const CompiledRenderPass& pass);

/// Returns the draws or dispatches of a pass: "370 → 159 draws", "2 draws, 1 of them in a part" of
/// the targets, or "2 dispatches". ", 1 of them by a buffer's counts" may follow.
std::string DrawsText(const ExplainedPass& pass);

/// Returns a number of bytes as text: "3.5 MiB".
std::string BytesText(std::uint64_t bytes);

/// Returns the frame as a picture in Graphviz's language. It shows the passes in their order with
/// what they draw, and the textures between them with size, format and bytes. The arrows show load
/// and store. Passes that are left out are grey, with the reason.
std::string FrameGraph(const ExplainedFrame& frame);

/// Returns whether WriteGraph knows the file's ending: .dot, .svg, .png or .pdf.
bool IsGraphFile(const std::filesystem::path& path);

/// Writes the graph: as it is if the file ends in .dot, else drawn by the program `dot`.
/// @throws AssetError         if the file cannot be written, or `dot` fails
/// @throws std::system_error  if there is no `dot`
void WriteGraph(const std::filesystem::path& path, const std::string& graph);

} // namespace limn
