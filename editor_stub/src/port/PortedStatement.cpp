#include "port/PortedStatement.h"

#include "port/PortMember.h"
#include "port/PortOperator.h"
#include "port/csharp/CSharpStatements.h"

#include <algorithm>

namespace limn
{

bool PortedStatement::Fail(const std::string& problem)
{
    m_Problem = m_Problem.empty() ? problem : m_Problem;
    return false;
}

std::optional<PortValue> PortedStatement::Value(CSharpWords words, const std::string& wanted)
{
    return Translate(Place(), words, wanted, &m_Problem);
}

void PortedStatement::Todo(CSharpWords words, const std::string& otherwise)
{
    const std::string why = m_Problem.empty() ? otherwise : InComment(m_Problem);
    m_Code.Todo(why, m_Model.Place(m_One, words.front().location), TextOf(*m_One.file, words));
    m_Problem.clear();
}

/// Writes a statement without its semicolon: a declaration, an assignment, a call.
bool PortedStatement::WriteSimple(CSharpWords words)
{
    DeclareOutputs(words);
    Word at = words.data();
    const Word end = at + words.size();
    if (at < end && at->Is("const"))
    {
        words = words.subspan(1);
        ++at;
    }
    const bool isReference = at < end && at->Is("ref");
    Word name = at + (isReference ? 1 : 0);
    const std::string type = ReadCSharpType(name);
    const bool isDeclaration = !type.empty() && name < end && name->isName() &&
                               !IsIn(name->text, {"is", "as", "in"}) &&
                               (name + 1 == end || name[1].Is("=") || name[1].Is(","));
    if (isDeclaration)
    {
        return WriteDeclaration(words);
    }
    const Word equals =
        FindOutsideOfBrackets(at, end, {"=", "+=", "-=", "*=", "/=", "|=", "&=", "%="});
    if (equals == end)
    {
        if (const auto shifted = ShiftText(words))
        {
            m_Code.Line(*shifted + ";");
            return true;
        }
    }
    if (equals < end && at->Is("(") && at->Behind() == equals)
    {
        return WriteSwap(SplitArguments(at->Inside()), {equals + 1, end});
    }
    if (equals < end)
    {
        return WriteAssignment({at, equals}, equals->text, {equals + 1, end});
    }
    if (std::ranges::count(words, std::string_view("?."), &CSharpToken::text) > 0)
    {
        return WriteMaybe(words);
    }
    const bool isStep = words.size() > 2 && (words.back().Is("+") || words.back().Is("-"));
    if (isStep)
    {
        const auto value = Value(words.first(words.size() - 2));
        if (value)
        {
            m_Code.Line((words.back().text[0] == '+' ? "++" : "--") + value->cpp + ";");
        }
        return value.has_value();
    }
    const auto value = Value(words);
    if (!value)
    {
        return false;
    }
    if (!value->cpp.empty()) // a call that limn leaves out
    {
        m_Code.Line(value->cpp + ";");
    }
    return true;
}

/// Declares the variables that stand behind `out` in a call: out TextureHandle mask.
void PortedStatement::DeclareOutputs(CSharpWords words)
{
    const Word end = words.data() + words.size();
    const bool hasSizes = std::ranges::count(words, std::string_view("GetKernelThreadGroupSizes"),
                                             &CSharpToken::text) > 0;
    for (Word at = words.data(); at + 2 < end; ++at)
    {
        Word name = at + 1;
        std::string type = at->Is("out") ? ReadCSharpType(name) : "";
        if (type == "_" || (!type.empty() && name->Is("_"))) // of a size that nobody needs
        {
            const bool isNew = hasSizes && !m_Scope.contains("_");
            name = isNew && type == "_" ? at + 1 : name;
            type = isNew ? "uint" : "";
        }
        const auto cpp = type.empty() || type == "var" ? std::nullopt : m_Model.CppType(type);
        const bool isOutput =
            cpp && name + 1 < end && name->isName() && (name[1].Is(",") || name[1].Is(")"));
        if (isOutput)
        {
            m_Code.Line(*cpp + " " + AddLocal(std::string(name->text), type).cpp +
                        PortModel::CppDefault(*cpp) + ";");
        }
    }
}

bool PortedStatement::WriteDeclaration(CSharpWords words)
{
    Word at = words.data();
    const Word end = at + words.size();
    const bool isReference = at->Is("ref");
    at += isReference ? 1 : 0;
    const std::string type = ReadCSharpType(at);
    while (at < end)
    {
        const std::string name(at->text);
        const auto known = m_Method.intLocals.find(name);
        const bool isInt = known != m_Method.intLocals.end() &&
                           IsIn(type, {"int", "int[]", "List<int>", "var"}) &&
                           known->second.find(k_PropertyIdType) != std::string::npos;
        const Word comma = FindOutsideOfBrackets(at, end, {","});
        Word value = at + (at + 1 < comma && at[1].Is("=") ? 2 : 1);
        value += value < comma && value->Is("ref") ? 1 : 0;
        if (!DeclareLocal(isInt ? known->second : type, name, {value, comma}, isReference))
        {
            return false;
        }
        at = std::min(comma + 1, end);
    }
    return true;
}

PortValue& PortedStatement::AddLocal(const std::string& name, const std::string& type)
{
    PortValue value{LocalName(m_Model, m_One, name), type};
    value.isVariable = true;
    value.isLocal = true;
    return m_Scope[name] = value;
}

bool PortedStatement::DeclareLocal(const std::string& type, const std::string& name,
                                   CSharpWords words, bool isReference)
{
    const std::string wanted = type == "var" ? "" : type;
    if (words.empty())
    {
        const auto cpp = m_Model.CppType(wanted);
        if (!cpp || IsReferenceType(m_Model, wanted))
        {
            return Fail("'" + type + "' without a value");
        }
        m_Code.Line("[[maybe_unused]] " + *cpp + " " + AddLocal(name, wanted).cpp +
                    PortModel::CppDefault(*cpp) + ";");
        return true;
    }
    // new T(...) { a = 1 }
    const auto braces = words.front().Is("new") && words.back().Is("}")
                            ? std::ranges::find(words, std::string_view("{"), &CSharpToken::text)
                            : words.end();
    const bool hasMembers =
        braces != words.end() && braces->Inside().size() > 2 && braces->Inside()[1].Is("=");
    const CSharpWords object(words.begin(), hasMembers ? braces : words.end());
    const bool isBare = hasMembers && !object.back().Is(")");
    Word bare = object.data() + 1;
    const std::string bareType = isBare ? ReadCSharpType(bare) : "";
    auto value = isBare ? PortMembers(Place(), m_Problem).Construct(bareType, {})
                        : Value(object, IsReferenceType(m_Model, wanted) ? "" : wanted);
    if (!value || value->type == "void" || (value->type == "null" && wanted.empty()))
    {
        return false;
    }
    const bool isOther =
        isReference || (value->isVariable && IsReferenceType(m_Model, value->type));
    PortValue& local = AddLocal(name, value->type.empty() ? wanted : value->type);
    const auto cpp =
        wanted.empty() || isOther || value->isPointer ? std::nullopt : m_Model.CppType(wanted);
    local.isPointer = value->isPointer;
    local.isLocal = !isOther && !value->isPointer;
    local.type = cpp && value->type == "null" ? wanted : local.type;
    if (!cpp && value->cpp.starts_with("{") && !m_Model.CppType(value->type))
    {
        m_Scope.erase(name);
        return value->type == "null" ? Fail("'" + type + "' that is null")
                                     : Fail("a list of '" + ElementTypeOf(value->type) + "'");
    }
    // A list of values has no type of its own in C++, and a pointer of limn's no check for null.
    const bool isTyped =
        !value->isPointer && (value->cpp.starts_with("{") || IsSharedType(m_Model, value->type));
    const auto typed = cpp || !isTyped ? cpp : m_Model.CppType(value->type);
    const std::string keyword = typed && *typed != "ShaderPropertyId" ? *typed + " "
                                : isOther && !value->isPointer        ? "auto& "
                                                                      : "auto ";
    const bool isText = value->type == "string" && value->cpp.starts_with("\"");
    const std::string made = isText ? "std::string(" + value->cpp + ")" : value->cpp;
    m_Code.Line("[[maybe_unused]] " + std::string(isText && wanted.empty() ? "auto " : keyword) +
                local.cpp + " = " + (cpp && value->cpp == "{}" ? *cpp + "{}" : made) + ";");
    return !hasMembers || WriteMembers(local, braces->Inside());
}

/// Writes a = 1, b = 2 of an object that was just made.
bool PortedStatement::WriteMembers(const PortValue& object, CSharpWords members)
{
    const PortValue value = object;
    for (const CSharpWords& member : SplitArguments(members))
    {
        if (member.size() < 3 || !member[1].Is("="))
        {
            return Fail("'new' with this in its braces");
        }
        const auto text = MemberAssignment(Place(), value, member, m_Problem);
        if (const PassMember* known = FindPassMember(member[0].text))
        {
            m_Code.Done({known->what, std::string(PlainTypeName(value.type)) + "." + known->name,
                         m_Model.Text(m_One, member.subspan(2)),
                         m_Model.Place(m_One, member[0].location), text.has_value()});
        }
        if (!text)
        {
            Todo(member);
        }
        else if (!text->empty())
        {
            m_Code.Line(*text + ";");
        }
    }
    return true;
}

bool PortedStatement::WriteAssignment(CSharpWords target, std::string_view word, CSharpWords value)
{
    if (target.size() > 1 && target.back().Is("?\?"))
    {
        return WriteIfNull(target.first(target.size() - 1), value);
    }
    if (target.empty() || value.empty())
    {
        return Fail("an assignment of this kind");
    }
    const auto name = target.back().text;
    const PassMember* member = FindPassMember(name);
    const bool isOfThis = target.size() == 3 && target[0].Is("this");
    const CSharpField* field = target.size() == 1 || isOfThis ? m_One.FindField(name) : nullptr;
    const CSharpClass* own = field ? m_Model.FindPlain(field->type) : nullptr;
    const bool isPass = own && m_Model.RoleOf(*own) == PortRole::Pass && word == "=";
    // new P() { renderPassEvent = X }
    const bool hasMembers = value.front().Is("new") && value.back().Is("}") && value.size() > 3;
    const Word braces = hasMembers ? &value.back() + value.back().match : nullptr;
    const CSharpWords members = braces && braces->Is("{") ? braces->Inside() : CSharpWords();
    const bool isMade = braces && (members.empty() || (members.size() > 2 && members[1].Is("=")));
    const CSharpWords object = isMade ? CSharpWords(value.data(), braces) : value;
    if (isPass && !m_Model.isDeclared(*field))
    {
        Value(object); // says why the pass cannot be made
    }
    auto text = TranslateAssignment(Place(), target, word, object, m_Problem);
    if (member)
    {
        const bool isOwn = target.size() < 3 || target[0].Is("this") || target[0].Is("base");
        const CSharpField* other = isOwn ? nullptr : m_One.FindField(target[0].text);
        m_Code.Done({member->what,
                     (isOwn   ? m_One.name
                      : other ? other->type
                              : "") +
                         "." + member->name,
                     m_Model.Text(m_One, value), m_Model.Place(m_One, target.front().location),
                     text.has_value()});
    }
    if (isPass)
    {
        m_Code.Done({"made", m_One.name + "." + field->name, m_Model.Text(m_One, value),
                     m_Model.Place(m_One, value.front().location), text.has_value()});
    }
    if (!text)
    {
        return false;
    }
    if (!text->empty())
    {
        m_Code.Line(*text + ";");
    }
    if (isPass)
    {
        m_Code.Make(m_Model.CppName(field->name));
    }
    if (isMade && !members.empty())
    {
        const auto whole = Value(target);
        return whole && WriteMembers(*whole, members);
    }
    return true;
}

/// Writes a ??= b.
bool PortedStatement::WriteIfNull(CSharpWords target, CSharpWords value)
{
    const auto object = Value(target);
    const auto isNull =
        object ? Combined(m_Model, *object, "==", {"{}", "null"}, m_Problem) : std::nullopt;
    if (!isNull)
    {
        return Fail("an assignment of this kind");
    }
    if (isNull->cpp == "false") // C++ always has the object
    {
        return true;
    }
    const std::size_t begin = m_Code.text.size();
    m_Code.Open("if (" + isNull->cpp + ")");
    const bool isGood = WriteAssignment(target, "=", value);
    m_Code.Close();
    m_Code.text.resize(isGood ? m_Code.text.size() : begin);
    return isGood;
}

std::optional<std::string> PortedStatement::ShiftText(CSharpWords words)
{
    const Word end = words.data() + words.size();
    const Word shift = FindOutsideOfBrackets(words.data(), end, {">=", "<="});
    const bool isShift = shift < end && shift > words.data() + 1 &&
                         shift[-1].text == shift->text.substr(0, 1); // > >=
    const auto target = isShift ? Value({words.data(), shift - 1}, "int") : std::nullopt;
    const auto bits = target && target->isVariable ? Value({shift + 1, end}, "int") : std::nullopt;
    return bits ? std::optional(target->cpp + " " + std::string(shift[-1].text) +
                                std::string(shift->text) + " " + bits->cpp)
                : std::nullopt;
}

/// Writes (a, b) = (b, a).
bool PortedStatement::WriteSwap(const std::vector<CSharpWords>& targets, CSharpWords values)
{
    const auto sources = values.front().Is("(") ? SplitArguments(values.front().Inside())
                                                : std::vector<CSharpWords>();
    if (targets.size() != 2 || sources.size() != 2)
    {
        return Fail("several values at once");
    }
    const auto first = Value(targets[0]);
    const auto second = Value(targets[1]);
    const auto left = Value(sources[0]);
    const auto right = Value(sources[1]);
    const bool isSwap = first && second && left && right && first->isVariable &&
                        first->cpp == right->cpp && second->cpp == left->cpp;
    if (!isSwap)
    {
        return Fail("several values at once");
    }
    m_Code.Line("std::swap(" + first->cpp + ", " + second->cpp + ");");
    return true;
}

/// Writes a?.b(c), which is a statement.
bool PortedStatement::WriteMaybe(CSharpWords words)
{
    const Word end = words.data() + words.size();
    const Word mark = FindOutsideOfBrackets(words.data(), end, {"?."});
    const auto object = mark < end ? Value({words.data(), mark}) : std::nullopt;
    if (!object || mark + 1 == end || !mark[1].isName())
    {
        return Fail("'?.' within an expression");
    }
    PortName name;
    name.name = mark[1].text;
    name.isCall = mark + 2 < end && mark[2].Is("(");
    name.arguments = name.isCall ? SplitArguments(mark[2].Inside()) : name.arguments;
    const bool isWhole = name.isCall && mark[2].Behind() == end;
    const auto call =
        isWhole ? PortMembers(Place(), m_Problem).MemberOf(*object, name) : std::nullopt;
    if (!call)
    {
        return Fail("'?.' of this");
    }
    const bool isPointer = object->isPointer || IsSharedType(m_Model, object->type);
    if (isPointer)
    {
        m_Code.Open("if (" + object->cpp + ")");
    }
    m_Code.Line(call->cpp + ";");
    if (isPointer)
    {
        m_Code.Close();
    }
    return true;
}

} // namespace limn
