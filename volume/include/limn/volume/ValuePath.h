#pragma once

#include <limn/volume/YamlNode.h>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// "NAME.group.value" taken apart: the one form of `--set`, `limn set` and what messages call a
/// value. NAME is a volume component's type, a feature's name or a feature's type; the keys are
/// those that lead to the value in a file.
struct ValuePath
{
    std::string name;
    std::vector<std::string> keys; ///< never empty

    /// @param names  those that there are, which may have dots themselves: the longest that the
    ///     text begins with is its name; the first dot ends any other
    /// @throws ContractError if the text has no dot within it
    static ValuePath Split(std::string_view text, const std::vector<std::string_view>& names);

    std::string KeysText() const; ///< "group.value"
    /// The keys with a value behind them, as if they stood in a file: `group: {value: 3}`.
    YamlNode AsMap(YamlNode value) const;
};

/// "NAME.group.value=VALUE", as a person types it.
struct ValueAssignment
{
    std::string path;  ///< "NAME.group.value"
    std::string value; ///< YAML; a colour's # needs no quotes, nothing is empty text

    /// @throws AssetError about the text as `file` if it has another form
    static ValueAssignment Parse(std::string_view text, const std::string& file);
    /// What is wrong with the form of the text, whatever there is of these names; "" if nothing.
    static std::string FormProblem(std::string_view text);
};

/// A value that a person typed.
/// @throws AssetError as ParseYaml
YamlNode ParseTypedValue(const std::string& value, const std::string& file);

} // namespace limn
