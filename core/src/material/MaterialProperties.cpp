// The functions of a Material that concern the Properties block of its shader as a whole.
#include <algorithm>
#include <limn/base/Case.h>
#include <limn/core/Material.h>

namespace limn
{

namespace
{

MaterialPropertyType TypeOf(const ShaderProperty& property)
{
    switch (property.type)
    {
    case ShaderPropertyType::Float:
    case ShaderPropertyType::Range:
    case ShaderPropertyType::Int:
        return MaterialPropertyType::Float;
    case ShaderPropertyType::Integer:
        return MaterialPropertyType::Int;
    case ShaderPropertyType::Color:
    case ShaderPropertyType::Vector:
        return MaterialPropertyType::Vector;
    case ShaderPropertyType::Texture:
        break;
    }
    return MaterialPropertyType::Texture;
}

/// Returns a value between two values of one kind, or nothing for a kind that has nothing in
/// between.
std::optional<ShaderPropertyValue> Between(const ShaderPropertyValue& start,
                                           const ShaderPropertyValue& end, float t)
{
    return std::visit(
        [&](const auto& from) -> std::optional<ShaderPropertyValue>
        {
            using Value = std::decay_t<decltype(from)>;
            const Value* to = std::get_if<Value>(&end);
            if (to == nullptr)
            {
                return std::nullopt;
            }
            if constexpr (std::is_same_v<Value, float> || std::is_same_v<Value, glm::vec4>)
            {
                return glm::mix(from, *to, t);
            }
            else if constexpr (std::is_same_v<Value, Color>)
            {
                return Color::Lerp(from, *to, t);
            }
            return std::nullopt;
        },
        start);
}

} // namespace

std::vector<std::string> Material::GetPropertyNames(MaterialPropertyType type) const
{
    std::vector<std::string> names;
    for (const ShaderProperty& property : m_Shader->document().properties)
    {
        if (TypeOf(property) == type)
        {
            names.push_back(property.name);
        }
    }
    return names;
}

std::vector<ShaderPropertyId> Material::GetTexturePropertyNameIDs() const
{
    const std::vector<std::string> names = GetTexturePropertyNames();
    return {names.begin(), names.end()};
}

void Material::CopyMatchingPropertiesFromMaterial(const Material& mat)
{
    for (const ShaderProperty& property : m_Shader->document().properties)
    {
        const ShaderPropertyId id(property.name);
        const auto copy = [&](ShaderPropertyId each)
        {
            if (const ShaderPropertyValue* value = mat.Find(each))
            {
                Set(each, *value);
            }
        };
        if (mat.HasProperty(id))
        {
            copy(id);
            copy(ShaderPropertyId(property.name + "_ST"));
        }
    }
}

void Material::Lerp(const Material& start, const Material& end, float t)
{
    for (const ShaderProperty& property : m_Shader->document().properties)
    {
        const ShaderPropertyId id(property.name);
        const ShaderPropertyValue* from = start.Find(id);
        const ShaderPropertyValue* to = end.Find(id);
        if (from != nullptr && to != nullptr)
        {
            if (auto value = Between(*from, *to, std::clamp(t, 0.0f, 1.0f)))
            {
                Set(id, std::move(*value));
            }
        }
    }
}

void Material::SetOverrideTag(std::string_view tag, std::string_view val)
{
    if (val.empty())
    {
        m_OverrideTags.erase(ToLower(tag));
        return;
    }
    m_OverrideTags[ToLower(tag)] = val;
}

std::string Material::GetTag(std::string_view tag, bool /*searchFallbacks*/,
                             std::string_view defaultValue) const
{
    if (const auto own = m_OverrideTags.find(ToLower(tag)); own != m_OverrideTags.end())
    {
        return own->second;
    }
    const std::string* value = m_Shader->subShader().tags.Find(tag);
    return value != nullptr ? *value : std::string(defaultValue);
}

std::vector<Color> Material::GetColorArray(ShaderPropertyId id) const
{
    std::vector<Color> colors;
    for (const glm::vec4& value : GetVectorArray(id))
    {
        colors.push_back(Color(value.x, value.y, value.z, value.w).gamma());
    }
    return colors;
}

} // namespace limn
