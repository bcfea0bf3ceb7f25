#include <algorithm>

#include "material/PropertyValues.h"
#include "support/UniqueId.h"

#include <cstring>
#include <limn/base/Case.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/FilteringSettings.h>
#include <limn/core/Material.h>
#include <limn/core/Mathf.h>
#include <type_traits>

namespace limn
{

namespace
{

const ShaderProperty* FindProperty(const Shader& shader, const std::string& name)
{
    const auto& properties = shader.document().properties;
    const auto it = std::ranges::find(properties, name, &ShaderProperty::name);
    return it == properties.end() ? nullptr : &*it;
}

/// Returns true for a property of the shader, and for what goes with a texture of it: X_ST is set
/// for shaders that do not read it, too.
bool isDeclared(const Shader& shader, std::string_view name)
{
    if (shader.FindPropertyIndex(name) >= 0)
    {
        return true;
    }
    const auto goesWith = [&](std::string_view suffix)
    {
        return name.ends_with(suffix) &&
               shader.FindPropertyIndex(name.substr(0, name.size() - suffix.size())) >= 0;
    };
    return goesWith("_ST") || goesWith("_HDR") || goesWith("_TexelSize");
}

ShaderPropertyId MainProperty(const Shader& shader, std::string_view attribute,
                              std::string_view usual)
{
    for (const ShaderProperty& property : shader.document().properties)
    {
        if (property.HasAttribute(attribute))
        {
            return ShaderPropertyId(property.name);
        }
    }
    return ShaderPropertyId(usual);
}

ShaderPropertyId ScaleOffsetId(ShaderPropertyId texture)
{
    return ShaderPropertyId(texture.name() + "_ST");
}

/// Returns whether two values have the same bytes, for numbers and fixed counts of them; -0 differs
/// from 0.
bool HasSameBytes(const ShaderPropertyValue& a, const ShaderPropertyValue& b)
{
    return a.index() == b.index() &&
           std::visit(
               [&](const auto& value)
               {
                   using Value = std::decay_t<decltype(value)>;
                   if constexpr (std::is_trivially_copyable_v<Value>)
                   {
                       return std::memcmp(&value, &std::get<Value>(b), sizeof(Value)) == 0;
                   }
                   return false;
               },
               a);
}

MaterialPropertyType TypeOf(const ShaderProperty& property)
{
    using enum ShaderPropertyType;
    return property.type == Texture                            ? MaterialPropertyType::Texture
           : property.type == Integer                          ? MaterialPropertyType::Int
           : property.type == Color || property.type == Vector ? MaterialPropertyType::Vector
                                                               : MaterialPropertyType::Float;
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

Material::Material(std::shared_ptr<const Shader> shader, std::string name)
    : m_Id(NextUniqueId()), m_Name(std::move(name)), m_Shader(std::move(shader))
{
    if (!m_Shader)
    {
        throw ContractError("a material needs a shader, but it is null");
    }
    m_Keywords = m_Shader->initialKeywords();
    if (m_Name.empty())
    {
        m_Name = m_Shader->name();
    }
    for (const ShaderProperty& property : m_Shader->document().properties)
    {
        const ShaderPropertyId id(property.name);
        if (Find(id) != nullptr)
        {
            continue; // of properties of one name the first counts
        }
        const auto& v = property.defaultValue;
        switch (property.type)
        {
        case ShaderPropertyType::Float:
        case ShaderPropertyType::Range:
        case ShaderPropertyType::Int:
            SetFloat(id, v[0]);
            break;
        case ShaderPropertyType::Integer:
            SetInt(id, static_cast<int>(v[0]));
            break;
        case ShaderPropertyType::Color:
            SetColor(id, Color{v[0], v[1], v[2], v[3]});
            break;
        case ShaderPropertyType::Vector:
            SetVector(id, {v[0], v[1], v[2], v[3]});
            break;
        case ShaderPropertyType::Texture:
            break; // a texture that was never set is looked up by its default name
        }
    }
}

Material::Material(const Material& source, std::shared_ptr<const Shader> shader)
    : Material(std::move(shader), source.m_Name)
{
    m_Values.SetAll(source.m_Values);
    m_RenderQueue = source.m_RenderQueue;
    m_Keywords = source.m_Keywords;
    KeywordsChanged();
}

void Material::SetColor(ShaderPropertyId id, const Color& value)
{
    isHdr(id) ? Set(id, value.vector()) : Set(id, value);
}

void Material::SetScaleOffset(ShaderPropertyId texture, int first, const glm::vec2& value)
{
    glm::vec4 changed = ScaleOffset(texture);
    changed[first] = value.x;
    changed[first + 1] = value.y;
    Set(ScaleOffsetId(texture), changed);
}

glm::vec4 Material::ScaleOffset(ShaderPropertyId texture) const
{
    const ShaderPropertyId id = ScaleOffsetId(texture);
    return m_Values.HasVector(id) ? m_Values.GetVector(id) : glm::vec4(1.0f, 1.0f, 0.0f, 0.0f);
}

void Material::SetColorArray(ShaderPropertyId id, const std::vector<Color>& values)
{
    std::vector<glm::vec4> vectors;
    for (const Color& value : values)
    {
        vectors.push_back(CoreUtils::ConvertSRGBToActiveColorSpace(value).vector());
    }
    Set(id, std::move(vectors));
}

void Material::SetTexture(ShaderPropertyId id, const RTHandle& value)
{
    Set(id, TextureOf(value, id, "material '" + m_Name + "': "));
}

void Material::FailGet(ShaderPropertyId id, const char* kind) const
{
    throw ContractError("material '" + m_Name + "': property '" + id.name() + "' is " +
                        (Find(id) != nullptr ? "not " : "not set, but it was read as ") + kind);
}

float Material::GetFloat(ShaderPropertyId id) const
{
    if (!m_Values.HasFloat(id) && !m_Values.HasInt(id))
    {
        FailGet(id, "a number");
    }
    return m_Values.GetFloat(id);
}

int Material::GetInt(ShaderPropertyId id) const
{
    return m_Values.HasInt(id) ? m_Values.GetInt(id) : Mathf::ToInt(GetFloat(id));
}

glm::vec4 Material::GetVector(ShaderPropertyId id) const
{
    if (!m_Values.HasVector(id) && !m_Values.HasColor(id))
    {
        FailGet(id, "a vector");
    }
    return m_Values.GetVector(id);
}

Color Material::GetColor(ShaderPropertyId id) const
{
    const ShaderPropertyValue* value = Find(id);
    if (const auto* color = std::get_if<Color>(value))
    {
        return *color;
    }
    if (const auto* vector = std::get_if<glm::vec4>(value))
    {
        const Color linear{vector->x, vector->y, vector->z, vector->w};
        return isHdr(id) ? linear : FromActiveColorSpace(linear);
    }
    FailGet(id, "a colour");
}

bool Material::HasOneOf(ShaderPropertyId id, std::initializer_list<ShaderPropertyType> types) const
{
    const ShaderProperty* property = FindProperty(*m_Shader, id.name());
    return property != nullptr && std::ranges::find(types, property->type) != types.end();
}

bool Material::isHdr(ShaderPropertyId id) const
{
    const ShaderProperty* property = FindProperty(*m_Shader, id.name());
    return property != nullptr && property->HasAttribute("HDR");
}

glm::mat4 Material::GetMatrix(ShaderPropertyId id) const
{
    if (const auto* matrix = std::get_if<glm::mat4>(Find(id)))
    {
        return *matrix;
    }
    FailGet(id, "a matrix");
}

ShaderPropertyId Material::MainColorId() const
{
    return MainProperty(*m_Shader, "MainColor", "_Color");
}

ShaderPropertyId Material::MainTextureId() const
{
    return MainProperty(*m_Shader, "MainTexture", "_MainTex");
}

void Material::CopyPropertiesFromMaterial(const Material& mat)
{
    m_Values.SetAll(mat.m_Values);
    m_RenderQueue = mat.m_RenderQueue;
    m_Keywords = mat.m_Keywords;
    m_DisabledPasses = mat.m_DisabledPasses;
    KeywordsChanged();
}

void Material::EnableKeyword(const std::string& keyword)
{
    const auto place = std::lower_bound(m_Keywords.begin(), m_Keywords.end(), keyword);
    if (place == m_Keywords.end() || *place != keyword)
    {
        m_Keywords.insert(place, keyword);
        KeywordsChanged();
    }
}

void Material::DisableKeyword(const std::string& keyword)
{
    if (std::erase(m_Keywords, keyword) > 0)
    {
        KeywordsChanged();
    }
}

void Material::KeywordsChanged()
{
    m_HasInitialKeywords = m_Keywords == m_Shader->initialKeywords();
    ++m_Version;
}

bool Material::IsKeywordEnabled(std::string_view keyword) const
{
    return std::binary_search(m_Keywords.begin(), m_Keywords.end(), keyword);
}

std::shared_ptr<const ShaderProgram>
Material::Compile(int passIndex, std::span<const std::string> globalKeywords) const
{
    return m_HasInitialKeywords && globalKeywords.empty()
               ? m_Shader->Compile(passIndex)
               : m_Shader->Compile(passIndex, m_Keywords, globalKeywords);
}

void Material::SetShaderPassEnabled(std::string_view passName, bool enabled)
{
    const std::string name = ToLower(passName);
    std::erase(m_DisabledPasses, name);
    if (!enabled)
    {
        m_DisabledPasses.push_back(name);
    }
    ++m_Version;
}

bool Material::GetShaderPassEnabled(std::string_view passName) const
{
    return std::ranges::find(m_DisabledPasses, ToLower(passName)) == m_DisabledPasses.end();
}

bool Material::isEnabled(int pass) const
{
    return GetShaderPassEnabled(m_Shader->passLightMode(pass));
}

void Material::SetRenderQueue(int queue)
{
    if (queue < -1 || queue > RenderQueueRange::maximumBound)
    {
        throw ContractError("material '" + m_Name + "': render queue " + std::to_string(queue) +
                            " is outside 0...5000");
    }
    m_RenderQueue = queue;
    ++m_Version;
}

void Material::Set(ShaderPropertyId id, ShaderPropertyValue value)
{
    if (!isFinite(value) || isEmptyArray(value))
    {
        RequireFinite(value, id, "material '" + m_Name + "': ");
    }
    const ShaderPropertyValue* now = m_Values.Find(id);
    if (now == nullptr && !isDeclared(*m_Shader, id.name()))
    {
        m_Undeclared.push_back(id);
    }
    if (now == nullptr || !HasSameBytes(*now, value))
    {
        m_Values.Set(id, std::move(value));
        ++m_Version; // passes that set in each frame what is there cost the frame nothing
    }
}

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
        for (const ShaderPropertyId each : {id, ScaleOffsetId(id)})
        {
            if (const ShaderPropertyValue* value = mat.Find(each); value && mat.HasProperty(id))
            {
                Set(each, *value);
            }
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
        colors.push_back(FromActiveColorSpace({value.x, value.y, value.z, value.w}));
    }
    return colors;
}

} // namespace limn
