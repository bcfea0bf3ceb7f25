#pragma once

#include <limn/core/MaterialPropertyBlock.h>
#include <limn/core/PipelineState.h>
#include <limn/core/RTHandle.h>
#include <limn/core/Shader.h>
#include <limn/core/ShaderKeyword.h>
#include <map>
#include <memory>
#include <span>
#include <string>

namespace limn
{

/// Unity: UnityEngine.MaterialPropertyType (2022.3).
enum class MaterialPropertyType
{
    Float = 0,  ///< Float, Range and Int
    Int = 1,    ///< Integer
    Vector = 2, ///< Vector and Color
    Matrix = 3, ///< of these three a Properties block has none
    Texture = 4,
    ConstantBuffer = 5,
    ComputeBuffer = 6
};

/// A shader with values for its properties, which begin with the defaults of its Properties block.
/// Values of names that the shader does not have are kept and have no effect, as in Unity; the
/// report of a frame that draws with the material names those that were set in it.
/// Unity: UnityEngine.Material (2022.3).
class Material
{
public:
    /// @throws ContractError if shader is null
    explicit Material(std::shared_ptr<const Shader> shader, std::string name = {});
    /// Makes a material with the values of `source` for another shader, whose own defaults fill in
    /// what `source` lacks, as assigning Material.shader does in Unity.
    /// @throws ContractError if shader is null
    Material(const Material& source, std::shared_ptr<const Shader> shader);

    std::uint64_t id() const { return m_Id; } ///< unique in the process
    const std::string& name() const { return m_Name; }
    const std::shared_ptr<const Shader>& shader() const { return m_Shader; }
    int passCount() const { return m_Shader->passCount(); }
    int FindPass(std::string_view passName) const { return m_Shader->FindPassByName(passName); }
    /// @throws ContractError if there is no such pass
    const std::string& GetPassName(int pass) const { return m_Shader->passName(pass); }

    // Setting a value throws ContractError naming material and property if it is not finite or is
    // an array without elements.
    void SetFloat(ShaderPropertyId id, float value) { Set(id, value); }
    void SetFloat(ShaderPropertyId id, detail::WholeNumber auto value)
    {
        SetFloat(id, static_cast<float>(value));
    }
    void SetInt(ShaderPropertyId id, int value) { Set(id, value); }
    void SetInteger(ShaderPropertyId id, int value) { Set(id, value); }
    void SetVector(ShaderPropertyId id, const glm::vec4& value) { Set(id, value); }
    void SetVector(ShaderPropertyId id, const detail::MadeVector4 auto& value)
    {
        SetVector(id, detail::ToVector4(value));
    }
    /// @param value  in sRGB; the shader gets it in the active colour space, unless the property is
    ///     declared [HDR]: those values are in that space already
    void SetColor(ShaderPropertyId id, const Color& value);
    void SetMatrix(ShaderPropertyId id, const glm::mat4& value) { Set(id, value); }
    // Arrays behave as those of MaterialPropertyBlock.
    void SetFloatArray(ShaderPropertyId id, std::vector<float> v) { Set(id, std::move(v)); }
    void SetVectorArray(ShaderPropertyId id, std::vector<glm::vec4> v) { Set(id, std::move(v)); }
    void SetMatrixArray(ShaderPropertyId id, std::vector<glm::mat4> v) { Set(id, std::move(v)); }
    /// Sets an array of colours, each as SetColor sets a property that is not [HDR].
    void SetColorArray(ShaderPropertyId id, const std::vector<Color>& values);
    void SetTexture(ShaderPropertyId id, std::shared_ptr<const Texture> value)
    {
        Set(id, std::move(value));
    }
    /// @throws ContractError for a handle that wraps an identifier: only command buffers know what
    ///         that stands for
    void SetTexture(ShaderPropertyId id, const RTHandle& value);
    // Buffers behave as those of MaterialPropertyBlock.
    void SetBuffer(ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> value)
    {
        Set(id, BufferRange{std::move(value), 0, 0});
    }
    void SetConstantBuffer(ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> value,
                           int offset, int size)
    {
        Set(id, ConstantRange(std::move(value), offset, size));
    }
    /// Returns the values that were set, or declared.
    const MaterialPropertyBlock& values() const { return m_Values; }
    bool hasBuffers() const { return m_Values.hasBuffers(); }
    /// Returns the names that were set and that the shader's Properties block lacks; its programs
    /// may read them.
    const std::vector<ShaderPropertyId>& undeclared() const { return m_Undeclared; }
    /// Sets how a mesh's coordinates map to the texture `id`; its shader reads that as X_ST.
    void SetTextureScale(ShaderPropertyId id, const glm::vec2& scale)
    {
        SetScaleOffset(id, 0, scale);
    }
    void SetTextureOffset(ShaderPropertyId id, const glm::vec2& offset)
    {
        SetScaleOffset(id, 2, offset);
    }
    const ShaderPropertyValue* Find(ShaderPropertyId id) const { return m_Values.Find(id); }

