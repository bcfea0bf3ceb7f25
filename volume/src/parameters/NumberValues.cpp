#include "parameters/ParameterValues.h"

#include <cmath>
#include <limits>

namespace limn::detail
{

namespace
{

template <typename T>
bool Store(const std::optional<T>& read, T& value)
{
    value = read.value_or(value);
    return read.has_value();
}

std::optional<glm::vec4> ReadNumbers(const ValueSource& source, int count)
{
    return ReadVector(source.node, count, source.subject, source.diagnostics);
}

} // namespace

std::string ListText(std::span<const float> numbers)
{
    std::string text = "[";
    for (const float number : numbers)
    {
        text += (text.size() > 1 ? ", " : "") + LimnText(number);
    }
    return text + "]";
}

std::string FieldsText(std::span<const float> numbers, std::string_view names)
{
    std::string text = "{";
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        text += (i > 0 ? ", " : "") + std::string(1, names[i]) + ": " + UnityText(numbers[i]);
    }
    return text + "}";
}

bool ValueSource::Refuse(std::string_view problem) const
{
    diagnostics.Error(node.location(), std::string(subject).append(": ").append(problem));
    return false;
}

bool ReadValue(const ValueSource& source, bool& value)
{
    return Store(ReadBool(source.node, source.subject, source.diagnostics), value);
}

bool ReadValue(const ValueSource& source, int& value)
{
    return Store(ReadInt(source.node, source.subject, source.diagnostics, source.range), value);
}

bool ReadValue(const ValueSource& source, std::uint32_t& value)
{
    const auto read = ReadInteger(source.node, source.subject, source.diagnostics,
                                  {0.0, std::numeric_limits<std::uint32_t>::max()});
    return Store(read ? std::optional(static_cast<std::uint32_t>(*read)) : std::nullopt, value);
}

bool ReadValue(const ValueSource& source, float& value)
{
    return Store(ReadFloat(source.node, source.subject, source.diagnostics, source.range), value);
}

bool ReadValue(const ValueSource& source, Color& value)
{
    return Store(ReadColor(source.node, source.subject, source.diagnostics), value);
}

bool ReadValue(const ValueSource& source, glm::vec2& value)
{
    const auto read = ReadNumbers(source, 2);
    if (!read)
    {
        return false;
    }
    // Only a range has limits, and of each end one: as its setter does it.
    if (static_cast<float>(source.range.min) > read->x ||
        static_cast<float>(source.range.max) < read->y)
    {
        return source.Refuse(ListText(std::span(&read->x, 2)) + " goes beyond " +
                             RangeText(source.range));
    }
    value = glm::vec2(*read);
    return true;
}

bool ReadValue(const ValueSource& source, glm::vec3& value)
{
    const auto read = ReadNumbers(source, 3);
    return Store(read ? std::optional(glm::vec3(*read)) : std::nullopt, value);
}

bool ReadValue(const ValueSource& source, glm::vec4& value)
{
    return Store(ReadNumbers(source, 4), value);
}

std::string LimnText(bool value)
{
    return value ? "true" : "false";
}

std::string LimnText(float value)
{
    return NumberText(static_cast<double>(value));
}

std::string LimnText(const Color& value)
{
    return FieldsText(std::span(&value.r, 4), "rgba");
}

std::string UnityText(bool value)
{
    return value ? "1" : "0";
}

std::string UnityText(float value)
{
    if (std::isinf(value))
    {
        return value > 0.0f ? "Infinity" : "-Infinity";
    }
    return std::isnan(value) ? "NaN" : NumberText(static_cast<double>(value));
}

std::string UnityText(const Color& value)
{
    return FieldsText(std::span(&value.r, 4), "rgba");
}

} // namespace limn::detail
