#include <limn/volume/ValueParameter.h>

#include "parameters/ParameterValues.h"

#include <algorithm>
#include <limits>
#include <limn/core/Material.h>
#include <limn/core/Texture.h>

namespace limn::detail
{

namespace
{

// Unity's Lerp functions without their clamp, in the order of operations that C# has.

float Lerp(float from, float to, float t)
{
    return from + (to - from) * t;
}

int Lerp(int from, int to, float t)
{
    // A float holds neither every int nor the difference of two, hence the detours.
    const auto difference = static_cast<float>(static_cast<std::int64_t>(to) - from);
    const float blended = static_cast<float>(from) + difference * t;
    constexpr auto least = static_cast<float>(std::numeric_limits<int>::min());
    return blended >= -least ? std::numeric_limits<int>::max()
                             : static_cast<int>(std::max(least, blended));
}

Color Lerp(const Color& from, const Color& to, float t)
{
    return {Lerp(from.r, to.r, t), Lerp(from.g, to.g, t), Lerp(from.b, to.b, t),
            Lerp(from.a, to.a, t)};
}

template <glm::length_t Count>
glm::vec<Count, float> Lerp(const glm::vec<Count, float>& from, const glm::vec<Count, float>& to,
                            float t)
{
    return from + (to - from) * t;
}

} // namespace

template <typename T>
bool ValueParameter<T>::ReadNode(const YamlNode& node, std::string_view subject,
                                 AssetDiagnostics& diagnostics, const ProfileContext& context)
{
    const ValueRange limits = this->range().value_or(ValueRange{});
    return ReadValue({node, subject, diagnostics, limits, context}, this->m_Value);
}

template <typename T>
std::string ValueParameter<T>::ValueText() const
{
    return LimnText(this->value());
}

template <typename T>
std::string ValueParameter<T>::UnityText() const
{
    return detail::UnityText(this->value());
}

template <typename T>
void LerpParameter<T>::Interp(const T& from, const T& to, float t)
{
    this->m_Value = Lerp(from, to, t);
}

void CheckLimits(const std::string& name, double min, double max)
{
    if (!(min <= max))
    {
        throw ContractError("'" + name + "' has the range " + RangeText({min, max}) +
                            "; the first limit must not be above the second");
    }
}

template class ValueParameter<bool>;
template class ValueParameter<LayerMask>;
template class ValueParameter<RenderingLayerMask>;
template class ValueParameter<AssetReference<Texture>>;
template class ValueParameter<AssetReference<Material>>;
template class ValueParameter<AnimationCurve>;
template class ValueParameter<TextureCurve>;
template class LerpParameter<int>;
template class LerpParameter<float>;
template class LerpParameter<Color>;
template class LerpParameter<glm::vec2>;
template class LerpParameter<glm::vec3>;
template class LerpParameter<glm::vec4>;
template class ValueParameter<int>;
template class ValueParameter<float>;
template class ValueParameter<Color>;
template class ValueParameter<glm::vec2>;
template class ValueParameter<glm::vec3>;
template class ValueParameter<glm::vec4>;

} // namespace limn::detail
