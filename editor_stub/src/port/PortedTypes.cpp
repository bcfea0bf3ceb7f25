#include "console/Texts.h"
#include "port/PortLiteral.h"
#include "port/PortedBody.h"

#include <algorithm>
#include <iterator>

namespace limn
{

namespace
{

std::string FieldText(const PortModel& model, const CSharpClass& one, const CSharpField& field)
{
    return field.type + " " + field.name +
           (field.value.empty() ? "" : " = " + model.Text(one, field.value));
}

constexpr std::int64_t k_LargestInt = 2147483647;

/// Returns whether C++ takes the value as C# has it, without a warning of brackets.
bool IsPlainEnumValue(CSharpWords words)
{
    std::string_view only;
    const auto isPlain = [&](const CSharpToken& word)
    {
        if (word.kind != CSharpTokenKind::Punctuation)
        {
            constexpr std::size_t k_MostDigits = 9; // of an int for sure
            return word.isName() ||
                   (word.text.size() <= k_MostDigits &&
                    (word.text.starts_with("0x") ||
                     word.text.find_first_of("_bBuUlL") == std::string_view::npos));
        }
        const bool isSame = only.empty() || only == word.text;
        only = word.text;
        return isSame && !word.Is("(") && !word.Is("^");
    };
    return std::ranges::all_of(words, isPlain);
}

std::string EntriesName(const PortModel& model, const CSharpClass& one)
{
    return "k_" + Replaced(model.QualifiedName(one), "::", "") + "Entries";
}

/// Returns whether [Flags] stands before an enum.
bool IsFlags(const CSharpClass& one)
{
    const CSharpToken* first = one.file->tokens.tokens.data();
    const CSharpToken* at = one.words.data();
    while (at > first && at[-1].isName()) // public
    {
        --at;
    }
    while (at > first && at[-1].Is("]") && at[-1].match < 0)
    {
        const CSharpToken* end = at - 1;
        at = end + end->match;
        if (std::ranges::any_of(at->Inside(), [](const auto& word) { return word.Is("Flags"); }))
        {
            return true;
        }
    }
    return false;
}

/// Writes the possible values of the class's settings of enum types.
void WriteEntries(PortedCode& code, const CSharpClass& one)
{
    const PortModel& model = code.model();
    std::set<const CSharpClass*> written;
    for (const CSharpField& field : one.fields)
    {
        const CSharpClass* own = model.Find(field.type);
        if (own && model.RoleOf(*own) == PortRole::Enum && model.isSerialized(field) &&
            model.isSetting(field.type) && written.insert(own).second)
        {
            const std::string type = model.QualifiedName(*own);
            code.Line("static constexpr EnumEntry " + EntriesName(model, *own) + "[] = {");
            for (const CSharpEnumerator& entry : own->enumerators)
            {
                code.Line("    {\"" + entry.name + "\", static_cast<int>(" + type +
                          "::" + model.CppName(entry.name) + ")},");
            }
            if (IsFlags(*own) && !own->enumeratorNames.contains("Everything"))
            {
                code.Line("    {\"Everything\", -1},");
            }
            code.Line("};");
        }
    }
}

std::string AttributeText(const CSharpField& field, std::string_view attribute)
{
    const CSharpAttribute* found = field.Find(attribute);
    return found ? PlainText(found->arguments).value_or("") : "";
}

/// ", {0, 1}" of [Range(0, 1)], {.min = 0} of [Min(0)]; "" for none.
std::string RangeText(const PortModel& model, const CSharpField& field)
{
    if (!IsIn(field.type, {"int", "float", "uint"}))
    {
        return "";
    }
    if (const CSharpAttribute* range = field.Find("Range"))
    {
        const auto limits = SplitArguments(range->arguments);
        const auto low = limits.size() == 2 ? TranslateNumber(model, limits[0]) : std::nullopt;
        const auto high = low ? TranslateNumber(model, limits[1]) : std::nullopt;
        return high ? ", {" + *low + ", " + *high + "}" : "";
    }
    const CSharpAttribute* least = field.Find("Min");
    const auto low = least ? TranslateNumber(model, least->arguments) : std::nullopt;
    return low ? ", {.min = " + *low + "}" : "";
}

void DescribeField(PortedCode& code, const CSharpField& field)
{
    const PortModel& model = code.model();
    const std::string name = model.CppName(field.name);
    const std::string start = "(\"" + field.name + "\", " + name;
    const std::string tooltip = ", \"" + AttributeText(field, "Tooltip") + "\");";
    const CSharpClass* own = model.Find(field.type);
    if (const std::string header = AttributeText(field, "Header"); !header.empty())
    {
        code.Line("inspector.Header(\"" + header + "\");");
    }
    const bool isStencil = !own && field.type == "StencilStateData";
    if (isStencil || (own && model.RoleOf(*own) == PortRole::Data))
    {
        code.Line("inspector.BeginGroup(\"" + field.name + "\");");
        code.Line(name + ".Describe(inspector);");
        code.Line("inspector.EndGroup();");
        return;
    }
    if (!own && PortModel::hasEntries(field.type))
    {
        code.Line("inspector.Field" + start + ", " + field.type + "Entries()" + tooltip);
        return;
    }
    // A tooltip of a shader with a slash in it would be taken for the shader's name.
    if (IsIn(field.type, {"Shader", "Material"}) && tooltip.find('/') != std::string::npos)
    {
        code.Line("inspector.Field" + start + ", std::string_view(" +
                  tooltip.substr(2, tooltip.size() - 4) + "));");
        return;
    }
    const std::string entries = own ? ", " + EntriesName(model, *own) : "";
    code.Line("inspector.Field" + start + entries + RangeText(model, field) + tooltip);
}

/// Finds the classes that others of the same list need before them.
class ClassNeeds
{
public:
    ClassNeeds(const PortModel& model, const std::vector<const CSharpClass*>& classes)
        : m_Model(model)
    {
        for (std::size_t i = 0; i < classes.size(); ++i)
        {
            m_Places.emplace(classes[i], i);
        }
    }

