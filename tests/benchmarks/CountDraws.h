#pragma once

#include <algorithm>
#include <limn/core/CompiledFrame.h>

namespace limn::benchmarks
{

/// Of all passes.
inline std::size_t CountDraws(const CompiledFrame& frame)
{
    std::size_t count = 0;
    for (const CompiledRenderPass& pass : frame.passes)
    {
        count += static_cast<std::size_t>(
            std::ranges::count_if(pass.commands, [](const PassCommand& command)
                                  { return std::holds_alternative<DrawCommand>(command); }));
    }
    return count;
}

} // namespace limn::benchmarks
