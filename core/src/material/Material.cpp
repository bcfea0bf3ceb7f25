#include <algorithm>

#include "material/RequireFinite.h"
#include "scene/UniqueId.h"
#include <limn/core/Material.h>
#include <limn/core/RenderQueueRange.h>

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
    const ShaderProperty* property = FindProperty(*m_Shader, id.name());
    if (property != nullptr && property->HasAttribute("HDR"))
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
    const ShaderPropertyId id(texture.name() + "_ST");
    const ShaderPropertyValue* old = Find(id);
    const glm::vec4* vector = old != nullptr ? std::get_if<glm::vec4>(old) : nullptr;
    glm::vec4 changed = vector != nullptr ? *vector : glm::vec4(1.0f, 1.0f, 0.0f, 0.0f);
    changed[first] = value.x;
    changed[first + 1] = value.y;
    Set(id, changed);
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
    // Choosing a variant costs more than a draw should.
    if (!m_HasInitialKeywords)
    {
        return m_Shader->Compile(passIndex, m_Keywords, globalKeywords);
    }
    return globalKeywords.empty() ? m_Shader->Compile(passIndex)
                                  : m_Shader->CompileWithGlobals(passIndex, globalKeywords);
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
    m_Values.Set(id, std::move(value));
    ++m_Version;
}

} // namespace limn
