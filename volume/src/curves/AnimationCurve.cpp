#include <limn/volume/AnimationCurve.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

/// 0 between keys of one time. In double: the difference of two floats need not be one.
double SlopeBetween(const Keyframe& left, const Keyframe& right)
{
    const double distance = static_cast<double>(right.time) - static_cast<double>(left.time);
    const double rise = static_cast<double>(right.value) - static_cast<double>(left.value);
    return distance > 0.0 ? rise / distance : 0.0;
}

/// The time within [first, last] that counts for one outside.
float Wrapped(float time, float first, float last, WrapMode mode)
{
    const double length = static_cast<double>(last) - static_cast<double>(first);
    const bool repeats = mode == WrapMode::Loop || mode == WrapMode::PingPong;
    if (!repeats || !std::isfinite(time) || !(length > 0.0))
    {
        return time > last ? last : time < first ? first : time;
    }
    const double period = mode == WrapMode::Loop ? length : 2.0 * length;
    double offset = std::fmod(static_cast<double>(time) - static_cast<double>(first), period);
    offset += offset < 0.0 ? period : 0.0;
    offset = offset > length ? period - offset : offset;
    return std::clamp(static_cast<float>(static_cast<double>(first) + offset), first, last);
}

bool HasOutWeight(const Keyframe& key)
{
    return key.weightedMode == WeightedMode::Out || key.weightedMode == WeightedMode::Both;
}

bool HasInWeight(const Keyframe& key)
{
    return key.weightedMode == WeightedMode::In || key.weightedMode == WeightedMode::Both;
}

double HandleLength(bool hasWeight, float weight)
{
    return hasWeight ? std::clamp(static_cast<double>(weight), 0.0, 1.0) : 1.0 / 3.0;
}

double Bezier(double a, double b, double c, double d, double u)
{
    const double v = 1.0 - u;
    return v * v * v * a + 3.0 * v * v * u * b + 3.0 * v * u * u * c + u * u * u * d;
}

float EvaluateBezier(const Keyframe& left, const Keyframe& right, float time)
{
    const auto start = static_cast<double>(left.time);
    const double distance = static_cast<double>(right.time) - start;
    const double out = HandleLength(HasOutWeight(left), left.outWeight);
    const double in = HandleLength(HasInWeight(right), right.inWeight);
    const double wanted = (static_cast<double>(time) - start) / distance;
    // Handles within the interval make time grow with the parameter, so halving finds it.
    double low = 0.0;
    double high = 1.0;
    for (int bit = 0; bit < std::numeric_limits<double>::digits; ++bit)
    {
        const double middle = 0.5 * (low + high);
        (Bezier(0.0, out, 1.0 - in, 1.0, middle) < wanted ? low : high) = middle;
    }
    const auto from = static_cast<double>(left.value);
    const auto to = static_cast<double>(right.value);
    const double handle = from + out * distance * static_cast<double>(left.outTangent);
    const double otherHandle = to - in * distance * static_cast<double>(right.inTangent);
    return static_cast<float>(Bezier(from, handle, otherHandle, to, high));
}

} // namespace

void AnimationCurve::SetKeys(std::vector<Keyframe> keys)
{
    m_Keys = std::move(keys);
    std::ranges::stable_sort(m_Keys, {}, &Keyframe::time);
}

int AnimationCurve::AddKey(const Keyframe& key)
{
    const auto place = std::ranges::lower_bound(m_Keys, key.time, {}, &Keyframe::time);
    if (place != m_Keys.end() && place->time == key.time)
    {
        return -1;
    }
    const auto added = m_Keys.insert(place, key);
    return static_cast<int>(added - m_Keys.begin());
}

int AnimationCurve::AddKey(float time, float value)
{
    const int index = AddKey(Keyframe{time, value});
    if (index >= 0)
    {
        SmoothTangents(index, 0.0f);
    }
    return index;
}

void AnimationCurve::SmoothTangents(int index, float weight)
{
    RequireKey(index);
    if (length() < 2)
    {
        return; // no line to take a slope from
    }
    const auto at = static_cast<std::size_t>(index);
    const bool isFirst = at == 0;
    const bool isLast = at + 1 == m_Keys.size();
    const double before = isFirst ? 0.0 : SlopeBetween(m_Keys[at - 1], m_Keys[at]);
    const double behind = isLast ? 0.0 : SlopeBetween(m_Keys[at], m_Keys[at + 1]);
    const double share = isFirst ? 0.0 : isLast ? 1.0 : (1.0 + static_cast<double>(weight)) * 0.5;
    const auto slope = static_cast<float>(share * before + (1.0 - share) * behind);
    m_Keys[at].inTangent = m_Keys[at].outTangent = slope;
}

void AnimationCurve::RemoveKey(int index)
{
    RequireKey(index);
    m_Keys.erase(m_Keys.begin() + index);
}

void AnimationCurve::RequireKey(int index) const
{
    if (index < 0 || index >= length())
    {
        throw ContractError("a curve of " + std::to_string(length()) + " keys has no key " +
                            std::to_string(index));
    }
}

float AnimationCurve::Evaluate(float time) const
{
    if (m_Keys.empty())
    {
        return 0.0f;
    }
    const float first = m_Keys.front().time;
    const float last = m_Keys.back().time;
    if (!(time >= first && time <= last))
    {
        time = Wrapped(time, first, last, time > last ? m_PostWrapMode : m_PreWrapMode);
    }
    if (!(time >= first))
    {
        return m_Keys.front().value;
    }
    const auto right = std::ranges::upper_bound(m_Keys, time, {}, &Keyframe::time);
    if (right == m_Keys.end())
    {
        return m_Keys.back().value;
    }
    const Keyframe& left = *(right - 1);
    const bool isBent = (HasOutWeight(left) || HasInWeight(*right)) &&
                        std::isfinite(left.outTangent) && std::isfinite(right->inTangent);
    return isBent ? EvaluateBezier(left, *right, time) : EvaluateBetween(left, *right, time).value;
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
