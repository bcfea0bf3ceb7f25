#include "port/PortExpression.h"

#include <array>

namespace limn
{

namespace
{

using Result = std::optional<PortValue>;

bool IsNumber(const std::string& type)
{
    return type == "int" || type == "float" || type == "uint";
}

/// Returns how tightly an operator binds; 0 if it is not known.
int Strength(std::string_view word)
{
    static const std::map<std::string_view, int> strengths = {
        {"||", 1}, {"&&", 2}, {"|", 3}, {"==", 4}, {"!=", 4}, {"<", 5}, {">", 5},
        {"<=", 5}, {">=", 5}, {"+", 6}, {"-", 6},  {"*", 7},  {"/", 7}};
    const auto found = strengths.find(word);
    return found == strengths.end() ? 0 : found->second;
}

/// C++ once had characters that begin with ??.
std::string WithoutTrigraphs(std::string text)
{
    for (std::size_t at = text.find("??"); at != std::string::npos; at = text.find("??", at))
    {
        text.insert(++at, "\\");
    }
    return text;
}

class Translator
{
public:
    Translator(const PortModel& model, const PortScope& scope, CSharpWords words)
        : m_Model(model), m_Scope(scope), m_At(words.data()), m_End(m_At + words.size())
    {
    }

    Result Run(const std::string& wanted)
    {
        Result value = ReadAny(wanted);
        return value && m_At == m_End ? Convert(*value, wanted) : std::nullopt;
    }

private:
    bool Next(std::string_view word)
    {
        if (m_At == m_End || !m_At->Is(word))
        {
            return false;
        }
        ++m_At;
        return true;
    }

    Result ReadAny(const std::string& wanted)
    {
        return m_At < m_End && m_At->Is("{") ? ReadElements(wanted) : ReadBinary(1, wanted);
    }

    Result Convert(PortValue value, const std::string& wanted) const
    {
        const CSharpClass* own = wanted.empty() ? nullptr : m_Model.Find(wanted);
        if (wanted.empty())
        {
            return value;
        }
        if (value.type == wanted || (own && own == m_Model.Find(value.type)))
        {
            value.cpp = value.isPointer ? "*" + value.cpp : value.cpp;
            value.isPointer = false;
            return value;
        }
        const bool isHex = value.cpp.find_first_of("xX~") != std::string::npos;
        if (wanted == "float" && value.type == "int")
        {
            return value.isLiteral && !isHex
                       ? PortValue{value.cpp + ".0f", "float", true}
                       : PortValue{"static_cast<float>(" + value.cpp + ")", "float"};
        }
        if (wanted == "uint" && value.type == "int" && value.isLiteral && value.cpp[0] != '-')
        {
            return PortValue{value.cpp + "u", "uint", true};
        }
        const bool isRendering = wanted.ends_with("RenderingLayerMask");
        const bool isMask = (wanted == "LayerMask" || isRendering) && !own;
        if (isMask && (value.type == "int" || value.type == "uint") && value.isLiteral)
        {
            const bool isAll = IsIn(value.cpp, {"-1", "~0", "0xFFFFFFFFu", "4294967295u"});
            const bool isNone = value.cpp == "0" || value.cpp == "0u";
            if (isAll || isNone)
            {
                return PortValue{wanted + (isAll ? "::Everything()" : "::Nothing()"), wanted};
            }
            if (value.cpp[0] == '-' || value.cpp[0] == '~')
            {
                return std::nullopt;
            }
            return PortValue{wanted + "(" + value.cpp + (value.type == "int" ? "u)" : ")"), wanted};
        }
        if (value.type == "null")
        {
            return PortValue{PortModel::CppDefault(m_Model.CppType(wanted).value_or("")), wanted};
        }
        return std::nullopt;
    }

    Result ReadBinary(int least, const std::string& wanted)
    {
        Result left = ReadUnary(wanted);
        while (left && m_At < m_End)
        {
            const std::string word(m_At->text);
            const int strength = Strength(word);
            if (strength < least || strength == 0)
            {
                break;
            }
            ++m_At;
            const Result right = ReadBinary(strength + 1, "");
            left = right ? Combine(*left, word, *right) : std::nullopt;
        }
        return left;
    }

