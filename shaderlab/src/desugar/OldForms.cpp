#include "desugar/Rewrites.h"

#include "hlsl/Types.h"

#include <algorithm>
#include <map>

namespace limn
{

namespace
{

const std::map<std::string_view, std::string_view> k_TextureTypes = {
    {"texture", "Texture2D"},   {"Texture", "Texture2D"},       {"texture2D", "Texture2D"},
    {"texture3D", "Texture3D"}, {"textureCUBE", "TextureCube"},
};

class OldFormTaker
{
public:
    OldFormTaker(TokenEdits& code, std::vector<Diagnostic>& warnings)
        : m_Code(code), m_Warnings(warnings)
    {
    }

    void Take()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            m_Depth += m_Code.Step(i);
            if (m_Depth == 0)
            {
                m_isInConstants = Text(i) != "}" &&
                                  (m_isInConstants || Text(i) == "cbuffer" || Text(i) == "tbuffer");
            }
            if (m_Code.isWord(i))
            {
                TakeWord(i);
            }
            if (m_Depth == 0 && (Text(i) == ";" || Text(i) == "}"))
            {
                m_Declaration = i + 1;
            }
        }
    }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }

    void TakeWord(std::size_t index)
    {
        const std::string_view word = Text(index);
        if (word == "sampler_state" && index > 1 && Text(index - 1) == "=" &&
            Text(index + 1) == "{")
        {
            TakeState(DeclaredBefore(index), index - 1, index + 1);
        }
        else if (word.substr(1, 6) == "ampler" && m_Depth == 0 && m_Code.isWord(index + 1))
        {
            TakeSampler(index + 1);
        }
        else if (word == "typedef" && Text(index + 1) == "struct")
        {
            TakeTypedef(index);
        }
        else if (word == "struct" && (m_Depth == 0 || (isInFunction() && !isInStruct(index))))
        {
            TakeStructVariables(index);
        }
        else if (word == "unsigned")
        {
            m_Code.Spelling(index) = Text(index + 1) == "int" ? "" : "uint";
            if (Text(index + 1) == "int")
            {
                m_Code.Spelling(index + 1) = "uint";
            }
        }
        else if ((word == "uniform" && m_Depth > 0) ||
                 (word == "row_major" && (m_Depth == 0 || (m_isInConstants && m_Depth == 1))))
        {
            // glslang gives no type to the value of a `uniform` parameter.
            m_Code.Spelling(index).clear();
        }
        else if (m_Code.isWord(index + 1))
        {
            if (const auto type = k_TextureTypes.find(word); type != k_TextureTypes.end())
            {
                m_Code.Spelling(index) = type->second;
            }
        }
    }

    /// `typedef struct tag { … } name;` becomes `struct name { … }; typedef name tag;`: to glslang
    /// the semantics of the other are those of an entry function.
    void TakeTypedef(std::size_t index)
    {
        const bool hasTag = m_Code.isWord(index + 2);
        const std::size_t open = index + (hasTag ? 3 : 2);
        const std::size_t name = m_Code.AfterBracket(open);
        if (Text(open) != "{" || !m_Code.isWord(name) || Text(name + 1) != ";")
        {
            return;
        }
        const std::string type(Text(name));
        m_Code.Spelling(index).clear();
        m_Code.Spelling(index + 1) = "struct " + type;
        m_Code.Spelling(name).clear();
        if (hasTag)
        {
            m_Code.Spelling(index + 2).clear();
        }
        if (hasTag && Text(index + 2) != type)
        {
            m_Code.Spelling(name + 1) +=
                " typedef " + type + " " + std::string(Text(index + 2)) + ";";
        }
    }

    /// `static struct { … } name = …` becomes `struct limn_Struct1 { … }; static limn_Struct1 name
    /// = …`: glslang takes a struct without a name for one of that name.
    void TakeStructVariables(std::size_t index)
    {
        const bool hasName = m_Code.isWord(index + 1);
        const std::size_t open = index + (hasName ? 2 : 1);
        const std::size_t behind = m_Code.AfterBracket(open);
        if (Text(open) != "{" || !m_Code.isWord(behind) || Text(index - 1) == "typedef")
        {
            return;
        }
        std::size_t first = index;
        while (first > 0 && isTypeModifier(Text(first - 1)))
        {
            --first;
        }
        const std::string name =
            hasName ? std::string(Text(index + 1)) : "limn_Struct" + std::to_string(index);
        m_Code.Spelling(index) = hasName ? "struct" : "struct " + name;
        m_Code.Spelling(behind - 1) += "; " + std::string(m_Code.Span(first, index)) + " " + name;
        m_Code.Erase(first, index);
    }

    bool isInStruct(std::size_t index) const
    {
        for (; index > m_Declaration && Text(index) != "{"; --index)
        {
            index = Text(index) == "}" ? m_Code.tokens().MatchingOpen(index) : index;
        }
        return Text(index - 1) == "struct" || Text(index - 2) == "struct";
    }

    /// Returns whether the brackets at hand are of a function.
    bool isInFunction() const
    {
        return m_Code.FindOutside(m_Declaration, "(") < m_Code.FindOutside(m_Declaration, "{");
    }

    /// `SamplerState name : register(s0) { … }`
    void TakeSampler(std::size_t name)
    {
        std::size_t open = name + 1;
        if (Text(open) == ":")
        {
            open += Text(open + 2) == "(" ? m_Code.AfterBracket(open + 2) - open : 2;
        }
        if (Text(open) == "{")
        {
            TakeState(name, open, open);
        }
    }

    /// The name in `modifiers type name … =` before the token.
    std::size_t DeclaredBefore(std::size_t index) const
    {
        while (index > 0 && Text(index - 1) != ";" && Text(index - 1) != "}")
        {
            --index;
        }
        while (m_Code.isWord(index + 1))
        {
            ++index;
        }
        return index;
    }

    void TakeState(std::size_t name, std::size_t first, std::size_t open)
    {
        const HlslPlace place = m_Code.tokens().Place(name);
        m_Warnings.push_back(
            {Severity::Warning, place.file, place.location,
             "'" + std::string(Text(name)) +
                 "': the state written here has no effect; filter and wrap modes come from the "
                 "texture, or from the name of a SamplerState"});
        m_Code.Erase(first, m_Code.AfterBracket(open));
    }

    TokenEdits& m_Code;
    std::vector<Diagnostic>& m_Warnings;
    int m_Depth = 0;               ///< brackets around the token
    std::size_t m_Declaration = 0; ///< of the file, that the token is in: its first
    bool m_isInConstants = false;
};

