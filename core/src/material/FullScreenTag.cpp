#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/core/Shader.h>
#include <sstream>

namespace limn
{

namespace
{

constexpr const char* k_Key = "LimnFullScreen";

/// "_A or _B is 0"; false if it is not that.
bool ReadZeroes(std::istream& words, std::vector<ShaderPropertyId>& zeroes)
{
    std::string name;
    std::string next = "or";
    while (next == "or" && words >> name >> next)
    {
        zeroes.emplace_back(name);
    }
    return next == "is" && words >> next && next == "0";
}

/// "within 3 texels", "within _Width texels" or nothing; false if it is none of them.
bool ReadReach(std::istream& words, FullScreenTag& tag)
{
    std::string word;
    std::string reach;
    if (!(words >> word))
    {
        return true;
    }
    if (word != "within" || !(words >> reach >> word) || word != "texels" || words >> word)
    {
        return false;
    }
    std::istringstream number(reach);
    float texels = 0.0f;
    if (number >> texels && number.eof() && texels >= 0.0f)
    {
        tag.reach = texels;
        return true;
    }
    tag.reachProperty = ShaderPropertyId(reach);
    return reach.starts_with('_');
}

std::optional<FullScreenTag> Parse(const std::string& value)
{
    FullScreenTag tag;
    if (value == "True")
    {
        return tag;
    }
    std::istringstream words(value);
    std::string word;
    if (words >> tag.output.r >> tag.output.g >> tag.output.b >> tag.output.a)
    {
        const bool isRight = words >> word && word == "where" && ReadZeroes(words, tag.zeroes) &&
                             ReadReach(words, tag);
        return isRight ? std::optional(tag) : std::nullopt;
    }
    words = std::istringstream(value);
    words >> word;
    tag.copied = ShaderPropertyId(word);
    std::string rest;
    std::getline(words, rest);
    return rest == " with alpha 1" ? std::optional(tag) : std::nullopt;
}

} // namespace

bool StaysWithinMesh(const ShaderLabPass& pass)
{
    const std::string* value = pass.tags.Find("LimnWithinMesh");
    return value && *value == "True";
}

std::optional<FullScreenTag> ReadFullScreenTag(const ShaderLabPass& pass, const std::string& file)
{
    const auto& tags = pass.tags.items;
    const auto tag = std::ranges::find(tags, k_Key, &ShaderTag::key);
    if (tag == tags.end())
    {
        return std::nullopt;
    }
    std::optional<FullScreenTag> result = Parse(tag->value);
    if (!result)
    {
        throw AssetError(file, tag->location,
                         std::string(k_Key) + ": '" + tag->value +
                             "' is no promise that limn knows; write \"True\", \"0 0 0 1 where "
                             "_A or _B is 0\", the same with \"within 3 texels\" behind it, or "
                             "\"_BlitTexture with alpha 1\"");
    }
    return result;
}

} // namespace limn
