#include "report/measure/Statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace limn::study
{

namespace
{

/// Half of what holds 95 % of a normal distribution, in halves of a standard deviation: the signs
/// of n independent values sum up to a standard deviation of √n halves.
constexpr double k_HalfOf95 = 1.96 / 2.0;

/// The value below which that part of the values lies; NaN without any.
double QuantileOf(std::vector<double> values, double part)
{
    if (values.empty())
    {
        return std::numeric_limits<double>::quiet_NaN();
    }
    std::ranges::sort(values);
    const double place = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - std::floor(place));
}

/// The variance of the sum of the signs of a block of neighbours, relative to that of independent
/// signs: 1 where nothing resembles its neighbours, 8 where each eight values are one.
double SignVariance(std::span<const double> values, double median, std::size_t block)
{
    double sum = 0.0;
    const std::size_t blocks = values.size() / block;
    for (std::size_t i = 0; i < blocks; ++i)
    {
        double signs = 0.0;
        for (const double value : values.subspan(i * block, block))
        {
            signs += value > median ? 1.0 : value < median ? -1.0 : 0.0;
        }
        sum += signs * signs / static_cast<double>(block);
    }
    return sum / static_cast<double>(blocks);
}

} // namespace

Spread SpreadOf(std::vector<double> values)
{
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    return {QuantileOf(values, 0.25), QuantileOf(values, 0.5), QuantileOf(values, 0.75)};
}

Bound BoundOfMedian(std::span<const double> inOrder, double disturbed)
{
    constexpr std::size_t k_LeastBlocks = 8; // of which a variance is worth something
    std::vector<double> sorted(inOrder.begin(), inOrder.end());
    std::ranges::sort(sorted);
    const double median = QuantileOf(sorted, 0.5);
    double variance = 1.0;
    for (std::size_t block = 2; block <= sorted.size() / k_LeastBlocks; block *= 2)
    {
        variance = std::max(variance, SignVariance(inOrder, median, block));
    }
    const auto count = static_cast<double>(sorted.size());
    const double reach = k_HalfOf95 * std::sqrt(count * variance);
    const double middle = (count + 1.0) / 2.0; // ranks begin at 1
    const double low = std::floor(middle - reach - disturbed * count / 2.0);
    const double high = std::ceil(middle + reach);
    if (!(low >= 1.0 && high <= count))
    {
        constexpr double k_Unknown = std::numeric_limits<double>::quiet_NaN();
        return {k_Unknown, k_Unknown};
    }
    return {sorted[static_cast<std::size_t>(low) - 1], sorted[static_cast<std::size_t>(high) - 1]};
}

std::vector<std::size_t> TurnsOf(std::size_t techniques, int rounds)
{
    std::mt19937 random; // the standard says what it gives, unlike std::shuffle
    std::vector<std::size_t> order(techniques);
    std::iota(order.begin(), order.end(), std::size_t{1});
    std::vector<std::size_t> turns{0};
    for (int round = 0; round < rounds; ++round)
    {
        for (std::size_t left = techniques; left > 1; --left)
        {
            std::swap(order[left - 1], order[random() % left]);
        }
        for (const std::size_t technique : order)
        {
            turns.insert(turns.end(), {technique, 0});
        }
    }
    return turns;
}

TimesInTurn::TimesInTurn(std::span<const std::size_t> turns, std::span<const double> milliseconds)
    : m_Turns(turns), m_Milliseconds(milliseconds)
{
    for (std::size_t pair = 0; pair < PairCount(); ++pair)
    {
        m_Around.push_back(TimeAround(pair));
    }
    FindQuietTime();
    ChoosePairs();
}

/// The median of the frames without an outline around a pair, its own two left out.
double TimesInTurn::TimeAround(std::size_t pair) const
{
    std::vector<double> around;
    for (std::size_t i = 1; i <= k_Around; ++i)
    {
        if (pair >= i)
        {
            around.push_back(Before(pair - i));
        }
        if (pair + i < PairCount())
        {
            around.push_back(Behind(pair + i));
        }
    }
    return QuantileOf(around, 0.5);
}

