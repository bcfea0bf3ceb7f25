#include "desugar/Rewrites.h"

#include "hlsl/Types.h"
#include "lowering/GlslangGuards.h"
#include <limn/base/Case.h>
#include <limn/base/WordList.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace limn
{

namespace
{

// Words that mean something before a type, so that another word follows.
const WordList k_StageModifiers("linear centroid point line triangle triangleadj lineadj");

// Types, and a word of GLSL, that name members and variables as well.
const WordList k_TypeNames("sampler texture matrix vector string layout");

// Microsoft's compiler takes these types in any case.
const WordList k_AnyCase("Vector VECTOR Matrix MATRIX");

const WordList k_ObjectModifiers("static uniform extern in");

// The words before brackets that hold no parameters.
const WordList k_Statements("for if while switch return");

class Speller
{
public:
    explicit Speller(TokenEdits& code) : m_Code(code)
    {
        FindLookedUp();
        FindSampledBy();
        FindOwnTypes();
    }

    void Spell()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (isWord(i))
            {
                SpellWord(i);
            }
            else if (Text(i).starts_with("0x") || Text(i).starts_with("0X"))
            {
                CutNumber(i);
            }
        }
    }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }
    bool isWord(std::size_t index) const { return m_Code.isWord(index); }

    void SpellWord(std::size_t index)
    {
        const std::string_view word = Text(index);
        const bool isMissing = word == "noise" || word == "msad4";
        if (word == "shared" || (!isWord(index + 1) && k_StageModifiers.Has(word)) ||
            (k_TypeNames.Has(word) && isNameHere(index)) || isTypeAsSemantic(index) ||
            (isMissing && Text(index + 1) == "("))
        {
            // The language has the missing ones and no device does; glslang crashes on them.
            m_Code.Spelling(index) = std::string(word) + "_";
        }
        else if (word == "struct" && isWord(index + 1) && Text(index + 2) != "{" &&
                 Text(index + 2) != ":" && Text(index + 2) != ";")
        {
            m_Code.Spelling(index).clear(); // before the name of a type, as in C
        }
        else if (word == "sampler" && m_SampledBy.contains(Text(index + 1)))
        {
            m_Code.Spelling(index) = "SamplerState";
        }
        else if (word == "SamplerState" && !LookedUpAs(index).empty())
        {
            m_Code.Spelling(index) = LookedUpAs(index);
        }
        else if (word == "Buffer" && (isWord(index + 1) || Text(index + 1) == "<"))
        {
            // A device reads both kinds alike; limn binds the structured one.
            m_Code.Spelling(index) =
                isWord(index + 1) ? "StructuredBuffer<float4>" : "StructuredBuffer";
        }
        else if (Text(index + 1) == "::" && Text(index + 3) == "(" && isFirst(index))
        {
            // To glslang a statement that begins with a type is a declaration: `Type::Method();`
            m_Code.Spelling(index).insert(0, "(");
            m_Code.Spelling(m_Code.AfterBracket(index + 3) - 1) += ")";
        }
        else if (word == "const" && (isObject(index + 1) || isParameter(index)))
        {
            // It says nothing; on objects glslang crashes on it, and of a function that is declared
            // with it and without it makes two.
            m_Code.Spelling(index).clear();
        }
        else if (word == "const" && Text(index + 1) == "static")
        {
            // The other way round glslang takes no size of an array from it.
            m_Code.Spelling(index) = "static";
            m_Code.Spelling(index + 1) = "const";
        }
        else if (word.starts_with("min1") && NumberType(word) && NumberType(word)->isMatrix())
        {
            m_Code.Spelling(index) = NumberType(word)->Spelling(); // glslang has vectors of it only
        }
        else if ((word == "vector" || word == "matrix") && Text(index + 1) == "<")
        {
            SplitTemplateEnd(index + 2);
        }
        else if (k_AnyCase.Has(word) && !m_OwnTypes.contains(word) && isWord(index + 1))
        {
            m_Code.Spelling(index) = ToLower(word);
        }
    }

    /// To its lowest 32 bits, eight digits.
    void CutNumber(std::size_t index)
    {
        const std::string_view text = Text(index).substr(2);
        const std::size_t size =
            std::min(text.find_first_not_of("0123456789abcdefABCDEF"), text.size());
        if (size > 8)
        {
            m_Code.Spelling(index) = "0x" + std::string(text.substr(size - 8));
        }
    }

    /// Returns whether the word stands among the modifiers of a function's parameter.
    bool isParameter(std::size_t index)
    {
        m_Answers.resize(m_Code.size());
        std::size_t open = std::max<std::size_t>(index, 1) - 1;
        for (; open > 2 && Text(open) != "(" && !m_Answers[open].has_value();
             open -= open > 0 ? 1 : 0)
        {
            const std::size_t partner = m_Code.tokens().MatchingOpen(open);
            if (Text(open) == ";" || Text(open) == "{" || (Text(open) == "}" && partner == open))
            {
                break;
            }
            open = partner;
        }
        // `type name(`; or what was found for another word of the list
        const bool isList = open > 2 && Text(open) == "(" && isWord(open - 1) &&
                            !k_Statements.Has(Text(open - 1)) &&
                            (isWord(open - 2) || Text(open - 2) == ">");
        const bool isOne = m_Answers[open].value_or(false) || isList;
        m_Answers[index] = isOne;
        return isOne;
    }

    /// Returns whether a statement begins with the word.
    bool isFirst(std::size_t index) const
    {
        const std::string_view before = Text(index - 1);
        return before == ";" || before == "{" || before == "}" || before == ")" || before == "else";
    }

    /// Returns whether the word is a variable or a member, not a type: `v.matrix`, but not `matrix
    /// m` or
    /// `(matrix)v`.
    bool isNameHere(std::size_t index) const
    {
        const std::string_view next = Text(index + 1);
        const bool isCast = Text(index - 1) == "(" && next == ")" && !isWord(index - 2);
        return !isWord(index + 1) && next != "<" && next != "(" && !isCast;
    }

    /// `float4 c : float4;`
    bool isTypeAsSemantic(std::size_t index) const
    {
        const std::string_view word = Text(index);
        const std::string_view next = Text(index + 1);
        const bool isType = k_TypeNames.Has(word) || word.starts_with("float") ||
                            word.starts_with("int") || word.starts_with("uint");
        return isType && Text(index - 1) == ":" && isWord(index - 2) &&
               (next == ";" || next == "," || next == ")" || next == "{");
    }

    /// Returns whether a texture, sampler or buffer is declared here, modifiers first.
    bool isObject(std::size_t index) const
    {
        while (k_ObjectModifiers.Has(Text(index)))
        {
            ++index;
        }
        return isObjectType(Text(index)) && (isWord(index + 1) || Text(index + 1) == "<");
    }

    /// `Texture2D<vector<float, 4>>`: here `>>` is no shift.
    void SplitTemplateEnd(std::size_t index)
    {
        while (isWord(index) || Text(index) == "," ||
               (!Text(index).empty() && isDigit(Text(index)[0])))
        {
            ++index;
        }
        if (Text(index) == ">>")
        {
            m_Code.Spelling(index) = "> >";
        }
    }

    void FindSampledBy()
    {
        for (std::size_t i = 3; i < m_Code.size(); ++i)
        {
            if (Text(i - 1) == "(" && Text(i - 3) == "." &&
                (Text(i - 2).starts_with("Sample") || Text(i - 2).starts_with("Gather") ||
                 Text(i - 2) == "CalculateLevelOfDetail"))
            {
                m_SampledBy.insert(Text(i));
            }
        }
    }

    /// The type of Direct3D 9 that a global SamplerState is used as, `tex2D(name, …)`; "" of
    /// others.
    std::string_view LookedUpAs(std::size_t index) const
    {
        const std::string_view before = Text(index - 1);
        const std::string_view behind = Text(index + 2);
        if (before == "(" || before == "," || (behind != ";" && behind != ":"))
        {
            return "";
        }
        const auto found = m_LookedUp.find(Text(index + 1));
        return found == m_LookedUp.end() || m_SampledBy.contains(found->first) ? "" : found->second;
    }

    void FindOwnTypes()
    {
        for (std::size_t i = 1; i < m_Code.size(); ++i)
        {
            if (Text(i - 1) == "struct" && k_AnyCase.Has(Text(i)))
            {
                m_OwnTypes.insert(Text(i));
            }
        }
    }

    void FindLookedUp()
    {
        static constexpr std::pair<std::string_view, std::string_view> k_Types[] = {
            {"tex1D", "sampler1D"},
            {"tex2D", "sampler2D"},
            {"tex3D", "sampler3D"},
            {"texCUBE", "samplerCUBE"}};
        for (std::size_t i = 2; i < m_Code.size(); ++i)
        {
            if (Text(i - 1) != "(" || !Text(i - 2).starts_with("tex") || Text(i + 1) != ",")
            {
                continue;
            }
            for (const auto& [start, type] : k_Types)
            {
                if (Text(i - 2).starts_with(start))
                {
                    m_LookedUp.try_emplace(Text(i), type);
                }
            }
        }
    }

    TokenEdits& m_Code;
    std::vector<std::optional<bool>> m_Answers; ///< of isParameter, by token
    std::set<std::string_view> m_OwnTypes;      ///< types of k_AnyCase that the program declares
    std::set<std::string_view> m_SampledBy; ///< by methods of textures: `_Tex.Sample(name, …)`
    std::map<std::string_view, std::string_view> m_LookedUp; ///< samplers: types of Direct3D 9
};

} // namespace

