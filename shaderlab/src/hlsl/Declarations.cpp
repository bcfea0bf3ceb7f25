#include "hlsl/Declarations.h"

#include <algorithm>
#include <array>

namespace limn
{

namespace
{

constexpr std::array<std::string_view, 29> k_Modifiers = {
    "static",     "const",         "uniform",         "extern",
    "volatile",   "precise",       "shared",          "inline",
    "row_major",  "column_major",  "nointerpolation", "linear",
    "centroid",   "noperspective", "sample",          "in",
    "out",        "inout",         "snorm",           "unorm",
    "lowp",       "mediump",       "highp",           "groupshared",
    "point",      "line",          "triangle",        "lineadj",
    "triangleadj"};

constexpr std::array<std::string_view, 11> k_ObjectTypes = {
    "Texture", "Sampler", "sampler",           "StructuredBuffer",       "ByteAddressBuffer",
    "Buffer",  "RW",      "RasterizerOrdered", "AppendStructuredBuffer", "ConsumeStructuredBuffer",
    "texture"};

bool isModifier(std::string_view word)
{
    return std::find(k_Modifiers.begin(), k_Modifiers.end(), word) != k_Modifiers.end();
}

bool isObjectType(std::string_view type)
{
    return std::any_of(k_ObjectTypes.begin(), k_ObjectTypes.end(),
                       [&](std::string_view start)
                       { return type.substr(0, start.size()) == start; });
}

/// Walks the tokens of a file once, declaration by declaration. What it does not understand it
/// passes over: the compiler behind it judges the code.
class DeclarationReader
{
public:
    explicit DeclarationReader(const std::vector<HlslToken>& tokens) : m_Tokens(tokens) {}

    HlslDeclarations Read()
    {
        while (!isEnd())
        {
            ReadDeclaration();
        }
        return std::move(m_Result);
    }

private:
    bool isEnd() const { return m_Index >= m_Tokens.size(); }
    std::string_view Text(std::size_t ahead = 0) const
    {
        return m_Index + ahead < m_Tokens.size() ? m_Tokens[m_Index + ahead].text
                                                 : std::string_view();
    }
    bool isWord() const { return !isEnd() && m_Tokens[m_Index].isWord; }
    /// The source from a token to the one before this.
    std::string_view Span(std::size_t first) const
    {
        const std::size_t end = std::min(m_Index, m_Tokens.size());
        if (first >= end)
        {
            return {};
        }
        const char* const begin = m_Tokens[first].text.data();
        const std::string_view last = m_Tokens[end - 1].text;
        return {begin, static_cast<std::size_t>(last.data() + last.size() - begin)};
    }
    bool Accept(std::string_view text)
    {
        const bool accepted = Text() == text;
        m_Index += accepted ? 1 : 0;
        return accepted;
    }

    /// From an opening bracket to behind the matching closing one.
    void SkipBalanced(std::string_view open, std::string_view close)
    {
        int depth = 0;
        do
        {
            depth += Text() == open ? 1 : 0;
            depth -= Text() == close ? 1 : 0;
            ++m_Index;
        } while (depth > 0 && !isEnd());
    }

    void SkipTo(std::string_view mark)
    {
        while (!isEnd() && Text() != mark)
        {
            if (Text() == "{")
            {
                SkipBalanced("{", "}");
            }
            else if (Text() == "(")
            {
                SkipBalanced("(", ")");
            }
            else
            {
                ++m_Index;
            }
        }
    }

    void ReadDeclaration()
    {
        const std::size_t begin = m_Index;
        std::vector<std::string_view> attributes;
        while (Text() == "[")
        {
            const std::size_t first = m_Index;
            SkipBalanced("[", "]");
            attributes.push_back(Span(first));
        }
        if (Text() == "template" && Text(1) == "<")
        {
            m_Result.templates.push_back(m_Index);
            SkipTo("{");
            SkipBalanced("{", "}");
        }
        else if (Text() == "struct" && Text(2) == "{")
        {
            ReadStruct();
        }
        else if (Text() == "cbuffer" || Text() == "tbuffer")
        {
            ReadConstantBuffer();
        }
        else if (Accept("typedef"))
        {
            const HlslVariable alias = ReadHead();
            m_Result.aliases.push_back({alias.name, alias.type});
            SkipTo(";");
            Accept(";");
        }
        else if (Text() == "struct")
        {
            SkipTo(";");
            Accept(";");
        }
        else if (isWord())
        {
            ReadFunctionOrVariables(begin, std::move(attributes));
        }
        else
        {
            ++m_Index;
        }
    }

