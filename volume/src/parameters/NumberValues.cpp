#include "parameters/ParameterValues.h"

#include <cmath>
#include <limn/base/Lists.h>

namespace limn::detail
{

std::string ListText(std::span<const float> numbers)
{
    return "[" + Joined(numbers, ", ", [](float number) { return LimnText(number); }) + "]";
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

bool ReadValue(const ValueSource& source, glm::vec2& value)
{
    glm::vec2 read(0.0f);
    if (!limn::ReadValue(source.node, source.subject, source.diagnostics, read))
    {
        return false;
    }
    // Only a range has limits, and of each end one: as its setter does it.
    if (static_cast<float>(source.range.min) > read.x ||
        static_cast<float>(source.range.max) < read.y)
    {
        return source.Refuse(ListText(std::span(&read.x, 2)) + " goes beyond " +
                             RangeText(source.range));
    }
    value = read;
    return true;
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
