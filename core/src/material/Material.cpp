#include <algorithm>
#include <cstring>
#include <type_traits>

#include "support/RequireFinite.h"
#include "support/UniqueId.h"
#include <limn/core/Material.h>
#include <limn/core/Mathf.h>

#include "material/PropertyValues.h"
#include <limn/base/Case.h>
#include <limn/core/FilteringSettings.h>

namespace limn
{

namespace
{

const ShaderProperty* FindProperty(const Shader& shader, const std::string& name)
{
    const auto& properties = shader.document().properties;
    const auto it = std::find_if(properties.begin(), properties.end(),
                                 [&](const ShaderProperty& p) { return p.name == name; });
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

/// @param property  null = it is declared nowhere
bool isHdr(const ShaderProperty* property)
{
    return property != nullptr && property->HasAttribute("HDR");
}

bool isOneOf(const ShaderProperty* property, std::initializer_list<ShaderPropertyType> types)
{
    return property != nullptr && std::ranges::find(types, property->type) != types.end();
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
    if (isHdr(FindProperty(*m_Shader, id.name())))
    {
        Set(id, value.vector());
        return;
    }
    Set(id, value);
}

void Material::SetTextureScale(ShaderPropertyId id, const glm::vec2& scale)
{
    SetScaleOffset(id, 0, scale);
}

void Material::SetTextureOffset(ShaderPropertyId id, const glm::vec2& offset)
{
    SetScaleOffset(id, 2, offset);
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
    const auto* vector = As<glm::vec4>(Find(ScaleOffsetId(texture)));
    return vector != nullptr ? *vector : glm::vec4(1.0f, 1.0f, 0.0f, 0.0f);
}

glm::vec2 Material::GetTextureScale(ShaderPropertyId id) const
{
    return ScaleOffset(id);
}

glm::vec2 Material::GetTextureOffset(ShaderPropertyId id) const
{
    const glm::vec4 value = ScaleOffset(id);
    return {value.z, value.w};
}

void Material::SetColorArray(ShaderPropertyId id, const std::vector<Color>& values)
{
    std::vector<glm::vec4> vectors;
    for (const Color& value : values)
    {
        vectors.push_back(value.linear().vector());
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
    const ShaderPropertyValue* value = Find(id);
    if (const auto* number = As<float>(value))
    {
        return *number;
    }
    if (const auto* integer = As<int>(value))
    {
        return static_cast<float>(*integer);
    }
    FailGet(id, "a number");
}

int Material::GetInt(ShaderPropertyId id) const
{
    if (const auto* integer = As<int>(Find(id)))
    {
        return *integer;
    }
    return Mathf::ToInt(GetFloat(id));
}

glm::vec4 Material::GetVector(ShaderPropertyId id) const
{
    const ShaderPropertyValue* value = Find(id);
    if (const auto* vector = As<glm::vec4>(value))
    {
        return *vector;
    }
    if (const auto* color = As<Color>(value))
    {
        return color->linear().vector();
    }
    FailGet(id, "a vector");
}

Color Material::GetColor(ShaderPropertyId id) const
{
    const ShaderPropertyValue* value = Find(id);
    if (const auto* color = As<Color>(value))
    {
        return *color;
    }
    if (const auto* vector = As<glm::vec4>(value))
    {
        const Color linear{vector->x, vector->y, vector->z, vector->w};
        return isHdr(FindProperty(*m_Shader, id.name())) ? linear : linear.gamma();
    }
    FailGet(id, "a colour");
}

glm::mat4 Material::GetMatrix(ShaderPropertyId id) const
{
    if (const auto* matrix = As<glm::mat4>(Find(id)))
    {
        return *matrix;
    }
    FailGet(id, "a matrix");
}

std::shared_ptr<const Texture> Material::GetTexture(ShaderPropertyId id) const
{
    return CopyOf<std::shared_ptr<const Texture>>(Find(id));
}

std::vector<float> Material::GetFloatArray(ShaderPropertyId id) const
{
    return ArrayIn<float>(Find(id));
}

std::vector<glm::vec4> Material::GetVectorArray(ShaderPropertyId id) const
{
    return ArrayIn<glm::vec4>(Find(id));
}

std::vector<glm::mat4> Material::GetMatrixArray(ShaderPropertyId id) const
{
    return ArrayIn<glm::mat4>(Find(id));
}

ShaderPropertyId Material::MainColorId() const
{
    return MainProperty(*m_Shader, "MainColor", "_Color");
}

ShaderPropertyId Material::MainTextureId() const
{
    return MainProperty(*m_Shader, "MainTexture", "_MainTex");
}

bool Material::HasProperty(ShaderPropertyId id) const
{
    return FindProperty(*m_Shader, id.name()) != nullptr;
}

bool Material::HasFloat(ShaderPropertyId id) const
{
    using enum ShaderPropertyType;
    return isOneOf(FindProperty(*m_Shader, id.name()), {Float, Range, Int});
}

bool Material::HasInteger(ShaderPropertyId id) const
{
    return isOneOf(FindProperty(*m_Shader, id.name()), {ShaderPropertyType::Integer});
}

bool Material::HasColor(ShaderPropertyId id) const
{
    return isOneOf(FindProperty(*m_Shader, id.name()), {ShaderPropertyType::Color});
}

bool Material::HasVector(ShaderPropertyId id) const
{
    return isOneOf(FindProperty(*m_Shader, id.name()), {ShaderPropertyType::Vector});
}

bool Material::HasTexture(ShaderPropertyId id) const
{
    return isOneOf(FindProperty(*m_Shader, id.name()), {ShaderPropertyType::Texture});
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

} // namespace limn