    void ReadStruct()
    {
        HlslStruct result;
        result.name = Text(1);
        m_Index += 2;
        result.members = ReadMembers(&result.methods);
        m_Result.structs.push_back(std::move(result));
        SkipTo(";");
        Accept(";");
    }

    void ReadConstantBuffer()
    {
        while (!isEnd() && Text() != "{")
        {
            ++m_Index;
        }
        std::vector<HlslVariable> members = ReadMembers(nullptr);
        for (HlslVariable& member : members)
        {
            member.endToken = m_Index - 1;
            member.isInBuffer = true;
            auto& list = isObjectType(member.type) ? m_Result.objects : m_Result.uniforms;
            list.push_back(std::move(member));
        }
    }

    /// `{ float4 a : X; float b[2], c; float Sum() { … } }`
    std::vector<HlslVariable> ReadMembers(std::vector<HlslFunction>* methods)
    {
        std::vector<HlslVariable> members;
        Accept("{");
        while (!isEnd() && !Accept("}"))
        {
            if (Text() == ";")
            {
                m_Result.emptyMembers.push_back(m_Index++);
                continue;
            }
            while (Text() == "[")
            {
                SkipBalanced("[", "]");
            }
            if (SkipUnknownMacro())
            {
                continue;
            }
            const std::size_t begin = m_Index;
            HlslVariable head = ReadHead();
            if (Text() != "(" || !methods)
            {
                ReadDeclarators(head, members);
                continue;
            }
            methods->push_back(ReadFunction(begin, head));
            Accept(";");
        }
        return members;
    }

    /// Modifiers, type and the first name.
    HlslVariable ReadHead()
    {
        HlslVariable variable;
        variable.firstToken = m_Index;
        while (isWord() && isModifier(Text()))
        {
            variable.modifiers.push_back(Text());
            ++m_Index;
        }
        if (Text() == "unsigned")
        {
            ++m_Index;
        }
        if (isWord())
        {
            variable.type = Text();
            ++m_Index;
        }
        if (Text() == "<")
        {
            const std::size_t first = m_Index + 1;
            SkipBalanced("<", ">");
            --m_Index;
            variable.templateArgument = Span(first);
            ++m_Index;
        }
        while (isWord() && isModifier(Text()))
        {
            ++m_Index;
        }
        if (isWord())
        {
            variable.name = Text();
            variable.token = m_Index;
            ++m_Index;
        }
        return variable;
    }

    /// Dimensions, semantic or register, and default value of one name.
    void ReadTail(HlslVariable& variable)
    {
        while (Accept("["))
        {
            const std::size_t first = m_Index;
            while (!isEnd() && Text() != "]")
            {
                ++m_Index;
            }
            variable.dimensions.push_back(Span(first));
            Accept("]");
        }
        while (Accept(":"))
        {
            const std::string_view word = Text();
            ++m_Index;
            if (Text() == "(")
            {
                SkipBalanced("(", ")");
            }
            else
            {
                variable.semantic = word;
            }
        }
        if (Accept("="))
        {
            const std::size_t first = m_Index;
            while (!isEnd() && Text() != "," && Text() != ";" && Text() != ")")
            {
                SkipValue();
            }
            variable.value = Span(first);
        }
    }

    void SkipValue()
    {
        if (Text() == "(")
        {
            SkipBalanced("(", ")");
        }
        else if (Text() == "{")
        {
            SkipBalanced("{", "}");
        }
        else
        {
            ++m_Index;
        }
    }