    Result Combine(PortValue left, const std::string& word, PortValue right) const
    {
        if (left.type == "float" || right.type == "float")
        {
            const bool areNumbers = IsNumber(left.type) && IsNumber(right.type);
            const Result a = areNumbers ? Convert(left, "float") : std::nullopt;
            const Result b = areNumbers ? Convert(right, "float") : std::nullopt;
            if (!a || !b)
            {
                return std::nullopt;
            }
            left = *a;
            right = *b;
        }
        const bool isEvent =
            left.type == "RenderPassEvent" && right.type == "int" && (word == "+" || word == "-");
        const bool isFlags = word == "|" && left.type == right.type &&
                             (left.type == "SortingCriteria" || left.type == "int" ||
                              left.type == "ScriptableRenderPassInput");
        const bool isLogic =
            (word == "&&" || word == "||") && left.type == "bool" && right.type == "bool";
        const bool isSame = left.type == right.type;
        const bool isComparison = Strength(word) == 4 || Strength(word) == 5;
        const bool isSum = Strength(word) >= 6 && IsNumber(left.type) && isSame;
        if (!isEvent && !isFlags && !isLogic && !isSum &&
            !(isComparison && isSame && left.type != "null"))
        {
            return std::nullopt;
        }
        return PortValue{"(" + left.cpp + " " + word + " " + right.cpp + ")",
                         isComparison ? "bool" : left.type};
    }

    Result ReadUnary(const std::string& wanted)
    {
        if (m_At == m_End || ++m_Depth > 200)
        {
            return std::nullopt;
        }
        if (Next("-") || Next("~") || Next("!"))
        {
            const std::string word(m_At[-1].text);
            Result value = ReadUnary("");
            const bool isGood =
                value && (word == "!" ? value->type == "bool"
                                      : IsNumber(value->type) && value->type != "uint");
            if (!isGood || (word == "~" && value->type != "int"))
            {
                return std::nullopt;
            }
            value->cpp = word + value->cpp;
            return value;
        }
        if (m_At->Is("(") && (m_At[1].Is("int") || m_At[1].Is("float")) && m_At + 2 < m_End &&
            m_At[2].Is(")"))
        {
            const std::string type(m_At[1].text);
            m_At += 3;
            const Result value = ReadUnary("");
            return value && IsNumber(value->type)
                       ? Result(PortValue{"static_cast<" + type + ">(" + value->cpp + ")", type})
                       : std::nullopt;
        }
        if (Next("("))
        {
            const Result value = ReadBinary(1, wanted);
            return Next(")") ? value : std::nullopt;
        }
        return ReadPrimary(wanted);
    }

    Result ReadPrimary(const std::string& wanted)
    {
        const CSharpToken& word = *m_At;
        if (word.kind == CSharpTokenKind::Number)
        {
            return ReadNumber();
        }
        if (word.kind == CSharpTokenKind::String)
        {
            const auto text = PlainText({m_At, 1});
            ++m_At;
            return text ? Result(PortValue{"\"" + *text + "\"", "string"}) : std::nullopt;
        }
        if (Next("true") || Next("false"))
        {
            return PortValue{std::string(word.text), "bool"};
        }
        if (Next("null") || Next("default"))
        {
            return PortValue{"{}", "null"};
        }
        if (Next("new"))
        {
            return ReadNew(wanted);
        }
        if (word.Is("nameof") && m_At + 3 < m_End && m_At[2].isName() && m_At[3].Is(")"))
        {
            m_At += 4;
            return PortValue{"\"" + std::string(m_At[-2].text) + "\"", "string"};
        }
        return word.isName() ? ReadChain() : std::nullopt;
    }