    // These return the value that was set, or else the default of the shader's Properties block. If
    // there is neither, or it is of another kind, they throw ContractError naming material and
    // property (Unity logs, and gives 0).
    float GetFloat(ShaderPropertyId id) const;
    int GetInt(ShaderPropertyId id) const; ///< a float without its fraction
    int GetInteger(ShaderPropertyId id) const { return GetInt(id); }
    glm::vec4 GetVector(ShaderPropertyId id) const; ///< as shaders read it: a colour is linear
    /// Returns the colour that SetColor would take for it: sRGB, or linear for an [HDR] property.
    Color GetColor(ShaderPropertyId id) const;
    glm::mat4 GetMatrix(ShaderPropertyId id) const;
    // These return null or an empty array if none was set, or something else was.
    std::shared_ptr<const Texture> GetTexture(ShaderPropertyId id) const
    {
        return m_Values.GetTexture(id);
    }
    std::vector<float> GetFloatArray(ShaderPropertyId id) const
    {
        return m_Values.GetFloatArray(id);
    }
    std::vector<glm::vec4> GetVectorArray(ShaderPropertyId id) const
    {
        return m_Values.GetVectorArray(id);
    }
    std::vector<Color> GetColorArray(ShaderPropertyId id) const; ///< sRGB, as SetColorArray's
    std::vector<glm::mat4> GetMatrixArray(ShaderPropertyId id) const
    {
        return m_Values.GetMatrixArray(id);
    }
    /// 1 if none was set
    glm::vec2 GetTextureScale(ShaderPropertyId id) const { return ScaleOffset(id); }
    /// 0 if none was set
    glm::vec2 GetTextureOffset(ShaderPropertyId id) const
    {
        const glm::vec4 value = ScaleOffset(id);
        return {value.z, value.w};
    }

    // These return whether the shader's Properties block has the property, of this kind: one that
    // was only set does not count.
    bool HasProperty(ShaderPropertyId id) const
    {
        return shader()->FindPropertyIndex(id.name()) >= 0;
    }
    /// Float, Range or Int, as in Unity
    bool HasFloat(ShaderPropertyId id) const
    {
        using enum ShaderPropertyType;
        return HasOneOf(id, {Float, Range, Int});
    }
    bool HasInt(ShaderPropertyId id) const { return HasFloat(id); }
    bool HasInteger(ShaderPropertyId id) const
    {
        return HasOneOf(id, {ShaderPropertyType::Integer});
    }
    bool HasColor(ShaderPropertyId id) const { return HasOneOf(id, {ShaderPropertyType::Color}); }
    bool HasVector(ShaderPropertyId id) const { return HasOneOf(id, {ShaderPropertyType::Vector}); }
    bool HasTexture(ShaderPropertyId id) const
    {
        return HasOneOf(id, {ShaderPropertyType::Texture});
    }
    // A Properties block has none of these kinds, so these return whether one was set.
    bool HasMatrix(ShaderPropertyId id) const { return m_Values.HasMatrix(id); }
    bool HasBuffer(ShaderPropertyId id) const { return m_Values.HasBuffer(id); }
    bool HasConstantBuffer(ShaderPropertyId id) const { return m_Values.HasConstantBuffer(id); }
    // These return what SetBuffer and SetConstantBuffer set; null = nothing. Unity's functions
    // return handles.
    std::shared_ptr<const GraphicsBuffer> GetBuffer(ShaderPropertyId id) const
    {
        return m_Values.GetBuffer(id);
    }
    std::shared_ptr<const GraphicsBuffer> GetConstantBuffer(ShaderPropertyId id) const
    {
        return HasConstantBuffer(id) ? GetBuffer(id) : nullptr;
    }
    /// Has no effect: equal meshes and states become instances of one draw by themselves.
    bool enableInstancing = false;

