#include "port/csharp/CSharpFile.h"

#include <algorithm>

namespace limn
{

namespace
{

std::string_view WithoutNamespace(std::string_view name)
{
    for (const std::string_view space :
         {"UnityEngine.Experimental.Rendering.", "UnityEngine.Rendering.Universal.",
          "UnityEngine.Rendering.RenderGraphModule.Util.",
          "UnityEngine.Rendering.RenderGraphModule.", "UnityEngine.Rendering.", "UnityEngine.",
          "System.Collections.Generic.", "System.", "Experimental.Rendering."})
    {
        if (name.starts_with(space))
        {
            return name.substr(space.size());
        }
    }
    return name;
}

/// Name, Name.Name, Name<A, B>.
std::string ReadTypeName(const CSharpToken*& at)
{
    std::string name;
    while (at->isName())
    {
        name += (at++)->text;
        if (at->Is("<"))
        {
            name += ReadCSharpGenerics(at);
        }
        if (!(at->Is(".") || at->Is("::")) || !at[1].isName())
        {
            break;
        }
        ++at;
        name += '.';
    }
    return std::string(WithoutNamespace(name));
}

bool IsVisible(const CSharpClass& one, const CSharpClass* context)
{
    for (; one.outer && context; context = context->outer)
    {
        if (context == one.outer || std::ranges::count(context->bases, one.outer->name) > 0)
        {
            return true;
        }
    }
    return !one.outer;
}

} // namespace

std::string ReadCSharpGenerics(const CSharpToken*& at)
{
    const CSharpToken* inner = at + 1;
    std::string text = "<";
    while (!inner->Is(">"))
    {
        const std::string type = ReadCSharpType(inner);
        if (type.empty() && !inner->Is(","))
        {
            return {};
        }
        text += type;
        if (inner->Is(","))
        {
            text += (inner++)->text;
        }
        else if (!inner->Is(">"))
        {
            return {};
        }
    }
    at = inner + 1;
    return text + ">";
}

std::string ReadCSharpType(const CSharpToken*& at)
{
    const bool isTuple = at->Is("("); // (int a, int b)
    std::string type = isTuple ? "(...)" : ReadTypeName(at);
    at = isTuple ? at->Behind() : at;
    while (!type.empty())
    {
        if (at->Is("?") && !at[1].Is("."))
        {
            ++at;
        }
        else if (at->Is("[") && (at[1].Is("]") || at[1].Is(",")))
        {
            type += at[1].Is("]") ? "[]" : "[,]";
            at = at->Behind();
        }
        else if (at->Is("*"))
        {
            type += '*';
            ++at;
        }
        else
        {
            break;
        }
    }
    return type;
}

std::vector<CSharpWords> SplitArguments(CSharpWords words)
{
    std::vector<CSharpWords> parts;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < words.size();)
    {
        if (words[i].Is(","))
        {
            parts.push_back(words.subspan(begin, i - begin));
            begin = i + 1;
        }
        i += static_cast<std::size_t>(words[i].Behind() - &words[i]);
    }
    if (begin < words.size())
    {
        parts.push_back(words.subspan(begin));
    }
    return parts;
}

std::string_view PlainTypeName(std::string_view type)
{
    return type.substr(0, type.find_first_of("<["));
}

const CSharpAttribute* CSharpField::Find(std::string_view attribute) const
{
    const auto found = std::ranges::find(attributes, attribute, &CSharpAttribute::name);
    return found == attributes.end() ? nullptr : &*found;
}

bool CSharpClass::Derives(std::string_view base) const
{
    return std::ranges::find(bases, base, PlainTypeName) != bases.end();
}

const CSharpField* CSharpClass::FindField(std::string_view field) const
{
    const auto found = fieldNames.find(field);
    return found == fieldNames.end() ? nullptr : &fields[found->second];
}

const CSharpMethod* CSharpClass::FindMethod(std::string_view method) const
{
    const auto found = methodNames.find(method);
    return found == methodNames.end() ? nullptr : &methods[found->second];
}

std::string_view TextOf(const CSharpFile& file, CSharpWords words)
{
    if (words.empty())
    {
        return {};
    }
    const CSharpToken& last = words.back();
    const std::size_t begin = words.front().offset;
    return std::string_view(file.text).substr(begin, last.offset + last.text.size() - begin);
}

ClassIndex::ClassIndex(const CSharpFiles& files, std::function<bool(std::string_view)> isOfUnity)
    : m_IsOfUnity(std::move(isOfUnity))
{
    for (const auto& file : files)
    {
        Add(file->classes);
    }
}

void ClassIndex::Add(const std::vector<CSharpClass>& classes)
{
    for (const CSharpClass& one : classes)
    {
        m_All.push_back(&one);
        m_ByName.emplace(one.name, &one);
        Add(one.classes);
    }
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
        const CSharpClass* outer = found->second->outer;
        if (space.empty() ? IsVisible(*found->second, context) : outer && outer->name == space)
        {
            return found->second;
        }
    }
    // Namespaces stand before names, too; a type may have come from where it is visible.
    return begin == end || m_IsOfUnity(name) ? nullptr : begin->second;
}

} // namespace limn
