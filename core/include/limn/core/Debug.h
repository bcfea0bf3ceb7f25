#pragma once

#include <concepts>
#include <exception>
#include <limn/core/Color.h>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace limn
{

/// Unity: UnityEngine.LogType (2022.3).
enum class LogType
{
    Error = 0,
    Assert = 1,
    Warning = 2,
    Log = 3,
    Exception = 4
};

/// A message from the author of a feature.
struct LogMessage
{
    LogType type = LogType::Log;
    std::string text;
    bool isNoted = false; ///< it is also in the report of the camera that is rendered
};

/// Receives each message on the thread that logs it.
using LogSink = void (*)(const LogMessage& message);
/// Sets the sink of all messages.
/// @param sink  replaces the sink before it; null: a line on stderr, which is the default
void SetLogSink(LogSink sink);

namespace detail
{

/// Returns the text that C# writes for a value: numbers the shortest way, `True`, `(1.00, 2.00)`.
std::string LogTextOf(std::string_view text);
std::string LogTextOf(bool value);
std::string LogTextOf(double value);
std::string LogTextOf(float value);
std::string LogTextOf(std::span<const float> vector, std::string before, int digits);
inline std::string LogTextOf(const glm::vec2& value)
{
    return LogTextOf(std::span(&value.x, 2), "(", 2);
}
inline std::string LogTextOf(const glm::vec3& value)
{
    return LogTextOf(std::span(&value.x, 3), "(", 2);
}
inline std::string LogTextOf(const glm::vec4& value)
{
    return LogTextOf(std::span(&value.x, 4), "(", 2);
}
std::string LogTextOf(const Color& value);
std::string LogTextOf(const std::exception& value);

template <typename T>
std::string LogText(const T& value)
{
    if constexpr (std::convertible_to<const T&, std::string_view>)
    {
        return LogTextOf(std::string_view(value));
    }
    else if constexpr (std::is_enum_v<T>)
    {
        return std::to_string(static_cast<long long>(value));
    }
    else if constexpr (std::integral<T> && !std::same_as<T, bool>)
    {
        return std::to_string(value);
    }
    else
    {
        return LogTextOf(value);
    }
}

/// A value of a format string.
struct LogArgument
{
    std::string text;
    double number = 0.0; ///< for a format with digits
    bool isNumber = false;
};
template <typename T>
LogArgument MakeLogArgument(const T& value)
{
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>)
    {
        return {LogText(value), static_cast<double>(value), true};
    }
    else
    {
        return {LogText(value)};
    }
}

void Log(LogType type, std::string text);
/// @throws ContractError for a format that C# does not know, or an index without a value
std::string FormatLog(std::string_view format, const std::vector<LogArgument>& arguments);

template <typename... Args>
void LogFormatted(LogType type, std::string_view format, const Args&... args)
{
    Log(type, FormatLog(format, {MakeLogArgument(args)...}));
}

} // namespace detail

/// Sends messages from the author of a feature to the sink (SetLogSink) and, while a camera is
/// rendered, to the notes of its report. Unity: UnityEngine.Debug (2022.3).
namespace Debug
{

// A context has no effect: there is no editor that could show it.
template <typename T, typename Context = int>
void Log(const T& message, const Context& /*context*/ = {})
{
    detail::Log(LogType::Log, detail::LogText(message));
}
template <typename T, typename Context = int>
void LogWarning(const T& message, const Context& /*context*/ = {})
{
    detail::Log(LogType::Warning, detail::LogText(message));
}
template <typename T, typename Context = int>
void LogError(const T& message, const Context& /*context*/ = {})
{
    detail::Log(LogType::Error, detail::LogText(message));
}
inline void LogException(const std::exception& exception)
{
    detail::Log(LogType::Exception, detail::LogTextOf(exception));
}

/// Logs a formatted message; the format has "{0}", "{1:F2}", and doubled braces, as in C#.
template <typename... Args>
void LogFormat(std::string_view format, const Args&... args)
{
    detail::LogFormatted(LogType::Log, format, args...);
}
template <typename... Args>
void LogWarningFormat(std::string_view format, const Args&... args)
{
    detail::LogFormatted(LogType::Warning, format, args...);
}
template <typename... Args>
void LogErrorFormat(std::string_view format, const Args&... args)
{
    detail::LogFormatted(LogType::Error, format, args...);
}

/// Logs the message if the condition is false, and goes on.
inline void Assert(bool condition, std::string_view message = "Assertion failed")
{
    if (!condition)
    {
        detail::Log(LogType::Assert, std::string(message));
    }
}

} // namespace Debug

} // namespace limn
