#include <limn/shaderlab/ShaderLabDocument.h>

#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

bool ShaderProperty::HasAttribute(std::string_view attributeName) const
{
    return std::ranges::any_of(
        attributes,
        [&](std::string_view text)
        { return Trim(text.substr(0, text.find('('))) == attributeName; },
        &ShaderAttribute::text);
}

const std::string* ShaderTags::Find(std::string_view key) const
{
    const auto found = std::ranges::find_if(items, [&](const ShaderTag& tag)
                                            { return EqualsIgnoringCase(tag.key, key); });
    return found == items.end() ? nullptr : &found->value;
}

void ShaderTags::Set(ShaderTag tag)
{
    const auto found = std::ranges::find_if(items, [&](const ShaderTag& item)
                                            { return EqualsIgnoringCase(item.key, tag.key); });
    if (found == items.end())
    {
        items.push_back(std::move(tag));
    }
    else
    {
        *found = std::move(tag);
    }
}

std::string_view ShaderLabPass::lightMode() const
{
    if (kind != ShaderLabPassKind::Pass)
    {
        return kind == ShaderLabPassKind::UsePass ? "UsePass" : "GrabPass";
    }
    if (isSurface)
    {
        return "ForwardBase";
    }
    const std::string* tag = tags.Find("LightMode");
    return tag ? std::string_view(*tag) : k_DefaultLightMode;
}

} // namespace limn
