#include "port/PortExpression.h"

#include "port/PortLiteral.h"
#include "port/PortMember.h"
#include "port/PortOperator.h"

#include <algorithm>

namespace limn
{

namespace
{

using Result = std::optional<PortValue>;

class Translator
{
public:
    Translator(const PortPlace& place, CSharpWords words, std::string& problem)
        : m_Place(place),
          m_At(words.data()),
          m_End(m_At + words.size()),
          m_Problem(problem),
          m_Members(m_Place, problem)
    {
    }

    Result Run(const std::string& wanted)
    {
        const Result value = ReadAny(wanted);
        if (value && m_At < m_End)
        {
            return Fail("'" + std::string(m_At->text) + "' is not understood");
        }
        const Result converted = value ? Converted(m_Place.model, *value, wanted) : std::nullopt;
        return !value || converted
                   ? converted
                   : Fail("a value of type '" + value->type + "' where '" + wanted + "' is needed");
    }

    /// Returns the assignment to what the words are.
    std::optional<std::string> Assign(std::string_view word, CSharpWords assigned)
    {
        m_Assigned = assigned;
        const Result target = ReadPrimary("");
        if (!m_Setter.empty() && word == "=")
        {
            return m_Setter == "-" ? "" : m_Setter;
        }
        if (!target || m_At < m_End || !m_Setter.empty() ||
            !(target->isVariable || target->type.empty()))
        {
            Fail("what is assigned to is no variable");
            return std::nullopt;
        }
        return AssignmentTo(m_Place, *target, word, assigned, m_Problem);
    }

private:
    Result Fail(const std::string& problem)
    {
        m_Problem = m_Problem.empty() ? problem : m_Problem;
        return std::nullopt;
    }

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
        return m_At < m_End && m_At->Is("{") ? ReadElements(wanted) : ReadTernary(wanted);
    }

    Result ReadTernary(const std::string& wanted)
    {
        const Result condition = ReadBinary(1, wanted);
        if (condition && Next("?\?"))
        {
            const Result other = ReadTernary(wanted);
            const Result either =
                other ? Otherwise(m_Place.model, *condition, *other) : std::nullopt;
            return either ? either : Fail("'?\?' of this");
        }
        if (!condition || m_At == m_End || !m_At->Is("?"))
        {
            return condition;
        }
        ++m_At;
        Result left = IsTruth(m_Place.model, *condition) ? ReadTernary(wanted) : std::nullopt;
        Result right = left && Next(":") ? ReadTernary(wanted) : std::nullopt;
        if (left && right && left->type != right->type)
        {
            std::string common = left->type == "null"                            ? right->type
                                 : right->type == "null" || right->type == "int" ? left->type
                                                                                 : right->type;
            for (Result* side : {&left, &right})
            {
                *side = Converted(m_Place.model, **side, common);
                const bool isBare = *side && (*side)->cpp == "{}";
                (isBare ? (*side)->cpp : common) =
                    isBare ? m_Place.model.CppType(common).value_or("") + "{}" : common;
            }
        }
        if (!left || !right || left->isPointer != right->isPointer)
        {
            return Fail("the values of '? :' are of two types");
        }
        PortValue value = *left;
        value.cpp = condition->Text(1) + " ? " + left->Text(1) + " : " + right->Text(0);
        value.isVariable = value.isLiteral = false;
        value.strength = 0;
        return value;
    }

    Result ReadBinary(int least, const std::string& wanted)
    {
        Result left = ReadUnary(wanted);
        while (left && m_At < m_End)
        {
            std::string word(m_At->text);
            const bool isShift = (word == "<" || word == ">") && m_At + 1 < m_End &&
                                 m_At[1].Is(word) && m_At[1].offset == m_At->offset + 1;
            word = isShift ? word + word : word;
            const bool isPattern = word == "is" && m_At + 1 < m_End;
            const int strength = isPattern ? Strength("==") : Strength(word);
            if (strength < least || strength == 0)
            {
                break;
            }
            m_At += isShift ? 2 : 1;
            if (isPattern)
            {
                left = ReadPatterns(*left);
                continue;
            }
            const Result right = ReadBinary(strength + 1, "");
            std::string problem;
            left = right ? Combined(m_Place.model, *left, word, *right, problem) : std::nullopt;
            if (!problem.empty())
            {
                return Fail(problem);
            }
        }
        return left;
    }

