#include <limn/core/ShaderKeyword.h>

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
        std::string known;
        for (const std::string_view keyword : keywords)
        {
            known += (known.empty() ? "" : ", ") + std::string(keyword);
        }
        throw ContractError("shader '" + shader.name() + "' has no keyword '" + m_Name + "'; " +
                            (known.empty() ? "it has none" : "it has " + known));
    }
}

} // namespace limn
