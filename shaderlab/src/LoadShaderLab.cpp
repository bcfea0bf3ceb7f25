#include <limn/shaderlab/ShaderLabParser.h>

#include "TextFile.h"

#include <algorithm>

namespace limn
{

ShaderLabDocument LoadShaderLab(const std::filesystem::path& path)
{
    const std::string file = path.string();
    const auto text = ReadTextFile(path);
    if (!text)
    {
        throw AssetError(file, {},
                         std::filesystem::exists(path) ? "file: it cannot be read"
                                                       : "file: no such file");
    }
    if (text->empty())
    {
        throw AssetError(file, {}, "file: it is empty; a shader starts with Shader \"name\"");
    }
    if (text->find('\0') != std::string::npos)
    {
        throw AssetError(file, {}, "file: it is binary; a shader is a text file in UTF-8");
    }
    ShaderLabParseResult result = ParseShaderLab(*text, file);
    if (result.hasErrors())
    {
        throw AssetError(std::move(result.diagnostics));
    }
    return std::move(result.document);
}

} // namespace limn
