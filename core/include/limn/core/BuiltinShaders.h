#pragma once

#include <limn/core/Shader.h>
#include <limn/core/Texture.h>
#include <memory>
#include <string_view>

namespace limn
{

/// limn's own shaders: "Universal Render Pipeline/Lit", "Universal Render Pipeline/Unlit",
/// "Hidden/Universal/CoreBlit".
const ShaderDatabase& BuiltinShaders();

/// One of BuiltinShaders(); null for any other name.
inline std::shared_ptr<const Shader>
FindBuiltinShader(std::string_view name, const std::shared_ptr<ShaderCompiler>& compiler)
{
    return Shader::Find(name, BuiltinShaders(), compiler);
}

/// A texture of one texel, or one a slice or face, of a ShaderLab default name ("white", "black",
/// "gray", "bump" or "normal", "red", "green", "blue", "clear"; any case); gray for any other. An
/// array has one element. Unity: texture defaults of ShaderLab properties.
std::shared_ptr<const Texture> DefaultTexture(std::string_view name,
                                              TextureDimension dimension = TextureDimension::Tex2D);

} // namespace limn
