#include "desugar/Rewrites.h"

#include <limn/base/WordList.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

namespace
{

const WordList k_ParameterModifiers("in out inout const uniform nointerpolation centroid linear");

/// Finds what is declared twice, once by the library.
class LibraryNames
{
public:
    LibraryNames(TokenEdits& code, ColumnFinder& lines) : m_Code(code), m_Lines(lines) {}

    void Hide()
    {
        FindTwice();
        for (std::size_t i = 0; i < m_Code.size() && !m_Hidden.empty(); ++i)
        {
            const bool isMember = i > 0 && Text(i - 1) == ".";
            if (m_Code.isWord(i) && !isMember && m_Hidden.contains(Text(i)) && isOfLibrary(i))
            {
                m_Code.Spelling(i).insert(0, "limn_Hidden_");
            }
        }
    }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }

    void FindTwice()
    {
        for (std::size_t i = 0; i < m_Code.size(); i = m_Code.AfterBracket(i))
        {
            if (Text(i) == "struct" && m_Code.isWord(i + 1) && Text(i + 2) == "{")
            {
                Declare("struct " + std::string(Text(i + 1)), i + 1);
            }
            else if (i > 0 && m_Code.isWord(i - 1) && m_Code.isWord(i) && Text(i + 1) == "(" &&
                     hasBody(m_Code.AfterBracket(i + 1)))
            {
                Declare(Signature(i), i);
            }
        }
    }

    bool hasBody(std::size_t index) const
    {
        return Text(index) == "{" || (Text(index) == ":" && Text(index + 2) == "{");
    }

    void Declare(const std::string& what, std::size_t token)
    {
        const auto [other, isNew] = m_Declared.emplace(what, token);
        if (!isNew && isOfLibrary(other->second) != isOfLibrary(token))
        {
            m_Hidden.insert(Text(token));
        }
    }

    /// Returns "name type type", with one name for what glslang takes for one type.
    std::string Signature(std::size_t name) const
    {
        std::string signature(Text(name));
        const std::size_t close = m_Code.AfterBracket(name + 1) - 1;
        for (std::size_t i = name + 2; i < close;)
        {
            const std::size_t end = std::min(m_Code.FindOutside(i, ","), close);
            while (i < end && k_ParameterModifiers.Has(Text(i)))
            {
                ++i;
            }
            const std::string_view type = Text(i);
            const std::string_view half = type.starts_with("half")    ? "half"
                                          : type.starts_with("fixed") ? "fixed"
                                                                      : "";
            signature += half.empty() ? " " + std::string(type)
                                      : " float" + std::string(type.substr(half.size()));
            i = end + 1;
        }
        return signature;
    }

    bool isOfLibrary(std::size_t token)
    {
        const std::string file = m_Code.tokens().Place(token).file;
        const auto [known, isNew] = m_Files.try_emplace(file, false);
        if (isNew)
        {
            known->second = m_Lines.isOfLibrary(file);
        }
        return known->second;
    }

    TokenEdits& m_Code;
    ColumnFinder& m_Lines;
    std::map<std::string, std::size_t> m_Declared; ///< the token of the name
    std::set<std::string_view> m_Hidden;
    std::map<std::string, bool> m_Files;
};

} // namespace

void HideLibraryNames(TokenEdits& code, ColumnFinder& lines)
{
    LibraryNames(code, lines).Hide();
}

} // namespace limn
