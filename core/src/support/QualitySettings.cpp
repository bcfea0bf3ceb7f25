#include <atomic>
#include <limn/core/QualitySettings.h>

namespace limn
{

namespace
{

std::atomic<ColorSpace>& Space()
{
    static std::atomic<ColorSpace> s_Space = ColorSpace::Linear;
    return s_Space;
}

} // namespace

ColorSpace QualitySettings::activeColorSpace()
{
    return Space().load(std::memory_order_relaxed);
}

void PlayerSettings::SetColorSpace(ColorSpace space)
{
    Space().store(space, std::memory_order_relaxed);
}

} // namespace limn
