#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

namespace limn
{

// These are GLM's vectors under the names that C# uses, so that `Vector4(1, 1, 0, 0)` can be ported
// as it is; their members are GLM's. Unity: UnityEngine.Vector2 ... (2022.3).

using Vector2 = glm::vec2;
using Vector3 = glm::vec3;
using Vector4 = glm::vec4;
using Vector2Int = glm::ivec2;
using Vector3Int = glm::ivec3;

/// A colour of red, green, blue and alpha, each nominally 0...1 (HDR: above). What a person writes
/// is sRGB; what a shader computes with is linear; the owner of a Color documents which of the two
/// it is. Unity: UnityEngine.Color (2022.3).
struct Color
{
    float r = 0.0f;
    float g = 0.0f;
    float b = 0.0f;
    float a = 1.0f;

    constexpr Color() = default;
    constexpr Color(float red_, float green_, float blue_, float alpha = 1.0f)
        : r(red_), g(green_), b(blue_), a(alpha)
    {
    }

    static const Color white;
    static const Color black;
    static const Color clear; ///< (0, 0, 0, 0)
    static const Color red;
    static const Color green;
    static const Color blue;
    static const Color cyan;
    static const Color magenta;
    static const Color yellow; ///< not (1, 1, 0): easier on the eye, as Unity's
    static const Color gray;
    static const Color grey;

    /// Returns this sRGB colour as linear RGB; alpha is kept. Above 1 the curve goes on as a power
    /// of 2.2, as Unity's does, as far as a float goes. Unity: Color.linear.
    Color linear() const { return {ToLinear(r), ToLinear(g), ToLinear(b), a}; }

    /// Returns this linear colour as sRGB; the inverse of linear(). Unity: Color.gamma.
    Color gamma() const { return {ToSRGB(r), ToSRGB(g), ToSRGB(b), a}; }

    // These compute with the components as they are. Unity: Color.grayscale, maxColorComponent,
    // Lerp ... (2022.3).
    constexpr float grayscale() const { return 0.299f * r + 0.587f * g + 0.114f * b; }
    constexpr float maxColorComponent() const { return std::max({r, g, b}); }
    /// Returns the colour between `a` and `b` at `t`.
    /// @param t  0 gives `a`, 1 gives `b`; clamped to 0...1
    static constexpr Color Lerp(const Color& a, const Color& b, float t)
    {
        return LerpUnclamped(a, b, std::clamp(t, 0.0f, 1.0f));
    }
    static constexpr Color LerpUnclamped(const Color& a, const Color& b, float t)
    {
        return a + (b - a) * t;
    }
    /// Returns the RGB colour of a hue, saturation and value.
    /// @param h, s, v  0...1
    /// @param hdr      if false, no component is above 1
    static Color HSVToRGB(float h, float s, float v, bool hdr = true);
    static void RGBToHSV(const Color& rgbColor, float& h, float& s, float& v);

    constexpr Color operator+(const Color& o) const { return {r + o.r, g + o.g, b + o.b, a + o.a}; }
    constexpr Color operator-(const Color& o) const { return {r - o.r, g - o.g, b - o.b, a - o.a}; }
    constexpr Color operator*(const Color& o) const { return {r * o.r, g * o.g, b * o.b, a * o.a}; }
    constexpr Color operator*(float x) const { return {r * x, g * x, b * x, a * x}; }
    constexpr Color operator/(float x) const { return {r / x, g / x, b / x, a / x}; }
    friend constexpr Color operator*(float x, const Color& color) { return color * x; }

    glm::vec4 vector() const { return {r, g, b, a}; }

    bool operator==(const Color&) const = default;

private:
    static float ToLinear(float s)
    {
        if (s <= 0.04045f)
        {
            return s / 12.92f;
        }
        return s <= 1.0f ? std::pow((s + 0.055f) / 1.055f, 2.4f)
                         : std::min(std::pow(s, 2.2f), std::numeric_limits<float>::max());
    }
    static float ToSRGB(float l)
    {
        if (l <= 0.0031308f)
        {
            return l * 12.92f;
        }
        return l < 1.0f ? 1.055f * std::pow(l, 1.0f / 2.4f) - 0.055f : std::pow(l, 1.0f / 2.2f);
    }
};

inline constexpr Color Color::white{1.0f, 1.0f, 1.0f, 1.0f};
inline constexpr Color Color::black{0.0f, 0.0f, 0.0f, 1.0f};
inline constexpr Color Color::clear{0.0f, 0.0f, 0.0f, 0.0f};
inline constexpr Color Color::red{1.0f, 0.0f, 0.0f, 1.0f};
inline constexpr Color Color::green{0.0f, 1.0f, 0.0f, 1.0f};
inline constexpr Color Color::blue{0.0f, 0.0f, 1.0f, 1.0f};
inline constexpr Color Color::cyan{0.0f, 1.0f, 1.0f, 1.0f};
inline constexpr Color Color::magenta{1.0f, 0.0f, 1.0f, 1.0f};
inline constexpr Color Color::yellow{1.0f, 235.0f / 255.0f, 4.0f / 255.0f, 1.0f};
inline constexpr Color Color::gray{0.5f, 0.5f, 0.5f, 1.0f};
inline constexpr Color Color::grey{0.5f, 0.5f, 0.5f, 1.0f};

namespace detail
{

/// A type that C# converts to Vector4 implicitly; the remaining components are 0.
template <typename T>
concept MadeVector4 =
    std::same_as<T, glm::vec2> || std::same_as<T, glm::vec3> || std::same_as<T, Color>;

inline glm::vec4 ToVector4(const glm::vec2& v)
{
    return {v, 0.0f, 0.0f};
}
inline glm::vec4 ToVector4(const glm::vec3& v)
{
    return {v, 0.0f};
}
inline glm::vec4 ToVector4(const Color& v)
{
    return v.vector();
}

} // namespace detail

/// A colour of four bytes, 255 = 1. Unity: UnityEngine.Color32 (2022.3).
struct Color32
{
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 0;

    constexpr Color32() = default;
    constexpr Color32(std::uint8_t r_, std::uint8_t g_, std::uint8_t b_, std::uint8_t a_)
        : r(r_), g(g_), b(b_), a(a_)
    {
    }
    /// Converts to the nearest Color32; components are clamped to 0...1.
    Color32(const Color& c) : r(ToByte(c.r)), g(ToByte(c.g)), b(ToByte(c.b)), a(ToByte(c.a)) {}
    operator Color() const
    {
        const auto part = [](std::uint8_t byte)
        {
            return static_cast<float>(byte) / 255.0f;
        };
        return {part(r), part(g), part(b), part(a)};
    }
    bool operator==(const Color32&) const = default;

private:
    static std::uint8_t ToByte(float part)
    {
        return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0f, 1.0f) * 255.0f));
    }
};

} // namespace limn
