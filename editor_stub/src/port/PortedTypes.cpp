#include "port/PortedCode.h"

#include <algorithm>

namespace limn
{

namespace
{

std::string FieldText(const PortModel& model, const CSharpClass& one, const CSharpField& field)
{
    const std::string_view value = TextOf(model.FileOf(one), field.value);
    return field.type + " " + field.name + (value.empty() ? "" : " = " + std::string(value));
}

/// A = 1 << 2, B = A | 4 mean the same in C++.
bool IsSameEnumValue(CSharpWords words, const CSharpClass& one)
{
    return std::ranges::all_of(
        words,
        [&](const CSharpToken& word)
        {
            const bool isMember = std::ranges::any_of(one.enumerators, [&](const auto& entry)
                                                      { return entry.name == word.text; });
            const bool isNumber =
                word.kind == CSharpTokenKind::Number &&
                word.text.find_first_not_of("0123456789abcdefABCDEFxX") == std::string_view::npos;
            return isNumber || (word.isName() && isMember) ||
                   (word.kind == CSharpTokenKind::Punctuation &&
                    std::string_view("<>|&~+-*()").find(word.text) != std::string_view::npos);
        });
}

std::string EntriesName(const PortModel& model, const CSharpClass& one)
{
    std::string name = model.QualifiedName(one);
    for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::"))
    {
        name.erase(at, 2);
    }
    return "k_" + name + "Entries";
}

void WriteEntriesOf(PortedCode& code, const CSharpClass& one)
{
    const PortModel& model = code.model();
    const std::string type = model.QualifiedName(one);
    code.Line("static constexpr EnumEntry " + EntriesName(model, one) + "[] = {");
    for (const CSharpEnumerator& entry : one.enumerators)
    {
        code.Line("    {\"" + entry.name + "\", static_cast<int>(" + type +
                  "::" + model.CppName(entry.name) + ")},");
    }
    code.Line("};");
}

/// What the class's settings of enums can be.
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
            WriteEntriesOf(code, *own);
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
    const bool isNumber = field.type == "int" || field.type == "float";
    if (const CSharpAttribute* range = field.Find("Range"); range && isNumber)
    {
        const auto limits = SplitArguments(range->arguments);
        const auto low = limits.size() == 2 ? TranslateNumber(model, limits[0]) : std::nullopt;
        const auto high = limits.size() == 2 ? TranslateNumber(model, limits[1]) : std::nullopt;
        return low && high ? ", {" + *low + ", " + *high + "}" : "";
    }
    if (const CSharpAttribute* least = field.Find("Min"); least && isNumber)
    {
        const auto low = TranslateNumber(model, least->arguments);
        return low ? ", {.min = " + *low + "}" : "";
    }
    return "";
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
    if (own && model.RoleOf(*own) == PortRole::Data)
    {
        // As Unity's files are read: what is in these stands beside the feature's own fields.
        const bool isFlat = field.name == "settings" || field.name == "m_Settings";
        if (!isFlat)
        {
            code.Line("inspector.BeginGroup(\"" + field.name + "\");");
        }
        code.Line(name + ".Describe(inspector);");
        if (!isFlat)
        {
            code.Line("inspector.EndGroup();");
        }
        return;
    }
    if (field.type == "CompareFunction" || field.type == "StencilOp")
    {
        code.Line("inspector.Field" + start + ", " + field.type + "Entries()" + tooltip);
        return;
    }
    const std::string entries = own ? ", " + EntriesName(model, *own) : "";
    code.Line("inspector.Field" + start + entries + RangeText(model, field) + tooltip);
}

/// How many levels of data are in it: groups of an Inspector are not nested.
bool HasData(const PortModel& model, const CSharpClass& one)
{
    return std::ranges::any_of(one.fields,
                               [&](const CSharpField& field)
                               {
                                   const CSharpClass* own = model.Find(field.type);
                                   return model.isSerialized(field) && own &&
                                          model.RoleOf(*own) == PortRole::Data;
                               });
}

bool Needs(const PortModel& model, const CSharpClass& one, const CSharpClass& other)
{
    const PortContext context(model, one);
    const auto isIn = [&](const std::string& type)
    {
        std::string_view name = PlainTypeName(type);
        const std::string inner = type.starts_with("List<") ? type.substr(5, type.size() - 6) : "";
        const CSharpClass* found = model.Find(inner.empty() ? name : std::string_view(inner));
        for (; found; found = model.OuterOf(*found))
        {
            if (found == &other)
            {
                return true;
            }
        }
        return false;
    };
    return std::ranges::any_of(one.fields, [&](const auto& field) { return isIn(field.type); }) ||
           std::ranges::any_of(one.bases, isIn) ||
           std::ranges::any_of(one.classes, [&](const CSharpClass& nested)
                               { return Needs(model, nested, other); });
}

} // namespace