    Result ReadNumber()
    {
        std::string text((m_At++)->text);
        std::erase(text, '_');
        const bool isHex = text.starts_with("0x") || text.starts_with("0X");
        const char last = text.back();
        if (text.starts_with("0b") || text.starts_with("0B"))
        {
            return std::nullopt;
        }
        if (!isHex && (last == 'f' || last == 'F'))
        {
            text.pop_back();
            const bool isWhole = text.find_first_of(".eE") == std::string::npos;
            return PortValue{text + (isWhole ? ".0f" : "f"), "float", true};
        }
        const bool isUnsigned = last == 'u' || last == 'U';
        if (isUnsigned)
        {
            text.pop_back();
        }
        const bool isInt = text.find_first_not_of("0123456789") == std::string::npos || isHex;
        const bool isOctal = text.size() > 1 && text[0] == '0' && !isHex; // in C++ only
        const bool hasSuffix = text.find_first_of("uUlL") != std::string::npos;
        const bool isSmall = text.size() < 10;
        if (!isInt || isOctal || hasSuffix || !(isSmall || (isHex && text.size() == 10)))
        {
            return std::nullopt;
        }
        // 0xFFFFFFFF is a uint without saying so.
        return isSmall && !isUnsigned ? PortValue{text, "int", true}
                                      : PortValue{text + "u", "uint", true};
    }

    /// Behind `new`.
    Result ReadNew(const std::string& wanted)
    {
        std::string type = m_At < m_End && !m_At->Is("(") ? ReadCSharpType(m_At) : "";
        if (m_At < m_End && m_At->Is("["))
        {
            return ReadArray(type + "[]");
        }
        type = type.empty() || type == "[]" ? wanted : type;
        std::vector<CSharpWords> arguments;
        if (m_At < m_End && m_At->Is("("))
        {
            arguments = TakeArguments();
        }
        if (m_At < m_End && m_At->Is("{"))
        {
            return arguments.empty() ? ReadElements(type) : std::nullopt;
        }
        return Construct(type, arguments);
    }

    /// Behind `new T`: [3] or [2] {a, b}.
    Result ReadArray(const std::string& type)
    {
        const auto cpp = m_Model.CppType(type);
        const Result size = Translate(m_Model, m_Scope, m_At->Inside(), "int");
        m_At = m_At->Behind();
        if (m_At < m_End && m_At->Is("{"))
        {
            return ReadElements(type);
        }
        // C# fills an array of a class with null, and C++ can make no nested class here yet.
        const CSharpClass* own = m_Model.Find(type.substr(0, type.size() - 2));
        const bool isOfClass = own && m_Model.RoleOf(*own) != PortRole::Enum;
        const bool isOfArrays = m_At < m_End && m_At->Is("[");
        if (!cpp || !size || isOfClass || isOfArrays)
        {
            return std::nullopt;
        }
        return PortValue{*cpp + "(" + (size->isLiteral ? "" : "static_cast<std::size_t>(") +
                             size->cpp + (size->isLiteral ? ")" : "))"),
                         type};
    }

    Result Construct(const std::string& type, const std::vector<CSharpWords>& arguments)
    {
        static const std::map<std::string, std::pair<std::size_t, std::size_t>> counts = {
            {"Color", {3, 4}},   {"Vector2", {2, 2}},     {"Vector3", {3, 3}},
            {"Vector4", {4, 4}}, {"ShaderTagId", {1, 1}}, {"ProfilingSampler", {1, 1}}};
        const auto cpp = m_Model.CppType(type);
        if (!cpp)
        {
            return std::nullopt;
        }
        if (arguments.empty())
        {
            return type == "ProfilingSampler"
                       ? std::nullopt
                       : Result(PortValue{*cpp + PortModel::CppDefault(*cpp), type});
        }
        const auto count = counts.find(type);
        if (count == counts.end() || arguments.size() < count->second.first ||
            arguments.size() > count->second.second)
        {
            return std::nullopt;
        }
        const bool isNamed = type == "ShaderTagId" || type == "ProfilingSampler";
        const auto values = List(arguments, isNamed ? "string" : "float");
        const bool isColor = type == "Color";
        return values ? Result(PortValue{
                            *cpp + (isColor ? "{" : "(") + *values + (isColor ? "}" : ")"), type})
                      : std::nullopt;
    }

    /// Returns the arguments of the bracket that stands here, and continues behind it.
    std::vector<CSharpWords> TakeArguments()
    {
        const CSharpWords words = m_At->Inside();
        m_At = m_At->Behind();
        return SplitArguments(words);
    }

    /// Returns "a, b", or nothing if one of the values is not known.
    std::optional<std::string> List(const std::vector<CSharpWords>& items,
                                    const std::string& type) const
    {
        std::string text;
        for (const CSharpWords& words : items)
        {
            const Result value = Translate(m_Model, m_Scope, words, type);
            if (!value)
            {
                return std::nullopt;
            }
            text += (text.empty() ? "" : ", ") + value->cpp;
        }
        return text;
    }

