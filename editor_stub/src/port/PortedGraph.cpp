#include "port/PortedCode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// A call of AddRasterRenderPass, AddUnsafePass or AddComputePass with the block of its builder:
/// renderGraph.AddRasterRenderPass<PassData>("Name", out var passData).
struct GraphPass
{
    std::string call; ///< "AddRasterRenderPass"
    SourceLocation location;
    CSharpWords name;      ///< the first argument; empty where there is none
    std::string problem;   ///< why the rest is not known; "" if it is known
    std::string graph;     ///< "renderGraph"
    std::string data;      ///< the type of the pass's data
    std::string dataName;  ///< "passData"
    CSharpWords sampler;   ///< the third argument; empty where there is none
    std::string builder;   ///< the builder's name
    CSharpWords body;      ///< the words behind the call, until the builder's scope ends
    std::size_t begin = 0; ///< where its statement begins in the file's text
    std::size_t end = 0;   ///< the place behind its statement
};

/// A call builder.SetRenderFunc(...) in a body.
struct RenderFunction
{
    std::vector<std::string> parameters; ///< two, or none if they are not known
    CSharpWords body;                    ///< the function's body; for `{ ... }` without the braces
    SourceLocation location;
    std::size_t begin = 0; ///< where the statement begins in the file's text
    std::size_t end = 0;   ///< the place behind its ;
};

using Word = const CSharpToken*;

/// Reads `out var data` or `out T data`.
/// @return its type; "" where it is none
std::string ReadOut(CSharpWords argument)
{
    if (argument.size() < 3 || !argument.front().Is("out"))
    {
        return "";
    }
    Word at = &argument[1];
    const std::string type = ReadCSharpType(at);
    return at == &argument.back() && at->isName() ? type : "";
}

/// Reads `var builder = graph.AddX<T>(name, out var data, sampler)`, and without the <T> where a T
/// stands behind `out`.
/// @return behind its last bracket; null where it is none, which the pass's problem then says
Word ReadCall(GraphPass& pass, Word at)
{
    pass.problem = "'var builder = renderGraph." + pass.call +
                   "<PassData>(name, out var passData)' is expected";
    const bool isDeclared = !ReadCSharpType(at).empty() && at->isName() && at[1].Is("=");
    if (!isDeclared)
    {
        return nullptr;
    }
    pass.builder = at->text;
    at += 2;
    if (!at->isName() || !at[1].Is(".") || GraphContextOf(at[2].text).empty())
    {
        return nullptr;
    }
    pass.graph = at->text;
    at += 3;
    const std::string generics = at->Is("<") ? ReadCSharpGenerics(at) : "";
    if (!at->Is("("))
    {
        return nullptr;
    }
    const auto arguments = SplitArguments(at->Inside());
    const std::string type = arguments.size() > 1 ? ReadOut(arguments[1]) : "";
    pass.data = generics.size() > 2 ? generics.substr(1, generics.size() - 2) : type;
    if (type.empty() || pass.data == "var")
    {
        return nullptr;
    }
    pass.dataName = arguments[1].back().text;
    pass.sampler = arguments.size() > 2 ? arguments[2] : CSharpWords();
    pass.problem.clear();
    return at->Behind();
}

/// `using (call) { ... }` or `using call; ...` at `at`.
/// @param end  of the block that it stands in
void ReadUsing(GraphPass& pass, Word at, Word end)
{
    const bool hasBlock = at[1].Is("(");
    const Word call = ReadCall(pass, at + (hasBlock ? 2 : 1));
    if (!call)
    {
        return;
    }
    const bool ends = hasBlock ? call + 1 == at[1].Behind() : call->Is(";");
    Word body = call + 1;
    if (!ends || (hasBlock && !body->Is("{")))
    {
        pass.problem = "one builder in a 'using' of its own is expected";
        return;
    }
    const Word last = hasBlock ? body->Behind() - 1 : end;
    pass.body = {hasBlock ? body + 1 : body, last};
    pass.begin = at->offset;
    pass.end = hasBlock ? last->offset + 1 : last->offset;
}

