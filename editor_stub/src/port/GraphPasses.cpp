#include "port/GraphPasses.h"
#include "port/csharp/CSharpTokens.h"

namespace limn
{

namespace
{

using Word = const CSharpToken*;

bool AddsGraphPass(const CSharpToken& word)
{
    return word.Is("AddRasterRenderPass") || word.Is("AddUnsafePass") || word.Is("AddComputePass");
}

Word Behind(Word word)
{
    return word->match > 0 ? word + word->match + 1 : word + 1;
}

struct OutArgument
{
    std::string type; ///< "var"
    std::string name; ///< "" = it is none
};

/// `out var data` or `out T data`.
OutArgument ReadOut(CSharpWords argument)
{
    if (argument.size() < 3 || !argument.front().Is("out"))
    {
        return {};
    }
    Word at = &argument[1];
    std::string type = ReadCSharpType(at);
    const bool isName = !type.empty() && at == &argument.back() && at->isName();
    return isName ? OutArgument{std::move(type), std::string(at->text)} : OutArgument();
}

/// Reads `var builder = graph.AddX<T>(name, out var data, sampler)`, and without the <T> where a T
/// stands behind `out`.
/// @return behind its last bracket; null where it is none, which the pass's problem then says
Word ReadCall(CSharpGraphPass& pass, Word at)
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
    if (!at->isName() || !at[1].Is(".") || !AddsGraphPass(at[2]))
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
    const auto arguments =
        SplitArguments({at + 1, static_cast<std::size_t>(at->match > 0 ? at->match - 1 : 0)});
    const OutArgument data = arguments.size() > 1 ? ReadOut(arguments[1]) : OutArgument();
    pass.data = generics.size() > 2 ? generics.substr(1, generics.size() - 2) : data.type;
    pass.dataName = data.name;
    if (pass.dataName.empty() || pass.data == "var")
    {
        return nullptr;
    }
    pass.sampler = arguments.size() > 2 ? arguments[2] : CSharpWords();
    pass.problem.clear();
    return Behind(at);
}

/// `using (call) { ... }` or `using call; ...` at `at`.
/// @param end  of the block that it stands in
void ReadUsing(CSharpGraphPass& pass, Word at, Word end)
{
    const bool hasBlock = at[1].Is("(");
    const Word call = ReadCall(pass, at + (hasBlock ? 2 : 1));
    if (!call)
    {
        return;
    }
    const bool ends = hasBlock ? call == at + 1 + at[1].match : call->Is(";");
    Word body = call + 1;
    if (!ends || (hasBlock && !body->Is("{")))
    {
        pass.problem = "one builder in a 'using' of its own is expected";
        return;
    }
    const Word last = hasBlock ? body + body->match : end;
    pass.body = {hasBlock ? body + 1 : body, last};
    pass.begin = at->offset;
    pass.end = hasBlock ? last->offset + 1 : last->offset;
}

/// Returns the name and the location of a call, whether or not the rest can be read.
CSharpGraphPass PassAt(Word word, Word end)
{
    CSharpGraphPass pass;
    pass.call = word->text;
    pass.location = word->location;
    pass.problem = "it stands under a condition, in a loop or without 'using'";
    for (Word open = word; open < end && !open->Is(";"); ++open)
    {
        if (open->Is("(") && open->match > 1)
        {
            pass.name = SplitArguments({open + 1, open + open->match}).front();
            break;
        }
    }
    return pass;
}

bool IsCallOf(Word at, const std::string& object, Word end)
{
    return end - at > 4 && at->Is(object) && at[1].Is(".") && at[2].isName() && at[3].Is("(") &&
           at[3].match > 0;
}

CSharpRenderFunction ReadFunction(CSharpWords words)
{
    CSharpRenderFunction function;
    function.location = words.front().location;
    function.body = words;
    Word at = words.data() + (words.front().Is("static") ? 1 : 0);
    const Word end = words.data() + words.size();
    if (at == end || !at->Is("(") || at->match <= 0 || Behind(at) >= end || !Behind(at)->Is("=>"))
    {
        return function;
    }
    for (const CSharpWords& parameter : SplitArguments({at + 1, at + at->match}))
    {
        function.parameters.emplace_back(parameter.empty() ? "" : parameter.back().text);
    }
    if (function.parameters.size() != 2)
    {
        function.parameters.clear();
        return function;
    }
    at = Behind(at) + 1;
    const bool isBlock = at < end && at->Is("{") && Behind(at) == end;
    function.body = {isBlock ? at + 1 : at, isBlock ? end - 1 : end};
    return function;
}

} // namespace

std::vector<CSharpGraphPass> FindGraphPasses(const CSharpMethod& method)
{
    std::vector<CSharpGraphPass> passes;
    const Word end = method.body.data() + method.body.size();
    Word statement = nullptr; ///< a `using` outside of all brackets
    Word statementEnd = nullptr;
    Word outer = method.body.data(); ///< the next word outside of all brackets
    for (Word at = method.body.data(); at < end; ++at)
    {
        if (at == outer)
        {
            outer = Behind(at);
            if (at->Is("using"))
            {
                statement = at;
                statementEnd = at[1].Is("(") ? Behind(at + 1) : at + 1;
                while (statementEnd < end && !at[1].Is("(") && !statementEnd->Is(";"))
                {
                    statementEnd = Behind(statementEnd);
                }
            }
        }
        if (AddsGraphPass(*at))
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

std::vector<CSharpRenderFunction> FindRenderFunctions(const CSharpGraphPass& pass)
{
    std::vector<CSharpRenderFunction> functions;
    const Word end = pass.body.data() + pass.body.size();
    for (Word at = pass.body.data(); at < end; at = Behind(at))
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
        if (open->Is("(") && open->match > 1)
        {
            functions.push_back(ReadFunction({open + 1, open + open->match}));
            const Word last = open + open->match + 1;
            functions.back().begin = at->offset;
            functions.back().end = last->Is(";") ? last->offset + 1 : 0;
        }
    }
    return functions;
}

std::vector<CSharpWords> FindSwitches(const CSharpGraphPass& pass)
{
    std::vector<CSharpWords> switches;
    const Word end = pass.body.data() + pass.body.size();
    for (Word at = pass.body.data(); at < end; at = Behind(at))
    {
        const bool isStatement = at == pass.body.data() || IsIn(at[-1].text, {";", "}", "{"});
        const bool isSwitch = isStatement && IsCallOf(at, pass.builder, end) && at[3].match == 2 &&
                              (at[4].Is("true") || at[4].Is("false")) && at[6].Is(";") &&
                              (IsIn(at[2].text, {"AllowPassCulling", "AllowGlobalStateModification",
                                                 "UseAllGlobalTextures"}) ||
                               (at[2].Is("EnableAsyncCompute") && pass.call == "AddComputePass"));
        if (isSwitch)
        {
            switches.push_back({at, at + 6});
        }
    }
    return switches;
}

} // namespace limn
