#pragma once

#include "Paths.h"
#include "commands/CommandRun.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

namespace limn::test
{

/// The words of limn's classes and enums, read off the public headers.
class HeaderWords
{
public:
    HeaderWords()
    {
        for (const char* folder :
             {"core/include/limn/core", "volume/include/limn/volume",
              "shaderlab/include/limn/shaderlab", "features/include/limn/features",
              "features/render_objects/include/limn/features"})
        {
            for (const auto& entry : std::filesystem::directory_iterator(SourcePath(folder)))
            {
                Read(std::regex_replace(ReadText(entry.path()), std::regex("//[^\n]*"), ""));
            }
        }
    }

    /// Whether the word is anywhere in the headers.
    bool HasWord(const std::string& word) const { return m_All.contains(word); }

    /// Whether it is a member function, or a function of a namespace.
    bool HasFunction(const std::string& type, const std::string& member) const
    {
        const auto found = m_Functions.find(type);
        const auto [begin, end] = m_Bases.equal_range(type);
        return (found != m_Functions.end() && found->second.contains(member)) ||
               std::any_of(begin, end,
                           [&](const auto& base) { return HasFunction(base.second, member); });
    }

    bool Has(const std::string& type, const std::string& member) const
    {
        const auto found = m_Words.find(type);
        if (found == m_Words.end())
        {
            return false;
        }
        const auto [begin, end] = m_Bases.equal_range(type);
        return member.empty() || member == "*" || found->second.contains(member) ||
               std::any_of(begin, end, [&](const auto& base) { return Has(base.second, member); });
    }

private:
    /// Names of parameters are no members, and what functions do is not either.
    static std::string Without(const std::string& text, char open, char close)
    {
        std::string result;
        int depth = 0;
        for (const char c : text)
        {
            depth -= c == close && depth > 0 ? 1 : 0;
            if (depth == 0)
            {
                result += c;
            }
            depth += c == open ? 1 : 0;
        }
        return result;
    }

    void Read(const std::string& text)
    {
        static const std::regex k_Class(
            R"(\b(class|struct|namespace|enum class)\s+(\w+)([^;{}()=]*)\{)");
        static const std::regex k_Word(R"(\w+)");
        static const std::regex k_Function(R"((\w+)\s*\()");
        static const std::regex k_Base(R"(public\s+(\w+::)*(\w+))");
        static const std::regex k_Alias(R"(\busing\s+(\w+)\s*=\s*(?:\w+::)*(\w+))");
        using Iterator = std::sregex_iterator;
        for (Iterator word(text.begin(), text.end(), k_Word); word != Iterator(); ++word)
        {
            m_All.insert(word->str());
        }
        for (Iterator match(text.begin(), text.end(), k_Class); match != Iterator(); ++match)
        {
            const auto begin = static_cast<std::size_t>(match->position() + match->length());
            std::size_t end = begin;
            for (int depth = 1; depth > 0 && end < text.size(); ++end)
            {
                depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
            }
            const std::string body =
                Without(Without(text.substr(begin, end - begin - 1), '(', ')'), '{', '}');
            std::set<std::string>& words = m_Words[(*match)[2]];
            for (Iterator word(body.begin(), body.end(), k_Word); word != Iterator(); ++word)
            {
                words.insert(word->str());
            }
            std::set<std::string>& functions = m_Functions[(*match)[2]];
            for (Iterator name(body.begin(), body.end(), k_Function); name != Iterator(); ++name)
            {
                functions.insert((*name)[1]);
            }
            const std::string bases = (*match)[3];
            for (Iterator base(bases.begin(), bases.end(), k_Base); base != Iterator(); ++base)
            {
                m_Bases.emplace((*match)[2], (*base)[2]);
            }
        }
        for (Iterator match(text.begin(), text.end(), k_Alias); match != Iterator(); ++match)
        {
            m_Words[(*match)[1]];
            m_Bases.emplace((*match)[1], (*match)[2]);
        }
    }

    std::map<std::string, std::set<std::string>> m_Words;
    std::map<std::string, std::set<std::string>> m_Functions; ///< those of them that are one
    std::set<std::string> m_All;
    std::multimap<std::string, std::string> m_Bases;
};

/// What limn calls a type of Unity's.
inline std::string CppType(const std::string& type)
{
    return type == "IRasterRenderGraphBuilder"    ? "RasterRenderGraphBuilder"
           : type == "IUnsafeRenderGraphBuilder"  ? "UnsafeRenderGraphBuilder"
           : type == "IComputeRenderGraphBuilder" ? "ComputeRenderGraphBuilder"
           : type == "Renderer"                   ? "MeshRenderer"
           : type == "VolumeParameter"            ? "VolumeParameterT" // Unity's VolumeParameter<T>
                                                  : type;
}

} // namespace limn::test
