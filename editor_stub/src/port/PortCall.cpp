#include "port/PortMember.h"
#include "port/PortedCode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Returns the type of a class's parameter, as it is called outside of the class.
std::string TypeIn(const PortModel& model, const CSharpClass& one, const CSharpParameter& parameter)
{
    const PortContext context(model, one);
    const CSharpClass* own = model.FindPlain(parameter.type);
    return Replaced(own ? model.QualifiedName(*own) : parameter.type, "::", ".");
}

/// Returns whether the argument must be a variable.
bool isMutableReference(const PortModel& model, const CSharpClass& one,
                        const CSharpParameter& parameter)
{
    const PortContext context(model, one);
    const auto type = model.CppParameter(parameter);
    return type && type->ends_with("&") && !type->starts_with("const ");
}

bool IsReferenceWord(const CSharpToken& word)
{
    return word.Is("ref") || word.Is("in") || word.Is("out");
}

/// Makes the value one that a pointer can be set to, or returns false.
bool PointTo(const PortModel& model, const PortValue& target, PortValue& value)
{
    const CSharpClass* own = model.Find(value.type);
    const bool isSame = value.type == target.type || (own && own == model.Find(target.type));
    if (value.type == "null")
    {
        value.cpp = "nullptr";
    }
    const bool isKept = isSame && (value.isPointer || (value.isVariable && !value.isLocal));
    if (isKept && !value.isPointer)
    {
        value.cpp = "&" + value.Text(90);
    }
    return value.type == "null" || isKept;
}

} // namespace

std::optional<std::string> AssignmentTo(const PortPlace& place, const PortValue& target,
                                        std::string_view word, CSharpWords assigned,
                                        std::string& problem)
{
    const std::string type = word == "=" && !target.isPointer ? target.type : "";
    const bool isBare = target.isPointer && assigned.size() > 1 && assigned[0].Is("new") &&
                        assigned[1].Is("(") &&
                        assigned[1].Inside().data() + assigned[1].match == &assigned.back() + 1;
    auto value = isBare ? PortMembers(place, problem)
                              .Construct(target.type, SplitArguments(assigned[1].Inside()))
                        : Translate(place, assigned, type, &problem);
    if (value && word != "=" && target.type == "float")
    {
        value = Converted(place.model, *value, "float");
    }
    const bool isGood = value && value->type != "void";
    if (isGood && target.isPointer && !target.own.empty() && !value->isPointer &&
        !value->isVariable && value->type != "null")
    {
        return target.cpp + " = &(" + target.own + " = " + value->cpp + ")";
    }
    if (isGood && target.isPointer && !PointTo(place.model, target, *value))
    {
        problem = "an object of its own where another's is kept";
        return std::nullopt;
    }
    const CSharpClass* own = place.model.Find(target.type);
    const bool isShared = own && own->keyword == "class" && !target.isPointer && !target.isLocal &&
                          isGood && value->isVariable;
    if (isShared)
    {
        problem = "C# keeps the same object here, and C++ would keep a copy";
        return std::nullopt;
    }
    if (isGood && word == "%=" && target.type == "float")
    {
        return target.cpp + " = std::fmod(" + target.cpp + ", " + value->cpp + ")";
    }
    return isGood ? std::optional(target.cpp + " " + std::string(word) + " " + value->cpp)
                  : std::nullopt;
}

std::optional<std::string> MemberAssignment(const PortPlace& place, const PortValue& object,
                                            CSharpWords words, std::string& problem)
{
    if (words.size() < 3 || !words[1].Is("="))
    {
        problem = "'new' with this in its braces";
        return std::nullopt;
    }
    const PortName name{std::string(words[0].text), "", false, {}, true};
    std::string unknown;
    const PortMembers members(place, unknown);
    const auto setter = members.Setter(object, name, words.subspan(2));
    const auto found = setter ? std::nullopt : members.MemberOf(object, name);
    if (setter)
    {
        return *setter == "-" ? "" : *setter;
    }
    if (found && found->isVariable)
    {
        return AssignmentTo(place, *found, "=", words.subspan(2), problem);
    }
    unknown = unknown.empty() ? "'" + name.name + "' is no variable in C++" : unknown;
    problem = problem.empty() ? unknown : problem;
    return std::nullopt;
}

std::optional<PortValue> MadeWith(const PortPlace& place, const PortValue& made,
                                  CSharpWords members, std::string& problem)
{
    PortValue object{"made", made.type};
    object.isVariable = object.isLocal = true;
    std::string text;
    for (const CSharpWords& member : SplitArguments(members))
    {
        const auto assigned = MemberAssignment(place, object, member, problem);
        if (!assigned)
        {
            return std::nullopt;
        }
        text += assigned->empty() ? "" : " " + *assigned + ";";
    }
    if (text.find("auto made = ") != std::string::npos)
    {
        problem = "'new' with members within another";
        return std::nullopt;
    }
    return PortValue{"[&] { auto made = " + made.cpp + ";" + text + " return made; }()", made.type};
}

std::optional<std::string> PortArgument(const PortPlace& place, const CSharpClass& owner,
                                        const CSharpParameter& parameter, CSharpWords words,
                                        std::string& problem)
{
    words = !words.empty() && IsReferenceWord(words[0]) ? words.subspan(1) : words;
    const bool isDeclared = words.size() > 1 && words.back().isName() &&
                            (words[words.size() - 2].isName() || words[words.size() - 2].Is(">") ||
                             words[words.size() - 2].Is("]"));
    words = isDeclared ? words.last(1) : words; // out T name
    const auto value = Translate(place, words, TypeIn(place.model, owner, parameter), &problem);
    const bool isFit =
        value && (value->isVariable || !isMutableReference(place.model, owner, parameter) ||
                  value->cpp.starts_with("*"));
    return isFit ? std::optional(value->cpp) : std::nullopt;
}

std::optional<std::string> MakePass(const PortPlace& place, const CSharpClass& pass,
                                    const std::vector<CSharpWords>& arguments, std::string& problem)
{
    const PortModel& model = place.model;
    const auto fits = [&](const CSharpMethod& method)
    {
        return method.isConstructor() && !method.isStatic && method.Takes(arguments.size()) &&
               SignatureOf(model, pass, method);
    };
    const auto constructor = std::ranges::find_if(pass.methods, fits);
    const bool hasNone = std::ranges::none_of(pass.methods, &CSharpMethod::isConstructor);
    if (model.isLeftOut(pass) ||
        (constructor == pass.methods.end() && !(hasNone && arguments.empty())))
    {
        return std::nullopt;
    }
    std::string text = "std::make_unique<" + model.QualifiedName(pass) + ">(";
    const std::size_t count =
        constructor == pass.methods.end() ? 0 : constructor->parameters.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        const CSharpParameter& parameter = constructor->parameters[i];
        const auto argument = PortArgument(
            place, pass, parameter, i < arguments.size() ? arguments[i] : parameter.value, problem);
        if (!argument)
        {
            return std::nullopt;
        }
        text += (i == 0 ? "" : ", ") + *argument;
    }
    return text + ")";
}

} // namespace limn
