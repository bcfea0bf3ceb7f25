#include <limn/core/Debug.h>

#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limn/base/Diagnostic.h>
#include <limn/base/NumberText.h>
#include <limn/core/CurrentCamera.h>
#include <limn/core/RenderReport.h>
#include <limn/core/RenderingData.h>

namespace limn
{

namespace
{

const char* NameOf(LogType type)
{
    constexpr const char* k_Names[] = {"error", "assertion", "warning", "log", "exception"};
    return k_Names[static_cast<int>(type)];
}

void WriteToStderr(const LogMessage& message)
{
    std::fprintf(stderr, "%s: %s\n", NameOf(message.type), message.text.c_str());
}

std::atomic<LogSink> s_LogSink{&WriteToStderr};

/// Returns the number with this many digits after the decimal point.
std::string Fixed(double value, int digits)
{
    if (!std::isfinite(value))
    {
        return detail::LogTextOf(value);
    }
    char text[512];
    std::snprintf(text, sizeof(text), "%.*f", digits, value);
    return text;
}

template <typename Float>
std::string FloatText(Float value)
{
    if (!std::isfinite(value))
    {
        return std::isnan(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity";
    }
    char text[64]; // no number is that long
    return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

/// @param place  what is between the braces: "0", "1:F2"
std::string Placed(std::string_view format, std::string_view place,
                   const std::vector<detail::LogArgument>& arguments)
{
    std::size_t index = 0;
    const char* const end = place.data() + place.size();
    const auto [rest, error] = std::from_chars(place.data(), end, index);
    if (error != std::errc() || index >= arguments.size())
    {
        throw ContractError("LogFormat '" + std::string(format) + "': there is no value {" +
                            std::string(place) + "}; the call has " +
                            CountText(arguments.size(), "value") + ", counted from 0");
    }
    const detail::LogArgument& argument = arguments[index];
    const std::size_t colon = place.find(':');
    if (!argument.isNumber || colon == std::string_view::npos)
    {
        return argument.text;
    }
    const std::string_view wanted = place.substr(colon + 1);
    const std::size_t point = wanted.find('.');
    if (wanted.find_first_not_of("0#.") == std::string_view::npos) // "0.00"
    {
        return Fixed(argument.number, point == std::string_view::npos
                                          ? 0
                                          : static_cast<int>(wanted.size() - point - 1));
    }
    if (wanted.front() == 'F' || wanted.front() == 'f')
    {
        int digits = 2;
        std::from_chars(wanted.data() + 1, wanted.data() + wanted.size(), digits);
        return Fixed(argument.number, digits);
    }
    return argument.text;
}

} // namespace

void SetLogSink(LogSink sink)
{
    s_LogSink = sink != nullptr ? sink : &WriteToStderr;
}

namespace detail
{

std::string LogTextOf(std::string_view text)
{
    return std::string(text);
}
std::string LogTextOf(bool value)
{
    return value ? "True" : "False";
}
std::string LogTextOf(double value)
{
    return FloatText(value);
}
std::string LogTextOf(float value)
{
    return FloatText(value);
}
std::string LogTextOf(std::span<const float> vector, std::string text, int digits)
{
    for (const float& value : vector)
    {
        text += (&value == vector.data() ? "" : ", ") + Fixed(double{value}, digits);
    }
    return text + ")";
}
std::string LogTextOf(const Color& value)
{
    return LogTextOf(std::span(&value.r, 4), "RGBA(", 3);
}
std::string LogTextOf(const std::exception& value)
{
    return value.what();
}

void Log(LogType type, std::string text)
{
    const RenderingData* camera = CurrentCamera::renderingData();
    const bool isNoted = camera != nullptr && camera->report != nullptr;
    if (isNoted)
    {
        camera->report->notes.push_back(text);
    }
    s_LogSink.load()({type, std::move(text), isNoted});
}

std::string FormatLog(std::string_view format, const std::vector<LogArgument>& arguments)
{
    std::string text;
    for (std::size_t i = 0; i < format.size(); ++i)
    {
        const bool isDoubled = i + 1 < format.size() && format[i + 1] == format[i];
        if ((format[i] == '{' || format[i] == '}') && isDoubled)
        {
            text += format[i++];
        }
        else if (format[i] == '{')
        {
            const std::size_t end = format.find('}', i);
            if (end == std::string_view::npos)
            {
                throw ContractError("LogFormat '" + std::string(format) +
                                    "': a brace is not closed; write a literal brace twice");
            }
            text += Placed(format, format.substr(i + 1, end - i - 1), arguments);
            i = end;
        }
        else
        {
            text += format[i];
        }
    }
    return text;
}

} // namespace detail

} // namespace limn
