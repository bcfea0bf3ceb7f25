#include <limn/volume/YamlNode.h>

#include <limn/shaderlab/ReadFile.h>

namespace limn
{

std::string ReadYamlText(const std::filesystem::path& path)
{
    return ReadFile(path, k_MaxTextBytes);
}

std::vector<YamlNode> LoadYamlFile(const std::filesystem::path& path)
{
    return ParseYaml(ReadYamlText(path), path.generic_string());
}

} // namespace limn