    void ReadDeclarators(HlslVariable variable, std::vector<HlslVariable>& result)
    {
        const std::size_t start = m_Index;
        const std::size_t known = result.size();
        do
        {
            if (result.size() > 0 && variable.name.empty() && isWord())
            {
                variable.name = Text();
                variable.token = m_Index++;
            }
            ReadTail(variable);
            result.push_back(variable);
            variable.name = {};
            variable.dimensions.clear();
            variable.semantic = {};
            variable.value = {};
        } while (Accept(","));
        if (Accept(";") && result.size() == known + 1)
        {
            result.back().lastToken = m_Index - 1;
        }
        else if (m_Index == start)
        {
            ++m_Index; // nothing was understood; do not stand still
        }
    }

    /// `UNKNOWN(…)` with or without a `;`.
    bool SkipUnknownMacro()
    {
        if (!isWord() || Text(1) != "(")
        {
            return false;
        }
        m_Result.unknownMacros.push_back(m_Index++);
        SkipBalanced("(", ")");
        Accept(";");
        return true;
    }

    void ReadFunctionOrVariables(std::size_t begin, std::vector<std::string_view> attributes)
    {
        if (SkipUnknownMacro())
        {
            return;
        }
        HlslVariable head = ReadHead();
        if (Text() == "(" && !head.name.empty())
        {
            m_Result.functions.push_back(ReadFunction(begin, head));
            m_Result.functions.back().attributes = std::move(attributes);
            return;
        }
        std::vector<HlslVariable> variables;
        ReadDeclarators(head, variables);
        for (HlslVariable& variable : variables)
        {
            const bool isStatic = variable.Has("static") || variable.Has("groupshared") ||
                                  (variable.Has("const") && !variable.Has("uniform"));
            if (isStatic)
            {
                m_Result.statics.push_back(variable.name);
                if (variable.Has("const") && variable.dimensions.empty())
                {
                    m_Result.constants[std::string(variable.name)] = variable.value;
                }
                continue;
            }
            variable.endToken = m_Index - 1;
            auto& list = isObjectType(variable.type) ? m_Result.objects : m_Result.uniforms;
            list.push_back(std::move(variable));
        }
    }

    HlslFunction ReadFunction(std::size_t begin, const HlslVariable& head)
    {
        HlslFunction function;
        function.begin = begin;
        function.returnType = head.type;
        function.name = head.name;
        Accept("(");
        while (!isEnd() && !Accept(")"))
        {
            HlslVariable parameter = ReadHead();
            ReadTail(parameter);
            if (!parameter.name.empty())
            {
                function.parameters.push_back(parameter);
            }
            if (!Accept(",") && Text() != ")")
            {
                ++m_Index;
            }
        }
        if (Accept(":"))
        {
            function.semantic = Text();
            ++m_Index;
        }
        function.hasBody = Text() == "{";
        if (function.hasBody)
        {
            SkipBalanced("{", "}");
        }
        else
        {
            Accept(";");
        }
        function.end = std::min(m_Index, m_Tokens.size());
        return function;
    }

    const std::vector<HlslToken>& m_Tokens;
    std::size_t m_Index = 0;
    HlslDeclarations m_Result;
};

} // namespace

bool HlslVariable::Has(std::string_view modifier) const
{
    return std::find(modifiers.begin(), modifiers.end(), modifier) != modifiers.end();
}

std::string_view HlslDeclarations::ResolveAlias(std::string_view type) const
{
    // An alias names what is declared before it, so that one walk backwards resolves chains.
    for (auto alias = aliases.rbegin(); alias != aliases.rend(); ++alias)
    {
        type = alias->name == type ? alias->type : type;
    }
    return type;
}

const HlslStruct* HlslDeclarations::FindStruct(std::string_view name) const
{
    const auto found = std::find_if(structs.begin(), structs.end(),
                                    [&](const HlslStruct& item) { return item.name == name; });
    return found == structs.end() ? nullptr : &*found;
}

const HlslFunction* HlslDeclarations::FindDefinition(std::string_view name) const
{
    const auto found =
        std::find_if(functions.begin(), functions.end(),
                     [&](const HlslFunction& item) { return item.hasBody && item.name == name; });
    return found == functions.end() ? nullptr : &*found;
}

HlslDeclarations ReadDeclarations(const std::vector<HlslToken>& tokens)
{
    return DeclarationReader(tokens).Read();
}

} // namespace limn