/// Returns the name and the location of a call, whether or not the rest can be read.
GraphPass PassAt(Word word, Word end)
{
    GraphPass pass;
    pass.call = word->text;
    pass.location = word->location;
    pass.problem = "it stands under a condition, in a loop or without 'using'";
    for (Word open = word; open < end && !open->Is(";"); ++open)
    {
        if (open->Is("(") && !open->Inside().empty())
        {
            pass.name = SplitArguments(open->Inside()).front();
            break;
        }
    }
    return pass;
}

RenderFunction ReadFunction(CSharpWords words)
{
    RenderFunction function;
    function.location = words.front().location;
    function.body = words;
    Word at = words.data() + (words.front().Is("static") ? 1 : 0);
    const Word end = words.data() + words.size();
    if (at == end || !at->Is("(") || at->Behind() >= end || !at->Behind()->Is("=>"))
    {
        return function;
    }
    for (const CSharpWords& parameter : SplitArguments(at->Inside()))
    {
        function.parameters.emplace_back(parameter.empty() ? "" : parameter.back().text);
    }
    if (function.parameters.size() != 2)
    {
        function.parameters.clear();
        return function;
    }
    at = at->Behind() + 1;
    const bool isBlock = at < end && at->Is("{") && at->Behind() == end;
    function.body = isBlock ? at->Inside() : CSharpWords(at, end);
    return function;
}

/// Returns the graph passes of a method in their order. A pass under a condition or in a loop has a
/// problem.
std::vector<GraphPass> FindGraphPasses(const CSharpMethod& method)
{
    std::vector<GraphPass> passes;
    const Word end = method.body.data() + method.body.size();
    Word statement = nullptr; ///< a `using` outside of all brackets
    Word statementEnd = nullptr;
    Word outer = method.body.data(); ///< the next word outside of all brackets
    for (Word at = method.body.data(); at < end; ++at)
    {
        if (at == outer)
        {
            outer = at->Behind();
            if (at->Is("using"))
            {
                statement = at;
                statementEnd = at[1].Behind();
                while (statementEnd < end && !at[1].Is("(") && !statementEnd->Is(";"))
                {
                    statementEnd = statementEnd->Behind();
                }
            }
        }
        if (!GraphContextOf(at->text).empty())
        {
            passes.push_back(PassAt(at, end));
            if (statement && at < statementEnd)
            {
                ReadUsing(passes.back(), statement, end);
                statement = nullptr;
            }
        }
    }
    return passes;
}

/// Returns the render functions among the statements of the pass's body.
std::vector<RenderFunction> FindRenderFunctions(const GraphPass& pass)
{
    std::vector<RenderFunction> functions;
    const Word end = pass.body.data() + pass.body.size();
    for (Word at = pass.body.data(); at < end; at = at->Behind())
    {
        if (end - at < 5 || !at->Is(pass.builder) || !at[1].Is(".") || !at[2].Is("SetRenderFunc"))
        {
            continue;
        }
        Word open = at + 3;
        if (open->Is("<"))
        {
            ReadCSharpGenerics(open);
        }
        if (open->Is("(") && !open->Inside().empty())
        {
            functions.push_back(ReadFunction(open->Inside()));
            const Word last = open->Behind();
            functions.back().begin = at->offset;
            functions.back().end = last->Is(";") ? last->offset + 1 : 0;
        }
    }
    return functions;
}

/// Returns the words of each statement like `builder.AllowPassCulling(false);`, whose argument is
/// true or false.
std::vector<CSharpWords> FindSwitches(const GraphPass& pass)
{
    std::vector<CSharpWords> switches;
    const Word end = pass.body.data() + pass.body.size();
    for (Word at = pass.body.data(); at < end; at = at->Behind())
    {
        const bool isStatement = at == pass.body.data() || IsIn(at[-1].text, {";", "}", "{"});
        const bool isSwitch =
            isStatement && end - at > 6 && at->Is(pass.builder) && at[1].Is(".") && at[3].Is("(") &&
            at[5].Is(")") && (at[4].Is("true") || at[4].Is("false")) && at[6].Is(";") &&
            (IsIn(at[2].text,
                  {"AllowPassCulling", "AllowGlobalStateModification", "UseAllGlobalTextures"}) ||
             (at[2].Is("EnableAsyncCompute") && pass.call == "AddComputePass"));
        if (isSwitch)
        {
            switches.push_back({at, at + 6});
        }
    }
    return switches;
}

