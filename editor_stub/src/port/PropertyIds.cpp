#include "port/PortModel.h"

namespace limn
{

namespace
{

constexpr int k_MaxRounds = 20; ///< from a field to a parameter to a field ...

/// The type with a property's number in place of int; "" where it holds no int.
std::string IdType(const std::string& type)
{
    return type == "int"         ? k_PropertyIdType
           : type == "int[]"     ? std::string(k_PropertyIdType) + "[]"
           : type == "List<int>" ? "List<" + std::string(k_PropertyIdType) + ">"
                                 : "";
}

bool IsIdType(std::string_view type)
{
    return type.find(k_PropertyIdType) != std::string_view::npos;
}

/// Finds the ints of all classes round by round.
class PropertyIdFinder
{
public:
    explicit PropertyIdFinder(const CSharpFiles& files)
    {
        for (const auto& file : files)
        {
            Collect(file->classes);
        }
    }

    void Run()
    {
        for (int round = 0; round < k_MaxRounds && m_HasChanged; ++round)
        {
            m_HasChanged = false;
            for (CSharpClass* one : m_Classes)
            {
                Look(*one);
            }
        }
    }

private:
    void Collect(std::vector<CSharpClass>& classes)
    {
        for (CSharpClass& one : classes)
        {
            m_Classes.push_back(&one);
            m_ClassesByName.emplace(one.name, &one);
            for (CSharpField& field : one.fields)
            {
                m_Fields.emplace(field.name, &field);
            }
            for (CSharpMethod& method : one.methods)
            {
                m_Methods.emplace(method.name, &method);
                CollectLocals(method);
            }
            Collect(one.classes);
        }
    }

    /// Finds the variables of a method that are declared as int, int[] or List<int>, or as var with
    /// a new array or list.
    static void CollectLocals(CSharpMethod& method)
    {
        const CSharpWords words = method.body;
        for (std::size_t i = 0; i + 2 < words.size(); ++i)
        {
            const CSharpToken* name = &words[i];
            const CSharpToken* end = words.data() + words.size();
            std::string type = IsIn(name->text, {"int", "List", "var"}) ? ReadCSharpType(name) : "";
            if (type.empty() || name + 1 >= end || !name->isName() ||
                !IsIn(name[1].text, {"=", ";"}))
            {
                continue;
            }
            if (type == "var" && name + 3 < end && name[2].Is("new"))
            {
                const CSharpToken* made = name + 3;
                type = ReadCSharpType(made);
                type += made < end && made->Is("[") ? "[]" : "";
            }
            if (!IdType(type).empty())
            {
                method.intLocals[std::string(name->text)] = type;
            }
        }
    }

    void Look(CSharpClass& one)
    {
        for (CSharpField& field : one.fields)
        {
            for (std::size_t i = 0; i < field.value.size(); ++i)
            {
                if (isProperty(field.value.subspan(i), one, nullptr))
                {
                    Mark(field.type);
                }
            }
        }
        for (CSharpMethod& method : one.methods)
        {
            for (std::size_t i = 0; i < method.body.size(); ++i)
            {
                LookAtAssignment(one, method, i);
                LookAtCall(one, method, i);
                LookAtReturn(one, method, i);
            }
        }
    }

    void Mark(std::string& type)
    {
        const std::string id = IdType(type);
        if (!id.empty())
        {
            type = id;
            m_HasChanged = true;
        }
    }

    /// Returns the type of a name in a method, or null if it is no variable.
    std::string* TypeOf(std::string_view name, CSharpClass& one, CSharpMethod* method)
    {
        for (std::size_t i = 0; method && i < method->parameters.size(); ++i)
        {
            if (method->parameters[i].name == name)
            {
                return &method->parameters[i].type;
            }
        }
        if (method && method->intLocals.contains(name))
        {
            return &method->intLocals.find(name)->second;
        }
        const auto found = one.fieldNames.find(name);
        return found == one.fieldNames.end() ? nullptr : &one.fields[found->second].type;
    }

    /// Returns the type of a class's field. Where the class is not known, any field counts that
    /// alone has this name.
    std::string* TypeOfMember(std::string_view owner, std::string_view name)
    {
        const auto found = m_ClassesByName.find(owner);
        if (found != m_ClassesByName.end())
        {
            return TypeOf(name, *found->second, nullptr);
        }
        const auto [begin, end] = m_Fields.equal_range(name);
        return begin != end && std::next(begin) == end ? &begin->second->type : nullptr;
    }

    /// A variable that words begin with.
    struct Variable
    {
        std::string* type = nullptr; ///< null = it is none
        std::size_t length = 0;      ///< in words
    };

    /// Finds a, this.a, data.a, Ids.a, and a[i] of them.
    Variable Find(CSharpWords words, CSharpClass& one, CSharpMethod* method)
    {
        const bool isThis = words.size() > 2 && words[0].Is("this") && words[1].Is(".");
        std::size_t at = isThis ? 2 : 0;
        if (words.empty() || !words[at].isName())
        {
            return {};
        }
        std::string* type = TypeOf(words[at].text, one, isThis ? nullptr : method);
        for (; at + 2 < words.size() && words[at + 1].Is(".") && words[at + 2].isName(); at += 2)
        {
            type =
                TypeOfMember(type ? std::string_view(*type) : words[at].text, words[at + 2].text);
        }
        const bool isElement = at + 1 < words.size() && words[at + 1].Is("[");
        return {type, at + 1 + (isElement ? words[at + 1].Inside().size() + 2 : 0)};
    }

