#include <limn/volume/YamlRead.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limn/base/Case.h>

namespace limn
{

namespace
{

void Refuse(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
            std::string_view problem)
{
    diagnostics.Error(node.location(), std::string(subject).append(": ").append(problem));
}

/// "camera.fieldOfView: found a map; a number is expected"
void RefuseKind(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                std::string_view expected)
{
    const char* inQuotes = node.isQuoted() ? " in quotes, which is text" : "";
    Refuse(node, subject, diagnostics,
           "found " + node.Describe() + inQuotes + "; " + std::string(expected) + " is expected");
}

/// Parses a number. Returns std::errc{} if all of `text` is one number.
template <typename T>
std::errc ParseNumber(std::string_view text, T& value)
{
    if (!text.empty() && text.front() == '+')
    {
        text.remove_prefix(1);
    }
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && rest != end ? std::errc::invalid_argument : error;
}

/// Returns whether the text is a name of YAML or C for infinity or NaN, in any case and with a
/// sign.
bool IsNonFiniteName(std::string_view text)
{
    std::string name = ToLower(text);
    std::erase_if(name, [](char c) { return c == '.' || c == '+' || c == '-'; });
    return name == "nan" || name == "inf" || name == "infinity";
}

/// Compares as `T`, in which a limit of 0.1 and a value of 0.1 are the same number.
template <typename T>
bool CheckRange(const YamlNode& node, T value, std::string_view subject,
                AssetDiagnostics& diagnostics, ValueRange range)
{
    if (value >= static_cast<T>(range.min) && value <= static_cast<T>(range.max))
    {
        return true;
    }
    Refuse(node, subject, diagnostics, node.scalar() + " is outside " + RangeText(range));
    return false;
}

} // namespace

std::optional<bool> ReadBool(const YamlNode& node, std::string_view subject,
                             AssetDiagnostics& diagnostics)
{
    const std::string& text = node.scalar();
    const bool isPlain = node.isScalar() && !node.isQuoted();
    if (isPlain && (text == "true" || text == "1"))
    {
        return true;
    }
    if (isPlain && (text == "false" || text == "0"))
    {
        return false;
    }
    for (const std::string_view unclear : {"yes", "no", "on", "off", "Yes", "No", "On", "Off"})
    {
        if (isPlain && text == unclear)
        {
            Refuse(node, subject, diagnostics,
                   "found " + node.Describe() +
                       ", which is text in one version of YAML and a truth value in another; true "
                       "or false is expected");
            return std::nullopt;
        }
    }
    RefuseKind(node, subject, diagnostics, "true or false");
    return std::nullopt;
}

bool LooksLikeNumber(const YamlNode& node)
{
    const std::string& text = node.scalar();
    const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    return !node.isQuoted() && text.size() > sign &&
           text.find_first_not_of("0123456789", sign) == std::string::npos;
}

std::optional<std::int64_t> ReadInteger(const YamlNode& node, std::string_view subject,
                                        AssetDiagnostics& diagnostics, ValueRange range)
{
    std::int64_t value = 0;
    const bool isPlain = node.isScalar() && !node.isQuoted();
    const std::errc error =
        isPlain ? ParseNumber(node.scalar(), value) : std::errc::invalid_argument;
    if (error == std::errc::result_out_of_range)
    {
        Refuse(node, subject, diagnostics, node.scalar() + " does not fit in 64 bits");
        return std::nullopt;
    }
    if (error != std::errc{})
    {
        RefuseKind(node, subject, diagnostics, "a whole number");
        return std::nullopt;
    }
    if (!CheckRange(node, static_cast<double>(value), subject, diagnostics, range))
    {
        return std::nullopt;
    }
    return value;
}

std::optional<int> ReadInt(const YamlNode& node, std::string_view subject,
                           AssetDiagnostics& diagnostics, ValueRange range)
{
    range.min = std::max(range.min, static_cast<double>(std::numeric_limits<int>::min()));
    range.max = std::min(range.max, static_cast<double>(std::numeric_limits<int>::max()));
    const std::optional<std::int64_t> value = ReadInteger(node, subject, diagnostics, range);
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

std::optional<float> ReadFloat(const YamlNode& node, std::string_view subject,
                               AssetDiagnostics& diagnostics, ValueRange range)
{
    const bool isPlain = node.isScalar() && !node.isQuoted();
    double value = 0.0;
    if (isPlain && IsNonFiniteName(node.scalar()))
    {
        Refuse(node, subject, diagnostics,
               node.Describe() + " is not a finite number; a number such as 0.5 is expected");
        return std::nullopt;
    }
    const std::errc error =
        isPlain ? ParseNumber(node.scalar(), value) : std::errc::invalid_argument;
    if (error == std::errc::invalid_argument)
    {
        RefuseKind(node, subject, diagnostics, "a number");
        return std::nullopt;
    }
    const float result = static_cast<float>(value);
    if (error != std::errc{} || !std::isfinite(result))
    {
        Refuse(node, subject, diagnostics, node.scalar() + " does not fit in 32 bits");
        return std::nullopt;
    }
    return CheckRange(node, result, subject, diagnostics, range) ? std::optional(result)
                                                                 : std::nullopt;
}

std::optional<std::string> ReadString(const YamlNode& node, std::string_view subject,
                                      AssetDiagnostics& diagnostics)
{
    if (!node.isScalar())
    {
        RefuseKind(node, subject, diagnostics, "text");
        return std::nullopt;
    }
    return node.scalar();
}

std::string RangeText(ValueRange range)
{
    return "[" + NumberText(range.min) + ", " + NumberText(range.max) + "]";
}

} // namespace limn
