#include "report/figures/Numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace limn::study
{

namespace
{

template <typename... Format>
std::string ToText(double value, Format... format)
{
    char text[400]; // the largest double has 309 digits
    const auto [end, error] = std::to_chars(text, text + sizeof(text), value, format...);
    return std::string(text, end);
}

} // namespace

std::string Readable(double value)
{
    if (std::isnan(value))
    {
        return "NaN";
    }
    if (std::isinf(value))
    {
        return value < 0.0 ? "-infinite" : "infinite";
    }
    const double size = std::abs(value);
    if (value == 0.0)
    {
        return "0";
    }
    if (size < 1e-4 || size >= 1e9)
    {
        return ToText(value, std::chars_format::scientific, 1);
    }
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
    std::string text = ToText(value, std::chars_format::fixed, decimals);
    if (decimals > 0)
    {
        text.erase(text.find_last_not_of('0') + 1); // 0.1, not 0.100
        text.erase(text.find_last_not_of('.') + 1);
    }
    return text;
}

std::string Exact(double value)
{
    return std::isnan(value) ? "nan" : ToText(value);
}

std::string Duration(double seconds)
{
    constexpr double k_Most = 1e9;
    if (!(seconds >= 1.0))
    {
        return "less than 1 s";
    }
    const auto whole = static_cast<long>(std::min(seconds, k_Most) + 0.5);
    const auto part = [](long count, const char* unit)
    {
        return count == 0 ? "" : std::to_string(count) + unit;
    };
    const std::string minutes = part(whole / 60 % 60, " min");
    const std::string large = whole >= 3600 ? part(whole / 3600, " h") : minutes;
    const std::string small = whole >= 3600 ? minutes : part(whole % 60, " s");
    return large + (large.empty() || small.empty() ? "" : " ") + small;
}

} // namespace limn::study