    /// The places of those that this one needs, or a class in it.
    std::set<std::size_t> Of(const CSharpClass& one) const
    {
        std::set<std::size_t> needs;
        Add(one, needs);
        needs.erase(m_Places.at(&one));
        return needs;
    }

private:
    void Add(const CSharpClass& one, std::set<std::size_t>& needs) const
    {
        const PortContext context(m_Model, one);
        for (const std::string& base : one.bases)
        {
            AddClass(m_Model.Find(base), needs);
        }
        for (const CSharpField& field : one.fields)
        {
            const std::string& type = field.type;
            const bool isList = type.starts_with("List<");
            AddClass(m_Model.Find(isList ? type.substr(5, type.size() - 6) : type), needs);
            for (const CSharpToken& word : field.value)
            {
                const CSharpClass* named = m_Model.Find(word.text);
                if (named != nullptr && m_Places.contains(named))
                {
                    AddClass(named, needs);
                }
            }
        }
        for (const CSharpClass& nested : one.classes)
        {
            Add(nested, needs);
        }
    }

    /// Adds a class and those around it, as far as they are in the list.
    void AddClass(const CSharpClass* one, std::set<std::size_t>& needs) const
    {
        for (; one; one = one->outer)
        {
            if (const auto place = m_Places.find(one); place != m_Places.end())
            {
                needs.insert(place->second);
            }
        }
    }

    const PortModel& m_Model;
    std::map<const CSharpClass*, std::size_t> m_Places;
};

/// The classes, each behind those that it needs; else, and in a circle, in their order.
std::vector<const CSharpClass*> SortedByNeeds(const PortModel& model,
                                              const std::vector<const CSharpClass*>& classes)
{
    const ClassNeeds needs(model, classes);
    std::vector<std::size_t> missing(classes.size()); // how many a class still needs
    std::vector<std::vector<std::size_t>> neededBy(classes.size());
    std::set<std::size_t> free;
    std::set<std::size_t> left;
    for (std::size_t i = 0; i < classes.size(); ++i)
    {
        const std::set<std::size_t> needed = needs.Of(*classes[i]);
        missing[i] = needed.size();
        for (const std::size_t other : needed)
        {
            neededBy[other].push_back(i);
        }
        (needed.empty() ? free : left).insert(i);
    }
    std::vector<const CSharpClass*> sorted;
    while (!free.empty() || !left.empty())
    {
        std::set<std::size_t>& from = free.empty() ? left : free; // in a circle: TODOs
        const std::size_t next = *from.begin();
        from.erase(from.begin());
        sorted.push_back(classes[next]);
        for (const std::size_t other : neededBy[next])
        {
            if (--missing[other] == 0 && left.erase(other) == 1)
            {
                free.insert(other);
            }
        }
    }
    return sorted;
}

/// " : Base" of data that derives from data.
std::string BaseText(const PortModel& model, const CSharpClass& one)
{
    for (const std::string& base : one.bases)
    {
        const CSharpClass* own = model.Find(base);
        if (own && own != &one && model.RoleOf(*own) == PortRole::Data && model.CppType(base))
        {
            return " : " + model.QualifiedName(*own);
        }
    }
    return "";
}

/// A ContextItem's, which is pure in C++.
void WriteReset(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    code.Line();
    code.Open("void Reset() override");
    PortedBody(code, one, method).Write();
    code.Close();
}

/// The field is there, by its name in C++.
void Declare(PortModel& model, const CSharpClass& one, const CSharpField& field, PortScope& scope)
{
    model.Declare(field);
    scope[field.name] = VariableOf(model, one, field);
}

} // namespace

PortValue VariableOf(const PortModel& model, const CSharpClass& one, const CSharpField& field)
{
    PortValue value{model.CppName(field.name), field.type};
    value.isVariable = true;
    const CSharpClass* own = model.FindPlain(field.type);
    value.isPointer = model.isShared(one, field) || (own && model.RoleOf(*own) == PortRole::Pass);
    value.own = model.hasOwn(one, field) ? value.cpp + "Own" : "";
    return value;
}

void WriteEnum(PortedCode& code, const CSharpClass& one)
{
    PortModel& model = code.model();
    const auto values = EnumValues(one);
    const bool isLarge = std::ranges::any_of(
        values, [](const auto& value)
        { return value && (*value > k_LargestInt || *value < -k_LargestInt - 1); });
    code.Open("enum class " + model.ClassName(one) + (isLarge ? " : std::int64_t" : ""));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const CSharpEnumerator& entry = one.enumerators[i];
        const std::string text = model.Text(one, entry.value);
        const std::string name = model.CppName(entry.name);
        const bool isPlain = !isLarge && IsPlainEnumValue(entry.value);
        code.Line(text.empty() ? name + ","
                  : !values[i] ? name + ", // TODO: = " + InComment(text)
                  : isPlain
                      ? name + " = " + text + ","
                      : name + " = " + std::to_string(*values[i]) + ", // " + InComment(text));
    }
    code.Close("};");
    model.Declare(one);
}

