#include <limn/shaderlab/VariantCount.h>

#include "keywords/DynamicKeywords.h"
#include <limn/base/WordList.h>

#include <algorithm>
#include <set>

namespace limn
{

namespace
{

constexpr std::uint64_t k_Base = 1'000'000'000;

std::set<std::string, std::less<>> SkippedKeywords(const PassProgram& program)
{
    std::set<std::string, std::less<>> skipped;
    for (const ProgramPragma& pragma : program.pragmas)
    {
        if (pragma.name == "skip_variants")
        {
            const auto words = SplitWords(pragma.arguments);
            skipped.insert(words.begin(), words.end());
        }
    }
    return skipped;
}

} // namespace

VariantCount::VariantCount(std::uint32_t value)
{
    for (; value > 0; value = static_cast<std::uint32_t>(value / k_Base))
    {
        m_Parts.push_back(static_cast<std::uint32_t>(value % k_Base));
    }
}

VariantCount& VariantCount::operator+=(const VariantCount& other)
{
    m_Parts.resize(std::max(m_Parts.size(), other.m_Parts.size()));
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < m_Parts.size(); ++i)
    {
        carry += m_Parts[i];
        carry += i < other.m_Parts.size() ? other.m_Parts[i] : 0;
        m_Parts[i] = static_cast<std::uint32_t>(carry % k_Base);
        carry /= k_Base;
    }
    if (carry > 0)
    {
        m_Parts.push_back(static_cast<std::uint32_t>(carry));
    }
    return *this;
}

VariantCount& VariantCount::operator*=(std::uint32_t factor)
{
    std::uint64_t carry = 0;
    for (std::uint32_t& part : m_Parts)
    {
        carry += std::uint64_t{part} * factor;
        part = static_cast<std::uint32_t>(carry % k_Base);
        carry /= k_Base;
    }
    for (; carry > 0; carry /= k_Base)
    {
        m_Parts.push_back(static_cast<std::uint32_t>(carry % k_Base));
    }
    while (!m_Parts.empty() && m_Parts.back() == 0)
    {
        m_Parts.pop_back();
    }
    return *this;
}

std::string VariantCount::ToString() const
{
    std::string text = m_Parts.empty() ? "0" : std::to_string(m_Parts.back());
    for (std::size_t i = m_Parts.size(); i-- > 1;)
    {
        const std::string part = std::to_string(m_Parts[i - 1]);
        text.append(9 - part.size(), '0').append(part);
    }
    return text;
}

VariantCount CountVariants(const PassProgram& program)
{
    const auto skipped = SkippedKeywords(program);
    const auto dynamic = DynamicKeywords(program);
    std::set<std::set<std::string>> counted;
    VariantCount count(1);
    for (const KeywordSet& set : program.keywordSets)
    {
        std::set<std::string> words(set.keywords.begin(), set.keywords.end());
        std::erase_if(words, [&](const std::string& word) { return dynamic.count(word) > 0; });
        if (set.isDynamic || words.empty() || !counted.insert(words).second)
        {
            continue;
        }
        const auto kept = std::ranges::count_if(words, [&](const std::string& word)
                                                { return skipped.count(word) == 0; });
        count *= static_cast<std::uint32_t>(kept);
    }
    return count;
}

} // namespace limn