    /// Reads what stands behind `is`: null, not null, a value, values with `or` between them.
    Result ReadPatterns(const PortValue& left)
    {
        const bool isNot = Next("not");
        Result all;
        do
        {
            const Result value = ReadBinary(Strength("<") + 1, "");
            std::string problem;
            const Result same =
                value ? Combined(m_Place.model, left, isNot ? "!=" : "==", *value, problem)
                      : std::nullopt;
            if (!same)
            {
                return Fail(problem.empty() ? "'is' with a type" : problem);
            }
            all = all ? Combined(m_Place.model, *all, "||", *same, problem) : same;
        } while (!isNot && Next("or"));
        return all;
    }

    Result ReadUnary(const std::string& wanted)
    {
        if (m_At == m_End || ++m_Depth > 200)
        {
            return Fail("an expression without an end");
        }
        const bool isStep = m_End - m_At > 2 && (m_At->Is("+") || m_At->Is("-")) &&
                            m_At[1].text == m_At->text && m_At[1].offset == m_At->offset + 1;
        if (isStep)
        {
            const std::string sign(m_At->text);
            m_At += 2;
            Result value = ReadUnary("");
            if (!value || !value->isVariable || !m_Place.isBody)
            {
                return Fail("'" + sign + sign + "' of this");
            }
            value->cpp = sign + sign + value->Text(90);
            value->strength = 90;
            return value;
        }
        if (Next("-") || Next("~") || Next("!"))
        {
            const std::string word(m_At[-1].text);
            Result value = ReadUnary("");
            const bool isVector =
                value && word == "-" && IsIn(value->type, {"Vector2", "Vector3", "Vector4"});
            const bool isGood =
                value &&
                (isVector || (word == "!" ? IsTruth(m_Place.model, *value)
                                          : IsNumber(value->type) && value->type != "uint"));
            const bool isMask =
                value && word == "~" && IsIn(value->type, {"LayerMask", "RenderingLayerMask"});
            if ((!isGood && !isMask) || (word == "~" && value->type != "int" && !isMask))
            {
                return Fail("'" + word + "' of this");
            }
            value->cpp = word + value->Text(90);
            value->type = word == "!" ? "bool" : value->type;
            value->isVariable = value->isPointer = false;
            value->strength = 90;
            value->isLiteral = value->isLiteral && word != "!";
            return value;
        }
        if (m_At->Is("(") && m_At->Behind() < m_End && isCast())
        {
            return ReadCast();
        }
        return ReadPrimary(wanted);
    }

    /// Returns whether a cast stands here: (T) in front of a name, a number or a bracket.
    bool isCast() const
    {
        const CSharpToken* at = m_At + 1;
        const std::string type = ReadCSharpType(at);
        const CSharpToken& behind = *m_At->Behind();
        const bool isType =
            !type.empty() && at == m_At->Behind() - 1 &&
            (IsIn(type, {"int", "float", "uint", "double", "bool"}) || m_Place.model.Find(type) ||
             m_Place.model.CppType(type) || type == "UniversalRenderer");
        return isType && !m_Place.scope.contains(type) &&
               (behind.isName() || behind.Is("(") || behind.Is("-") ||
                behind.kind == CSharpTokenKind::Number);
    }

    Result ReadCast()
    {
        const CSharpToken* at = m_At + 1;
        const std::string type = ReadCSharpType(at);
        m_At = m_At->Behind();
        const Result value = ReadUnary("");
        if (!value)
        {
            return value;
        }
        if (const Result number = CastNumber(m_Place.model, *value, type))
        {
            return number;
        }
        const Result converted = Converted(m_Place.model, *value, type);
        return converted ? converted : Fail("'(" + type + ")' of a '" + value->type + "'");
    }

    Result ReadPrimary(const std::string& wanted)
    {
        if (m_At->Is("("))
        {
            const bool isWhole = m_At->Behind() == m_End;
            const Result inner =
                Translate(m_Place, m_At->Inside(), isWhole ? wanted : "", &m_Problem);
            m_At = m_At->Behind();
            return inner ? ReadBehind(*inner) : inner;
        }
        const CSharpToken& word = *m_At;
        if (word.kind == CSharpTokenKind::Number)
        {
            return NumberValue(std::string((m_At++)->text));
        }
        if (word.kind == CSharpTokenKind::String)
        {
            const auto text = PlainText({m_At, 1});
            ++m_At;
            const Result filled = text ? Result(PortValue{"\"" + *text + "\"", "string"})
                                       : TextWithValues(m_Place, word, m_Problem);
            return filled ? filled : Fail("a text with values in it");
        }
        if (Next("true") || Next("false"))
        {
            return PortValue{std::string(word.text), "bool"};
        }
        if (Next("null") || Next("default"))
        {
            const bool isTyped = m_At < m_End && m_At->Is("(");
            m_At = isTyped ? m_At->Behind() : m_At;
            return PortValue{"{}", "null"};
        }
        if (Next("new"))
        {
            const Result made = ReadNew(wanted);
            return made && m_Place.isBody ? ReadBehind(*made) : made;
        }
        if (word.Is("nameof") && m_At + 3 < m_End && m_At[2].isName() && m_At[3].Is(")"))
        {
            m_At += 4;
            return PortValue{"\"" + std::string(m_At[-2].text) + "\"", "string"};
        }
        return word.isName() ? ReadHead() : Fail("'" + std::string(word.text) + "'");
    }