void WriteField(PortedCode& code, const CSharpClass& one, const CSharpField& field,
                PortScope& scope)
{
    const PortModel& model = code.model();
    const std::string name = model.CppName(field.name);
    const std::string place = model.Place(one, field.location);
    const std::string csharp = FieldText(model, one, field);
    if (one.FindField(field.name) != &field)
    {
        code.Todo("a second member of this name", place, csharp + ";");
        return;
    }
    const auto pointed = model.isShared(one, field) ? model.CppPointed(field.type) : std::nullopt;
    if (pointed)
    {
        const std::string own = VariableOf(model, one, field).own;
        const bool isMade = !own.empty() && !field.value.empty();
        if (!own.empty())
        {
            code.Line(*pointed + " " + own + ";");
        }
        code.Line("Borrowed<" + *pointed + "> " + name + (isMade ? " = &" + own : "") + ";");
        Declare(code.model(), one, field, scope);
        return;
    }
    const auto type = model.CppType(field.type);
    std::string problem;
    const auto value = Translate(PortPlace{model, scope}, field.value, field.type, &problem);
    if (!type || (!value && (field.isConst || *type == "ProfilingSampler")))
    {
        const bool isSampler = type && !field.isConst;
        if (!isSampler || !field.value.empty())
        {
            code.Todo(isSampler ? "its name" : "a member", place, csharp + ";");
        }
        if (isSampler)
        {
            code.Line("ProfilingSampler " + name + "{\"" + one.name + "\"};");
            Declare(code.model(), one, field, scope);
        }
        return;
    }
    if (!value && !field.value.empty())
    {
        code.Todo("what it begins with" + (problem.empty() ? "" : ": " + InComment(problem)), place,
                  csharp + ";");
    }
    const bool isText = field.isConst && field.type == "string";
    const CSharpClass* own = model.Find(field.type);
    const bool isEnum = own && model.RoleOf(*own) == PortRole::Enum;
    const bool isId = value && field.isStatic && field.isReadonly && *type == k_PropertyIdType;
    const std::string prefix = field.isConst    ? "static constexpr "
                               : isId           ? "inline static const "
                               : field.isStatic ? "inline static "
                                                : "";
    // A nested class has no default values yet where the outer one is being defined.
    const bool isPlainData = own && (!value || value->cpp == *type + "{}");
    if (isPlainData && !isEnum && field.isStatic && own->outer)
    {
        code.Line("static " + *type + " " + name + ";");
        code.Behind("inline " + *type + " " + model.QualifiedName(one) + "::" + name + ";");
        Declare(code.model(), one, field, scope);
        return;
    }
    const bool isLiteral = isText && value->cpp.starts_with("\"");
    code.Line((isText && !isLiteral ? "inline static const " : prefix) +
              (isLiteral ? "const char*" : *type) + " " + name +
              (isPlainData && !isEnum ? ""
               : !value               ? PortModel::CppDefault(*type)
                                      : " = " + value->cpp) +
              ";");
    Declare(code.model(), one, field, scope);
}

