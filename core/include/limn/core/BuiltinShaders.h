#pragma once

#include <limn/core/Shader.h>
#include <limn/core/Texture.h>
#include <memory>
#include <string_view>

namespace limn
{

/// Returns the shaders of core/shaders: those that have Unity's names ("Universal Render
/// Pipeline/Lit", "Skybox/Procedural", ...) and "Limn/Half Lambert".
const ShaderDatabase& BuiltinShaders();

/// Returns the shader of BuiltinShaders() with this name, or null for any other name.
inline std::shared_ptr<const Shader>
FindBuiltinShader(std::string_view name, const std::shared_ptr<ShaderCompiler>& compiler)
{
    return Shader::Find(name, BuiltinShaders(), compiler);
}

/// Returns "white", "black", "gray" (sRGB), "linearGray", "bump", "red", "green", "blue", "clear".
/// Unity: texture defaults of ShaderLab properties.
std::vector<std::string_view> DefaultTextureNames();

/// Returns a texture of one texel, or of one texel per slice or face, by one of these names in any
/// case. "normal" is the same as "bump"; any other name gives gray. An array has one element.
std::shared_ptr<const Texture> DefaultTexture(std::string_view name,
                                              TextureDimension dimension = TextureDimension::Tex2D);

} // namespace limn
