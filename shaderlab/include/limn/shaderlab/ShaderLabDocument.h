#pragma once

#include <limn/shaderlab/CompiledPass.h>
#include <limn/shaderlab/Diagnostic.h>
#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/RenderState.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The type keyword of a property. Unity stores `Int` as a float (UnityEngine.Rendering.
/// ShaderPropertyType, 2022.3); only `Integer` is an integer.
enum class ShaderPropertyType
{
    Float,
    Range,
    Int,
    Integer,
    Color,
    Vector,
    Texture
};

/// `[…]` before a property, raw: "HDR", "Enum(UnityEngine.Rendering.BlendMode)".
struct ShaderAttribute
{
    SourceLocation location;
    std::string text;

    bool operator==(const ShaderAttribute&) const = default;
};

struct ShaderProperty
{
    SourceLocation location;
    std::string name;
    std::string displayName;
    ShaderPropertyType type = ShaderPropertyType::Float;
    TextureDimension dimension = TextureDimension::Tex2D; ///< `Rect` and `Any` count as 2D
    float rangeMin = 0.0f;                                ///< of a Range
    float rangeMax = 0.0f;
    std::array<float, 4> defaultValue{}; ///< as written: a Color is not converted; numbers in [0]
    std::string defaultTexture;          ///< "white", "bump" …; "" and unknown names mean gray
    std::vector<ShaderAttribute> attributes;

    /// Whether an attribute has this name; its arguments do not matter.
    bool HasAttribute(std::string_view attributeName) const;

    bool operator==(const ShaderProperty&) const = default;
};

struct ShaderTag
{
    SourceLocation location;
    std::string key;
    std::string value;

    bool operator==(const ShaderTag&) const = default;
};

/// The tags of a scope, all `Tags` blocks together, in the order of the file.
struct ShaderTags
{
    std::vector<ShaderTag> items;

    /// The value, or null where the tag is absent. Keys are compared without case.
    const std::string* Find(std::string_view key) const;
    /// Adds a tag; a later value of the same key replaces the earlier one.
    void Set(ShaderTag tag);

    bool operator==(const ShaderTags&) const = default;
};

struct ShaderLabPass
{
    SourceLocation location;
    std::string name; ///< as written; Unity compares pass names without case
    ShaderTags tags;
    RenderState state;                  ///< what the scopes around the pass set is included
    std::optional<PassProgram> program; ///< absent: a legacy pass of fixed-function commands

    /// The LightMode tag; "SRPDefaultUnlit" where there is none, as URP 14 counts such a pass.
    std::string_view lightMode() const;

    bool operator==(const ShaderLabPass&) const = default;
};

struct ShaderLabSubShader
{
    SourceLocation location;
    ShaderTags tags;
    int lod = 0; ///< 0 = none given
    std::vector<ShaderLabPass> passes;

    bool operator==(const ShaderLabSubShader&) const = default;
};

/// `Dependency "name" = "shader"`.
struct ShaderDependency
{
    SourceLocation location;
    std::string name;
    std::string shader;

    bool operator==(const ShaderDependency&) const = default;
};

/// `CustomEditorForRenderPipeline "class" "pipeline asset"`.
struct PipelineEditor
{
    SourceLocation location;
    std::string editor;
    std::string pipelineAsset;

    bool operator==(const PipelineEditor&) const = default;
};

/// A ShaderLab file as plain data: what is written, in the order of the file, nothing compiled.
/// Unity: ShaderLab (2022.3).
struct ShaderLabDocument
{
    std::string file;
    SourceLocation location;
    std::string name;
    std::vector<ShaderProperty> properties;
    std::vector<ShaderLabSubShader> subShaders;
    std::string fallback; ///< "" = off or none given
    std::string customEditor;
    std::vector<PipelineEditor> pipelineEditors;
    std::vector<ShaderDependency> dependencies;

    bool operator==(const ShaderLabDocument&) const = default;
};

} // namespace limn
