#include <limn/core/FrameCommands.h>

namespace limn
{

PerDrawData FrameInstances::PerDraw(const DrawCommand& draw, std::uint32_t instance) const
{
    const std::uint32_t element = Element(draw.firstInstance + instance);
    return draw.drawsObjects ? objects->Get(element) : perDraw.at(element);
}

} // namespace limn
