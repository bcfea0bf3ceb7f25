#include <limn/volume/ValueParameters.h>

#include "blending/Lerp.h"
#include "parameters/ParameterValues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <limn/core/Material.h>
#include <limn/core/Texture.h>

namespace limn::detail
{

namespace
{

using limn::Lerp;

int Lerp(int from, int to, float t)
{
    const double part = (static_cast<double>(to) - from) * static_cast<double>(t);
    const double blended = from + part;
    const double whole = std::round(blended);
    // 7 of 10 at 0.7f, which is a little less: what a float cannot tell from a whole number is one.
    const bool isWhole = std::abs(blended - whole) <= std::min(0.25, std::abs(part) * 0x1p-24);
    constexpr double least = std::numeric_limits<int>::min(); // of NaN, too
    constexpr double most = std::numeric_limits<int>::max();
    return static_cast<int>(std::min(most, std::max(least, isWhole ? whole : blended)));
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
    glm::vec<Count, float> blended;
    for (glm::length_t i = 0; i < Count; ++i)
    {
        blended[i] = Lerp(from[i], to[i], t);
    }
    return blended;
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
template class ValueParameter<std::uint32_t>;
template class ValueParameter<float>;
template class ValueParameter<Color>;
template class ValueParameter<glm::vec2>;
template class ValueParameter<glm::vec3>;
template class ValueParameter<glm::vec4>;

} // namespace limn::detail