    /// Behind `new`.
    Result ReadNew(const std::string& wanted)
    {
        std::string type = m_At < m_End && !m_At->Is("(") ? ReadCSharpType(m_At) : "";
        if (wanted.find(k_PropertyIdType) != std::string::npos) // new int[3], new List<int>()
        {
            type = Replaced(type, "int", k_PropertyIdType);
        }
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
            const CSharpWords inside = m_At->Inside();
            const bool hasMembers = inside.size() > 2 && inside[1].Is("=");
            m_At = hasMembers ? m_At->Behind() : m_At;
            return hasMembers          ? Construct(type, arguments, inside)
                   : arguments.empty() ? ReadElements(type)
                                       : Fail("'new' with this in its braces");
        }
        return Construct(type, arguments);
    }

    /// Behind `new T`: [3] or [2] {a, b}.
    Result ReadArray(const std::string& type)
    {
        const auto cpp = m_Place.model.CppType(type);
        const Result size = Translate(m_Place, m_At->Inside(), "int", &m_Problem);
        m_At = m_At->Behind();
        if (m_At < m_End && m_At->Is("{"))
        {
            return ReadElements(type);
        }
        // C# fills an array of a class with null, and C++ can make no nested class here yet.
        const CSharpClass* own = m_Place.model.Find(type.substr(0, type.size() - 2));
        const bool isOfClass = own && m_Place.model.RoleOf(*own) != PortRole::Enum;
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
            {"Vector4", {2, 4}}, {"ShaderTagId", {1, 1}}, {"ProfilingSampler", {1, 1}}};
        const auto count = counts.find(type);
        if (m_Place.model.Find(type) || count == counts.end() || arguments.empty())
        {
            return m_Members.Construct(type, arguments);
        }
        if (arguments.size() < count->second.first || arguments.size() > count->second.second)
        {
            return Fail("'new " + type + "' with these arguments");
        }
        const bool isNamed = type == "ShaderTagId" || type == "ProfilingSampler";
        auto values = List(arguments, isNamed ? "string" : "float");
        const bool isColor = type == "Color";
        for (std::size_t i = arguments.size(); values && type == "Vector4" && i < 4; ++i)
        {
            *values += ", 0.0f";
        }
        return values ? Result(PortValue{
                            type + (isColor ? "{" : "(") + *values + (isColor ? "}" : ")"), type})
                      : std::nullopt;
    }

    /// Returns `new T(arguments) { a = b, c = d }`: a function that makes it.
    Result Construct(const std::string& type, const std::vector<CSharpWords>& arguments,
                     CSharpWords members)
    {
        const Result made = m_Place.isBody ? Construct(type, arguments) : std::nullopt;
        if (!made || made->isPointer || IsReferenceType(m_Place.model, type))
        {
            return Fail("'new' with members");
        }
        return MadeWith(m_Place, *made, members, m_Problem);
    }

    /// Returns the arguments of the bracket that stands here, and continues behind it.
    std::vector<CSharpWords> TakeArguments()
    {
        const CSharpWords words = m_At->Inside();
        m_At = m_At->Behind();
        return SplitArguments(words);
    }

    /// Returns "a, b", or nothing if one of the values is not known.
    std::optional<std::string> List(const std::vector<CSharpWords>& items, const std::string& type)
    {
        std::string text;
        for (const CSharpWords& words : items)
        {
            const Result value = Translate(m_Place, words, type, &m_Problem);
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

    /// Reads a name with what stands behind it: a, this.a, base.a(), UnityEngine.a.
    Result ReadHead()
    {
        while (IsIn(m_At->text, {"UnityEngine", "Unity", "System", "global", "Experimental"}) &&
               m_End - m_At > 2 && (m_At[1].Is(".") || m_At[1].Is("::")))
        {
            do
            {
                m_At += 2;
            } while (m_End - m_At > 2 && m_At[1].Is(".") &&
                     IsIn(m_At->text, {"Experimental", "Rendering", "Universal",
                                       "RenderGraphModule", "Collections", "Generic", "Util"}));
        }
        const bool isThis = m_At->Is("this");
        const bool isBase = m_At->Is("base");
        if ((isThis || isBase) && m_End - m_At > 2 && m_At[1].Is("."))
        {
            m_At += 2;
            PortName name = ReadName();
            name.isOfThis = true;
            if (const Result setter = OwnSetter(name))
            {
                return setter;
            }
            const auto own = m_Place.scope.find("this." + name.name);
            return Behind(own != m_Place.scope.end() && !name.isCall ? own->second
                          : isBase ? m_Members.BaseMember(name, true)
                                   : m_Members.Find(name));
        }
        if (isThis && m_Place.isBody && m_Place.model.context())
        {
            ++m_At;
            PortValue self{"*this", m_Place.model.context()->name};
            self.isVariable = true;
            self.strength = 90;
            return self;
        }
        if (const Result named = ReadTypeName())
        {
            return named;
        }
        if (const Result size = ReadSize())
        {
            return size;
        }
        const PortName name = ReadName();
        const auto variable = m_Place.scope.find(name.name);
        const CSharpClass* self = m_Place.model.context();
        const CSharpMethod* property = self ? self->FindMethod(name.name) : nullptr;
        const CSharpField* field = self ? self->FindField(name.name) : nullptr;
        const bool isNamedSo =
            (variable != m_Place.scope.end() && variable->second.type == name.name) ||
            (field && field->type == name.name) ||
            (property && property->isProperty && property->type == name.name);
        const bool isAlsoType =
            isNamedSo && m_End - m_At > 1 && m_At->Is(".") &&
            isStatic(name.name, std::string(m_At[1].text), m_End - m_At > 2 && m_At[2].Is("("));
        if (isAlsoType) // RenderPassEvent RenderPassEvent = RenderPassEvent.AfterRendering
        {
            PortValue type{m_Place.model.CppType(name.name).value_or(name.name), name.name};
            type.isType = true;
            return ReadBehind(type);
        }
        if (const Result setter = OwnSetter(name))
        {
            return setter;
        }
        return Behind(m_Members.Find(name));
    }

    /// Keeps the code of an assignment to a member of the class that is no variable in C++. Returns
    /// nothing if it is one.
    Result OwnSetter(const PortName& name)
    {
        return name.isTarget ? SetterOf(PortValue{"", SelfType()}, name) : std::nullopt;
    }

    /// Reads GetType().Name or typeof(T).Name, or returns nothing and reads nothing.
    Result ReadTypeName()
    {
        const CSharpToken* behind = m_End - m_At > 3 && m_At[1].Is("(") ? m_At[1].Behind() : m_End;
        const bool isName = m_End - behind > 1 && behind->Is(".") && behind[1].Is("Name");
        const CSharpClass* self = m_Place.model.context();
        const CSharpWords inside = isName ? m_At[1].Inside() : CSharpWords();
        std::string type;
        if (isName && m_At->Is("GetType") && inside.empty() && self)
        {
            type = self->name;
        }
        else if (isName && m_At->Is("typeof") && inside.size() == 1)
        {
            type = inside[0].text;
        }
        if (type.empty())
        {
            return std::nullopt;
        }
        m_At = behind + 2;
        return PortValue{"\"" + type + "\"", "string"};
    }

    /// Reads sizeof(T), Marshal.SizeOf(typeof(T)) or Marshal.SizeOf<T>(), or returns nothing and
    /// reads nothing.
    Result ReadSize()
    {
        const bool isWord = m_At->Is("sizeof") && m_End - m_At > 1;
        const bool isCall = IsIn(m_At->text, {"Marshal", "UnsafeUtility"}) && m_End - m_At > 3 &&
                            m_At[1].Is(".") && m_At[2].Is("SizeOf");
        const CSharpToken* at = m_At + (isWord ? 1 : 3);
        const bool isGeneric = isCall && at->Is("<");
        const bool isOfType = isCall && at->Is("(") && at[1].Is("typeof");
        if (!isWord && !isGeneric && !isOfType)
        {
            return std::nullopt;
        }
        at += isOfType ? 3 : 1;
        const std::string type = ReadCSharpType(at);
        const auto cpp = m_Place.model.CppType(type);
        if (!cpp)
        {
            return std::nullopt;
        }
        m_At = isOfType ? at + 2 : isGeneric ? at + 3 : at + 1;
        return PortValue{"static_cast<int>(sizeof(" + *cpp + "))", "int"};
    }

    /// Returns whether the member is the type's and no object's.
    bool isStatic(const std::string& type, const std::string& member, bool isCall) const
    {
        const CSharpClass* own = m_Place.model.Find(type);
        const PortEntry* entry = m_Place.model.table().Find(type, member);
        return own ? own->enumeratorNames.contains(member)
                   : entry && (entry->result == type || (entry->result.empty() && !isCall &&
                                                         entry->verdict == PortVerdict::Same &&
                                                         !IsSharedType(m_Place.model, type)));
    }

    std::string SelfType() const
    {
        const CSharpClass* one = m_Place.model.context();
        return one ? BaseTypeOf(m_Place.model.RoleOf(*one)) : "";
    }

    Result Behind(const Result& value) { return value ? ReadBehind(*value) : value; }

    /// Reads the name that stands here, with what belongs to it.
    PortName ReadName()
    {
        PortName name;
        name.name = (m_At++)->text;
        const CSharpToken* behind = m_At;
        if (m_At < m_End && m_At->Is("<"))
        {
            const std::string generics = ReadCSharpGenerics(behind);
            if (!generics.empty() && behind < m_End && behind->Is("("))
            {
                name.generics = generics;
                m_At = behind;
            }
        }
        name.isCall = m_At < m_End && m_At->Is("(");
        if (name.isCall)
        {
            name.arguments = TakeArguments();
        }
        name.isTarget = m_Assigned.data() != nullptr && m_At == m_End;
        return name;
    }

    /// Keeps the code of an assignment to a member that is no variable in C++.
    Result SetterOf(const PortValue& value, const PortName& name)
    {
        const auto setter = m_Members.Setter(value, name, m_Assigned);
        m_Setter = setter.value_or("");
        return setter ? Result(value) : std::nullopt;
    }

    /// Reads what stands behind a value: .b[c].
    Result ReadBehind(PortValue value)
    {
        while (m_At < m_End)
        {
            if (m_At->Is("[") && !value.isType)
            {
                const Result element = m_Members.Element(value, m_At->Inside());
                m_At = m_At->Behind();
                if (!element)
                {
                    return element;
                }
                value = *element;
            }
            else if ((m_At->Is(".") || m_At->Is("?.")) && m_At + 1 < m_End && m_At[1].isName())
            {
                const bool isMaybe = m_At->Is("?.") && value.type != "VolumeStack"; // never null
                ++m_At;
                const PortName name = ReadName();
                if (name.isTarget && SetterOf(value, name))
                {
                    return value;
                }
                const Result vector =
                    value.isType ? VectorValue(value.type, name.name) : std::nullopt;
                const Result member = vector ? vector : m_Members.MemberOf(value, name);
                if (!member)
                {
                    return member;
                }
                if (isMaybe && (value.isPointer || IsSharedType(m_Place.model, value.type)))
                {
                    const bool isLast =
                        m_At == m_End || !(m_At->Is(".") || m_At->Is("?.") || m_At->Is("["));
                    const Result maybe =
                        isLast ? Maybe(m_Place.model, value, *member) : std::nullopt;
                    return maybe ? maybe : Fail("'?.' within an expression");
                }
                value = *member;
            }
            else
            {
                break;
            }
        }
        return value.isType ? Fail("a type where a value is needed") : Result(value);
    }

    PortPlace m_Place;
    const CSharpToken* m_At;
    const CSharpToken* m_End;
    std::string& m_Problem;
    PortMembers m_Members;
    CSharpWords m_Assigned;
    std::string m_Setter; ///< the assignment, where it is a call in C++
    int m_Depth = 0;
};

} // namespace

std::optional<PortValue> Translate(const PortPlace& place, CSharpWords words,
                                   const std::string& wanted, std::string* problem)
{
    std::string own;
    return words.empty() ? std::nullopt
                         : Translator(place, words, problem ? *problem : own).Run(wanted);
}

std::optional<std::string> TranslateAssignment(const PortPlace& place, CSharpWords target,
                                               std::string_view word, CSharpWords value,
                                               std::string& problem)
{
    return target.empty() || value.empty() ? std::nullopt
                                           : Translator(place, target, problem).Assign(word, value);
}

} // namespace limn
