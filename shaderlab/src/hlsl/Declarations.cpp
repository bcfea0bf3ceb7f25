#include "hlsl/Declarations.h"

#include <limn/base/Text.h>

namespace limn
{

namespace
{

constexpr std::string_view k_Template =
    "limn reads no templates of HLSL 2021; write the function or struct once for each type";
constexpr std::string_view k_Interface = "limn has no interfaces of HLSL; write their functions as "
                                         "methods of the structs that have them";
constexpr std::string_view k_UnknownMacro = "unknown macro; a declaration is expected here, so "
                                            "define it or include the file that does";

/// Walks the tokens of a file once, declaration by declaration. What it does not understand it
/// passes over: the compiler behind it judges the code.
class DeclarationReader
{
public:
    explicit DeclarationReader(const HlslTokens& tokens) : m_Tokens(tokens) {}

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
    std::string_view Text(std::size_t ahead = 0) const { return m_Tokens.Text(m_Index + ahead); }
    bool isWord() const { return m_Tokens.isWord(m_Index); }
    /// The source from a token to the one before this.
    std::string_view Span(std::size_t first) const { return m_Tokens.Span(first, m_Index); }
    bool Accept(std::string_view text)
    {
        const bool accepted = Text() == text;
        m_Index += accepted ? 1 : 0;
        return accepted;
    }

    /// A token, or from an opening bracket to behind the one that closes it.
    void Skip() { m_Index = m_Tokens.AfterBracket(m_Index); }
    void SkipTo(std::string_view mark) { m_Index = m_Tokens.FindOutside(m_Index, mark); }
    void SkipStatement()
    {
        SkipTo(";");
        Accept(";");
    }
    void Complain(std::string_view problem)
    {
        m_Result.problems.push_back({m_Index, std::string(problem)});
    }
    /// From a `<` to behind its `>`.
    void SkipTemplate()
    {
        int depth = 0;
        do
        {
            depth += Text() == "<" ? 1 : Text() == ">" ? -1 : Text() == ">>" ? -2 : 0;
            ++m_Index;
        } while (depth > 0 && !isEnd());
    }

    void ReadDeclaration()
    {
        const std::size_t begin = m_Index;
        std::vector<std::string_view> attributes;
        while (Text() == "[")
        {
            const std::size_t first = m_Index;
            Skip();
            attributes.push_back(Span(first));
        }
        const bool isTemplate = Text() == "template" && Text(1) == "<";
        if (isTemplate || (Text() == "interface" && Text(2) == "{"))
        {
            Complain(isTemplate ? k_Template : k_Interface);
            SkipTo("{");
            Skip();
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
            m_Result.aliases.push_back(ReadHead());
            SkipStatement();
        }
        else if (Text() == "struct" && Text(2) == ";")
        {
            SkipStatement();
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
        SkipStatement();
    }

    void ReadConstantBuffer()
    {
        const std::string_view name = Text(1);
        SkipTo("{");
        std::vector<HlslVariable> members = ReadMembers(nullptr);
        for (HlslVariable& member : members)
        {
            member.endToken = m_Index - 1;
            member.isInBuffer = true;
            member.buffer = name;
            AddGlobal(std::move(member));
        }
    }

    void AddGlobal(HlslVariable variable)
    {
        auto& list = isObjectType(variable.type) ? m_Result.objects : m_Result.uniforms;
        list.push_back(std::move(variable));
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
                Skip();
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
        while (isWord() && isTypeModifier(Text()))
        {
            variable.modifiers.push_back(Text());
            ++m_Index;
        }
        if (Text() == "unsigned" || Text() == "struct")
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
            SkipTemplate();
            --m_Index;
            variable.templateArgument = Span(first);
            ++m_Index;
        }
        while (isWord() && isTypeModifier(Text()))
        {
            ++m_Index;
        }
        ReadName(variable);
        return variable;
    }

    void ReadName(HlslVariable& variable)
    {
        if (isWord())
        {
            variable.name = Text();
            variable.token = m_Index++;
        }
    }

    /// Dimensions, semantic or register, and default value of one name.
    void ReadTail(HlslVariable& variable)
    {
        while (Accept("["))
        {
            const std::size_t first = m_Index;
            SkipTo("]");
            variable.dimensions.push_back(Span(first));
            Accept("]");
        }
        while (Accept(":"))
        {
            const std::string_view word = Text();
            ++m_Index;
            if (Text() == "(")
            {
                Skip();
            }
            else
            {
                variable.semantic = word;
            }
        }
        if (Accept("="))
        {
            variable.valueToken = m_Index;
            while (!isEnd() && Text() != "," && Text() != ";" && Text() != ")")
            {
                Skip();
            }
            variable.valueEnd = m_Index;
        }
    }

