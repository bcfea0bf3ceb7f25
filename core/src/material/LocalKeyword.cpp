#include <limn/core/ShaderKeyword.h>

#include <limn/base/Lists.h>
#include <limn/core/Shader.h>
#include <set>

namespace limn
{

namespace
{

std::set<std::string_view> KeywordsOf(const Shader& shader)
{
    std::set<std::string_view> keywords;
    for (const ShaderLabPass& pass : shader.subShader().passes)
    {
        if (pass.program)
        {
            for (const KeywordSet& set : pass.program->keywordSets)
            {
                keywords.insert(set.keywords.begin(), set.keywords.end());
            }
        }
    }
    keywords.erase("");
    return keywords;
}

} // namespace

LocalKeyword::LocalKeyword(const Shader& shader, std::string_view name)
    : m_Shader(&shader), m_Name(name)
{
    const std::set<std::string_view> keywords = KeywordsOf(shader);
    if (!keywords.contains(name))
    {
        throw ContractError(
            "shader '" + shader.name() + "' has no keyword '" + m_Name + "'; " +
            (keywords.empty() ? "it has none" : "it has " + Joined(keywords, ", ")));
    }
}

} // namespace limn
