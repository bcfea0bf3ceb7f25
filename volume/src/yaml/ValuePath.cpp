#include <limn/volume/ProfileEdit.h>

#include <algorithm>
#include <limn/base/Lists.h>
#include <limn/base/ParseWhole.h>
#include <limn/volume/YamlRead.h>
#include <optional>

namespace limn
{

namespace
{

bool HasPrefix(std::string_view text, std::string_view name)
{
    return text.size() > name.size() + 1 && text.starts_with(name) && text[name.size()] == '.';
}

/// Returns whether there is a dot with something before the first and behind the last.
bool IsPath(std::string_view text)
{
    return text.find('.') != std::string_view::npos && text.front() != '.' && text.back() != '.';
}

/// Returns what stands before "=", "+=", "-=" or "*=".
std::string_view PathBefore(std::string_view text, std::size_t equals)
{
    const bool hasSign =
        equals > 0 && std::string_view("+-*").find(text[equals - 1]) != std::string_view::npos;
    return text.substr(0, equals - (hasSign ? 1 : 0));
}

/// Returns the number that the assignment's sign makes of the one that there is.
std::string Sum(const std::string& current, const ValueAssignment& assignment,
                const std::string& file)
{
    const std::optional<double> old = ParseWhole<double>(current);
    const std::optional<double> operand = ParseWhole<double>(assignment.value);
    if (!old || !operand)
    {
        throw AssetError(file, {},
                         std::string{assignment.sign} + "= needs numbers; the value is " +
                             (old ? "'" + assignment.value + "'" : current));
    }
    const double result = assignment.sign == '+'   ? *old + *operand
                          : assignment.sign == '-' ? *old - *operand
                                                   : *old * *operand;
    return NumberText(static_cast<double>(static_cast<float>(result)));
}

} // namespace

ValuePath ValuePath::Split(std::string_view text, const std::vector<std::string_view>& names)
{
    if (!IsPath(text))
    {
        throw ContractError("ValuePath::Split: '" + std::string(text) + "' has no name and value");
    }
    std::size_t end = 0;
    for (const std::string_view name : names)
    {
        end = HasPrefix(text, name) ? std::max(end, name.size()) : end;
    }
    end = end == 0 ? text.find('.') : end;
    ValuePath path;
    path.name = text.substr(0, end);
    for (std::size_t dot = end; dot != std::string_view::npos;)
    {
        const std::size_t next = text.find('.', dot + 1);
        path.keys.emplace_back(text.substr(dot + 1, next - dot - 1));
        dot = next;
    }
    return path;
}

std::string ValuePath::KeysText() const
{
    return Joined(keys, ".");
}

YamlNode ValuePath::AsMap(YamlNode value) const
{
    for (auto key = keys.rbegin(); key != keys.rend(); ++key)
    {
        YamlContent content;
        content.kind = YamlKind::Map;
        content.entries.push_back({*key, {}, std::move(value)});
        value = YamlNode(std::move(content));
    }
    return value;
}

std::string ValueAssignment::FormProblem(std::string_view text)
{
    const std::size_t equals = text.find('=');
    const bool isGood = equals != std::string_view::npos && IsPath(PathBefore(text, equals));
    return isGood ? "" : "NAME.path=value is expected, ScreenSpaceOutline.m_OutlineWidth=4";
}

ValueAssignment ValueAssignment::Parse(std::string_view text, const std::string& file)
{
    const std::string problem = FormProblem(text);
    if (!problem.empty())
    {
        throw AssetError(file, {}, problem);
    }
    const std::size_t equals = text.find('=');
    const std::string_view path = PathBefore(text, equals);
    return {std::string(path), std::string(text.substr(equals + 1)),
            path.size() < equals ? text[equals - 1] : '='};
}

std::string ValueAssignment::Text() const
{
    return path + (sign == '=' ? "=" : std::string{sign, '='}) + value;
}

std::string ValueAssignment::NewValue(const std::string& current, const std::string& member,
                                      const std::string& file) const
{
    if (member.empty())
    {
        return sign == '=' ? value : Sum(current, *this, file);
    }
    std::string text;
    const YamlNode whole = ParseYaml(current, file).front();
    for (const YamlEntry& entry : whole.entries())
    {
        const std::string& old = entry.value.scalar();
        const std::string fresh =
            entry.key != member ? old : (sign == '=' ? value : Sum(old, *this, file));
        text += (text.empty() ? "" : ", ") + entry.key + ": " + fresh;
    }
    return "{" + text + "}";
}

std::vector<std::string> MembersOfValue(const std::string& valueText)
{
    std::vector<std::string> members;
    if (valueText.starts_with('{'))
    {
        const YamlNode value = ParseYaml(valueText, "").front();
        for (const YamlEntry& entry : value.entries())
        {
            if (!entry.value.isScalar() || !ParseWhole<double>(entry.value.scalar()))
            {
                return {};
            }
            members.push_back(entry.key);
        }
    }
    return members;
}

YamlNode ParseTypedValue(const std::string& value, const std::string& file)
{
    // A colour is typed without the quotes that YAML needs, since a shell takes them away.
    const bool isColor = !value.empty() && value.front() == '#';
    return ParseYaml(isColor || value.empty() ? "'" + value + "'" : value, file).front();
}

} // namespace limn
