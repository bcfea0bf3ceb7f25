#include "port/GraphPasses.h"
#include "port/PortedCode.h"
#include "port/csharp/CSharpTokens.h"

#include <algorithm>

namespace limn
{

namespace
{

std::string ContextOf(const std::string& call)
{
    return call == "AddUnsafePass"    ? "UnsafeGraphContext"
           : call == "AddComputePass" ? "ComputeGraphContext"
                                      : "RasterGraphContext";
}

/// One method with the passes that it adds.
class GraphMethodWriter
{
public:
    GraphMethodWriter(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
        : m_Code(code),
          m_Model(code.model()),
          m_File(m_Model.FileOf(one)),
          m_One(one),
          m_Method(method),
          m_Scope(ScopeOf(m_Model, one, method))
    {
    }

    /// The method's C# as comments, and in its place each pass that is understood.
    void Write(std::vector<CSharpGraphPass> passes)
    {
        const std::string_view body = BodyText(m_File, m_Method);
        std::size_t at = static_cast<std::size_t>(body.data() - m_File.text.data());
        const std::size_t end = at + body.size();
        for (CSharpGraphPass& pass : passes)
        {
            Understand(pass);
            if (pass.problem.empty())
            {
                WriteText(at, pass.begin);
                WritePass(pass);
                at = pass.end;
            }
            Note(pass);
        }
        WriteText(at, end);
        for (const CSharpGraphPass& pass : passes)
        {
            if (!pass.problem.empty())
            {
                m_Code.Line("// TODO " + m_Model.Place(m_One, pass.location) + ": the pass of " +
                            pass.call + " is not begun: " + pass.problem);
            }
        }
    }

private:
    /// Gives a pass the problem that it has in C++.
    void Understand(CSharpGraphPass& pass)
    {
        if (!pass.problem.empty())
        {
            return;
        }
        const bool isGraph = std::ranges::any_of(
            m_Method.parameters, [&](const CSharpParameter& parameter)
            { return parameter.name == pass.graph && parameter.type == "RenderGraph"; });
        if (!isGraph)
        {
            pass.problem = "'" + pass.graph + "' is no parameter of type RenderGraph";
        }
        else if (!m_Model.CppType(pass.data))
        {
            pass.problem = "the type '" + pass.data + "' is none of the pass's or file's";
        }
        else if (!Name(pass))
        {
            pass.problem = "its name, '" + std::string(TextOf(m_File, pass.name)) +
                           "', is not known before it runs";
        }
    }

    std::optional<std::string> Name(const CSharpGraphPass& pass) const
    {
        const CSharpWords local = pass.name.size() == 1 ? Local(pass.name[0].text) : CSharpWords();
        const auto name = Translate(m_Model, m_Scope, local.empty() ? pass.name : local, "string");
        return name ? std::optional(name->cpp) : std::nullopt;
    }

    /// Gives what `string name = ...;` in the method says, where no other statement assigns to the
    /// name.
    CSharpWords Local(std::string_view name) const
    {
        const CSharpWords body = m_Method.body;
        CSharpWords value;
        for (std::size_t i = 1; i + 1 < body.size(); ++i)
        {
            if (!body[i].Is(name) || !(body[i + 1].Is("=") || body[i + 1].Is("+=")))
            {
                continue;
            }
            const bool isDeclared = body[i - 1].Is("string") || body[i - 1].Is("var");
            if (!isDeclared || !value.empty())
            {
                return {};
            }
            std::size_t end = i + 2;
            while (end < body.size() && !body[end].Is(";"))
            {
                ++end;
            }
            value = body.subspan(i + 2, end - i - 2);
        }
        return value;
    }

    /// ", profilingSampler"; "" where it is not known, as it changes nothing.
    std::string SamplerText(const CSharpGraphPass& pass) const
    {
        const CSharpWords& words = pass.sampler;
        const bool isBase = !words.empty() && words.back().Is("profilingSampler") &&
                            (words.size() == 1 || (words.size() == 3 && words[0].Is("this")));
        const auto value = isBase || words.empty()
                               ? std::nullopt
                               : Translate(m_Model, m_Scope, words, "ProfilingSampler");
        return isBase ? ", profilingSampler" : value ? ", " + value->cpp : "";
    }

    /// Returns the type of the data, as the pass's class calls it.
    std::string TypeOf(const CSharpGraphPass& pass) const
    {
        const std::string type = *m_Model.CppType(pass.data);
        const std::string owner = m_Model.QualifiedName(m_One) + "::";
        return type.starts_with(owner) ? type.substr(owner.size()) : type;
    }

    void Note(const CSharpGraphPass& pass)
    {
        m_Code.Done({"graph pass", m_One.name + "." + pass.call,
                     std::string(TextOf(m_File, pass.name)), m_Model.Place(m_One, pass.location),
                     pass.problem.empty()});
    }

    /// C# between passes.
    void WriteText(std::size_t begin, std::size_t end)
    {
        const std::string_view text = std::string_view(m_File.text).substr(begin, end - begin);
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        if (first != std::string_view::npos)
        {
            const std::string_view before = std::string_view(m_File.text).substr(0, begin + first);
            SourceLocation location;
            location.line = 1 + static_cast<int>(std::ranges::count(before, '\n'));
            m_Code.Todo("port", m_Model.Place(m_One, location), text);
        }
    }

    void WritePass(const CSharpGraphPass& pass)
    {
        const std::string data = LocalName(m_Model, m_One, pass.dataName);
        const std::string builder = LocalName(m_Model, m_One, pass.builder);
        m_Code.Open();
        m_Code.Line(TypeOf(pass) + "* " + data + " = nullptr;");
        m_Code.Line("auto " + builder + " = " + LocalName(m_Model, m_One, pass.graph) + "." +
                    pass.call + "<" + TypeOf(pass) + ">(" + *Name(pass) + ", " + data +
                    SamplerText(pass) + ");");
        const auto functions = FindRenderFunctions(pass);
        m_Code.Todo("what it holds and declares", m_Model.Place(m_One, pass.location),
                    TextWithout(pass, functions));
        for (const CSharpWords& words : FindSwitches(pass))
        {
            m_Code.Line(builder + "." + std::string(words[2].text) + "(" +
                        std::string(words[4].text) + ");");
        }
        if (functions.size() != 1)
        {
            m_Code.Line(functions.empty() ? "// TODO: no SetRenderFunc stands in its block"
                                          : "// TODO: several SetRenderFunc stand in its block");
        }
        WriteFunction(pass, builder, functions.size() == 1 ? functions[0] : CSharpRenderFunction());
        m_Code.Close();
    }

    /// The pass's C# without the one function that stands below it.
    std::string TextWithout(const CSharpGraphPass& pass,
                            const std::vector<CSharpRenderFunction>& functions) const
    {
        std::string text = m_File.text.substr(pass.begin, pass.end - pass.begin);
        if (functions.size() == 1 && functions[0].end > functions[0].begin)
        {
            const std::size_t end = functions[0].end - pass.begin;
            std::size_t begin = functions[0].begin - pass.begin;
            begin = text.find_last_not_of(" \t\r\n", begin - 1) + 1;
            text.erase(begin, end - begin);
        }
        return text;
    }

    void WriteFunction(const CSharpGraphPass& pass, const std::string& builder,
                       const CSharpRenderFunction& function)
    {
        const std::string context = ContextOf(pass.call);
        const bool isKnown = !function.parameters.empty();
        const auto name = [&](std::size_t i, const char* otherwise)
        {
            const std::string own =
                isKnown ? LocalName(m_Model, m_One, function.parameters[i]) : otherwise;
            const bool isTaken = own == pass.dataName || own == pass.builder || isParameter(own);
            return isTaken || own == "_" ? own + (own == "_" ? otherwise : "_") : own;
        };
        const std::string first = name(0, "data");
        const std::string second = name(1, "context");
        m_Code.Open(builder + ".SetRenderFunc([]([[maybe_unused]] " + TypeOf(pass) + "& " + first +
                    ", [[maybe_unused]] " + context + "& " + second + ")");
        const std::string call = OwnCall(pass, function, context);
        if (!call.empty())
        {
            m_Code.Line(call + "(" + first + ", " + second + ");");
        }
        else if (!function.body.empty())
        {
            m_Code.Todo("port", m_Model.Place(m_One, function.location),
                        TextOf(m_File, function.body));
        }
        m_Code.Close("});");
    }

    bool isParameter(const std::string& name) const
    {
        return std::ranges::any_of(m_Method.parameters, [&](const CSharpParameter& parameter)
                                   { return parameter.name == name; });
    }

    /// The pass's own function that does it all: Draw of `(data, context) => Draw(data, context)`
    /// and of `Draw`. "" = there is none in C++.
    std::string OwnCall(const CSharpGraphPass& pass, const CSharpRenderFunction& function,
                        const std::string& context) const
    {
        CSharpWords words = function.body;
        if (!words.empty() && words.back().Is(";"))
        {
            words = words.first(words.size() - 1);
        }
        const bool isCall = function.parameters.size() == 2 && words.size() == 6 &&
                            words[1].Is("(") && words[2].Is(function.parameters[0]) &&
                            words[3].Is(",") && words[4].Is(function.parameters[1]);
        const bool isGroup = function.parameters.empty() && words.size() == 1;
        if (!isCall && !isGroup)
        {
            return "";
        }
        const auto isNamed = [&](const CSharpMethod& method)
        {
            return method.name == words[0].text;
        };
        const CSharpMethod* method = m_One.FindMethod(words[0].text);
        const bool fits = method && std::ranges::count_if(m_One.methods, isNamed) == 1 &&
                          method->isStatic && method->parameters.size() == 2 &&
                          method->parameters[0].type == pass.data &&
                          method->parameters[1].type == context;
        const auto signature = fits ? SignatureOf(m_Model, m_One, *method) : std::nullopt;
        return signature ? signature->name : "";
    }

    PortedCode& m_Code;
    const PortModel& m_Model;
    const CSharpFile& m_File;
    const CSharpClass& m_One;
    const CSharpMethod& m_Method;
    PortScope m_Scope;
};

} // namespace

bool WriteGraphPasses(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    std::vector<CSharpGraphPass> passes = FindGraphPasses(method);
    if (passes.empty())
    {
        return false;
    }
    GraphMethodWriter(code, one, method).Write(std::move(passes));
    return true;
}

} // namespace limn
