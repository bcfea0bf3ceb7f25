#include "port/PortLiteral.h"
#include "port/PortMember.h"
#include "port/PortedBody.h"

#include <algorithm>

namespace limn
{

namespace
{

/// A parameter of URP's that limn has with the same constructor.
bool IsShippedParameter(const PortModel& model, std::string_view type)
{
    const PortEntry* entry = model.table().Find(type);
    return entry && type.ends_with("Parameter") && type != "VolumeParameter" &&
           !type.starts_with("Animation") && !type.starts_with("Object") &&
           !type.starts_with("TextureCurve") && !type.starts_with("Enum") &&
           !type.starts_with("Material");
}

/// An argument of a parameter's constructor in C#.
struct ParameterArgument
{
    std::string name;
    std::string type;
};

/// Returns the arguments of a parameter's constructor, in their order.
std::vector<ParameterArgument> ArgumentsOf(const std::string& type)
{
    const std::string named = ParameterValueType(type);
    const std::string value = named.empty() ? "float" : named;
    const auto has = [&](const char* part)
    {
        return type.find(part) != std::string::npos;
    };
    std::vector<ParameterArgument> arguments{{"value", value}};
    const std::string limit = value == "Vector2" ? "float" : value;
    if (has("Clamped") || has("FloatRange"))
    {
        arguments.insert(arguments.end(), {{"min", limit}, {"max", limit}});
    }
    else if (has("Min") || has("Max"))
    {
        arguments.push_back({has("Min") ? "min" : "max", limit});
    }
    if (value == "Color")
    {
        arguments.insert(arguments.end(),
                         {{"hdr", "bool"}, {"showAlpha", "bool"}, {"showEyeDropper", "bool"}});
    }
    arguments.push_back({"overrideState", "bool"});
    return arguments;
}

/// The arguments in C++; nothing if one of them is not known.
/// @param known  those that the constructor has
std::optional<std::string> Arguments(const PortModel& model, const PortScope& scope,
                                     std::vector<CSharpWords> arguments,
                                     std::vector<ParameterArgument> known, bool hasTooltip)
{
    const auto isDisplay = [](const CSharpToken& word)
    {
        return word.Is("DisplayType");
    };
    // A bool, how an editor shows it, and whether it is overridden.
    if (known.size() == 2 &&
        (arguments.size() == 3 ||
         (arguments.size() == 2 && std::ranges::any_of(arguments[1], isDisplay))))
    {
        arguments.erase(arguments.begin() + 1);
    }
    if (known.size() == 5 && arguments.size() == 2) // a colour and whether it is overridden
    {
        known.erase(known.begin() + 1, known.end() - 1);
    }
    std::string text;
    for (std::size_t i = 0; i < arguments.size(); ++i)
    {
        const CSharpWords& words = arguments[i];
        const bool isNamed = words.size() > 2 && words[0].isName() && words[1].Is(":");
        const bool isKnown = i < known.size() && (!isNamed || words[0].Is(known[i].name));
        const auto value =
            isKnown ? Translate(model, scope, isNamed ? words.subspan(2) : words, known[i].type)
                    : std::nullopt;
        if (!value)
        {
            return std::nullopt;
        }
        text += ", " + value->cpp;
    }
    // A tooltip stands behind the last one.
    const bool isShort = hasTooltip && known.size() == 5 && arguments.size() == 4;
    return isShort ? text + ", false" : text;
}

std::string TooltipOf(const CSharpField& field)
{
    const CSharpAttribute* found = field.Find("Tooltip");
    const auto text = found ? PlainText(found->arguments) : std::nullopt;
    return text ? ", {.tooltip = \"" + *text + "\"}" : "";
}

/// "FloatParameter width{this, "width", 1.0f};"
/// @param arguments  those behind the name: ", 1.0f"
std::string ParameterText(const PortModel& model, const CSharpField& field, const std::string& type,
                          const std::string& arguments)
{
    return type + " " + model.CppName(field.name) + "{this, \"" + field.name + "\"" + arguments +
           TooltipOf(field) + "};";
}

/// "EnumParameter<Mode> mode{this, "mode", Mode::Off, {{"Off", Mode::Off}}};"; "" if it is none.
std::string EnumParameterText(const PortModel& model, const PortScope& scope,
                              const CSharpField& field, const std::vector<CSharpWords>& arguments)
{
    const CSharpClass* own = model.Find(field.type);
    const CSharpClass* type = own && model.RoleOf(*own) != PortRole::Parameter
                                  ? nullptr
                                  : model.Find(model.HeldType(field.type));
    if (!type || model.RoleOf(*type) != PortRole::Enum || !model.isDeclared(*type))
    {
        return "";
    }
    const std::string cpp = model.QualifiedName(*type);
    const auto value = arguments.empty() ? std::optional(PortValue{cpp + "{}", type->name})
                                         : Translate(model, scope, arguments[0], type->name);
    const auto isOn = arguments.size() == 2 ? Translate(model, scope, arguments[1], "bool")
                                            : std::optional(PortValue{"", "bool"});
    if (!value || !isOn || arguments.size() > 2)
    {
        return "";
    }
    const std::string names = Joined(
        type->enumerators, ", ",
        [&](const CSharpEnumerator& entry)
        { return "{\"" + entry.name + "\", " + cpp + "::" + model.CppName(entry.name) + "}"; });
    return ParameterText(model, field, "EnumParameter<" + cpp + ">",
                         ", " + value->cpp + ", {" + names + "}" +
                             (isOn->cpp.empty() ? "" : ", " + isOn->cpp));
}

/// A parameter of a uint, which in Unity is a mask of rendering layers more often than not.
std::string NumberParameterText(const PortModel& model, const PortScope& scope,
                                const CSharpField& field, const std::vector<CSharpWords>& arguments)
{
    const bool isMask = model.HeldType(field.type) == "RenderingLayerMask" ||
                        (field.type + field.name).find("ayer") != std::string::npos;
    // The C# may have a type of that name for Unity before 6, which has none.
    const std::string mask =
        model.Find("RenderingLayerMask") ? "limn::RenderingLayerMask" : "RenderingLayerMask";
    auto text = Arguments(model, scope, arguments,
                          {{"value", isMask ? mask : "uint"}, {"overrideState", "bool"}},
                          !TooltipOf(field).empty());
    if (text && text->empty()) // new VolumeParameter<uint>()
    {
        text = isMask ? ", " + mask + "::Nothing()" : ", 0u";
    }
    return !text ? ""
                 : ParameterText(model, field,
                                 isMask ? "RenderingLayerMaskParameter" : "UIntParameter", *text);
}

void WriteParameter(PortedCode& code, const CSharpClass& one, const CSharpField& field,
                    PortScope& scope)
{
    const PortModel& model = code.model();
    const std::string place = model.Place(one, field.location);
    const std::string csharp = field.type + " " + field.name + " = " + model.Text(one, field.value);
    const bool isWhole = !field.value.empty() && field.value.back().Is(")");
    const auto arguments = isWhole ? NewArguments(field.value) : std::nullopt;
    // IntParameter blurs = new ClampedIntParameter(1, 0, 5);
    const bool isNamed = arguments && field.value.size() > 3 && field.value[2].Is("(");
    const std::string type = isNamed ? std::string(field.value[1].text) : field.type;
    std::string line;
    if (arguments && IsShippedParameter(model, type) && !model.Find(type))
    {
        const auto text =
            Arguments(model, scope, *arguments, ArgumentsOf(type), !TooltipOf(field).empty());
        line = text ? ParameterText(model, field, type, *text) : "";
    }
    else if (arguments)
    {
        const CSharpClass* own = model.Find(field.type);
        const std::string& base = own && !own->bases.empty() ? own->bases.front() : field.type;
        const std::string held =
            base.starts_with("VolumeParameter<") ? model.HeldType(field.type) : "";
        line = held == "uint" || held == "RenderingLayerMask"
                   ? NumberParameterText(model, scope, field, *arguments)
                   : EnumParameterText(model, scope, field, *arguments);
    }
    code.Done({"parameter", one.name + "." + field.name, csharp, place, !line.empty()});
    if (line.empty())
    {
        code.Todo("a parameter", place, csharp + ";");
        return;
    }
    code.Line(line);
    scope[field.name] = {model.CppName(field.name), field.type};
    code.model().Declare(field);
}

/// IsActive and IsTileCompatible.
void WriteQuestion(PortedCode& code, const CSharpClass& one, const std::string& name,
                   const PortScope& scope)
{
    const PortModel& model = code.model();
    const CSharpMethod* method = one.FindMethod(name);
    CSharpWords words = method ? method->body : CSharpWords();
    if (method && !method->isExpression && !words.empty() && words.front().Is("return"))
    {
        words = words.subspan(1, words.size() - 2); // return ...;
    }
    const auto value = Translate(model, scope, words, "bool");
    code.Open("bool " + name + "() const override");
    if (method && !value)
    {
        code.TodoBody("port", one, *method);
    }
    code.Line("return " + (value ? value->cpp : "false") + ";");
    code.Close();
    if (method)
    {
        code.model().Declare(*method);
    }
}

} // namespace

void WriteComponent(PortedCode& code, const CSharpClass& one)
{
    const PortContext context(code.model(), one);
    PortModel& model = code.model();
    const bool isPostProcess = one.Derives("IPostProcessComponent");
    code.Line("/// What volumes set. C#: " + model.Place(one, one.location) + ".");
    code.Open("class " + model.ClassName(one) + " final : public VolumeComponent" +
              (isPostProcess ? ", public IPostProcessComponent" : ""));
    code.Label("public:");
    WriteTypes(code, NestedIn(one));
    PortScope scope;
    for (const CSharpField& field : one.fields)
    {
        const CSharpClass* own = model.Find(field.type);
        const bool isParameter = PlainTypeName(field.type).ends_with("Parameter") ||
                                 (own && model.RoleOf(*own) == PortRole::Parameter);
        isParameter ? WriteParameter(code, one, field, scope) : WriteField(code, one, field, scope);
    }
    if (isPostProcess)
    {
        scope["active"] = {"active", "bool"};
        code.Line();
        WriteQuestion(code, one, "IsActive", scope);
        WriteQuestion(code, one, "IsTileCompatible", scope);
    }
    std::set<std::string> signatures;
    for (const CSharpMethod& method : one.methods)
    {
        if (method.isConstructor() && !method.isStatic && method.parameters.empty())
        {
            code.Line();
            code.Open(model.ClassName(one) + "()");
            PortedBody(code, one, method).Write();
            code.Close();
        }
        else if (!isPostProcess || (method.name != "IsActive" && method.name != "IsTileCompatible"))
        {
            WriteHelper(code, one, method, signatures);
        }
    }
    code.Close("};");
    model.Declare(one);
}

} // namespace limn
