#include <limn/volume/ValueParameters.h>

#include <algorithm>
#include <limn/base/Lists.h>

namespace limn::detail
{

std::optional<std::int64_t> ReadEnum(const YamlNode& node, std::string_view subject,
                                     AssetDiagnostics& diagnostics, const EnumNames& names)
{
    const auto withNumber = [](const auto& entry)
    {
        return entry.name + " (" + std::to_string(entry.value) + ")";
    };
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
                                               "; it must be one of " +
                                               Joined(names, ", ", withNumber));
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