    // These get and set the property with the attribute [MainColor] or [MainTexture], or else
    // _Color and _MainTex; getting throws as GetColor does. Unity: Material.color, mainTexture ...
    // (2022.3).
    Color color() const { return GetColor(MainColorId()); }
    void SetColor(const Color& value) { SetColor(MainColorId(), value); }
    std::shared_ptr<const Texture> mainTexture() const { return GetTexture(MainTextureId()); }
    void SetMainTexture(std::shared_ptr<const Texture> v) { SetTexture(MainTextureId(), v); }
    glm::vec2 mainTextureScale() const { return GetTextureScale(MainTextureId()); }
    void SetMainTextureScale(const glm::vec2& v) { SetTextureScale(MainTextureId(), v); }
    glm::vec2 mainTextureOffset() const { return GetTextureOffset(MainTextureId()); }
    void SetMainTextureOffset(const glm::vec2& v) { SetTextureOffset(MainTextureId(), v); }

    // These return names of the shader's Properties block, in its order.
    std::vector<std::string> GetPropertyNames(MaterialPropertyType type) const;
    std::vector<std::string> GetTexturePropertyNames() const
    {
        return GetPropertyNames(MaterialPropertyType::Texture);
    }
    std::vector<ShaderPropertyId> GetTexturePropertyNameIDs() const;

    /// Returns the value that SetOverrideTag set, or else a tag of the shader's SubShader, in any
    /// case; `defaultValue` if there is none.
    /// @param searchFallbacks  no effect: the SubShader that is drawn with has them
    /// @source Unity: Material.GetTag (2022.3)
    std::string GetTag(std::string_view tag, bool searchFallbacks,
                       std::string_view defaultValue = {}) const;

    /// Sets the value that GetTag returns.
    /// @param val  empty: the shader's own value again
    /// @source Unity: Material.SetOverrideTag (2022.3)
    void SetOverrideTag(std::string_view tag, std::string_view val);

    /// Sets values between those of two materials at t = 0 and 1, for what both have as a float, a
    /// vector or a colour. The rest stays. t is clamped.
    /// @source Unity: Material.Lerp (2022.3)
    void Lerp(const Material& start, const Material& end, float t);

    /// Copies the values of another material for the properties that both shaders have.
    /// @source Unity: Material.CopyMatchingPropertiesFromMaterial (2022.3)
    void CopyMatchingPropertiesFromMaterial(const Material& mat);
    /// Copies the values, keywords and render queue of another material, not its shader.
    /// @source Unity: Material.CopyPropertiesFromMaterial (2022.3)
    void CopyPropertiesFromMaterial(const Material& mat);