void WriteEnum(PortedCode& code, const CSharpClass& one)
{
    PortModel& model = code.model();
    code.Open("enum class " + one.name);
    for (const CSharpEnumerator& entry : one.enumerators)
    {
        const std::string value(TextOf(model.FileOf(one), entry.value));
        const std::string name = model.CppName(entry.name);
        const bool isSame = IsSameEnumValue(entry.value, one);
        code.Line(value.empty() ? name + ","
                  : isSame      ? name + " = " + value + ","
                                : name + ", // TODO: = " + value);
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
    const bool isId = field.type == "int" && field.value.size() == 6 &&
                      field.value[0].Is("Shader") && field.value[2].Is("PropertyToID");
    if (isId)
    {
        const auto id = Translate(model, scope, field.value.subspan(4, 1), "string");
        if (id)
        {
            code.Line("inline static const ShaderPropertyId " + name + " = Shader::PropertyToID(" +
                      id->cpp + ");");
            return;
        }
    }
    auto type = model.CppType(field.type);
    if (type && field.type == "Material" && model.isSetting(one, field))
    {
        type = "std::shared_ptr<const Material>"; // as an Inspector has it
    }
    const auto value = Translate(model, scope, field.value, field.type);
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
            scope[field.name] = {name, field.type};
        }
        return;
    }
    if (!value && !field.value.empty())
    {
        code.Todo("what it begins with", place, csharp + ";");
    }
    const bool isText = field.isConst && field.type == "string";
    const CSharpClass* own = model.Find(field.type);
    const bool isEnum = own && model.RoleOf(*own) == PortRole::Enum;
    const std::string prefix = field.isConst    ? "static constexpr "
                               : field.isStatic ? "inline static "
                                                : "";
    // A nested class has no default values yet where the outer one is being defined.
    const bool isPlainData = own && (!value || value->cpp == *type + "{}");
    code.Line(prefix + (isText ? "const char*" : *type) + " " + name +
              (isPlainData && !isEnum ? ""
               : value                ? " = " + value->cpp
                                      : "{}") +
              ";");
    scope[field.name] = {name, model.ValueType(one, field)};
}

void WriteDescription(PortedCode& code, const CSharpClass& one)
{
    const PortModel& model = code.model();
    WriteEntries(code, one);
    code.Open("void Describe([[maybe_unused]] Inspector& inspector)" +
              std::string(model.RoleOf(one) == PortRole::Feature ? " override" : ""));
    for (const CSharpField& field : one.fields)
    {
        if (!model.isSerialized(field))
        {
            continue;
        }
        const CSharpClass* own = model.Find(field.type);
        const bool isTooDeep = own && model.RoleOf(*own) == PortRole::Data &&
                               (HasData(model, *own) || model.RoleOf(one) == PortRole::Data);
        const bool isDone = model.isSetting(field.type) && !isTooDeep;
        code.Done({"setting", one.name + "." + field.name, FieldText(model, one, field),
                   model.Place(one, field.location), isDone});
        if (isDone)
        {
            DescribeField(code, field);
        }
        else
        {
            code.Todo("no setting of limn has this type", model.Place(one, field.location),
                      FieldText(model, one, field) + ";");
        }
    }
    code.Close();
}

void WriteTypes(PortedCode& code, std::vector<const CSharpClass*> classes)
{
    const PortModel& model = code.model();
    while (!classes.empty())
    {
        const auto isFree = [&](const CSharpClass* one)
        {
            return std::ranges::none_of(classes, [&](const CSharpClass* other)
                                        { return other != one && Needs(model, *one, *other); });
        };
        auto next = std::ranges::find_if(classes, isFree);
        next = next == classes.end() ? classes.begin() : next; // in a circle: TODOs
        const CSharpClass& one = **next;
        classes.erase(next);
        switch (model.RoleOf(one))
        {
        case PortRole::Enum:
            WriteEnum(code, one);
            code.Line();
            break;
        case PortRole::Data:
            WriteData(code, one);
            code.Line();
            break;
        default:
            break;
        }
    }
}

void WriteData(PortedCode& code, const CSharpClass& one)
{
    const PortContext context(code.model(), one);
    PortModel& model = code.model();
    code.Line("/// C#: " + model.Place(one, one.location) + ".");
    code.Open("struct " + one.name);
    std::vector<const CSharpClass*> nested;
    for (const CSharpClass& inner : one.classes)
    {
        nested.push_back(&inner);
    }
    WriteTypes(code, nested);
    PortScope scope;
    for (const CSharpField& field : one.fields)
    {
        WriteField(code, one, field, scope);
    }
    for (const CSharpMethod& method : one.methods)
    {
        code.Line();
        code.Todo(method.name, model.Place(one, method.location),
                  BodyText(model.FileOf(one), method));
    }
    code.Line();
    // What a pass hands to its function is no setting.
    const CSharpClass* outer = model.OuterOf(one);
    if (!outer || model.RoleOf(*outer) != PortRole::Pass)
    {
        WriteDescription(code, one);
    }
    code.Close("};");
    model.Declare(one);
}

} // namespace limn
