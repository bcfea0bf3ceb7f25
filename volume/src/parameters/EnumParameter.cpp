#include <limn/volume/ValueParameters.h>

#include <algorithm>

namespace limn::detail
{

namespace
{

/// "Off (0), On (1)"
std::string Listed(const EnumNames& names)
{
    std::string text;
    for (const auto& entry : names)
    {
        text += (text.empty() ? "" : ", ") + entry.name + " (" + std::to_string(entry.value) + ")";
    }
    return text;
}

} // namespace

std::optional<std::int64_t> ReadEnum(const YamlNode& node, std::string_view subject,
                                     AssetDiagnostics& diagnostics, const EnumNames& names)
{
    const auto found =
        std::find_if(names.begin(), names.end(),
                     [&node](const auto& entry)
                     {
                         return node.isScalar() && (entry.name == node.scalar() ||
                                                    std::to_string(entry.value) == node.scalar());
                     });
    if (found == names.end())
    {
        diagnostics.Error(node.location(), std::string(subject) + ": found " + node.Describe() +
                                               "; it must be one of " + Listed(names));
        return std::nullopt;
    }
    return found->value;
}

std::string EnumText(std::int64_t value, const EnumNames& names)
{
    const auto found = std::ranges::find(names, value, &EnumNames::value_type::value);
    return found == names.end() ? std::to_string(value) : found->name;
}

} // namespace limn::detail
