#include "desugar/Rewrites.h"

#include <limn/base/WordList.h>

#include <algorithm>
#include <map>
#include <utility>

namespace limn
{

namespace
{

/// A namespace is called by its whole name: "A::B::", and what is outside of all "".
class NamespaceTaker
{
public:
    explicit NamespaceTaker(TokenEdits& code) : m_Code(code) {}

    void Take()
    {
        Walk(0, m_Code.size(), "", &NamespaceTaker::FindName);
        if (!m_Names.empty())
        {
            Walk(0, m_Code.size(), "", &NamespaceTaker::Spell);
        }
    }

private:
    using Step = std::size_t (NamespaceTaker::*)(std::size_t, const std::string&);

    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }

    void Walk(std::size_t index, std::size_t end, const std::string& space, Step step)
    {
        while (index < end)
        {
            const bool isSpace = Text(index) == "namespace" && Text(index + 2) == "{";
            if (!isSpace)
            {
                index = (this->*step)(index, space);
                continue;
            }
            const std::string inner = space + std::string(Text(index + 1)) + "::";
            const std::size_t behind = m_Code.AfterBracket(index + 2);
            m_Names[inner];
            m_Code.Erase(index, index + 3);
            Walk(index + 3, behind - 1, inner, step);
            m_Code.Spelling(behind - 1).clear();
            index = behind;
        }
    }

    /// Notes what the namespace declares: functions, types and variables that are no uniforms.
    std::size_t FindName(std::size_t index, const std::string& space)
    {
        const std::string_view word = Text(index);
        const std::string_view before = index > 0 ? Text(index - 1) : "";
        const std::string_view next = Text(index + 1);
        const bool isEnd = word == ";" || (word == "{" && before == ")");
        if (word == "using")
        {
            m_Names[""]; // which may be all that there are
        }
        m_IsOwn = !isEnd && (m_IsOwn || word == "static" || word == "const" || word == "struct" ||
                             word == "typedef");
        const bool isNamed =
            m_Code.isWord(index) && index > 0 &&
            (m_Code.isWord(index - 1) || before == ">" || before == "," || before == "}");
        if (isNamed && !space.empty() && (next == "(" || (m_IsOwn && isBehindName(next))))
        {
            m_Names[space].insert(word);
        }
        if (word == "struct")
        {
            FindMembers(index);
        }
        return m_Code.AfterBracket(index);
    }

    void FindMembers(std::size_t index)
    {
        index = std::min(m_Code.FindOutside(index, "{"), m_Code.FindOutside(index, ";"));
        const std::size_t end = m_Code.AfterBracket(index);
        bool isStruct = false; // the brackets that come are another one's
        for (++index; index < end;)
        {
            if (m_Code.isWord(index) && (isBehindName(Text(index + 1)) || Text(index + 1) == "("))
            {
                m_Members.insert(Text(index));
            }
            isStruct = Text(index) == "struct" || (isStruct && m_Code.isWord(index));
            // A name within a method is no member.
            index = isStruct && Text(index + 1) == "{" ? index + 2 : m_Code.AfterBracket(index);
        }
    }

    static bool isBehindName(std::string_view mark)
    {
        return mark.size() == 1 && std::string_view("=;,[:{").find(mark) != mark.npos;
    }

    /// `A::B::name`, and `name` in A::B, get a name of their own; the namespaces go.
    std::size_t Spell(std::size_t index, const std::string& space)
    {
        const std::string_view before = index > 0 ? Text(index - 1) : "";
        if (!m_Code.isWord(index) || before == "." || before == "::")
        {
            return index + 1;
        }
        if (Text(index) == "using" && Text(index + 1) == "namespace")
        {
            return Use(index, space);
        }
        bool isDone = false;
        for (const std::string& from : Around(space))
        {
            isDone = isDone || SpellIn(from, index);
        }
        for (const auto& [used, end] : m_Used)
        {
            isDone = isDone || (index < end && SpellIn(used, index));
        }
        return index + 1;
    }

    /// A::B::, A:: and what is outside of all.
    static std::vector<std::string> Around(std::string space)
    {
        std::vector<std::string> all = {space};
        while (!space.empty())
        {
            const std::size_t outer = space.rfind("::", space.size() - 3);
            space.resize(outer == space.npos ? 0 : outer + 2);
            all.push_back(space);
        }
        return all;
    }

    /// `using namespace A::B;` counts to the end of the brackets around it.
    std::size_t Use(std::size_t index, const std::string& space)
    {
        const std::size_t end = m_Code.FindOutside(index, ";");
        if (Text(end) != ";")
        {
            return index + 1; // the compiler says what is wrong
        }
        std::string path;
        for (std::size_t i = index + 2; i < end; ++i)
        {
            path += Text(i);
        }
        for (const std::string& from : Around(space))
        {
            if (m_Names.count(from + path + "::") > 0)
            {
                m_Used.emplace_back(from + path + "::", m_Code.FindOutside(index, "}"));
                m_Code.Erase(index, end + 1);
                return end + 1;
            }
        }
        throw AssetError({m_Code.tokens().Error(index + 2, "there is no such namespace")});
    }

    /// Returns whether the namespace has the name.
    bool SpellIn(std::string path, std::size_t index)
    {
        std::size_t name = index;
        for (; Text(name + 1) == "::"; name += 2)
        {
            const std::string inner = path + std::string(Text(name)) + "::";
            if (m_Names.count(inner) == 0)
            {
                break;
            }
            path = inner;
        }
        const auto names = m_Names.find(path);
        const bool isOwn = names != m_Names.end() && names->second.count(Text(name)) > 0;
        m_Code.Erase(index, name);
        if (isOwn && m_Members.count(Text(name)) == 0)
        {
            std::string& spelling = m_Code.Spelling(name) = "limn_";
            for (; !path.empty(); path.erase(0, path.find("::") + 2))
            {
                spelling.append(path.substr(0, path.find("::"))).append("_");
            }
            spelling.append(Text(name));
        }
        return isOwn || name > index;
    }

    TokenEdits& m_Code;
    std::map<std::string, std::set<std::string_view>> m_Names; ///< by namespace
    std::set<std::string_view> m_Members; ///< of structs, which have no own names
    std::vector<std::pair<std::string, std::size_t>> m_Used; ///< namespace; token where that ends
    bool m_IsOwn = false; ///< the declaration at hand is of no uniform
};

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

void TakeNamespaces(TokenEdits& code)
{
    NamespaceTaker(code).Take();
}

void HideLibraryNames(TokenEdits& code, ColumnFinder& lines)
{
    LibraryNames(code, lines).Hide();
}

} // namespace limn
