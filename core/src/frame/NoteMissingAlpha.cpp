#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

bool BlendsWithAlpha(const FrameNode& node, std::size_t target, const FrameTables& tables)
{
    return AnyDraw(node, tables,
                   [&](const DrawSetup& draw)
                   { return FactorsReadAlpha(draw.state.targets.at(target)); });
}

} // namespace

void NoteMissingAlpha(const FrameNodes& nodes, CompiledFrame& frame)
{
    for (const FrameNode& node : nodes)
    {
        const auto& colors = node.targets.colors;
        for (std::size_t i = 0; i < colors.size(); ++i)
        {
            const GraphicsFormat format = colors[i]->graphicsFormat();
            if (format == GraphicsFormat::B10G11R11_UFloatPack32 && BlendsWithAlpha(node, i, frame))
            {
                frame.notes.push_back("pass '" + std::string(node.name) +
                                      "' blends with the alpha of '" + colors[i]->name() +
                                      "', but its format " + ToString(format) +
                                      " has no alpha: it counts as 1; if this is the camera's "
                                      "colour, set hdrColorBufferPrecision to 64 bits");
            }
        }
    }
}

} // namespace limn
