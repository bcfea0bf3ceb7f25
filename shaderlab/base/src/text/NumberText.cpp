#include <limn/base/NumberText.h>

#include <array>
#include <charconv>
#include <cmath>

namespace limn
{

std::string NumberText(double number)
{
    std::array<char, 64> buffer{};
    const double magnitude = std::abs(number);
    const bool isPlain = number == 0.0 || (magnitude >= 1e-4 && magnitude < 1e15);
    const std::chars_format format =
        isPlain ? std::chars_format::fixed : std::chars_format::general;
    // The shortest digits that give the number back: as a float's where it came from one.
    const float asFloat = static_cast<float>(number);
    const bool isFloat = static_cast<double>(asFloat) == number;
    char* end = buffer.data() + buffer.size();
    const auto result = isFloat ? std::to_chars(buffer.data(), end, asFloat, format)
                                : std::to_chars(buffer.data(), end, number, format);
    return {buffer.data(), result.ptr};
}

std::string CountText(std::size_t count, std::string_view noun)
{
    return std::to_string(count).append(" ").append(noun).append(count == 1 ? "" : "s");
}

} // namespace limn