    /// {a, b}
    Result ReadElements(const std::string& type)
    {
        const bool isArray = type.ends_with("[]");
        const bool isList = type.starts_with("List<");
        const auto elements = TakeArguments();
        if (!isArray && !isList)
        {
            return std::nullopt;
        }
        const auto values =
            List(elements, type.substr(isList ? 5 : 0, type.size() - (isList ? 6 : 2)));
        return values ? Result(PortValue{"{" + *values + "}", type}) : std::nullopt;
    }

    /// a.b.c
    Result ReadChain()
    {
        std::vector<std::string> names;
        do
        {
            if (m_At == m_End || !m_At->isName())
            {
                return std::nullopt;
            }
            names.emplace_back((m_At++)->text);
        } while (Next("."));
        const bool isQualified = names.front() == "UnityEngine";
        while (isQualified && names.size() > 1 &&
               IsIn(names.front(),
                    {"UnityEngine", "Experimental", "Rendering", "Universal", "RenderGraphModule"}))
        {
            names.erase(names.begin()); // a namespace
        }
        if (m_At < m_End && m_At->Is("(") &&
            names == std::vector<std::string>{"Shader", "PropertyToID"})
        {
            const Result name = Translate(m_Model, m_Scope, m_At->Inside(), "string");
            m_At = m_At->Behind();
            return name ? Result(PortValue{"Shader::PropertyToID(" + name->cpp + ")",
                                           k_PropertyIdType})
                        : std::nullopt;
        }
        if (names.front() == "this" && names.size() > 1)
        {
            names.erase(names.begin());
            names.front().insert(0, "this."); // not the parameter of this name
        }
        const auto found = m_Scope.find(names.front());
        return found == m_Scope.end() ? StaticValue(names) : MemberValue(found->second, names);
    }

    Result MemberValue(PortValue value, const std::vector<std::string>& names) const
    {
        for (std::size_t i = 1; i < names.size(); ++i)
        {
            const CSharpClass* own = m_Model.Find(value.type);
            const CSharpField* field = own ? own->FindField(names[i]) : nullptr;
            const std::string dot = value.isPointer ? "->" : ".";
            const bool isParameter = PlainTypeName(value.type).ends_with("Parameter");
            if (names[i] == "value" && isParameter)
            {
                value = {value.cpp + ".value()", ParameterValue(value.type)};
            }
            else if (names[i] == "overrideState" && isParameter)
            {
                value = {value.cpp + ".overrideState()", "bool"};
            }
            else if (field && m_Model.RoleOf(*own) == PortRole::Data && !field->isStatic &&
                     m_Model.isDeclared(*field))
            {
                const bool isVariable = value.isVariable;
                value = {value.cpp + dot + m_Model.CppName(field->name), field->type};
                value.isVariable = isVariable;
                value.isPointer = m_Model.isShared(*own, *field);
            }
            else
            {
                return std::nullopt;
            }
        }
        return value;
    }

    /// Returns the value type of a volume parameter of this type.
    std::string ParameterValue(const std::string& type) const
    {
        const std::string plain(PlainTypeName(type));
        for (const auto& [part, value] : {std::pair("Float", "float"), std::pair("Int", "int"),
                                          std::pair("Bool", "bool"), std::pair("Color", "Color")})
        {
            if (plain.ends_with(std::string(part) + "Parameter"))
            {
                return value;
            }
        }
        return m_Model.HeldType(type);
    }

    /// Vector2.one; nothing for others.
    static Result VectorValue(const std::string& type, const std::string& member)
    {
        static const std::map<std::string_view, std::array<int, 4>> values = {
            {"zero", {0, 0, 0, 0}},  {"one", {1, 1, 1, 1}},    {"up", {0, 1, 0, 0}},
            {"down", {0, -1, 0, 0}}, {"right", {1, 0, 0, 0}},  {"left", {-1, 0, 0, 0}},
            {"back", {0, 0, -1, 0}}, {"forward", {0, 0, 1, 0}}};
        const auto value = values.find(member);
        const bool isVector = IsIn(type, {"Vector2", "Vector3", "Vector4"});
        const auto size = isVector ? static_cast<std::size_t>(type.back() - '0') : 0;
        const bool isAlong = member == "back" || member == "forward";
        const bool isAny = member == "zero" || member == "one";
        if (value == values.end() || size == 0 || (size == 4 && !isAny) || (size == 2 && isAlong))
        {
            return std::nullopt;
        }
        std::string text = type + "(";
        for (std::size_t i = 0; i < size; ++i)
        {
            text += (i == 0 ? "" : ", ") + std::to_string(value->second[i]) + ".0f";
        }
        return PortValue{text + ")", type};
    }

