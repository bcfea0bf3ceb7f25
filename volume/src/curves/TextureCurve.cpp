#include <limn/volume/TextureCurve.h>

#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

namespace limn
{

TextureCurve::TextureCurve(AnimationCurve curve, float zeroValue, bool loop,
                           const glm::vec2& bounds)
    : TextureCurve(std::move(curve), zeroValue, loop, glm::length(bounds))
{
}

TextureCurve::TextureCurve(AnimationCurve curve, float zeroValue, bool loop, float range)
    : m_Curve(std::move(curve)), m_ZeroValue(zeroValue), m_Loop(loop), m_Range(range)
{
    if (m_Loop && m_Curve.length() > 1)
    {
        std::vector<Keyframe> keys(m_Curve.keys().begin(), m_Curve.keys().end());
        keys.insert(keys.begin(), m_Curve.keys().back());
        keys.front().time -= range;
        keys.push_back(m_Curve.keys().front());
        keys.back().time += range;
        m_LoopingCurve.SetKeys(std::move(keys));
    }
}

float TextureCurve::Evaluate(float time) const
{
    if (m_Curve.length() == 0)
    {
        return m_ZeroValue;
    }
    return m_LoopingCurve.length() > 0 ? m_LoopingCurve.Evaluate(time) : m_Curve.Evaluate(time);
}

std::array<float, TextureCurve::k_SampleCount> TextureCurve::Samples() const
{
    std::array<float, k_SampleCount> samples{};
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
        samples[i] = Evaluate(static_cast<float>(i) / static_cast<float>(k_SampleCount));
    }
    return samples;
}

std::shared_ptr<const Texture2D> TextureCurve::MakeTexture() const
{
    std::vector<std::byte> texels(k_SampleCount * sizeof(std::uint16_t));
    std::byte* texel = texels.data();
    for (const float sample : Samples())
    {
        const std::uint16_t half = glm::packHalf1x16(sample);
        std::memcpy(texel, &half, sizeof half);
        texel += sizeof half;
    }
    const SamplerState sampler{FilterMode::Bilinear, TextureWrapMode::Clamp, TextureWrapMode::Clamp,
                               TextureWrapMode::Clamp, false};
    return std::make_shared<const Texture2D>(
        "TextureCurve", k_SampleCount, 1, GraphicsFormat::R16_SFloat, std::move(texels), sampler);
}

} // namespace limn
