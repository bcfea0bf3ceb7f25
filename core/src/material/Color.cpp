#include <limn/core/Color.h>

namespace limn
{

Color Color::HSVToRGB(float h, float s, float v, bool hdr)
{
    // Each component is the value less what the saturation takes where its hue is far.
    const auto component = [&](float hue)
    {
        const float distance = std::abs(std::fmod(h - hue + 1.5f, 1.0f) - 0.5f) * 6.0f;
        return v * (1.0f - s * std::clamp(distance - 1.0f, 0.0f, 1.0f));
    };
    const Color color(component(0.0f), component(1.0f / 3.0f), component(2.0f / 3.0f));
    return hdr ? color
               : Color(std::min(color.r, 1.0f), std::min(color.g, 1.0f), std::min(color.b, 1.0f));
}

void Color::RGBToHSV(const Color& rgbColor, float& h, float& s, float& v)
{
    const auto& [r, g, b, a] = rgbColor;
    v = rgbColor.maxColorComponent();
    const float range = v - std::min({r, g, b});
    s = v > 0.0f ? range / v : 0.0f;
    const float sixth = range <= 0.0f ? 0.0f
                        : v == r      ? (g - b) / range
                        : v == g      ? (b - r) / range + 2.0f
                                      : (r - g) / range + 4.0f;
    const float turn = sixth < 0.0f ? sixth / 6.0f + 1.0f : sixth / 6.0f;
    h = turn < 1.0f ? turn : 0.0f; // so little below 0 is nothing of a turn
}

} // namespace limn
