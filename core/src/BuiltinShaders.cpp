#include <algorithm>
#include <cctype>
#include <limn/core/BuiltinShaders.h>
#include <limn/shaderlab/EmbeddedFile.h>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> BuiltinShaders();
}

namespace
{

struct BuiltinShader
{
    std::string_view name;
    std::string_view file;
};

constexpr BuiltinShader k_Shaders[] = {
    {"Universal Render Pipeline/Lit", "Lit.shader"},
    {"Universal Render Pipeline/Unlit", "Unlit.shader"},
    {"Hidden/Universal/CoreBlit", "CoreBlit.shader"},
};

std::shared_ptr<const Texture> SolidTexture(const char* name, int r, int g, int b, int a)
{
    const std::vector<std::byte> texel{static_cast<std::byte>(r), static_cast<std::byte>(g),
                                       static_cast<std::byte>(b), static_cast<std::byte>(a)};
    return std::make_shared<const Texture2D>(name, 1, 1, GraphicsFormat::R8G8B8A8_UNorm, texel);
}

} // namespace

std::shared_ptr<const Shader> FindBuiltinShader(std::string_view name,
                                                const std::shared_ptr<ShaderCompiler>& compiler)
{
    for (const BuiltinShader& shader : k_Shaders)
    {
        for (const EmbeddedFile& file : embedded::BuiltinShaders())
        {
            if (shader.name == name && shader.file == file.path)
            {
                return Shader::FromText(file.text, std::string(file.path), compiler);
            }
        }
    }
    return nullptr;
}

std::vector<std::string_view> BuiltinShaderNames()
{
    std::vector<std::string_view> names;
    for (const BuiltinShader& shader : k_Shaders)
    {
        names.push_back(shader.name);
    }
    return names;
}

std::shared_ptr<const Texture> DefaultTexture(std::string_view name)
{
    static const std::shared_ptr<const Texture> textures[] = {
        SolidTexture("gray", 128, 128, 128, 128), SolidTexture("white", 255, 255, 255, 255),
        SolidTexture("black", 0, 0, 0, 255),      SolidTexture("bump", 128, 128, 255, 128),
        SolidTexture("red", 255, 0, 0, 255),      SolidTexture("green", 0, 255, 0, 255),
        SolidTexture("blue", 0, 0, 255, 255),     SolidTexture("clear", 0, 0, 0, 0)};
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    lower = lower == "normal" ? "bump" : lower;
    const auto found = std::find_if(std::begin(textures), std::end(textures),
                                    [&](const auto& texture) { return texture->name() == lower; });
    return found == std::end(textures) ? textures[0] : *found;
}

} // namespace limn
