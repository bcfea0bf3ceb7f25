#include "port/ClassIndex.h"

#include <algorithm>

namespace limn
{

ClassIndex::ClassIndex(const CSharpFiles& files, std::function<bool(std::string_view)> isOfUnity)
    : m_IsOfUnity(std::move(isOfUnity))
{
    for (const auto& file : files)
    {
        Add(file->classes, nullptr);
    }
}

void ClassIndex::Add(const std::vector<CSharpClass>& classes, const CSharpClass* outer)
{
    for (const CSharpClass& one : classes)
    {
        m_All.push_back(&one);
        m_Outer[&one] = outer;
        m_ByName.emplace(one.name, &one);
        Add(one.classes, &one);
    }
}

bool ClassIndex::isVisible(const CSharpClass& one, const CSharpClass* context) const
{
    const CSharpClass* outer = OuterOf(one);
    if (!outer)
    {
        return true;
    }
    for (; context; context = OuterOf(*context))
    {
        const bool isInherited = std::ranges::any_of(context->bases, [&](const std::string& base)
                                                     { return base == outer->name; });
        if (context == outer || isInherited)
        {
            return true;
        }
    }
    return false;
}

const CSharpClass* ClassIndex::Find(std::string_view type, const CSharpClass* context) const
{
    const std::string_view plain = PlainTypeName(type);
    const std::size_t dot = plain.rfind('.');
    const std::string_view name = plain.substr(dot + 1);
    const std::string_view before = plain.substr(0, dot == std::string_view::npos ? 0 : dot);
    const std::string_view space = before.substr(before.rfind('.') + 1);
    const auto [begin, end] = m_ByName.equal_range(name);
    for (auto found = begin; found != end; ++found)
    {
        const CSharpClass* outer = OuterOf(*found->second);
        if (space.empty() ? isVisible(*found->second, context) : outer && outer->name == space)
        {
            return found->second;
        }
    }
    // Namespaces stand before names, too; a type may have come from where it is visible.
    return begin == end || m_IsOfUnity(name) ? nullptr : begin->second;
}

} // namespace limn
