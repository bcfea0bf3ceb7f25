#include "port/PortMember.h"

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

/// Returns the object itself.
std::string ObjectText(const PortValue& value)
{
    return value.isPointer ? "*" + value.Text(90) : value.cpp;
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
        return OwnField(AccessOf(model(), value), own, *field, value.isVariable || value.isPointer);
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
                                    : PortValue{ObjectText(value), element + "[]"};
    }
    if (name.name == "Add" && name.arguments.size() == 1)
    {
        const auto item = Translate(m_Place, name.arguments[0], element, &m_Problem);
        return item ? Result(PortValue{access + "push_back(" + item->cpp + ")", "void"}) : item;
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
                            StartsWithAny(code, {"glm::", "std::numeric_limits<"});
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
    const bool isEnumerator = value.isType && !name.isCall && result.type.empty() && isSame;
    result.type = isEnumerator ? plain : result.type;
    result.isPointer = entry->isPointer;
    result.isVariable = (!name.isCall && isDefault && (value.isVariable || value.isPointer)) ||
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

std::optional<PortMembers::Argument> PortMembers::OneArgument(CSharpWords words) const
{
    const bool isReference = !words.empty() && IsIn(words[0].text, {"ref", "in", "out"});
    words = words.subspan(isReference ? 1 : 0);
    const bool isDeclared =
        isReference && words.size() == 2 && words[0].isName() && words[1].isName(); // out uint x
    words = words.subspan(isDeclared ? 1 : 0);
    const auto value = Translate(m_Place, words, "", &m_Problem);
    if (!value || value->isType || value->type == "void")
    {
        return std::nullopt;
    }
    const bool isList = value->cpp.starts_with("{") && !ElementTypeOf(value->type).empty();
    const auto list = isList ? model().CppType(value->type) : std::nullopt;
    return Argument{*value,
                    value->type == "null" ? "nullptr" : list.value_or("") + ObjectText(*value)};
}

std::optional<std::vector<PortMembers::Argument>>
PortMembers::Arguments(const std::vector<CSharpWords>& words) const
{
    std::vector<Argument> arguments;
    for (CSharpWords one : words)
    {
        const bool isNamed = one.size() > 2 && one[0].isName() && one[1].Is(":");
        // These stand where the C++ has them, too, if they are the last ones.
        const bool isLast = arguments.size() + 1 == words.size();
        const bool isPassName = isNamed && one[0].Is("passName");
        if (isNamed && isLast &&
            (IsIn(one[0].text, {"pass", "passIndex", "flags", "index"}) || isPassName))
        {
            if (isPassName && words.size() == 5) // behind a scale and an offset
            {
                const std::string filter = "RenderGraphUtils::BlitFilterMode::ClampBilinear";
                arguments.push_back({{filter, ""}, filter});
            }
            one = one.subspan(2);
        }
        else if (isNamed)
        {
            Fail("the named argument '" + std::string(one[0].text) + "'");
            return std::nullopt;
        }
        const auto argument = OneArgument(one);
        if (!argument)
        {
            return std::nullopt;
        }
        arguments.push_back(*argument);
    }
    return arguments;
}

/// Returns the arguments of ReAllocateIfNeeded: those behind the first two become members of
/// ReAllocateArguments.
std::optional<std::vector<PortMembers::Argument>>
PortMembers::NamedArguments(const std::vector<CSharpWords>& words) const
{
    static const std::vector<std::string> names{"filterMode", "wrapMode",   "isShadowMap",
                                                "anisoLevel", "mipMapBias", "name"};
    std::vector<Argument> arguments;
    std::size_t first = 2; // behind the handle and the descriptor
    std::map<std::size_t, std::string> members;
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        const bool isNamed = words[i].size() > 2 && words[i][0].isName() && words[i][1].Is(":");
        const auto argument = OneArgument(isNamed ? words[i].subspan(2) : words[i]);
        if (!argument)
        {
            return std::nullopt;
        }
        const auto name = isNamed ? std::ranges::find(names, words[i][0].text) : names.end();
        const auto place = isNamed ? static_cast<std::size_t>(name - names.begin()) : i - first;
        first = i == 1 && argument->value.type == "Vector2" ? 3 : first; // a scale before it
        if (!isNamed && i < first)
        {
            arguments.push_back(*argument);
        }
        else if (place < names.size())
        {
            members[place] = "." + names[place] + " = " + argument->text;
        }
        else
        {
            Fail("the named argument '" + std::string(words[i][0].text) + "'");
            return std::nullopt;
        }
    }
    std::string list;
    for (const auto& [place, text] : members)
    {
        list += (list.empty() ? "{" : ", ") + text;
    }
    arguments.push_back({{list + "}", ""}, list + "}"});
    return arguments;
}

