#pragma once

#include <concepts>
#include <limn/core/Texture.h>
#include <limn/volume/ProfileContext.h>
#include <limn/volume/ValueParameters.h>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

using TextureReference = AssetReference<Texture>;

/// A texture of any dimension or of one dimension; blending switches as soon as t > 0. YAML has a
/// path, relative to the file ("" or nothing stands for no texture), or Unity's {fileID: 2800000,
/// guid: ..., type: 3}. Unity's form cannot name a path, so UnityText writes a null reference for a
/// reference that has only a path.
///
/// Reading loads the texture if the ProfileContext does that and the parameter is overridden. Only
/// flat textures can be loaded: a cubemap, a volume texture or a render texture keeps its location,
/// and a note says so. Unity: TextureParameter (URP 14).
class TextureParameter : public detail::ValueParameter<TextureReference>
{
public:
    using ValueParameter::ValueParameter;

    TextureParameter(VolumeComponent* owner, std::string_view name, TextureReference value,
                     std::optional<TextureDimension> textureDimension, bool overrideState = false,
                     ParameterInfo info = {})
        : ValueParameter(owner, name, std::move(value), overrideState, std::move(info)),
          m_Dimension(textureDimension)
    {
    }

    /// Returns the dimension of the textures that an editor offers; nullopt stands for all.
    /// Blending ignores it.
    virtual std::optional<TextureDimension> dimension() const { return m_Dimension; }
    /// Returns whether a file can hold such a texture.
    virtual bool isLoadable() const
    {
        return dimension().value_or(TextureDimension::Tex2D) == TextureDimension::Tex2D;
    }
    std::string_view typeName() const override { return "Texture"; }

private:
    bool ReadNode(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext& context) override;

    std::optional<TextureDimension> m_Dimension;
};

namespace detail
{

/// A parameter of textures of one dimension.
template <TextureDimension itsDimension>
class TextureParameterOf : public TextureParameter
{
public:
    using TextureParameter::TextureParameter;
    std::optional<TextureDimension> dimension() const override { return itsDimension; }
};

} // namespace detail

/// The same as TextureParameter, whose value also switches instead of blending.
/// Unity: NoInterpTextureParameter (URP 14).
using NoInterpTextureParameter = detail::NamedParameter<TextureParameter, "NoInterpTexture">;

/// A flat texture. Unity: Texture2DParameter (URP 14).
using Texture2DParameter =
    detail::NamedParameter<detail::TextureParameterOf<TextureDimension::Tex2D>, "Texture2D">;

/// A volume texture. Unity: Texture3DParameter (URP 14).
using Texture3DParameter =
    detail::NamedParameter<detail::TextureParameterOf<TextureDimension::Tex3D>, "Texture3D">;

/// A texture that is drawn into. Unity: RenderTextureParameter (URP 14).
class RenderTextureParameter : public TextureParameter
{
public:
    using TextureParameter::TextureParameter;
    std::optional<TextureDimension> dimension() const override { return TextureDimension::Tex2D; }
    bool isLoadable() const override { return false; }
    std::string_view typeName() const override { return "RenderTexture"; }
};

/// The same as RenderTextureParameter, whose value also switches instead of blending.
/// Unity: NoInterpRenderTextureParameter (URP 14).
using NoInterpRenderTextureParameter =
    detail::NamedParameter<RenderTextureParameter, "NoInterpRenderTexture">;

/// A cubemap. Unity: CubemapParameter (URP 14).
using CubemapParameter =
    detail::NamedParameter<detail::TextureParameterOf<TextureDimension::Cube>, "Cubemap">;

/// The same as CubemapParameter, whose value also switches instead of blending.
/// Unity: NoInterpCubemapParameter (URP 14).
using NoInterpCubemapParameter = detail::NamedParameter<CubemapParameter, "NoInterpCubemap">;

class Material;

using MaterialReference = AssetReference<Material>;

/// A material; blending switches as soon as t > 0. It is written in YAML and loaded like a
/// TextureParameter. Unity: MaterialParameter (URP 14.0.12).
class MaterialParameter : public detail::ValueParameter<MaterialReference>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "Material"; }

private:
    bool ReadNode(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext& context) override;
};

namespace detail
{

/// The base of all ObjectParameters, which does not depend on the type of their object.
class ObjectParameterBase : public VolumeParameter
{
public:
    /// Does nothing: the parameter is always overridden, as in Unity. Each of the object's
    /// parameters has its own override state.
    void SetOverrideState(bool) override {}
    std::span<VolumeParameter* const> parameters() const override;

    std::string ValueText() const override; ///< the overridden parameters
    std::string UnityText() const override;
    std::string_view typeName() const override { return "Object"; }

protected:
    ObjectParameterBase(VolumeComponent* owner, std::string_view name,
                        std::unique_ptr<VolumeComponent> value, ParameterInfo info);

    std::unique_ptr<VolumeComponent> m_Value;

private:
    virtual std::unique_ptr<VolumeComponent> Create() const = 0;
    bool ReadNode(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext& context) final;
    void InterpValues(const VolumeParameter& from, const VolumeParameter& to, float t) final;
    void CopyValue(const VolumeParameter& other) final;
    const ObjectParameterBase& Cast(const VolumeParameter& other) const;
    void CopyParameters(const VolumeComponent& from);
};

} // namespace detail

/// A group of parameters within a parameter. Blending copies the override states of `to` and blends
/// the parameters overridden there; it does nothing if any of the three has no object. YAML has a
/// map of the object's parameters; those named are overridden. {} stands for no object.
///
/// The object is a VolumeComponent, because parameters register with one. It belongs to this
/// parameter alone: copying a value copies the parameters, where Unity shares the object.
/// Unity: ObjectParameter<T> (URP 14).
template <std::derived_from<VolumeComponent> T>
class ObjectParameter final : public detail::ObjectParameterBase
{
public:
    using VolumeParameter::SetValue;

    /// @param value  may be null
    ObjectParameter(VolumeComponent* owner, std::string_view name, std::unique_ptr<T> value,
                    ParameterInfo info = {})
        : ObjectParameterBase(owner, name, std::move(value), std::move(info))
    {
    }

    void SetValue(std::unique_ptr<T> value) { m_Value = std::move(value); }

    T* value() { return static_cast<T*>(m_Value.get()); } ///< null if there is none
    const T* value() const { return static_cast<const T*>(m_Value.get()); }

private:
    std::unique_ptr<VolumeComponent> Create() const override { return std::make_unique<T>(); }
};

} // namespace limn