    void ReadDeclarators(const HlslVariable& head, std::vector<HlslVariable>& result)
    {
        HlslVariable variable = head;
        const std::size_t start = m_Index;
        const std::size_t known = result.size();
        do
        {
            if (result.size() > 0 && variable.name.empty())
            {
                ReadName(variable);
            }
            ReadTail(variable);
            variable.declaratorEnd = m_Index;
            result.push_back(variable);
            variable = head;
            variable.name = {};
        } while (Accept(","));
        if (Accept(";"))
        {
            for (std::size_t i = known; i < result.size(); ++i)
            {
                result[i].semicolon = m_Index - 1;
            }
        }
        else if (Text() == "}" && !isEnd())
        {
            Complain(k_MissingSemicolon);
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
        Complain(k_UnknownMacro);
        ++m_Index;
        Skip();
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
                if (variable.Has("const") && variable.dimensions.empty())
                {
                    m_Result.constants[std::string(variable.name)] =
                        m_Tokens.Span(variable.valueToken, variable.valueEnd);
                }
                m_Result.statics.push_back(std::move(variable));
                continue;
            }
            variable.endToken = m_Index - 1;
            AddGlobal(std::move(variable));
        }
    }

    HlslFunction ReadFunction(std::size_t begin, const HlslVariable& head)
    {
        HlslFunction function;
        function.begin = begin;
        function.returnType = head.type;
        function.returnArgument = head.templateArgument;
        function.name = head.name;
        function.token = head.token;
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
        function.body = m_Index;
        if (function.hasBody)
        {
            Skip();
        }
        else
        {
            Accept(";");
        }
        function.end = std::min(m_Index, m_Tokens.size());
        return function;
    }

    const HlslTokens& m_Tokens;
    std::size_t m_Index = 0;
    HlslDeclarations m_Result;
};

} // namespace

std::string_view HlslDeclarations::ResolveAlias(std::string_view type,
                                                std::string_view* argument) const
{
    // An alias names what is declared before it, so that one walk backwards resolves chains.
    for (auto alias = aliases.rbegin(); alias != aliases.rend(); ++alias)
    {
        if (alias->name == type)
        {
            type = alias->type;
            if (argument)
            {
                *argument = alias->templateArgument;
            }
        }
    }
    return type;
}

const HlslStruct* HlslDeclarations::FindStruct(std::string_view name) const
{
    const auto found = std::ranges::find(structs, name, &HlslStruct::name);
    return found == structs.end() ? nullptr : &*found;
}

const HlslFunction* HlslDeclarations::FindDefinition(std::string_view name) const
{
    const auto found = std::ranges::find_if(functions, [&](const HlslFunction& item)
                                            { return item.hasBody && item.name == name; });
    return found == functions.end() ? nullptr : &*found;
}

HlslDeclarations ReadDeclarations(const HlslTokens& tokens)
{
    return DeclarationReader(tokens).Read();
}

HlslType TypeOf(const HlslDeclarations& declarations, std::string_view type,
                std::string_view argument)
{
    type = declarations.ResolveAlias(type, &argument);
    if (type == "void")
    {
        HlslType result;
        result.kind = HlslType::Kind::Void;
        return result;
    }
    if ((type == "vector" || type == "matrix") && !argument.empty())
    {
        const auto scalar = NumberType(Trim(argument.substr(0, argument.find(','))));
        const auto size = [&](std::size_t comma)
        {
            const std::string_view text =
                comma == argument.npos ? "" : Trim(argument.substr(comma + 1));
            return text.empty() || !isDigit(text[0]) ? 0 : text[0] - '0';
        };
        const int first = size(argument.find(','));
        const int second = size(argument.rfind(','));
        const bool isKnown = scalar && first > 0 && second > 0;
        return !isKnown           ? HlslType()
               : type == "vector" ? scalar->As(first)
                                  : scalar->As(second, first);
    }
    if (const auto number = NumberType(type))
    {
        return *number;
    }
    HlslType result;
    const HlslStruct* structure = declarations.FindStruct(type);
    if (structure || isObjectType(type))
    {
        result.kind = structure ? HlslType::Kind::Struct : HlslType::Kind::Object;
        result.name = type;
        result.element = argument;
    }
    return result;
}

HlslType TypeOf(const HlslDeclarations& declarations, const HlslVariable& variable)
{
    HlslType type = TypeOf(declarations, variable.type, variable.templateArgument);
    type.dimensions = static_cast<std::uint8_t>(variable.dimensions.size());
    return type;
}

std::string TypeText(std::string_view type, std::string_view argument)
{
    return std::string(type) + (argument.empty() ? "" : "<" + std::string(argument) + ">");
}

std::string DeclarationOf(std::string_view name, const HlslVariable& variable)
{
    std::string text = TypeText(variable.type, variable.templateArgument) + " ";
    text += name;
    for (const std::string_view size : variable.dimensions)
    {
        text.append("[").append(size).append("]");
    }
    return text;
}

} // namespace limn
