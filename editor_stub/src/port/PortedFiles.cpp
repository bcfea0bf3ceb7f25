#include "port/PortedCode.h"

#include <algorithm>

namespace limn
{

namespace
{

std::vector<const CSharpClass*> TopLevel(const PortModel& model, PortRole role)
{
    std::vector<const CSharpClass*> classes = model.Of(role);
    std::erase_if(classes, [&](const CSharpClass* one) { return model.OuterOf(*one) != nullptr; });
    return classes;
}

} // namespace

std::string PortedHeader(PortedCode& code, const std::vector<std::string>& sources)
{
    PortModel& model = code.model();
    code.text = "#pragma once\n\n#include <limn/core/ComputeShader.h>\n#include "
                "<limn/core/Mathf.h>\n#include <limn/core/RenderGraph.h>\n"
                "#include <limn/core/ScriptableRenderer.h>\n#include <limn/limn.h>\n\n";
    std::string from;
    for (const std::string& source : sources)
    {
        from += (from.empty() ? "" : ", ") + source;
    }
    code.Line("// Begun by `limn port` from " + from + "; PORTING.md says what is left.");
    code.Line();
    code.Line("namespace " + model.name() + "Plugin");
    code.Line("{");
    code.Line();
    code.Line("using namespace limn;");
    code.Line();
    for (const CSharpClass* pass : TopLevel(model, PortRole::Pass))
    {
        code.Line("class " + model.ClassName(*pass) + ";");
    }
    std::vector<const CSharpClass*> types = TopLevel(model, PortRole::Enum);
    std::ranges::copy(TopLevel(model, PortRole::Data), std::back_inserter(types));
    std::ranges::copy(TopLevel(model, PortRole::Context), std::back_inserter(types));
    WriteTypes(code, types);
    for (const CSharpClass* component : TopLevel(model, PortRole::Component))
    {
        WriteComponent(code, *component);
        code.Line();
    }
    for (const CSharpClass* feature : TopLevel(model, PortRole::Feature))
    {
        WriteFeature(code, *feature);
        code.Line();
    }
    code.Line("} // namespace " + model.name() + "Plugin");
    return std::move(code.text);
}

std::string PortedSource(PortedCode& code)
{
    PortModel& model = code.model();
    const auto features = TopLevel(model, PortRole::Feature);
    code.text =
        "#include \"" + features.front()->name + ".h\"\n\n#include <limn/features/Plugin.h>\n\n";
    code.Line("namespace " + model.name() + "Plugin");
    code.Line("{");
    code.Line();
    for (const CSharpClass* one : model.classes())
    {
        const CSharpClass* outer = model.OuterOf(*one);
        const PortRole role = model.RoleOf(*one);
        const bool isNested = outer && (role == PortRole::Component || role == PortRole::Feature);
        if ((model.isLeftOut(*one) || isNested) && !(outer && model.isLeftOut(*outer)))
        {
            code.Todo("limn has nothing of this kind: " + one->keyword + " " + one->name,
                      model.Place(*one, one->location), TextOf(model.FileOf(*one), one->words));
            code.Line();
        }
    }
    for (const CSharpClass* pass : model.Of(PortRole::Pass))
    {
        if (!model.isLeftOut(*pass))
        {
            WritePass(code, *pass);
        }
    }
    for (const CSharpClass* feature : features)
    {
        WriteFeatureMethods(code, *feature);
    }
    code.Line("} // namespace " + model.name() + "Plugin");
    code.Line();
    code.Open("LIMN_PLUGIN(features, components)");
    for (const CSharpClass* feature : features)
    {
        code.Line("features.Register<" + model.name() + "Plugin::" + model.ClassName(*feature) +
                  ">(\"" + RegisteredName(*feature) + "\");");
    }
    for (const CSharpClass* component : TopLevel(model, PortRole::Component))
    {
        code.Line("components.Register<" + model.name() + "Plugin::" + model.ClassName(*component) +
                  ">(\"" + RegisteredName(*component) + "\");");
    }
    code.Close();
    return std::move(code.text);
}

} // namespace limn
