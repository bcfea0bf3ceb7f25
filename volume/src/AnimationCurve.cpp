#include <limn/volume/AnimationCurve.h>

#include <algorithm>
#include <cmath>
#include <limn/shaderlab/Diagnostic.h>

namespace limn
{

namespace
{

bool IsEarlier(const Keyframe& a, const Keyframe& b)
{
    return a.time < b.time;
}

} // namespace

void AnimationCurve::SetKeys(std::vector<Keyframe> keys)
{
    m_Keys = std::move(keys);
    std::stable_sort(m_Keys.begin(), m_Keys.end(), IsEarlier);
}

int AnimationCurve::AddKey(const Keyframe& key)
{
    const auto place = std::lower_bound(m_Keys.begin(), m_Keys.end(), key, IsEarlier);
    if (place != m_Keys.end() && place->time == key.time)
    {
        return -1;
    }
    const auto added = m_Keys.insert(place, key);
    return static_cast<int>(added - m_Keys.begin());
}

void AnimationCurve::RemoveKey(int index)
{
    if (index < 0 || index >= length())
    {
        throw ContractError("a curve of " + std::to_string(length()) + " keys has no key " +
                            std::to_string(index));
    }
    m_Keys.erase(m_Keys.begin() + index);
}

float AnimationCurve::Evaluate(float time) const
{
    if (m_Keys.empty())
    {
        return 0.0f;
    }
    if (!(time >= m_Keys.front().time))
    {
        return m_Keys.front().value;
    }
    const auto right =
        std::upper_bound(m_Keys.begin(), m_Keys.end(), time,
                         [](float wanted, const Keyframe& key) { return wanted < key.time; });
    return right == m_Keys.end() ? m_Keys.back().value
                                 : EvaluateBetween(*(right - 1), *right, time).value;
}

Keyframe AnimationCurve::EvaluateBetween(const Keyframe& left, const Keyframe& right, float time)
{
    if (!std::isfinite(left.outTangent) || !std::isfinite(right.inTangent))
    {
        return {time, left.value};
    }
    // In double: the powers of an un-normalised time lose what a float has.
    const auto leftTime = static_cast<double>(left.time);
    const auto leftValue = static_cast<double>(left.value);
    const auto leftSlope = static_cast<double>(left.outTangent);
    const auto rightSlope = static_cast<double>(right.inTangent);
    const double dx = std::max(static_cast<double>(right.time) - leftTime, 1e-4);
    const double slope = (static_cast<double>(right.value) - leftValue) / dx;
    const double cubic = (leftSlope + rightSlope - 2.0 * slope) / (dx * dx);
    const double square = (3.0 * slope - 2.0 * leftSlope - rightSlope) / dx;
    const double x = static_cast<double>(time) - leftTime;
    const double value = ((cubic * x + square) * x + leftSlope) * x + leftValue;
    const double tangent = (3.0 * cubic * x + 2.0 * square) * x + leftSlope;
    return {time, static_cast<float>(value), static_cast<float>(tangent),
            static_cast<float>(tangent)};
}

} // namespace limn