/// The median of the frame before a pair and of its neighbours without an outline.
double TimesInTurn::MedianOfThree(std::size_t pair) const
{
    return pair > 0 ? QuantileOf({Before(pair - 1), Before(pair), Behind(pair)}, 0.5)
                    : QuantileOf({Before(pair), Behind(pair)}, 0.5);
}

void TimesInTurn::FindQuietTime()
{
    constexpr double k_LeastNear = 0.25;
    constexpr double k_MostNear = 0.8;
    constexpr double k_Scatters = 4.0;
    std::vector<double> all;
    std::vector<double> scatter;
    for (std::size_t pair = 0; pair < PairCount(); ++pair)
    {
        all.push_back(Before(pair));
        scatter.push_back(std::abs(Before(pair) / m_Around[pair] - 1.0));
    }
    m_Near = std::clamp(k_Scatters * SpreadOf(scatter).median, k_LeastNear, k_MostNear);

    // The median of a tenth would be low by its noise; that of all that is near it is not.
    const double lowest = QuantileOf(m_Around, 0.1);
    std::vector<double> quiet;
    std::vector<double> quietOfThree;
    for (std::size_t pair = 0; pair < PairCount(); ++pair)
    {
        m_IsQuiet.push_back(m_Around[pair] <= lowest * (1.0 + m_Near));
        if (m_IsQuiet.back())
        {
            quiet.push_back(Before(pair));
            quietOfThree.push_back(MedianOfThree(pair));
        }
    }
    m_QuietTime = QuantileOf(quiet, 0.5);
    m_LeastQuietTime = QuantileOf(quietOfThree, 0.1);
    m_BusyTime = QuantileOf(all, 0.95);
}

void TimesInTurn::ChoosePairs()
{
    double quiet = 0.0;
    double disturbed = 0.0;
    double near = 0.0;
    const auto isNear = [this](double time)
    {
        return std::abs(time - m_QuietTime) <= m_Near * m_QuietTime;
    };
    for (std::size_t pair = 0; pair < PairCount(); ++pair)
    {
        const bool isFrameQuiet = m_IsQuiet[pair] && isNear(Before(pair));
        const bool isSlow = Before(pair) > m_QuietTime && !isNear(Before(pair));
        quiet += m_IsQuiet[pair] ? 1.0 : 0.0;
        disturbed += m_IsQuiet[pair] && isSlow ? 1.0 : 0.0;
        near += isFrameQuiet ? 1.0 : 0.0;
        m_Counts.push_back(isFrameQuiet && isNear(Behind(pair)));
    }
    m_Disturbed = quiet > 0.0 ? disturbed / quiet : 0.0;
    m_QuietPart = near / static_cast<double>(PairCount());
}

TimeAdded TimesInTurn::AddedBy(std::size_t technique) const
{
    std::vector<std::size_t> all;
    std::vector<std::size_t> counting;
    for (std::size_t pair = 0; pair < PairCount(); ++pair)
    {
        if (m_Turns[2 * pair + 1] == technique)
        {
            all.push_back(pair);
            counting.insert(counting.end(), m_Counts[pair] ? 1 : 0, pair);
        }
    }
    std::vector<double> frames;
    std::vector<double> differences;
    for (const std::size_t pair : counting.empty() ? all : counting)
    {
        frames.push_back(Outlined(pair));
        differences.push_back(Outlined(pair) - (Before(pair) + Behind(pair)) / 2.0);
    }
    TimeAdded result{SpreadOf(frames), SpreadOf(differences),
                     std::numeric_limits<double>::quiet_NaN()};
    // Occasional disturbances hit a long frame more often. This must be counted: a disturbed frame
    // without an outline rules its pair out, but one with an outline does not.
    const double longer = std::max(1.0, result.frame.median / m_QuietTime);
    const Bound bound = BoundOfMedian(differences, std::min(1.0, m_Disturbed * longer));
    if (!counting.empty() && !std::isnan(bound.low))
    {
        const double slower = bound.low > 0.0 ? std::max(1.0, m_QuietTime / m_LeastQuietTime) : 1.0;
        const double median = result.added.median;
        result.uncertainty = std::max(median - bound.low / slower, bound.high - median);
    }
    return result;
}

bool HasLoadChanged(double quietPart)
{
    constexpr double k_Quiet = 0.9;
    return quietPart < k_Quiet;
}

} // namespace limn::study
