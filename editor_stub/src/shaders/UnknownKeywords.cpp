#include "shaders/UnknownKeywords.h"

#include <set>

namespace limn
{

namespace
{

/// Without those that hide behind an #include_with_pragmas.
std::set<std::string> DeclaredKeywords(const std::vector<ShaderCheck>& checks)
{
    std::set<std::string> declared;
    for (const ShaderCheck& check : checks)
    {
        for (const CheckedSubShader& subShader : check.subShaders)
        {
            for (const CheckedPass& pass : subShader.passes)
            {
                const std::vector<KeywordSet> none;
                for (const KeywordSet& set :
                     pass.pass->program ? pass.pass->program->keywordSets : none)
                {
                    declared.insert(set.keywords.begin(), set.keywords.end());
                }
                declared.insert(pass.keywords.begin(), pass.keywords.end());
            }
        }
    }
    declared.erase("");
    return declared;
}

} // namespace

void PrintUnknownKeywords(const std::vector<ShaderCheck>& checks,
                          const std::vector<std::string>& keywords, Console& console)
{
    const std::set<std::string> declared =
        keywords.empty() ? std::set<std::string>() : DeclaredKeywords(checks);
    for (const std::string& keyword : keywords)
    {
        if (declared.count(keyword) == 0)
        {
            console.Warning("--keywords: no pass declares the keyword " +
                            UnknownName(keyword, {declared.begin(), declared.end()}));
        }
    }
}

} // namespace limn
