#include "console/Texts.h"
#include "port/PortedCode.h"

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

/// Returns the constructor that the pass has in C++ for this number of arguments, or null.
const CSharpMethod* ConstructorOf(const PortModel& model, const CSharpClass& pass,
                                  std::size_t arguments)
{
    const auto fits = [&](const CSharpMethod& method)
    {
        return method.isConstructor() && !method.isStatic &&
               method.parameters.size() == arguments && SignatureOf(model, pass, method);
    };
    const auto found = std::ranges::find_if(pass.methods, fits);
    return found == pass.methods.end() ? nullptr : &*found;
}

/// The type of a class's parameter, as it is called outside of the class.
std::string TypeIn(const PortModel& model, const CSharpClass& one, const CSharpParameter& parameter)
{
    const PortContext context(model, one);
    const CSharpClass* own = model.FindPlain(parameter.type);
    return Replaced(own ? model.QualifiedName(*own) : parameter.type, "::", ".");
}

/// Returns whether the argument must be a variable.
bool isMutableReference(const PortModel& model, const CSharpClass& one,
                        const CSharpParameter& parameter)
{
    const PortContext context(model, one);
    const auto type = model.CppParameter(parameter);
    return type && type->ends_with("&") && !type->starts_with("const ");
}

/// "std::make_unique<P>(a, b)" of `new P(a, b)`; "" where that is not known.
std::string MakePass(const PortModel& model, const CSharpClass& pass, const PortScope& scope,
                     CSharpWords words)
{
    const auto arguments = NewArguments(words);
    if (!arguments)
    {
        return "";
    }
    const CSharpMethod* constructor = ConstructorOf(model, pass, arguments->size());
    const bool hasNone = std::ranges::none_of(pass.methods, &CSharpMethod::isConstructor);
    if (!constructor && !(hasNone && arguments->empty()))
    {
        return "";
    }
    std::string text = "std::make_unique<" + model.QualifiedName(pass) + ">(";
    for (std::size_t i = 0; i < arguments->size(); ++i)
    {
        const CSharpParameter& parameter = constructor->parameters[i];
        const auto value = Translate(model, scope, (*arguments)[i], TypeIn(model, pass, parameter));
        if (!value || (isMutableReference(model, pass, parameter) && !value->isVariable))
        {
            return "";
        }
        text += (i == 0 ? "" : ", ") + value->cpp;
    }
    return text + ")";
}

/// The event of `new P() { renderPassEvent = X }`.
CSharpWords InitializedEvent(CSharpWords words)
{
    for (std::size_t i = 0; i + 3 < words.size(); ++i)
    {
        if (words[i].Is("{") && words[i + 1].Is("renderPassEvent") && words[i + 2].Is("="))
        {
            return SplitArguments(words[i].Inside().subspan(2)).front();
        }
    }
    return {};
}

