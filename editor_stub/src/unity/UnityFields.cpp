#include "unity/UnityFields.h"

#include <limn/base/ParseWhole.h>

namespace limn
{

void UnityFields::Fail(const UnityNode& node, const std::string& message) const
{
    throw AssetError(m_File, {node ? node.line() : m_Fields.line(), 0}, message);
}

std::size_t UnityFields::Number(const UnityNode& node, std::size_t most) const
{
    const auto value = ParseWhole<std::size_t>(node.text());
    if (node && value.value_or(most + 1) > most)
    {
        Fail(node, std::string(node.key()) + " is '" + std::string(node.text().substr(0, 40)) +
                       "'; a whole number from 0 to " + std::to_string(most) + " is expected");
    }
    return value.value_or(0);
}

std::vector<std::byte> UnityFields::Bytes(const UnityNode& node) const
{
    const auto digit = [&](char c)
    {
        const int value = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;
        if (value < 0)
        {
            Fail(node, std::string(node.key()) + " holds '" + std::string(1, c) +
                           "'; two of 0...9 and a...f for each byte are expected");
        }
        return static_cast<std::uint8_t>(value);
    };
    const std::string_view text = node.text();
    if (text.size() % 2 != 0)
    {
        Fail(node, std::string(node.key()) + " ends within a byte; the file is cut off");
    }
    std::vector<std::byte> bytes(text.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); ++i)
    {
        bytes[i] = static_cast<std::byte>(digit(text[2 * i]) << 4 | digit(text[2 * i + 1]));
    }
    return bytes;
}

} // namespace limn
