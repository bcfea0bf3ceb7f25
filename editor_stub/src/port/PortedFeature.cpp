#include "console/Texts.h"
#include "port/PortLiteral.h"
#include "port/PortMember.h"
#include "port/PortedBody.h"

#include <algorithm>
#include <limn/features/Features.h>

namespace limn
{

namespace
{

const CSharpClass* PassOf(const PortModel& model, const CSharpField& field)
{
    const CSharpClass* own = model.FindPlain(field.type);
    const bool isOne = own && model.RoleOf(*own) == PortRole::Pass && !model.isLeftOut(*own);
    return isOne ? own : nullptr;
}

/// Writes the constructor of a feature, which makes the passes that are there from the beginning.
void WriteFeatureConstructor(PortedCode& code, const CSharpClass& one)
{
    const PortModel& model = code.model();
    const std::string className = model.ClassName(one);
    const PortScope none;
    std::vector<std::string> lines;
    for (const CSharpField& field : one.fields)
    {
        const CSharpClass* pass = field.value.empty() ? nullptr : PassOf(model, field);
        const auto arguments = pass ? NewArguments(field.value) : std::nullopt;
        std::string problem;
        const auto making =
            arguments ? MakePass({model, none, true}, *pass, *arguments, problem) : std::nullopt;
        if (making)
        {
            lines.push_back(model.CppName(field.name) + " = " + *making + ";");
            code.Make(model.CppName(field.name));
        }
    }
    if (lines.empty())
    {
        code.Line(className + "::" + className + "() = default;");
        return;
    }
    code.Open(className + "::" + className + "()");
    std::ranges::for_each(lines, [&](const std::string& line) { code.Line(line); });
    code.Close();
}

/// Writes the bodies of the methods that C++ has.
void WriteBodies(PortedCode& code, const CSharpClass& one)
{
    const PortModel& model = code.model();
    for (const CSharpMethod& method : one.methods)
    {
        const auto signature = SignatureOf(model, one, method);
        code.Line();
        if (!signature || !model.isDeclared(method))
        {
            code.TodoBody(method.name, one, method);
            continue;
        }
        const std::size_t begin = code.text.size();
        code.Open(signature->Text(model.ClassName(one) + "::"));
        PortedBody(code, one, method).Write();
        code.Close();
        code.TrimUnused(begin);
    }
}

} // namespace

std::string RegisteredName(const CSharpClass& one)
{
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFeatures(features, components);
    const bool isTaken =
        components.Find(one.name) != nullptr || features.Create(one.name) != nullptr;
    return one.name + (isTaken ? "Port" : "");
}

void WriteFeature(PortedCode& code, const CSharpClass& one)
{
    const PortContext context(code.model(), one);
    PortModel& model = code.model();
    code.Line("/// C#: " + model.Place(one, one.location) + ".");
    code.Open("class " + model.ClassName(one) + " final : public ScriptableRendererFeature");
    code.Label("public:");
    for (const CSharpClass& inner : one.classes)
    {
        if (model.RoleOf(inner) == PortRole::Pass && !model.isLeftOut(inner))
        {
            code.Line("class " + model.ClassName(inner) + ";");
        }
    }
    WriteTypes(code, NestedIn(one));
    PortScope scope;
    for (const CSharpField& field : one.fields)
    {
        if (const CSharpClass* pass = PassOf(model, field))
        {
            code.Line("Owned<" + model.QualifiedName(*pass) + "> " + model.CppName(field.name) +
                      ";");
            model.Declare(field);
        }
        else
        {
            WriteField(code, one, field, scope);
        }
    }
    code.Line();
    const std::string className = model.ClassName(one);
    code.Line(className + "();");
    code.Line("~" + className + "() override;");
    code.Line();
    for (const auto& [name, otherwise] :
         {std::pair("Create", "void Create() override {} // TODO: the C# has none"),
          std::pair("AddRenderPasses",
                    "void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}")})
    {
        const CSharpMethod* method = one.FindMethod(name);
        if (!method || !SignatureOf(model, one, *method))
        {
            code.Line(otherwise);
        }
    }
    WriteUsing(code, one);
    std::set<std::string> signatures;
    for (const CSharpMethod& method : one.methods)
    {
        const auto signature = SignatureOf(model, one, method);
        if (signature && !method.isConstructor() &&
            signatures.insert(signature->name + signature->parameters).second)
        {
            code.Line((method.isStatic ? "static " : "") +
                      Replaced(signature->Text(), "[[maybe_unused]] ", "") + ";");
            model.Declare(method);
        }
    }
    WriteDescription(code, one);
    code.Close("};");
    model.Declare(one);
}

void WriteFeatureMethods(PortedCode& code, const CSharpClass& one)
{
    const PortContext context(code.model(), one);
    PortModel& model = code.model();
    const std::string className = model.ClassName(one);
    WriteFeatureConstructor(code, one);
    code.Line(className + "::~" + className + "() = default;");
    // A pass that no method makes is nothing, so that no line may use it.
    PortedCode trial(model);
    WriteBodies(trial, one);
    for (const CSharpField& field : one.fields)
    {
        const std::string name = model.CppName(field.name);
        if (PassOf(model, field) && !trial.isMade(name) && !code.isMade(name))
        {
            model.Withdraw(field);
        }
    }
    WriteBodies(code, one);
    code.Line();
}

} // namespace limn