void NotePass(PortedCode& code, const CSharpClass& one, const GraphPass& pass)
{
    const PortModel& model = code.model();
    code.Done({"graph pass", one.name + "." + pass.call, model.Text(one, pass.name),
               model.Place(one, pass.location), pass.problem.empty()});
}

/// One method with the passes that it adds.
class GraphMethodWriter
{
public:
    GraphMethodWriter(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
        : m_Code(code),
          m_Model(code.model()),
          m_File(*one.file),
          m_One(one),
          m_Method(method),
          m_Scope(ScopeOf(m_Model, one, method))
    {
    }

    /// The method's C# as comments, and in its place each pass that is understood.
    void Write(std::vector<GraphPass> passes)
    {
        const std::string_view body = BodyText(m_File, m_Method);
        std::size_t at = static_cast<std::size_t>(body.data() - m_File.text.data());
        const std::size_t end = at + body.size();
        for (GraphPass& pass : passes)
        {
            Understand(pass);
            if (pass.problem.empty())
            {
                WriteText(at, pass.begin);
                WritePass(pass);
                at = pass.end;
            }
            NotePass(m_Code, m_One, pass);
        }
        WriteText(at, end);
        for (const GraphPass& pass : passes)
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
    void Understand(GraphPass& pass)
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
            pass.problem =
                "its name, '" + m_Model.Text(m_One, pass.name) + "', is not known before it runs";
        }
    }

    std::optional<std::string> Name(const GraphPass& pass) const
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
            value = body.subspan(i + 2);
            value = {value.begin(),
                     std::ranges::find(value, std::string_view(";"), &CSharpToken::text)};
        }
        return value;
    }

    /// ", profilingSampler"; "" where it is not known, as it changes nothing.
    std::string SamplerText(const GraphPass& pass) const
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
    std::string TypeOf(const GraphPass& pass) const
    {
        const std::string type = *m_Model.CppType(pass.data);
        const std::string owner = m_Model.QualifiedName(m_One) + "::";
        return type.starts_with(owner) ? type.substr(owner.size()) : type;
    }

    /// C# between passes.
    void WriteText(std::size_t begin, std::size_t end)
    {
        const std::string_view text = std::string_view(m_File.text).substr(begin, end - begin);
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        if (first != std::string_view::npos)
        {
            const std::string_view before = std::string_view(m_File.text).substr(0, begin + first);
            const auto line = 1 + std::ranges::count(before, '\n');
            m_Code.Todo("port", m_Model.Place(m_One, {static_cast<int>(line)}), text);
        }
    }

    void WritePass(const GraphPass& pass)
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
        WriteFunction(pass, builder, functions.size() == 1 ? functions[0] : RenderFunction());
        m_Code.Close();
    }

    /// The pass's C# without the one function that stands below it.
    std::string TextWithout(const GraphPass& pass,
                            const std::vector<RenderFunction>& functions) const
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

    void WriteFunction(const GraphPass& pass, const std::string& builder,
                       const RenderFunction& function)
    {
        const std::string context = GraphContextOf(pass.call);
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
        return std::ranges::count(m_Method.parameters, name, &CSharpParameter::name) > 0;
    }

    /// The pass's own function that does it all: Draw of `(data, context) => Draw(data, context)`
    /// and of `Draw`. "" = there is none in C++.
    std::string OwnCall(const GraphPass& pass, const RenderFunction& function,
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
        const std::string_view name = words[0].text;
        const CSharpMethod* method = m_One.FindMethod(name);
        const bool fits =
            method && std::ranges::count(m_One.methods, name, &CSharpMethod::name) == 1 &&
            method->isStatic && method->parameters.size() == 2 &&
            method->parameters[0].type == pass.data && method->parameters[1].type == context;
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
    std::vector<GraphPass> passes = FindGraphPasses(method);
    if (passes.empty())
    {
        return false;
    }
    GraphMethodWriter(code, one, method).Write(std::move(passes));
    return true;
}

void NoteGraphPasses(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    for (GraphPass& pass : FindGraphPasses(method))
    {
        pass.problem = "it stays a comment";
        NotePass(code, one, pass);
    }
}

} // namespace limn