class CreateWriter
{
public:
    CreateWriter(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
        : m_Code(code), m_Model(code.model()), m_One(one), m_Scope(ScopeOf(m_Model, one, method))
    {
        m_Scope["name"] = {"name", "string"};
    }

    void Write(const PortedAssignment& assignment)
    {
        CSharpWords target = assignment.target;
        if (target.size() >= 3 && target[0].Is("this"))
        {
            target = target.subspan(2);
        }
        const PassMember* member = target.size() == 3 ? FindPassMember(target[2].text) : nullptr;
        const CSharpField* field = m_One.FindField(std::string(target[0].text));
        const CSharpClass* pass = field ? PassOf(m_Model, *field) : nullptr;
        if (pass && target.size() == 1)
        {
            WriteMaking(*field, *pass, assignment.value);
        }
        else if (pass && member)
        {
            WriteMember(*field, *member, assignment.value);
        }
    }

private:
    void WriteMaking(const CSharpField& field, const CSharpClass& pass, CSharpWords value)
    {
        const std::string making = MakePass(m_Model, pass, m_Scope, value);
        const std::string name = m_Model.CppName(field.name);
        m_Code.Done({"made in Create", m_One.name + "." + field.name, m_Model.Text(m_One, value),
                     m_Model.Place(m_One, value.empty() ? field.location : value[0].location),
                     !making.empty()});
        if (making.empty())
        {
            m_Code.Line("// TODO: make '" + name + "', which is nothing so far");
            return;
        }
        m_Code.Line(name + " = " + making + ";");
        m_Made.insert(field.name);
        const CSharpWords event = InitializedEvent(value);
        if (!event.empty())
        {
            WriteMember(field, *FindPassMember("renderPassEvent"), event);
        }
    }

    void WriteMember(const CSharpField& field, const PassMember& member, CSharpWords value)
    {
        const auto translated = m_Made.contains(field.name)
                                    ? Translate(m_Model, m_Scope, value, member.type)
                                    : std::nullopt;
        m_Code.Done({member.what, field.type + "." + member.name, m_Model.Text(m_One, value),
                     m_Model.Place(m_One, value.front().location), translated.has_value()});
        m_Code.Line(translated ? m_Model.CppName(field.name) + "->" + member.name + " = " +
                                     translated->cpp + ";"
                               : "// TODO: " + field.name + "'s " + member.name);
    }

    PortedCode& m_Code;
    const PortModel& m_Model;
    const CSharpClass& m_One;
    PortScope m_Scope;
    std::set<std::string> m_Made;
};

/// The fields of passes that a body hands to EnqueuePass.
std::vector<const CSharpField*> EnqueuedIn(const PortModel& model, const CSharpClass& one,
                                           const CSharpMethod& method)
{
    std::vector<const CSharpField*> fields;
    for (std::size_t i = 0; i + 2 < method.body.size(); ++i)
    {
        const bool isCall = method.body[i].Is("EnqueuePass") && method.body[i + 1].Is("(");
        const std::size_t at = i + 2 + (method.body[i + 2].Is("this") ? 2 : 0);
        const CSharpField* field =
            isCall && at < method.body.size() ? one.FindField(method.body[at].text) : nullptr;
        if (field && PassOf(model, *field))
        {
            AddOnce(field, fields);
        }
    }
    return fields;
}

void WriteEnqueuing(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    for (const CSharpField* field : EnqueuedIn(code.model(), one, method))
    {
        const std::string name = code.model().CppName(field->name);
        const std::string renderer = LocalName(code.model(), one, method.parameters[0].name);
        const std::string data = LocalName(code.model(), one, method.parameters[1].name);
        const std::string owner =
            one.FindField("name") ? "ScriptableRendererFeature::name" : "name";
        code.Open("if (" + name + ")");
        code.Line(renderer + ".EnqueuePass(*" + name + ");");
        code.Close();
        code.Open("else");
        code.Line(data + ".report->notes.push_back(" + owner + " + \": '" + field->name +
                  "' is not drawn, Create does not make it\");");
        code.Close();
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
            code.Line("std::unique_ptr<" + model.QualifiedName(*pass) + "> " +
                      model.CppName(field.name) + ";");
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
            code.Line(signature->Text() + ";");
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
    const PortModel& model = code.model();
    const std::string className = model.ClassName(one);
    code.Line(className + "::" + className + "() = default;");
    code.Line(className + "::~" + className + "() = default;");
    for (const CSharpMethod& method : one.methods)
    {
        const auto signature = SignatureOf(model, one, method);
        code.Line();
        if (!signature || !model.isDeclared(method))
        {
            code.TodoBody(method.name, one, method);
            continue;
        }
        code.Open(signature->Text(className + "::"));
        code.TodoBody("port", one, method);
        if (signature->isOverride && method.name == "Create")
        {
            CreateWriter writer(code, one, method);
            for (const PortedAssignment& assignment : AssignmentsOf(method.body))
            {
                writer.Write(assignment);
            }
        }
        else if (signature->isOverride && method.name == "AddRenderPasses")
        {
            WriteEnqueuing(code, one, method);
        }
        else
        {
            WriteResult(code, *signature);
        }
        code.Close();
    }
    code.Line();
}

} // namespace limn
