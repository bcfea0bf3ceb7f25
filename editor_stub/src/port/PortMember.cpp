#include "port/PortMember.h"

#include "port/PortOperator.h"
#include "port/PortedCode.h"

#include <algorithm>
#include <map>

namespace limn
{

namespace
{

/// Returns the object with what its members stand behind: "a." or "a->".
std::string AccessOf(const PortModel& model, const PortValue& value)
{
    const bool isArrow = value.isPointer || IsSharedType(model, value.type);
    return value.isType ? value.cpp + "::" : value.Text(90) + (isArrow ? "->" : ".");
}

std::string InBrackets(const std::string& generics)
{
    return generics.size() < 3 ? "" : generics.substr(1, generics.size() - 2);
}

} // namespace

std::optional<PortValue> PortMembers::Fail(const std::string& problem) const
{
    if (m_Problem.empty())
    {
        m_Problem = problem;
    }
    return std::nullopt;
}

std::optional<PortValue> PortMembers::Find(const PortName& name) const
{
    const auto found = m_Place.scope.find(name.name);
    if (found != m_Place.scope.end() && !name.isCall && !name.isOfThis)
    {
        return found->second;
    }
    for (const CSharpClass* one = model().context(); one; one = one->outer)
    {
        const bool isInner = one == model().context();
        if (const CSharpField* field = one->FindField(name.name))
        {
            return isInner || field->isStatic ? OwnField(isInner ? "" : "::", *one, *field, true)
                                              : Fail("'" + name.name + "' is of another object");
        }
        if (const CSharpMethod* method = one->FindMethod(name.name);
            method && (name.isCall || method->isProperty))
        {
            return isInner            ? OwnCall("", *one, name)
                   : method->isStatic ? OwnCall(model().QualifiedName(*one) + "::", *one, name)
                                      : Fail("'" + name.name + "' is of another object");
        }
        const Result inherited = isInner && m_Place.isBody ? BaseMember(name, false) : std::nullopt;
        if (inherited)
        {
            return inherited;
        }
    }
    if (const CSharpClass* own = model().Find(name.name))
    {
        PortValue type{model().QualifiedName(*own), name.name};
        type.isType = true;
        return type;
    }
    if (!name.isCall && model().table().HasType(name.name))
    {
        PortValue type{name.name, name.name};
        type.isType = true;
        return type;
    }
    return Fail("'" + name.name + "' is not known");
}

std::optional<PortValue> PortMembers::BaseMember(const PortName& name, bool isExplicit) const
{
    const CSharpClass* one = model().context();
    const std::string base = one ? BaseTypeOf(model().RoleOf(*one)) : "";
    if (base.empty() || model().table().OwnerOf(base, name.name, true).empty())
    {
        return std::nullopt;
    }
    PortValue self{"*this", base};
    self.isVariable = true;
    return UnityMember(self, isExplicit ? base + "::" : "", name);
}

std::optional<PortValue> PortMembers::MemberOf(const PortValue& value, const PortName& name) const
{
    const CSharpClass* own = model().Find(value.type);
    if (own)
    {
        Result member = OwnMember(value, *own, name);
        if (member)
        {
            member->isLocal = value.isLocal && !value.isPointer && !member->isPointer;
        }
        return member;
    }
    if (value.type.empty())
    {
        return Fail("the type of what has the member '" + name.name + "' is not known");
    }
    if (!ElementTypeOf(value.type).empty() && !value.isType)
    {
        return ListMember(value, name);
    }
    if (PlainTypeName(value.type).ends_with("Parameter") &&
        IsIn(name.name, {"value", "overrideState"}))
    {
        return ParameterMember(value, name);
    }
    return UnityMember(value, AccessOf(model(), value), name);
}

std::optional<PortValue> PortMembers::OwnMember(const PortValue& value, const CSharpClass& own,
                                                const PortName& name) const
{
    const PortRole role = model().RoleOf(own);
    if (role == PortRole::Parameter)
    {
        return ParameterMember(value, name);
    }
    if (value.isType && own.enumeratorNames.contains(name.name))
    {
        const auto cpp = model().CppType(value.type);
        return cpp ? Result(PortValue{*cpp + "::" + model().CppName(name.name), own.name})
                   : Fail("'" + value.type + "' stands further below");
    }
    if (value.isType && own.classNames.contains(name.name))
    {
        PortValue type{value.cpp + "::" + name.name, value.type + "." + name.name};
        type.isType = true;
        return type;
    }
    if (const CSharpField* field = own.FindField(name.name); field && !name.isCall)
    {
        // Volumes set what a component holds; those who read it do not change it.
        const bool isOfStack = role == PortRole::Component && model().context() != &own;
        return OwnField(AccessOf(model(), value), own, *field,
                        (value.isVariable || value.isPointer) && !isOfStack);
    }
    if (const CSharpMethod* method = own.FindMethod(name.name);
        method && (name.isCall || method->isProperty))
    {
        return OwnCall(AccessOf(model(), value), own, name);
    }
    for (const std::string& base : own.bases)
    {
        const CSharpClass* outer = model().Find(base);
        if (outer && outer != &own && (outer->FindField(name.name) || outer->FindMethod(name.name)))
        {
            return OwnMember(value, *outer, name);
        }
    }
    const std::string base = BaseTypeOf(role);
    return base.empty() ? Fail("'" + own.name + "." + name.name + "' is not known")
                        : UnityMember({value.cpp, base, false, true, value.isPointer},
                                      AccessOf(model(), value), name);
}

/// Returns a type of the class of the PortContext as it is called outside of that class.
std::string PortMembers::TypeFromOutside(const std::string& type) const
{
    const CSharpClass* own = model().FindPlain(type);
    return own ? Replaced(model().QualifiedName(*own), "::", ".") : type;
}

std::optional<PortValue> PortMembers::OwnField(const std::string& access, const CSharpClass& own,
                                               const CSharpField& field, bool isVariable) const
{
    if (!model().isDeclared(field))
    {
        return Fail("'" + own.name + "." + field.name + "' is no C++");
    }
    PortValue value;
    {
        const PortContext context(model(), own);
        value = VariableOf(model(), own, field);
        value.type = TypeFromOutside(field.type);
    }
    value.cpp = (field.isStatic && !access.empty() ? model().QualifiedName(own) + "::" : access) +
                value.cpp;
    value.own = value.own.empty() ? "" : access + value.own;
    value.isVariable = isVariable && !field.isConst;
    return value;
}

std::optional<PortValue> PortMembers::OwnCall(const std::string& access, const CSharpClass& own,
                                              const PortName& name) const
{
    if (!m_Place.isBody)
    {
        return Fail("a call outside of a method");
    }
    for (const CSharpMethod& method : own.methods)
    {
        const auto& parameters = method.parameters;
        const std::size_t given = name.arguments.size();
        if (method.name != name.name || !method.Takes(given) || !IsCallable(model(), own, method))
        {
            continue;
        }
        const bool isOfStack =
            model().RoleOf(own) == PortRole::Component && model().context() != &own;
        if (isOfStack && !method.isStatic && !IsConst(model(), own, method))
        {
            return Fail("'" + name.name + "' changes the component, which nobody may");
        }
        const auto signature = SignatureOf(model(), own, method);
        std::string text;
        bool isGood = signature.has_value();
        for (std::size_t i = 0; i < parameters.size() && isGood; ++i)
        {
            const auto argument =
                PortArgument(m_Place, own, parameters[i],
                             i < given ? name.arguments[i] : parameters[i].value, m_Problem);
            isGood = argument.has_value();
            text += isGood ? (i == 0 ? "" : ", ") + *argument : "";
        }
        if (isGood)
        {
            const PortContext context(model(), own);
            return PortValue{access + signature->name + "(" + text + ")",
                             TypeFromOutside(method.type)};
        }
    }
    return Fail("the method '" + own.name + "." + name.name + "' is no C++");
}

std::optional<PortValue> PortMembers::ListMember(const PortValue& value, const PortName& name) const
{
    const std::string access = AccessOf(model(), value);
    const std::string element = ElementTypeOf(value.type);
    const auto list = model().CppType(value.type);
    if (IsIn(name.name, {"Length", "Count"}))
    {
        return PortValue{"static_cast<int>(" + access + "size())", "int"};
    }
    if (IsIn(name.name, {"Clear", "ToArray", "ToList"}) && name.isCall && name.arguments.empty())
    {
        return name.name == "Clear" ? PortValue{access + "clear()", "void"}
                                    : PortValue{value.Object(), element + "[]"};
    }
    const CSharpClass* own = model().Find(element);
    const bool isComparable = !own || model().RoleOf(*own) == PortRole::Enum;
    if ((name.name == "Add" || (name.name == "Contains" && isComparable)) &&
        name.arguments.size() == 1)
    {
        const auto item = Translate(m_Place, name.arguments[0], element, &m_Problem);
        if (!item || name.name == "Add")
        {
            return item ? Result(PortValue{access + "push_back(" + item->cpp + ")", "void"}) : item;
        }
        PortValue found{"std::ranges::count(" + value.Object() + ", " + item->cpp + ") > 0",
                        "bool"};
        found.strength = Strength(">");
        return found;
    }
    if (name.name == "RemoveAt" && name.arguments.size() == 1)
    {
        const auto at = Translate(m_Place, name.arguments[0], "int", &m_Problem);
        return at ? Result(PortValue{access + "erase(" + access + "begin() + " + at->Text(9) + ")",
                                     "void"})
                  : at;
    }
    return Fail("limn has no '" + value.type + "." + name.name + "' on one line");
}

std::optional<PortValue> PortMembers::ParameterMember(const PortValue& value,
                                                      const PortName& name) const
{
    if (name.name == "overrideState")
    {
        return PortValue{AccessOf(model(), value) + "overrideState()", "bool"};
    }
    if (name.name != "value" || name.isCall)
    {
        return Fail("limn has no '" + value.type + "." + name.name + "'");
    }
    const std::string named = ParameterValueType(std::string(PlainTypeName(value.type)));
    const std::string type = named.empty() ? model().HeldType(value.type) : named;
    return PortValue{AccessOf(model(), value) + (type == "Texture" ? "value().asset" : "value()"),
                     type};
}

std::optional<PortValue> PortMembers::UnityMember(const PortValue& value, const std::string& access,
                                                  const PortName& name) const
{
    const std::string plain(PlainTypeName(value.type));
    const std::string owner = model().table().OwnerOf(plain, name.name, false);
    const PortEntry* entry = owner.empty() ? nullptr : model().table().Find(owner, name.name);
    const std::string full = plain + "." + name.name;
    if (!entry)
    {
        return Fail("'" + full + "' is not known");
    }
    const bool isSame = entry->verdict == PortVerdict::Same;
    if (!isSame && entry->cpp.empty())
    {
        return Fail(entry->verdict == PortVerdict::Differs
                        ? "'" + full + "' differs: " + entry->words
                        : "limn has no '" + full + "'" +
                              (entry->words.empty() ? "" : ": " + entry->words));
    }
    auto arguments = ArgumentsOf(owner, name);
    const auto generics = TypeArguments(name.generics);
    if (!arguments || !generics)
    {
        return std::nullopt;
    }
    for (Argument& argument : *arguments)
    {
        // No properties and no material are no pointers in C++.
        argument.text =
            argument.text == "nullptr" && name.name.starts_with("Draw") ? "{}" : argument.text;
    }
    const std::string special = model().table().CodeFor(owner + "." + name.name, arguments->size());
    const std::string& code = special.empty() ? entry->cpp : special;
    const bool isConstant = isSame || code == "FilteringSettings()" ||
                            full == "Shader.PropertyToID" ||
                            StartsWithAny(code, {"glm::", "std::numeric_limits<", "\""});
    if (!m_Place.isBody && (!isConstant || (name.isCall && full != "Shader.PropertyToID")))
    {
        return Fail("a call outside of a method");
    }
    if (code == "-" && name.isCall)
    {
        return PortValue{"", "void"};
    }
    const bool isDefault = code.empty() || code == "=";
    const auto cpp = FillIn(!isDefault    ? code
                            : name.isCall ? "@%($*)"
                                          : "@%",
                            value, access, name.name + *generics, *arguments);
    if (!cpp)
    {
        return std::nullopt;
    }
    PortValue result{*cpp, entry->result == "T" ? InBrackets(name.generics) : entry->result};
    if (result.type == "N")
    {
        const auto isFloat = [](const Argument& one)
        {
            return one.value.type == "float";
        };
        result.type = std::ranges::any_of(*arguments, isFloat) ? "float"
                      : arguments->empty()                     ? ""
                                                               : arguments->front().value.type;
    }
    const bool isEnumerator = value.isType && !name.isCall && result.type.empty() && isSame;
    result.type = isEnumerator ? plain : result.type;
    result.isPointer = entry->isPointer;
    result.isType = value.isType && !name.isCall && entry->result == full; // one within another
    const bool isPart = code.starts_with("$&[");                           // of a matrix
    result.isVariable =
        (!name.isCall && (isDefault || isPart) && (value.isVariable || value.isPointer)) ||
        IsReferenceType(model(), result.type);
    return result;
}

std::optional<std::string> PortMembers::TypeArguments(const std::string& generics) const
{
    const std::string type = InBrackets(generics);
    if (type.empty())
    {
        return "";
    }
    const CSharpClass* own = model().Find(type);
    const bool isKnown = own ? model().isDeclared(*own) : model().table().HasType(type);
    if (!isKnown)
    {
        Fail("the type '" + type + "' is not known");
        return std::nullopt;
    }
    return "<" + (own ? model().QualifiedName(*own) : type) + ">";
}

std::optional<std::string> PortMembers::FillIn(std::string_view code, const PortValue& value,
                                               const std::string& access, const std::string& name,
                                               const std::vector<Argument>& arguments) const
{
    if (code == "!")
    {
        Fail("limn has no '" + name + "' with these arguments");
        return std::nullopt;
    }
    std::string text;
    for (std::size_t i = 0; i < code.size(); ++i)
    {
        const char next = i + 1 < code.size() ? code[i + 1] : '\0';
        if (code[i] != '$')
        {
            text += code[i] == '@' ? access : code[i] == '%' ? name : std::string(1, code[i]);
            continue;
        }
        const bool isRaw = next == 'p';
        const std::size_t at = i + (isRaw ? 2 : 1);
        const std::size_t number =
            code[at] >= '1' && code[at] <= '9' ? static_cast<std::size_t>(code[at] - '1') : 9;
        i = at;
        if (next == '&' || next == '*')
        {
            text += next == '&' ? value.Object() : ListText(arguments, next);
            continue;
        }
        if (next == 'v' || next == 'i' || next == 'f' || next == 'F')
        {
            text += ListText(arguments, next);
            ++i;
            continue;
        }
        if (number >= arguments.size())
        {
            Fail("'" + name + "' with " + std::to_string(arguments.size()) + " arguments");
            return std::nullopt;
        }
        const Argument& argument = arguments[number];
        std::string type;
        if (at + 1 < code.size() && code[at + 1] == ':' && at + 2 < code.size() &&
            code[at + 2] != ':')
        {
            const std::size_t end = std::min(code.find_first_of(",)", at), code.size());
            type = code.substr(at + 2, end - at - 2);
            i = end - 1;
        }
        const auto converted =
            type.empty() ? Result(argument.value) : Converted(model(), argument.value, type);
        if (!converted)
        {
            Fail("argument " + std::to_string(number + 1) + " of '" + name + "' is no " + type);
            return std::nullopt;
        }
        text += !type.empty() ? converted->cpp : isRaw ? argument.value.cpp : argument.text;
    }
    return text;
}

std::optional<PortValue> PortMembers::Element(const PortValue& value, CSharpWords index) const
{
    const std::string element = ElementTypeOf(value.type);
    const auto places = SplitArguments(index);
    if (value.type == "Matrix4x4" && places.size() == 2) // [row, column]
    {
        const auto row = Translate(m_Place, places[0], "int", &m_Problem);
        const auto column = Translate(m_Place, places[1], "int", &m_Problem);
        return row && column
                   ? Result(PortValue{value.Text(90) + "[" + column->cpp + "][" + row->cpp + "]",
                                      "float", false, value.isVariable})
                   : std::nullopt;
    }
    const auto at = Translate(m_Place, index, "int", &m_Problem);
    if (at && IsIn(value.type, {"Vector2", "Vector3", "Vector4"}))
    {
        return PortValue{value.Text(90) + "[" + at->cpp + "]", "float", false, value.isVariable};
    }
    if (element.empty() || !at || value.isPointer)
    {
        return Fail("'" + value.type + "' with []");
    }
    // C# looks whether there is such an element.
    PortValue result{value.Text(90) + ".at(" +
                         (at->isLiteral ? at->cpp : "static_cast<std::size_t>(" + at->cpp + ")") +
                         ")",
                     element};
    result.isVariable = true;
    return result;
}

std::optional<PortValue> PortMembers::Construct(const std::string& type,
                                                const std::vector<CSharpWords>& words) const
{
    const CSharpClass* own = model().Find(type);
    const auto cpp = model().CppType(type);
    if (own && model().RoleOf(*own) == PortRole::Pass && m_Place.isBody)
    {
        const auto making = MakePass(m_Place, *own, words, m_Problem);
        PortValue value{making.value_or(""), type};
        value.isPointer = true;
        return making ? Result(value) : Fail("no constructor of '" + type + "' takes these");
    }
    const std::string code = own ? "" : model().table().CodeFor("new:" + type, words.size());
    if (!code.empty() && !words.empty() &&
        (m_Place.isBody || IsIn(type, {"RenderTargetIdentifier", "FilteringSettings", "Vector2Int",
                                       "Vector3Int", "RenderStateBlock", "DepthState", "BlendState",
                                       "RasterState", "RenderQueueRange"})))
    {
        const auto arguments = Arguments("new:" + type, words);
        if (arguments && type == "RenderTargetIdentifier" && (*arguments)[0].value.type == "int")
        {
            return Fail("a property's number that is an 'int'");
        }
        const std::string whole = // some arguments may have been left out
            arguments ? model().table().CodeFor("new:" + type, arguments->size()) : "";
        const auto text = arguments
                              ? FillIn(whole == "=" ? "%($*)" : whole, {}, "", type, *arguments)
                              : std::nullopt;
        return text ? Result(PortValue{*text, type}) : std::nullopt;
    }
    if (code == "!" || (type == "RenderTargetIdentifier" && !words.empty()))
    {
        return Fail("limn has no 'new " + type + "' with these arguments");
    }
    if (type == "CommandBuffer" && words.empty() && m_Place.isBody)
    {
        return PortValue{"CommandBuffer()", type};
    }
    const bool isPlain = cpp && words.empty() && !IsSharedType(model(), type);
    return isPlain && type != "ProfilingSampler"
               ? Result(PortValue{*cpp + PortModel::CppDefault(*cpp), type})
               : Fail("'new " + type + "' is not known");
}

std::optional<std::string> PortMembers::Setter(const PortValue& value, const PortName& name,
                                               CSharpWords assigned) const
{
    const CSharpClass* own = value.cpp.empty() ? model().context() : model().Find(value.type);
    const PortName call{"Set" + name.name, "", true, {assigned}};
    const CSharpMethod* setter = own ? own->FindMethod(call.name) : nullptr;
    if (setter && setter->isSetter)
    {
        const auto text = OwnCall(value.cpp.empty() ? "" : AccessOf(model(), value), *own, call);
        return text ? std::optional(text->cpp) : std::nullopt;
    }
    const bool isParameter = PlainTypeName(value.type).ends_with("Parameter") ||
                             (model().Find(value.type) &&
                              model().RoleOf(*model().Find(value.type)) == PortRole::Parameter);
    const std::string owner = model().table().OwnerOf(PlainTypeName(value.type), name.name, true);
    const PortEntry* entry = owner.empty() ? nullptr : model().table().Find(owner, name.name);
    const std::string code = isParameter && name.name == "value" ? "@SetValue($1)"
                             : entry                             ? entry->cppSet
                                                                 : "";
    if (isParameter && !value.isVariable)
    {
        Fail("a volume's parameter is not changed by those who read it");
        return std::nullopt;
    }
    const auto arguments = code.empty() ? std::nullopt : Arguments("", {assigned});
    return arguments ? FillIn(code, value, AccessOf(model(), value), name.name, *arguments)
                     : std::nullopt;
}

} // namespace limn