    /// Color.white, RenderPassEvent.AfterRendering, Settings.Mode.On
    Result StaticValue(const std::vector<std::string>& names) const
    {
        if (names.size() < 2)
        {
            return std::nullopt;
        }
        const std::string& type = names[names.size() - 2];
        const std::string& member = names.back();
        if (const CSharpClass* own = m_Model.Find(type))
        {
            const CSharpField* field = own->FindField(member);
            if (field && field->isStatic && m_Model.RoleOf(*own) == PortRole::Data &&
                m_Model.isDeclared(*field))
            {
                return PortValue{m_Model.QualifiedName(*own) + "::" + m_Model.CppName(member),
                                 field->type};
            }
            const bool isMember = own->enumeratorNames.contains(member);
            const auto cpp = isMember ? m_Model.CppType(type) : std::nullopt;
            return cpp ? Result(PortValue{*cpp + "::" + m_Model.CppName(member), own->name})
                       : std::nullopt;
        }
        if (const Result vector = VectorValue(type, member))
        {
            return vector;
        }
        const PortEntry* entry = m_Model.table().Find(type, member);
        const bool isSame = entry && entry->verdict == PortVerdict::Same &&
                            m_Model.CppType(type) == type &&
                            (entry->result.empty() || entry->result == type);
        return isSame ? Result(PortValue{type + "::" + member, type}) : std::nullopt;
    }

    const PortModel& m_Model;
    const PortScope& m_Scope;
    const CSharpToken* m_At;
    const CSharpToken* m_End;
    int m_Depth = 0;
};

} // namespace

std::optional<PortValue> Translate(const PortModel& model, const PortScope& scope,
                                   CSharpWords words, const std::string& wanted)
{
    return words.empty() ? std::nullopt : Translator(model, scope, words).Run(wanted);
}

std::optional<std::vector<CSharpWords>> NewArguments(CSharpWords words)
{
    for (std::size_t i = 0; i < words.size() && words.front().Is("new"); ++i)
    {
        if (words[i].Is("("))
        {
            return SplitArguments(words[i].Inside());
        }
    }
    return std::nullopt;
}

std::optional<std::string> PlainText(CSharpWords words)
{
    if (words.size() > 2 && words.size() % 2 == 1 && words[1].Is("+"))
    {
        const auto first = PlainText(words.first(1));
        const auto rest = PlainText(words.subspan(2));
        return first && rest ? std::optional(WithoutTrigraphs(*first + *rest)) : std::nullopt;
    }
    if (words.size() != 1 || words[0].kind != CSharpTokenKind::String)
    {
        return std::nullopt;
    }
    const std::string_view text = words[0].text;
    const bool isPlain = text.size() >= 2 && text[0] == '"' && !text.starts_with("\"\"\"");
    const std::string_view inner = isPlain ? text.substr(1, text.size() - 2) : "\\";
    for (std::size_t at = inner.find('\\'); at < inner.size(); at = inner.find('\\', at + 2))
    {
        if (at + 1 >= inner.size() ||
            std::string_view("\\\"nt").find(inner[at + 1]) == std::string_view::npos)
        {
            return std::nullopt;
        }
    }
    return WithoutTrigraphs(std::string(inner));
}

std::optional<std::string> TranslateNumber(const PortModel& model, CSharpWords words)
{
    const auto value = Translate(model, {}, words, "");
    if (!value || (value->type != "int" && value->type != "float"))
    {
        return std::nullopt;
    }
    std::string text = value->cpp;
    if (value->type == "float" && text.ends_with("f"))
    {
        text.pop_back();
    }
    return text;
}

} // namespace limn