    /// Switches a keyword. Keywords choose the variant of each pass; they begin with the shader's
    /// initial ones. A keyword that the shader does not have is kept and has no effect, as in
    /// Unity. A keyword of a dynamic_branch is a value that draws pass to the shader: switching it
    /// compiles nothing.
    void EnableKeyword(const std::string& keyword);
    void DisableKeyword(const std::string& keyword);
    bool IsKeywordEnabled(std::string_view keyword) const;
    void EnableKeyword(const LocalKeyword& keyword) { EnableKeyword(keyword.name()); }
    void DisableKeyword(const LocalKeyword& keyword) { DisableKeyword(keyword.name()); }
    bool IsKeywordEnabled(const LocalKeyword& keyword) const
    {
        return IsKeywordEnabled(keyword.name());
    }
    void SetKeyword(const LocalKeyword& keyword, bool value)
    {
        value ? EnableKeyword(keyword) : DisableKeyword(keyword);
    }
    /// Returns the keywords that are on, sorted. Unity: Material.shaderKeywords.
    const std::vector<std::string>& shaderKeywords() const { return m_Keywords; }
    /// Returns the pass in the variant of these keywords, as Shader::Compile does.
    /// @param globalKeywords  the keywords that are on for all materials, sorted
    std::shared_ptr<const ShaderProgram>
    Compile(int passIndex, std::span<const std::string> globalKeywords = {}) const;

    /// Switches whether renderers of this material are drawn with passes of this LightMode;
    /// otherwise they are drawn as if its shader had none. Only DrawRenderers and renderer lists
    /// look at it.
    /// @param passName  a LightMode, in any case; one that the shader does not have has no effect
    /// @source Unity: Material.SetShaderPassEnabled (2022.3)
    void SetShaderPassEnabled(std::string_view passName, bool enabled);
    bool GetShaderPassEnabled(std::string_view passName) const;
    /// Returns the shader's first pass of this LightMode, or -1 if it has none or that is switched
    /// off.
    int FindEnabledPassByLightMode(ShaderTagId lightMode) const
    {
        const int pass = m_Shader->FindPassByLightMode(lightMode);
        return m_DisabledPasses.empty() || pass < 0 || isEnabled(pass) ? pass : -1;
    }

    /// Return the queue by which draws are filtered and sorted: the shader's unless it is set here.
    int rawRenderQueue() const { return m_RenderQueue; } ///< -1 = the shader's
    int renderQueue() const { return m_RenderQueue < 0 ? m_Shader->renderQueue() : m_RenderQueue; }
    /// @param queue  0...5000, or -1 for the shader's
    /// @throws ContractError outside these
    void SetRenderQueue(int queue);

    /// Returns a number that grows with every change, so that users of resolved values know when to
    /// resolve them again.
    std::uint64_t version() const { return m_Version; }

private:
    void Set(ShaderPropertyId id, ShaderPropertyValue value);
    void SetScaleOffset(ShaderPropertyId texture, int first, const glm::vec2& value);
    void KeywordsChanged();
    bool isEnabled(int pass) const;
    /// Returns whether the Properties block has the property, and of one of these types.
    bool HasOneOf(ShaderPropertyId id, std::initializer_list<ShaderPropertyType> types) const;
    /// Returns whether the property is declared [HDR].
    bool isHdr(ShaderPropertyId id) const;
    ShaderPropertyId MainColorId() const;
    ShaderPropertyId MainTextureId() const;
    glm::vec4 ScaleOffset(ShaderPropertyId texture) const;
    [[noreturn]] void FailGet(ShaderPropertyId id, const char* kind) const;

    std::uint64_t m_Id;
    std::string m_Name;
    std::shared_ptr<const Shader> m_Shader;
    MaterialPropertyBlock m_Values;
    std::vector<ShaderPropertyId> m_Undeclared;
    std::vector<std::string> m_Keywords;               ///< sorted
    std::vector<std::string> m_DisabledPasses;         ///< LightModes in lower case
    std::map<std::string, std::string> m_OverrideTags; ///< by tag in lower case
    bool m_HasInitialKeywords = true;
    int m_RenderQueue = -1;
    std::uint64_t m_Version = 0;
};

} // namespace limn