std::string RespellForGlslang(std::string text, const PassProgram& program, ColumnFinder& lines,
                              std::vector<Diagnostic>& warnings)
{
    std::optional<HlslTokens> tokens(std::in_place, text, &lines);
    std::optional<TokenEdits> code(std::in_place, *tokens);
    RequireShallow(*tokens);
    RequirePairs(*tokens);
    const auto rewrite = [&](const auto& edit)
    {
        edit(*code);
        if (code->isEdited()) // as hardly ever
        {
            text = code->Assemble();
            tokens.emplace(text, &lines);
            code.emplace(*tokens);
        }
    };
    rewrite(SpellEnums);
    rewrite(TakeStructsOutOfBuffers);
    rewrite(TakeNamespaces);
    rewrite(CopyBaseMembers);
    rewrite(TakeStaticMembers);
    rewrite([&](TokenEdits& whole) { HideLibraryNames(whole, lines); });
    rewrite([&](TokenEdits& whole) { TakeTessellation(whole, program); });
    rewrite(
        [&](TokenEdits& whole)
        {
            TakeUniformParameters(
                whole, {program.vertex.name, program.geometry.name, program.fragment.name});
        });
    TakeOldForms(*code, warnings);
    Speller(*code).Spell();
    return code->Assemble();
}

} // namespace limn
