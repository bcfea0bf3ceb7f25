#include "port/PortModel.h"

namespace limn
{

namespace
{

constexpr int k_MaxRounds = 20; ///< from a field to a parameter to a field ...

/// Returns whether Unity's method takes a property's number first.
bool TakesProperty(std::string_view method)
{
    return StartsWithAny(method,
                         {"SetGlobal", "SetFloat", "SetInt", "SetVector", "SetColor", "SetTexture",
                          "SetMatrix", "SetBuffer", "SetConstantBuffer", "GetFloat", "GetInt",
                          "GetVector", "GetColor", "GetMatrix", "GetTexture"}) ||
           IsIn(method, {"GetTemporaryRT", "GetTemporaryRTArray", "ReleaseTemporaryRT",
                         "HasProperty", "RenderTargetIdentifier"});
}

/// The type with a property's number in place of int; "" where it holds no int.
std::string IdType(const std::string& type)
{
    return type == "int"         ? k_PropertyIdType
           : type == "int[]"     ? std::string(k_PropertyIdType) + "[]"
           : type == "List<int>" ? "List<" + std::string(k_PropertyIdType) + ">"
                                 : "";
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
            for (CSharpMethod& method : one.methods)
            {
                m_Methods.emplace(method.name, &method);
            }
            Collect(one.classes);
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

    /// The type of a name in a method; null where it is none of a field or parameter.
    std::string* TypeOf(std::string_view name, CSharpClass& one, CSharpMethod* method)
    {
        for (std::size_t i = 0; method && i < method->parameters.size(); ++i)
        {
            if (method->parameters[i].name == name)
            {
                return &method->parameters[i].type;
            }
        }
        const auto found = one.fieldNames.find(name);
        return found == one.fieldNames.end() ? nullptr : &one.fields[found->second].type;
    }

    /// Returns whether a property's number begins there: Shader.PropertyToID(...), or a name of
    /// such.
    bool isProperty(CSharpWords words, CSharpClass& one, CSharpMethod* method)
    {
        words = words.size() > 2 && words[0].Is("this") ? words.subspan(2) : words;
        if (words.size() > 3 && words[1].Is(".") && words[2].Is("PropertyToID"))
        {
            return words[0].Is("Shader");
        }
        const bool isAlone =
            words.size() == 1 || (words.size() > 1 && IsIn(words[1].text, {";", ",", ")"}));
        const std::string* type =
            isAlone && words[0].isName() ? TypeOf(words[0].text, one, method) : nullptr;
        return type && *type == k_PropertyIdType;
    }

    /// name = ..., name[i] = ... at a word.
    void LookAtAssignment(CSharpClass& one, CSharpMethod& method, std::size_t at)
    {
        const CSharpWords words = method.body.subspan(at);
        const bool isElement = words.size() > 1 && words[1].Is("[");
        const std::size_t equals = isElement ? words[1].Inside().size() + 3 : 1;
        if (!words[0].isName() || equals + 1 >= words.size() || !words[equals].Is("="))
        {
            return;
        }
        const bool isThis = at > 1 && method.body[at - 1].Is(".") && method.body[at - 2].Is("this");
        std::string* type = TypeOf(words[0].text, one, isThis ? nullptr : &method);
        if (type && isProperty(words.subspan(equals + 1), one, &method))
        {
            Mark(*type);
        }
        const bool isFromName = words.size() > equals + 2 && words[equals + 2].Is(";");
        std::string* from = isFromName ? TypeOf(words[equals + 1].text, one, &method) : nullptr;
        if (type && from && *type == k_PropertyIdType)
        {
            Mark(*from);
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
        if (TakesProperty(words[0].text) && arguments[0].size() == 1 && arguments[0][0].isName())
        {
            if (std::string* type = TypeOf(arguments[0][0].text, one, &method))
            {
                Mark(*type);
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
    std::multimap<std::string_view, CSharpMethod*> m_Methods;
    bool m_HasChanged = true;
};

} // namespace

void MarkPropertyIds(const CSharpFiles& files)
{
    PropertyIdFinder(files).Run();
}

} // namespace limn
