#include <algorithm>
#include <limn/core/FullScreenTag.h>
#include <limn/shaderlab/Diagnostic.h>
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
        const bool isRight = words >> word && word == "where" && ReadZeroes(words, tag.zeroes);
        return isRight && !(words >> word) ? std::optional(tag) : std::nullopt;
    }
    words = std::istringstream(value);
    words >> word;
    tag.copied = ShaderPropertyId(word);
    std::string rest;
    std::getline(words, rest);
    return rest == " with alpha 1" ? std::optional(tag) : std::nullopt;
}

} // namespace

std::optional<FullScreenTag> ReadFullScreenTag(const ShaderLabPass& pass, const std::string& file)
{
    const auto& tags = pass.tags.items;
    const auto tag = std::find_if(tags.begin(), tags.end(),
                                  [](const ShaderTag& item) { return item.key == k_Key; });
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
                             "_A or _B is 0\" or \"_BlitTexture with alpha 1\"");
    }
    return result;
}

} // namespace limn
