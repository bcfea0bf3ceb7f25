#include "port/PortedGraph.h"

#include <algorithm>

namespace limn
{

GraphPassCall ReadGraphPass(CSharpWords head)
{
    const CSharpToken* const end = head.data() + head.size();
    const auto call = std::ranges::find_if(head, [](const CSharpToken& word)
                                           { return !GraphContextOf(word.text).empty(); });
    GraphPassCall read;
    read.name = call->text;
    read.location = call->location;
    const CSharpToken* open = &*call + 1;
    const std::string generics = open < end && open->Is("<") ? ReadCSharpGenerics(open) : "";
    if (open < end && open->Is("("))
    {
        read.arguments = SplitArguments(open->Inside());
    }
    const CSharpWords out = read.arguments.size() > 1 ? read.arguments[1] : CSharpWords();
    const bool isOut = out.size() > 2 && out[0].Is("out");
    const CSharpToken* type = isOut ? &out[1] : nullptr;
    const std::string declared = isOut ? ReadCSharpType(type) : "";
    read.data = generics.size() > 2 ? generics.substr(1, generics.size() - 2)
                : declared != "var" ? declared
                                    : "";
    read.dataName = isOut ? out.back().text : "";
    const CSharpToken* name = head.data();
    const bool isDeclared =
        !ReadCSharpType(name).empty() && name + 1 < end && name->isName() && name[1].Is("=");
    read.builder = isDeclared ? name->text : "";
    read.isWhole = isDeclared && !declared.empty() && &*call - name > 3;
    read.graph = read.isWhole ? CSharpWords(name + 2, &*call - 1) : CSharpWords();
    return read;
}

RenderFunction ReadRenderFunction(CSharpWords words)
{
    RenderFunction read;
    const CSharpToken* open = words.data();
    const CSharpToken* const end = open + words.size();
    if (open < end && open->Is("<"))
    {
        ReadCSharpGenerics(open);
    }
    if (open >= end || !open->Is("(") || open->Inside().empty())
    {
        read.problem = "'SetRenderFunc' of this";
        return read;
    }
    CSharpWords function = open->Inside();
    function = function.subspan(function.front().Is("static") ? 1 : 0);
    read.isGroup = function.size() == 1;
    read.parameters = {"data", "context"};
    read.body = function;
    if (read.isGroup)
    {
        return read;
    }
    const CSharpToken* const last = function.data() + function.size();
    const CSharpToken* const arrow = function.empty() ? last : function.front().Behind();
    const auto parameters = arrow < last && function.front().Is("(")
                                ? SplitArguments(function.front().Inside())
                                : std::vector<CSharpWords>();
    if (parameters.size() != 2 || parameters[0].empty() || parameters[1].empty() ||
        !arrow->Is("=>") || arrow + 1 == last)
    {
        read.problem = "a function of two parameters is expected";
        return read;
    }
    read.parameters = {std::string(parameters[0].back().text),
                       std::string(parameters[1].back().text)};
    read.isBlock = arrow[1].Is("{");
    read.body = read.isBlock ? arrow[1].Inside() : CSharpWords(arrow + 1, last);
    return read;
}

std::string BuilderTypeOf(std::string_view call)
{
    return call == "AddRasterRenderPass" ? "IRasterRenderGraphBuilder"
           : call == "AddUnsafePass"     ? "IUnsafeRenderGraphBuilder"
                                         : "IComputeRenderGraphBuilder";
}

std::string CaptureOf(const CSharpClass& one, const PortScope& scope, CSharpWords body,
                      const std::set<std::string>& own)
{
    bool hasLocals = false;
    bool hasMembers = false;
    for (std::size_t i = 0; i < body.size(); ++i)
    {
        const std::string name(body[i].text);
        if (!body[i].isName() ||
            (i > 0 && body[i - 1].Is(".") && !(i > 1 && body[i - 2].Is("this"))) ||
            own.contains(name))
        {
            continue;
        }
        const CSharpField* field = one.FindField(name);
        const CSharpMethod* method = one.FindMethod(name);
        hasMembers = hasMembers || (field && !field->isStatic) || (method && !method->isStatic) ||
                     name == "this";
        hasLocals = hasLocals || (!field && scope.contains(name));
    }
    return hasLocals ? hasMembers ? "[=, this]" : "[=]" : hasMembers ? "[this]" : "[]";
}

void NoteGraphPasses(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    const PortModel& model = code.model();
    for (const CSharpToken& word : method.body)
    {
        if (!GraphContextOf(word.text).empty())
        {
            code.Done({"graph pass", one.name + "." + std::string(word.text), "",
                       model.Place(one, word.location), false});
        }
    }
}

} // namespace limn
