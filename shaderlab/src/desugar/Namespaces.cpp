#include "desugar/Rewrites.h"

#include "hlsl/TokenEdits.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

} // namespace

void TakeNamespaces(TokenEdits& code)
{
    NamespaceTaker(code).Take();
}

} // namespace limn
