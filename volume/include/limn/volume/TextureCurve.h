#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <limn/core/Texture.h>
#include <limn/volume/AnimationCurve.h>
#include <memory>

namespace limn
{

/// A curve over 0...1 that a shader reads as a texture. Unity: TextureCurve (URP 14).
class TextureCurve
{
public:
    static constexpr int k_SampleCount = 128;

    TextureCurve() = default;
    /// @param zeroValue  the value of a curve without keys, at every time
    /// @param loop       if true, the end continues into the beginning
    /// @param bounds     the length of this vector is the period of a loop, as in Unity
    TextureCurve(AnimationCurve curve, float zeroValue, bool loop, const glm::vec2& bounds);
    TextureCurve(AnimationCurve curve, float zeroValue, bool loop, float range);

    float Evaluate(float time) const;

    /// Returns Evaluate(i / 128) for each i.
    std::array<float, k_SampleCount> Samples() const;

    /// Returns the samples as a new 128x1 texture of R16_SFloat, bilinear and clamped.
    std::shared_ptr<const Texture2D> MakeTexture() const;

    const AnimationCurve& curve() const { return m_Curve; }
    float zeroValue() const { return m_ZeroValue; }
    bool loop() const { return m_Loop; }
    float range() const { return m_Range; }

    bool operator==(const TextureCurve&) const = default;

private:
    AnimationCurve m_Curve;
    AnimationCurve m_LoopingCurve; ///< the curve with the neighbours of the first and the last key
    float m_ZeroValue = 0.0f;
    bool m_Loop = false;
    float m_Range = 1.0f;
};

} // namespace limn
