#include <limn/shaderlab/ShaderLabParser.h>

#include <limn/base/ReadFile.h>

#include <algorithm>

namespace limn
{

namespace
{

/// Unity takes single zero bytes for blanks; a file that has many of them is none of text.
bool isBinary(const std::string& text)
{
    const auto zeros = std::count(text.begin(), text.end(), '\0');
    return static_cast<std::size_t>(zeros) > text.size() / 16;
}

bool isUtf16(const std::string& text)
{
    const std::string start = text.substr(0, 2);
    return start == "\xFF\xFE" || start == "\xFE\xFF";
}

} // namespace

ShaderLabParseResult LoadShaderLabWithDiagnostics(const std::filesystem::path& path)
{
    const std::string file = path.string();
    const std::string text = ReadFile(path);
    if (text.empty())
    {
        throw AssetError(file, {}, "file: it is empty; a shader starts with Shader \"name\"");
    }
    if (isUtf16(text))
    {
        throw AssetError(file, {}, "file: it is in UTF-16; save it in UTF-8");
    }
    if (isBinary(text))
    {
        throw AssetError(file, {}, "file: it is binary; a shader is a text file in UTF-8");
    }
    return ParseShaderLab(text, file);
}

ShaderLabDocument LoadShaderLab(const std::filesystem::path& path)
{
    ShaderLabParseResult result = LoadShaderLabWithDiagnostics(path);
    if (result.hasErrors())
    {
        throw AssetError(std::move(result.diagnostics));
    }
    return std::move(result.document);
}

} // namespace limn