/// Takes the uniform ones out of `( … )` and gives those declarations of theirs that are not
/// `known` yet: several entry functions may have the same one.
std::string TakeParameters(TokenEdits& code, std::size_t open, std::set<std::string>& known)
{
    std::string declarations;
    const std::size_t close = code.AfterBracket(open) - 1;
    bool hasFirst = false;
    for (std::size_t begin = open + 1; begin < close;)
    {
        const std::size_t end = std::min(code.FindOutside(begin, ","), close);
        if (code.Text(begin) == "uniform")
        {
            const std::string declaration = code.Spelled(begin, end);
            declarations += known.insert(declaration).second ? declaration + "; " : "";
            code.Erase(begin, end);
        }
        const bool isTaken = code.Text(begin) == "uniform";
        if (begin > open + 1 && (isTaken || !hasFirst))
        {
            code.Spelling(begin - 1).clear(); // the comma before it
        }
        hasFirst = hasFirst || !isTaken;
        begin = end + 1;
    }
    return declarations;
}

} // namespace

void TakeOldForms(TokenEdits& code, std::vector<Diagnostic>& warnings)
{
    OldFormTaker(code, warnings).Take();
}

void TakeUniformParameters(TokenEdits& code, const std::set<std::string_view>& entries)
{
    std::set<std::string> known;
    std::size_t declaration = 0;
    for (std::size_t i = 0; i < code.size();)
    {
        if (i > 0 && entries.count(code.Text(i)) > 0 && code.isWord(i - 1) &&
            code.Text(i + 1) == "(")
        {
            const std::string declarations = TakeParameters(code, i + 1, known);
            if (!declarations.empty())
            {
                code.Spelling(declaration).insert(0, declarations);
            }
        }
        const bool isEnd = code.Text(i) == "{" || code.Text(i) == ";";
        i = code.Step(i) > 0 ? code.AfterBracket(i) : i + 1;
        declaration = isEnd ? i : declaration;
    }
}

} // namespace limn
