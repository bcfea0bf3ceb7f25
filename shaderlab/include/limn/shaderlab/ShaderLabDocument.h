#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/RenderState.h>
#include <limn/shaderlab/ShaderProgram.h>

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

/// The raw text of a `[…]` before a property: "HDR", "Enum(UnityEngine.Rendering.BlendMode)".
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
    std::string textureType; ///< the keyword of a Texture in Unity's spelling: "2DArray", "Any"
    float rangeMin = 0.0f;   ///< the limits of a Range
    float rangeMax = 0.0f;
    std::array<float, 4> defaultValue{}; ///< as written: a Color is not converted; numbers in [0]
    std::string defaultTexture;          ///< "white", "bump" …; "" and unknown names mean gray
    std::string textureMode; ///< the text in the braces behind it: "TexGen CubeReflect"; no effect
    std::vector<ShaderAttribute> attributes;

    /// Returns whether an attribute has this name, whatever its arguments.
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

/// The tags of all `Tags` blocks of a scope, in the order of the file.
struct ShaderTags
{
    std::vector<ShaderTag> items;

    /// Returns the value of a tag, or null if it is absent. Keys are compared without case.
    const std::string* Find(std::string_view key) const;
    /// Adds a tag; a later value of the same key replaces the earlier one.
    void Set(ShaderTag tag);

    bool operator==(const ShaderTags&) const = default;
};

/// An entry of PackageRequirements: `"package" : "range"`.
struct PackageRequirement
{
    SourceLocation location;
    std::string package;
    std::string range; ///< as written: "1.2", "[1.0,2.0)", "unity=2021.2"; "" = any version

    bool operator==(const PackageRequirement&) const = default;
};

/// A fixed-function command (Lighting, Fog, SetTexture …) in canonical text. It is kept but not
/// used, because limn draws only with programs.
struct LegacyCommand
{
    SourceLocation location;
    std::string text; ///< "Fog { Mode Off }"

    bool operator==(const LegacyCommand&) const = default;
};

/// The LightMode of a pass without that tag. Unity: URP 14.
inline constexpr std::string_view k_DefaultLightMode = "SRPDefaultUnlit";

enum class ShaderLabPassKind
{
    Pass,
    UsePass, ///< a pass of another shader, which usePass names
    GrabPass ///< copies the screen into the texture grabTexture
};

/// An entry of a SubShader's list of passes, in the order of the file. Only a Pass that is no
/// surface shader can have a program that draws.
struct ShaderLabPass
{
    SourceLocation location;
    ShaderLabPassKind kind = ShaderLabPassKind::Pass;
    std::string usePass;     ///< "Shader/Path/PASSNAME" as written; the name follows the last '/'
    std::string grabTexture; ///< "" = _GrabTexture
    /// The pass is a program directly in a SubShader, which is a surface shader.
    bool isSurface = false;
    std::string name; ///< as written; Unity compares pass names without case
    ShaderTags tags;
    std::vector<PackageRequirement> packageRequirements;
    RenderState state;                         ///< includes what the scopes around the pass set
    std::vector<LegacyCommand> legacyCommands; ///< the commands of the scopes around it come first
    std::optional<PassProgram> program;        ///< absent: a legacy pass of fixed-function commands

    /// Returns the LightMode tag, or k_DefaultLightMode if there is none. Entries that URP never
    /// draws by itself have a name that no URP pass asks for: "UsePass", "GrabPass", and
    /// "ForwardBase" for a surface shader.
    std::string_view lightMode() const;

    bool operator==(const ShaderLabPass&) const = default;
};

struct ShaderLabSubShader
{
    SourceLocation location;
    std::vector<PackageRequirement> packageRequirements;
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

/// A ShaderLab file as plain data: its text in the order of the file; nothing is compiled.
/// Unity: ShaderLab (2022.3).
struct ShaderLabDocument
{
    std::string file;
    SourceLocation location;
    std::string name;
    std::vector<ShaderProperty> properties;
    std::vector<ShaderLabSubShader> subShaders;
    std::string fallback;            ///< "" = off or none given
    SourceLocation fallbackLocation; ///< the place of the Fallback command
    std::string customEditor;
    std::vector<PipelineEditor> pipelineEditors;
    std::vector<ShaderDependency> dependencies;

    bool operator==(const ShaderLabDocument&) const = default;
};

} // namespace limn
