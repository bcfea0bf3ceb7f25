#pragma once

#include "Paths.h"
#include "commands/CommandRun.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace limn::test
{

/// What the public headers say of members, read off their doc lines.
class HeaderDocs
{
public:
    HeaderDocs()
    {
        for (const char* folder : {"core/include/limn/core", "volume/include/limn/volume",
                                   "shaderlab/include/limn/shaderlab"})
        {
            for (const auto& entry : std::filesystem::directory_iterator(SourcePath(folder)))
            {
                Read(ReadText(entry.path()));
            }
        }
    }

    /// The first sentence of the member's, or of a base's; "" where there is none.
    std::string Of(const std::string& type, const std::string& member) const
    {
        const auto found = m_Docs.find(type + "." + member);
        if (found != m_Docs.end())
        {
            return found->second;
        }
        const auto [begin, end] = m_Bases.equal_range(type);
        for (auto base = begin; base != end; ++base)
        {
            if (std::string doc = Of(base->second, member); !doc.empty())
            {
                return doc;
            }
        }
        return "";
    }

private:
    struct Scope
    {
        std::string name;
        int depth = 0; ///< of what is in it
    };

    /// Up to its first sentence's end, without what a @ begins.
    static std::string FirstSentence(const std::string& doc)
    {
        static const std::regex k_Sentence(R"(^(.*?[^.][.;!])(\s|$))");
        const std::string text = doc.substr(0, doc.find('@'));
        std::smatch match;
        std::string sentence = std::regex_search(text, match, k_Sentence) ? match[1].str() : text;
        sentence.erase(sentence.find_last_not_of(" ;") + 1);
        return sentence.starts_with("Unity: ") ? "" : sentence;
    }

    /// What a declaration declares; "" if it is none.
    static std::string NameOf(const std::string& code)
    {
        static const std::regex k_Member(R"((\w+)\s*(\(|=|;|\{|,|\[|$))");
        std::smatch match;
        return std::regex_search(code, match, k_Member) ? match[1].str() : "";
    }

    void Read(const std::string& text)
    {
        static const std::regex k_Class(
            R"(^\s*(?:class|struct|namespace|enum class) (\w+)([^;]*)$)");
        static const std::regex k_Base(R"(public\s+(?:\w+::)*(\w+))");
        std::istringstream lines(text);
        std::vector<Scope> scopes;
        std::string doc;
        std::string opened; ///< whose { comes next
        int depth = 0;
        for (std::string line; std::getline(lines, line);)
        {
            const std::size_t slashes = line.find("//");
            const std::string code = line.substr(0, slashes);
            const std::string comment = slashes == std::string::npos ? "" : line.substr(slashes);
            const bool isEmpty = code.find_first_not_of(" \t") == std::string::npos;
            if (isEmpty)
            {
                doc = comment.starts_with("/// ")
                          ? doc + (doc.empty() ? "" : " ") + comment.substr(4)
                      : comment == "///" ? doc
                                         : "";
                continue;
            }
            std::smatch match;
            if (std::regex_match(code, match, k_Class))
            {
                opened = match[1];
                const std::string bases = match[2];
                for (std::sregex_iterator base(bases.begin(), bases.end(), k_Base), end;
                     base != end; ++base)
                {
                    m_Bases.emplace(opened, (*base)[1]);
                }
            }
            else if (!scopes.empty() && scopes.back().depth == depth)
            {
                const std::string own = comment.starts_with("///< ") ? comment.substr(5) : doc;
                const std::string name = NameOf(code);
                const std::string sentence = FirstSentence(own);
                if (!name.empty() && !sentence.empty())
                {
                    m_Docs.emplace(scopes.back().name + "." + name, sentence); // an overload's
                }
            }
            doc = code.find_first_of(";{},") != std::string::npos || !opened.empty() ? "" : doc;
            for (const char c : code)
            {
                depth += c == '{' ? 1 : 0;
                if (c == '{' && !opened.empty())
                {
                    scopes.push_back({std::move(opened), depth});
                    opened.clear();
                }
                if (c == '}')
                {
                    scopes.resize(scopes.size() -
                                  (!scopes.empty() && scopes.back().depth == depth ? 1 : 0));
                    --depth;
                }
            }
        }
    }

    std::map<std::string, std::string> m_Docs; ///< by "Type.Member"
    std::multimap<std::string, std::string> m_Bases;
};

} // namespace limn::test