void WriteDescription(PortedCode& code, const CSharpClass& one)
{
    const PortModel& model = code.model();
    WriteEntries(code, one);
    code.Open("void Describe([[maybe_unused]] Inspector& inspector)" +
              std::string(model.RoleOf(one) == PortRole::Feature ? " override" : ""));
    for (const CSharpField& field : one.fields)
    {
        const CSharpClass* own = model.FindPlain(field.type);
        const bool isPass = own && model.RoleOf(*own) == PortRole::Pass;
        if (!model.isSerialized(field) || isPass)
        {
            continue;
        }
        const bool isDone = model.isSetting(field.type) && model.isDeclared(field);
        const std::string csharp = FieldText(model, one, field);
        const std::string place = model.Place(one, field.location);
        code.Done({"setting", one.name + "." + field.name, csharp, place, isDone});
        isDone ? DescribeField(code, field)
               : code.Todo("no setting of limn has this type", place, csharp + ";");
    }
    code.Close();
}

std::vector<const CSharpClass*> NestedIn(const CSharpClass& one)
{
    std::vector<const CSharpClass*> nested;
    std::ranges::transform(one.classes, std::back_inserter(nested),
                           [](const CSharpClass& inner) { return &inner; });
    return nested;
}

void WriteTypes(PortedCode& code, const std::vector<const CSharpClass*>& classes)
{
    const PortModel& model = code.model();
    for (const CSharpClass* one : SortedByNeeds(model, classes))
    {
        const PortRole role = model.RoleOf(*one);
        if (role == PortRole::Enum || role == PortRole::Data || role == PortRole::Context)
        {
            role == PortRole::Enum ? WriteEnum(code, *one) : WriteData(code, *one);
            code.Line();
        }
    }
}

bool IsConst(const PortModel& model, const CSharpClass& one, const CSharpMethod& method)
{
    const auto isOwnCall = [&](const CSharpToken& word)
    {
        const CSharpMethod* called = word.isName() ? one.FindMethod(word.text) : nullptr;
        return called && called != &method && !called->isStatic;
    };
    const auto changesField = [&](const CSharpClass& owner)
    {
        return std::ranges::any_of(owner.fields, [&](const CSharpField& field)
                                   { return IsChanged(method.body, field.name, true); });
    };
    const auto changesOfBase = [&](const std::string& base)
    {
        const CSharpClass* own = model.Find(base);
        return own && changesField(*own);
    };
    const bool isComponent = model.RoleOf(one) == PortRole::Component;
    const bool isQuestion = method.isExpression && method.type != "void";
    return (isComponent || isQuestion) && std::ranges::none_of(method.body, isOwnCall) &&
           !changesField(one) && std::ranges::none_of(one.bases, changesOfBase);
}

void WriteHelper(PortedCode& code, const CSharpClass& one, const CSharpMethod& method,
                 std::set<std::string>& signatures)
{
    const auto signature = method.isOverride || method.isConstructor()
                               ? std::nullopt
                               : SignatureOf(code.model(), one, method);
    code.Line();
    if (!signature || !signatures.insert(signature->name + signature->parameters).second)
    {
        code.TodoBody(method.name, one, method);
        return;
    }
    const bool isConst = !method.isStatic && IsConst(code.model(), one, method);
    const std::size_t begin = code.text.size();
    code.Open((method.isStatic ? "static " : "") + signature->Text() + (isConst ? " const" : ""));
    PortedBody(code, one, method).Write();
    code.Close();
    code.TrimUnused(begin);
    code.model().Declare(method);
}

void WriteData(PortedCode& code, const CSharpClass& one)
{
    const PortContext context(code.model(), one);
    PortModel& model = code.model();
    code.Line("/// C#: " + model.Place(one, one.location) + ".");
    const bool isContext = model.RoleOf(one) == PortRole::Context;
    code.Open(isContext ? "class " + model.ClassName(one) + " final : public ContextItem"
                        : "struct " + model.ClassName(one) + BaseText(model, one));
    if (isContext)
    {
        code.Label("public:");
    }
    WriteTypes(code, NestedIn(one));
    PortScope scope;
    for (const CSharpField& field : one.fields)
    {
        WriteField(code, one, field, scope);
    }
    std::set<std::string> signatures;
    for (const CSharpMethod& method : one.methods)
    {
        if (isContext && method.name == "Reset" && method.parameters.empty())
        {
            WriteReset(code, one, method);
        }
        else
        {
            WriteHelper(code, one, method, signatures);
        }
    }
    if (isContext && !one.FindMethod("Reset"))
    {
        code.Line("void Reset() override {} // TODO: the C# has none");
    }
    // The data that a pass gives to its function are no settings.
    const bool isOfPass = one.outer && model.RoleOf(*one.outer) == PortRole::Pass;
    if (!isContext && !one.isStatic && !isOfPass)
    {
        code.Line();
        WriteDescription(code, one);
    }
    code.Close("};");
    model.Declare(one);
}

} // namespace limn
