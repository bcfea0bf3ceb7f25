#include <limn/volume/ProfileEdit.h>

#include <algorithm>

namespace limn
{

namespace
{

bool HasPrefix(std::string_view text, std::string_view name)
{
    return text.size() > name.size() + 1 && text.starts_with(name) && text[name.size()] == '.';
}

/// Whether there is a dot with something before the first and behind the last.
bool IsPath(std::string_view text)
{
    return text.find('.') != std::string_view::npos && text.front() != '.' && text.back() != '.';
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
    std::string text;
    for (const std::string& key : keys)
    {
        text += (text.empty() ? "" : ".") + key;
    }
    return text;
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
    const bool isGood = equals != std::string_view::npos && IsPath(text.substr(0, equals));
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
    return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

YamlNode ParseTypedValue(const std::string& value, const std::string& file)
{
    // A colour is typed without the quotes that YAML needs, since a shell takes them away.
    const bool isColor = !value.empty() && value.front() == '#';
    return ParseYaml(isColor || value.empty() ? "'" + value + "'" : value, file).front();
}

} // namespace limn