std::optional<std::vector<PortMembers::Argument>>
PortMembers::ArgumentsOf(const std::string& owner, const PortName& name) const
{
    const auto isNamed = [](const CSharpWords& words)
    {
        return words.size() > 2 && words[0].isName() && words[1].Is(":");
    };
    const bool hasNamed = std::ranges::any_of(name.arguments, isNamed);
    const bool isAgain = owner == "RenderingUtils" && name.name.starts_with("ReAllocate");
    const auto handle =
        isAgain && !name.arguments.empty() ? OneArgument(name.arguments[0]) : std::nullopt;
    if (isAgain && (!handle || handle->value.type != "RTHandle"))
    {
        Fail("a target that is no RTHandle");
        return std::nullopt;
    }
    if (hasNamed && isAgain)
    {
        return NamedArguments(name.arguments);
    }
    std::vector<CSharpWords> words = name.arguments;
    const bool isAlloc = owner == "RTHandles" && name.name == "Alloc" && words.size() == 2;
    CSharpWords title = isAlloc ? words.back() : CSharpWords();
    if (isAlloc)
    {
        title = isNamed(title) && title[0].Is("name") ? title.subspan(2) : title;
        words.pop_back(); // what an identifier stands for is called by its own name
    }
    auto arguments = Arguments(words);
    if (arguments && isAlloc && (*arguments)[0].value.type == "RenderTextureDescriptor")
    {
        const auto called = OneArgument(title);
        return called ? std::optional(std::vector<Argument>{
                            (*arguments)[0],
                            {{"FilterMode::Point", ""}, "FilterMode::Point"},
                            {{"TextureWrapMode::Repeat", ""}, "TextureWrapMode::Repeat"},
                            *called})
                      : std::nullopt;
    }
    const auto property = PropertyArgument(owner, name.name, arguments ? arguments->size() : 0);
    if (arguments && property && *property < arguments->size() &&
        (*arguments)[*property].value.type == "int")
    {
        Fail("a property's number that is an 'int'");
        return std::nullopt;
    }
    const std::size_t textures = name.name == "Blit" ? 3 : name.name == "SetRenderTarget" ? 2 : 0;
    for (std::size_t i = 0; arguments && i < std::min(textures, arguments->size()); ++i)
    {
        if ((*arguments)[i].value.type == "int")
        {
            Fail("a texture's number that is an 'int'");
            return std::nullopt;
        }
    }
    const auto isObject = [&](const Argument& argument)
    {
        return IsSharedType(model(), argument.value.type) || argument.value.isPointer;
    };
    if (arguments && owner == "Debug" && name.name.ends_with("Format") &&
        std::ranges::any_of(*arguments, isObject))
    {
        Fail("an object in a text");
        return std::nullopt;
    }
    const bool isKeyword = arguments && owner == "CoreUtils" && name.name == "SetKeyword";
    if (isKeyword && (*arguments)[0].value.type == "Material")
    {
        (*arguments)[0].text = "*" + (*arguments)[0].text;
    }
    else if (isKeyword && (*arguments)[0].value.type != "CommandBuffer")
    {
        Fail("a keyword of something that is neither a material nor global");
        return std::nullopt;
    }
    return arguments;
}

/// @param kind  of the list: 'v', 'i', 'f' or '*'
std::string PortMembers::ListText(const std::vector<Argument>& arguments, char kind) const
{
    const bool hasFloat = std::ranges::any_of(arguments, [](const Argument& one)
                                              { return one.value.type == "float"; });
    std::string text;
    for (const Argument& argument : arguments)
    {
        const std::string& type = argument.value.type;
        const bool isWhole = kind == 'f' && hasFloat && type == "int";
        const bool isShort = kind == 'v' && (type == "Vector2" || type == "Vector3");
        const bool isTexture = kind == 'i' && IsIn(type, {"Texture", "Texture2D", "RenderTexture"});
        const bool isHandle = kind == 'i' && type == "TextureHandle";
        const std::string one = isWhole     ? Converted(model(), argument.value, "float")->cpp
                                : isHandle  ? "RTHandle(" + argument.text + ")"
                                : isShort   ? Converted(model(), argument.value, "Vector4")->cpp
                                : isTexture ? "RenderTargetIdentifier(" + argument.text + ")"
                                            : argument.text;
        text += (text.empty() ? "" : ", ") + one;
    }
    return text;
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
            text += next == '&' ? ObjectText(value) : ListText(arguments, next);
            continue;
        }
        if (next == 'v' || next == 'i' || next == 'f')
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
    const auto at = Translate(m_Place, index, "int", &m_Problem);
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
        (m_Place.isBody ||
         IsIn(type, {"RenderTargetIdentifier", "FilteringSettings", "Vector2Int", "Vector3Int"})))
    {
        const auto arguments = Arguments(words);
        if (arguments && type == "RenderTargetIdentifier" && (*arguments)[0].value.type == "int")
        {
            return Fail("a property's number that is an 'int'");
        }
        const auto text = arguments ? FillIn(code == "=" ? "%($*)" : code, {}, "", type, *arguments)
                                    : std::nullopt;
        return text ? Result(PortValue{*text, type}) : std::nullopt;
    }
    if (code == "!" || (type == "RenderTargetIdentifier" && !words.empty()))
    {
        return Fail("limn has no 'new " + type + "' with these arguments");
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
    const auto arguments =
        code.empty() ? std::nullopt : Arguments(std::vector<CSharpWords>{assigned});
    return arguments ? FillIn(code, value, AccessOf(model(), value), name.name, *arguments)
                     : std::nullopt;
}

} // namespace limn