    /// Returns whether a property's number begins there: Shader.PropertyToID(...), a call that
    /// gives one, or a variable.
    bool isProperty(CSharpWords words, CSharpClass& one, CSharpMethod* method)
    {
        if (words.size() > 3 && words[1].Is(".") && words[2].Is("PropertyToID"))
        {
            return words[0].Is("Shader");
        }
        if (words.size() > 2 && words[1].Is("(") && m_Methods.contains(words[0].text))
        {
            return IsIdType(m_Methods.find(words[0].text)->second->type);
        }
        const Variable variable = Find(words, one, method);
        const bool isAlone =
            variable.length == words.size() ||
            (variable.type && IsIn(words[variable.length].text, {";", ",", ")", ":", "}"}));
        return variable.type && isAlone && IsIdType(*variable.type);
    }

    /// name = ..., name[i] = ... at a word.
    void LookAtAssignment(CSharpClass& one, CSharpMethod& method, std::size_t at)
    {
        const CSharpWords words = method.body.subspan(at);
        const bool isMember = at > 0 && method.body[at - 1].Is(".");
        const Variable target = isMember ? Variable() : Find(words, one, &method);
        if (!target.type || target.length + 1 >= words.size() || !words[target.length].Is("="))
        {
            return;
        }
        const CSharpWords value = words.subspan(target.length + 1);
        const CSharpToken* end = value.data() + value.size();
        const CSharpToken* behind = FindOutsideOfBrackets(value.data(), end, {";"});
        const CSharpToken* choice = FindOutsideOfBrackets(value.data(), behind, {"?"});
        if (isProperty(value, one, &method) ||
            (choice < behind && isProperty({choice + 1, end}, one, &method)))
        {
            Mark(*target.type);
        }
        const Variable from = Find(value, one, &method);
        if (from.type && from.length < value.size() && value[from.length].Is(";") &&
            IsIdType(*target.type))
        {
            Mark(*from.type);
        }
    }

    /// return ... at a word.
    void LookAtReturn(CSharpClass& one, CSharpMethod& method, std::size_t at)
    {
        const bool isReturn = method.isExpression ? at == 0 : method.body[at].Is("return");
        if (isReturn &&
            isProperty(method.body.subspan(at + (method.isExpression ? 0 : 1)), one, &method))
        {
            Mark(method.type);
        }
    }

    /// Method(a, b) at a word.
    void LookAtCall(CSharpClass& one, CSharpMethod& method, std::size_t at)
    {
        const CSharpWords words = method.body.subspan(at);
        if (words.size() < 3 || !words[0].isName() || !words[1].Is("(") || words[2].Is(")"))
        {
            return;
        }
        const auto arguments = SplitArguments(words[1].Inside());
        const bool isAdded = words[0].Is("Add") && at > 1 && method.body[at - 1].Is(".");
        std::string* list = isAdded ? TypeOf(method.body[at - 2].text, one, &method) : nullptr;
        if (list && isProperty(arguments[0], one, &method))
        {
            Mark(*list);
        }
        const auto index = PropertyArgument("", words[0].text, arguments.size());
        if (index && *index < arguments.size())
        {
            const Variable variable = Find(arguments[*index], one, &method);
            if (variable.type && variable.length == arguments[*index].size())
            {
                Mark(*variable.type);
            }
        }
        for (std::size_t i = 0; i < arguments.size(); ++i)
        {
            if (isProperty(arguments[i], one, &method))
            {
                MarkParameters(words[0].text, i, arguments.size());
            }
        }
    }

    /// Marks a parameter of every method and constructor of this name. It does not follow which one
    /// is called.
    void MarkParameters(std::string_view name, std::size_t index, std::size_t arguments)
    {
        const auto [begin, end] = m_Methods.equal_range(name);
        for (auto found = begin; found != end; ++found)
        {
            CSharpMethod& method = *found->second;
            if (!method.isOverride && method.parameters.size() >= arguments)
            {
                Mark(method.parameters[index].type);
            }
        }
    }

    std::vector<CSharpClass*> m_Classes;
    std::map<std::string_view, CSharpClass*> m_ClassesByName;
    std::multimap<std::string_view, CSharpField*> m_Fields;
    std::multimap<std::string_view, CSharpMethod*> m_Methods;
    bool m_HasChanged = true;
};

} // namespace

std::optional<std::size_t> PropertyArgument(std::string_view owner, std::string_view method,
                                            std::size_t arguments)
{
    const bool isByName = IsIn(owner, {"Material", "MaterialPropertyBlock", "Shader"});
    if (IsIn(method, {"PropertyToID", "SetGlobalDepthBias", "GetKernelThreadGroupSizes",
                      "IsSupported", "Dispatch", "DispatchIndirect"}))
    {
        return std::nullopt;
    }
    if (method.starts_with("SetCompute"))
    {
        const bool isOfKernel = IsIn(method, {"SetComputeTextureParam", "SetComputeBufferParam"});
        return isOfKernel ? 2 : 1;
    }
    if (IsIn(method, {"SetTexture", "SetBuffer"}) && !isByName)
    {
        return owner == "ComputeShader" || arguments == 3 ? 1 : 0; // behind the kernel
    }
    const bool isFirst =
        isByName || owner == "ComputeShader" || method.ends_with("TemporaryRT") ||
        StartsWithAny(method,
                      {"SetGlobal", "SetFloat", "SetInt", "SetVector", "SetColor", "SetTexture",
                       "SetMatrix", "SetBuffer", "SetConstantBuffer", "GetFloat", "GetInt",
                       "GetVector", "GetColor", "GetMatrix", "GetTexture"}) ||
        IsIn(method, {"GetTemporaryRTArray", "HasProperty", "RenderTargetIdentifier"});
    return isFirst ? std::optional<std::size_t>(0) : std::nullopt;
}

void MarkPropertyIds(const CSharpFiles& files)
{
    PropertyIdFinder(files).Run();
}

} // namespace limn
