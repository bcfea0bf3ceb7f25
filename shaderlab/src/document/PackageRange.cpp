#include <limn/shaderlab/PackageRange.h>

#include <limn/base/Text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <compare>
#include <optional>

namespace limn
{

namespace
{

struct Version
{
    std::array<int, 3> numbers{};
    bool isRelease = true;           ///< sorts behind the pre-releases of the same numbers
    std::string_view preReleaseName; ///< "-preview.", "b"
    int preReleaseNumber = 0;        ///< that ends it: preview.10 is behind preview.9

    auto operator<=>(const Version&) const = default;
};

/// Nothing if the text does not begin with a number.
std::optional<Version> ReadVersion(std::string_view text)
{
    Version version;
    text = Trim(text);
    for (std::size_t i = 0; i < version.numbers.size(); ++i)
    {
        const auto [end, error] =
            std::from_chars(text.data(), text.data() + text.size(), version.numbers[i]);
        if (error != std::errc{} || version.numbers[i] < 0)
        {
            return std::nullopt;
        }
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (!text.starts_with('.'))
        {
            break;
        }
        text.remove_prefix(1);
    }
    // Unity numbers its own releases 2022.3.10f1; a and b are pre-releases.
    if (text.starts_with('-') || text.starts_with('a') || text.starts_with('b'))
    {
        version.isRelease = false;
        const std::size_t digits = text.find_last_not_of("0123456789") + 1;
        version.preReleaseName = text.substr(0, digits);
        std::from_chars(text.data() + digits, text.data() + text.size(), version.preReleaseNumber);
    }
    return version;
}

/// "[a]", "[a,b)", … without blanks around it.
bool isInInterval(const Version& version, std::string_view text)
{
    const bool hasLow = text.front() == '[';
    const bool hasHigh = text.back() == ']';
    const std::string_view inside = text.substr(1, text.size() - 2);
    const std::size_t comma = inside.find(',');
    if (comma == inside.npos)
    {
        const std::optional<Version> only = ReadVersion(inside);
        return hasLow && hasHigh && only && version == *only;
    }
    const std::string_view ends[] = {Trim(inside.substr(0, comma)), Trim(inside.substr(comma + 1))};
    const std::optional<Version> low = ReadVersion(ends[0]);
    const std::optional<Version> high = ReadVersion(ends[1]);
    if ((!low && !ends[0].empty()) || (!high && !ends[1].empty()))
    {
        return false;
    }
    const bool isAbove = !low || (hasLow ? version >= *low : version > *low);
    const bool isBelow = !high || (hasHigh ? version <= *high : version < *high);
    return isAbove && isBelow;
}

bool isInPart(const Version& version, std::string_view text)
{
    const bool isInterval = text.size() > 2 && (text.front() == '[' || text.front() == '(') &&
                            (text.back() == ']' || text.back() == ')');
    if (isInterval)
    {
        return isInInterval(version, text);
    }
    const std::optional<Version> least = ReadVersion(text);
    return least && version >= *least;
}

} // namespace

bool isInPackageRange(std::string_view version, std::string_view range)
{
    const std::optional<Version> read = ReadVersion(version);
    if (Trim(range).empty())
    {
        return true;
    }
    while (read && !range.empty())
    {
        const std::size_t end = std::min(range.find(';'), range.size());
        const std::string_view part = Trim(range.substr(0, end));
        if (!part.empty() && isInPart(*read, part))
        {
            return true;
        }
        range.remove_prefix(std::min(end + 1, range.size()));
    }
    return false;
}

} // namespace limn
