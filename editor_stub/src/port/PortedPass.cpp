#include "port/PortedCode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// A method that limn calls, with the parameters of Unity 2022.3 and 6 in C++.
struct KnownMethod
{
    std::string_view name;
    std::vector<std::string> parameters;
};

/// Returns the methods that limn calls; there are none for classes that are neither features nor
/// passes.
const std::vector<KnownMethod>& MethodsOf(PortRole role)
{
    static const std::vector<KnownMethod> none;
    static const std::vector<KnownMethod> feature = {
        {"Create", {}},
        {"Dispose", {"bool"}},
        {"AddRenderPasses", {"ScriptableRenderer&", "RenderingData&"}},
        {"SetupRenderPasses", {"ScriptableRenderer&", "const RenderingData&"}}};
    static const std::vector<KnownMethod> pass = {
        {"OnCameraSetup", {"CommandBuffer&", "RenderingData&"}},
        {"Configure", {"CommandBuffer&", "const RenderTextureDescriptor&"}},
        {"Execute", {"ScriptableRenderContext&", "RenderingData&"}},
        {"RecordRenderGraph", {"RenderGraph&", "ContextContainer&"}},
        {"OnCameraCleanup", {"CommandBuffer&"}},
        {"FrameCleanup", {"CommandBuffer&"}},
        {"OnFinishCameraStackRendering", {"CommandBuffer&"}}};
    return role == PortRole::Feature ? feature : role == PortRole::Pass ? pass : none;
}

/// Returns whether it is the older half of a pass that has both halves; limn would run that half
/// alone.
bool IsCompatibilityMethod(const CSharpClass& one, const CSharpMethod& method)
{
    return IsIn(method.name, {"Execute", "OnCameraSetup", "Configure"}) && method.isOverride &&
           one.FindMethod("RecordRenderGraph");
}

/// Notes events and names of the pass that an assignment sets.
void Note(PortedCode& code, const CSharpClass& one, const PortedAssignment& assignment, bool isDone)
{
    if (const PassMember* member = FindPassMember(assignment.target.back().text))
    {
        code.Done({member->what, one.name + "." + member->name,
                   code.model().Text(one, assignment.value),
                   code.model().Place(one, assignment.target.front().location), isDone});
    }
}

/// Takes the pointers out of a scope in which they are null; their names.
std::set<std::string> TakePointers(PortScope& scope)
{
    std::set<std::string> names;
    std::erase_if(scope,
                  [&](const auto& entry)
                  {
                      if (entry.second.isPointer && entry.first.starts_with("this."))
                      {
                          names.insert(entry.first.substr(5));
                      }
                      return entry.second.isPointer;
                  });
    return names;
}

void WriteConstructor(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    const PortModel& model = code.model();
    const auto signature = SignatureOf(model, one, method);
    if (!signature)
    {
        code.TodoBody("a constructor; limn has no such parameters", one, method);
        return;
    }
    const bool isConversion = method.parameters.size() == 1;
    code.Open((isConversion ? "explicit " : "") + signature->Text());
    code.TodoBody("port", one, method);
    PortScope scope = ScopeOf(model, one, method);
    std::set<std::string> unset = TakePointers(scope);
    for (const PortedAssignment& assignment : AssignmentsOf(method.body))
    {
        const std::string name(assignment.target.back().text);
        if (const CSharpField* field = unset.contains(name) ? one.FindField(name) : nullptr)
        {
            scope["this." + name] = VariableOf(model, one, *field);
        }
        const std::string line = AssignmentText(model, scope, assignment);
        Note(code, one, assignment, !line.empty());
        if (!line.empty() && unset.erase(name) > 0)
        {
            scope.try_emplace(name, scope["this." + name]);
        }
        else if (unset.contains(name))
        {
            scope.erase("this." + name);
        }
        if (!line.empty())
        {
            code.Line(line);
        }
    }
    code.Close();
}

void WriteMethod(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    for (const PortedAssignment& assignment : AssignmentsOf(method.body))
    {
        Note(code, one, assignment, false);
    }
    const auto signature = SignatureOf(code.model(), one, method);
    const bool isOld = IsCompatibilityMethod(one, method);
    if (!signature || isOld)
    {
        code.TodoBody(method.name + (isOld
                                         ? ": Unity 6's compatibility mode; limn runs it where the "
                                           "pipeline's enableRenderCompatibilityMode is on"
                                         : ""),
                      one, method);
        NoteGraphPasses(code, one, method);
        return;
    }
    code.Open((method.isStatic ? "static " : "") + signature->Text());
    if (!WriteGraphPasses(code, one, method))
    {
        code.TodoBody("port", one, method);
    }
    WriteResult(code, *signature);
    code.Close();
}

/// Returns whether C++ has one of the methods that limn runs.
bool HasWork(const PortModel& model, const CSharpClass& one)
{
    const auto isWork = [&](const CSharpMethod& method)
    {
        return IsIn(method.name, {"Execute", "RecordRenderGraph"}) && method.isOverride &&
               !IsCompatibilityMethod(one, method) && SignatureOf(model, one, method);
    };
    return std::ranges::any_of(one.methods, isWork);
}

/// Returns whether a body assigns to a parameter or to a member of it.
bool IsChanged(CSharpWords body, std::string_view name)
{
    for (std::size_t i = 0; i + 1 < body.size(); ++i)
    {
        const bool isIt = body[i].Is(name) && (i == 0 || !body[i - 1].Is("."));
        std::size_t behind = i + 1;
        while (isIt && behind + 2 < body.size() && body[behind].Is(".") &&
               body[behind + 1].isName())
        {
            behind += 2;
        }
        if (isIt && IsIn(body[behind].text, {"=", "+=", "-=", "*=", "/=", "|=", "&=", "++", "--"}))
        {
            return true;
        }
    }
    return false;
}

} // namespace

const PassMember* FindPassMember(std::string_view name)
{
    static const PassMember members[] = {
        {"renderPassEvent", "RenderPassEvent", "event"},
        {"profilingSampler", "ProfilingSampler", "name of a pass"}};
    const auto* found = std::ranges::find(members, name, &PassMember::name);
    return found == std::end(members) ? nullptr : found;
}

std::string AssignmentText(const PortModel& model, const PortScope& scope,
                           const PortedAssignment& assignment)
{
    CSharpWords target = assignment.target;
    std::string name(target.back().text);
    const bool isThis = target.size() == 3 && (target[0].Is("this") || target[0].Is("base"));
    if (!(target.size() == 1 || isThis) || !target.back().isName())
    {
        return "";
    }
    const PassMember* member = FindPassMember(name);
    const auto found = scope.find("this." + name);
    const PortValue field = member                 ? PortValue{name, member->type}
                            : found != scope.end() ? found->second
                                                   : PortValue{};
    if (field.cpp.empty())
    {
        return "";
    }
    const auto value = Translate(model, scope, assignment.value, field.isPointer ? "" : field.type);
    const bool isSame =
        value && (!field.isPointer || (value->isVariable && model.Find(value->type) &&
                                       model.Find(value->type) == model.Find(field.type)));
    const bool isAddress = field.isPointer && isSame && !value->isPointer;
    return isSame ? field.cpp + " = " + (isAddress ? "&" : "") + value->cpp + ";" : "";
}

std::string LocalName(const PortModel& model, const CSharpClass& one, const std::string& name)
{
    bool isHiding = FindPassMember(name) || name == "name";
    for (const CSharpClass* owner = &one; owner; owner = owner->outer)
    {
        isHiding = isHiding || owner->FindField(name); // of those around it Clang warns, too
    }
    const std::string cpp = model.CppName(name);
    return isHiding && cpp == name ? name + "_" : cpp;
}

std::string PortedSignature::Text(const std::string& owner) const
{
    std::string text = result.empty() ? "" : result + " ";
    text += owner + name + parameters;
    return isOverride && owner.empty() ? text + " override" : text;
}

std::optional<PortedSignature> SignatureOf(const PortModel& model, const CSharpClass& one,
                                           const CSharpMethod& method)
{
    const PortContext context(model, one);
    if (one.FindField(method.name))
    {
        return std::nullopt; // no C#
    }
    const auto& known = MethodsOf(model.RoleOf(one));
    const auto found = std::ranges::find(known, method.name, &KnownMethod::name);
    const bool isKnown =
        found != known.end() && found->parameters.size() == method.parameters.size();
    const bool isTwin = method.name == "FrameCleanup" && one.FindMethod("OnCameraCleanup");
    PortedSignature signature{"void", model.CppName(method.name), "(", method.isOverride};
    std::vector<std::string> types;
    if (method.isOverride)
    {
        if (!isKnown || isTwin)
        {
            return std::nullopt;
        }
        signature.name = found->name;
        types = found->parameters;
    }
    else
    {
        const auto result = method.isConstructor() || method.type == "void"
                                ? std::optional(method.type)
                                : model.CppType(method.type);
        if (method.isProperty || !result || isKnown) // which it would hide
        {
            return std::nullopt;
        }
        signature.result = *result;
        signature.name = method.isConstructor() ? model.ClassName(one) : signature.name;
        for (const CSharpParameter& parameter : method.parameters)
        {
            const auto type = model.CppParameter(parameter);
            if (!type)
            {
                return std::nullopt;
            }
            const auto value = model.CppType(parameter.type);
            const bool isCopy =
                value && *type == "const " + *value + "&" && IsChanged(method.body, parameter.name);
            types.push_back(isCopy ? *value : *type);
        }
    }
    for (std::size_t i = 0; i < types.size(); ++i)
    {
        signature.parameters += (i == 0 ? "[[maybe_unused]] " : ", [[maybe_unused]] ") + types[i] +
                                " " + LocalName(model, one, method.parameters[i].name);
    }
    signature.parameters += ")";
    return signature;
}

void WriteResult(PortedCode& code, const PortedSignature& signature)
{
    if (signature.result != "void")
    {
        code.Line("return " + signature.result + PortModel::CppDefault(signature.result) + ";");
    }
}

PortScope ScopeOf(const PortModel& model, const CSharpClass& one, const CSharpMethod& method)
{
    PortScope scope;
    for (const CSharpField& field : one.fields)
    {
        if (model.isDeclared(field))
        {
            scope[field.name] = VariableOf(model, one, field);
            scope["this." + field.name] = scope[field.name];
        }
    }
    for (const CSharpParameter& parameter : method.parameters)
    {
        PortValue value{LocalName(model, one, parameter.name), parameter.type};
        value.isVariable = true;
        scope[parameter.name] = value;
    }
    return scope;
}

void WriteUsing(PortedCode& code, const CSharpClass& one)
{
    const PortModel& model = code.model();
    const bool isFeature = model.RoleOf(one) == PortRole::Feature;
    for (const KnownMethod& known : MethodsOf(model.RoleOf(one)))
    {
        const auto isOverload = [&](const CSharpMethod& method)
        {
            return method.name == known.name && SignatureOf(model, one, method) &&
                   !method.isOverride;
        };
        if (std::ranges::any_of(one.methods, isOverload))
        {
            code.Line(std::string("using ") +
                      (isFeature ? "ScriptableRendererFeature::" : "ScriptableRenderPass::") +
                      std::string(known.name) + ";");
        }
    }
}

void WritePass(PortedCode& code, const CSharpClass& one)
{
    const PortContext context(code.model(), one);
    const PortModel& model = code.model();
    const std::string place = model.Place(one, one.location);
    code.Done({"pass", one.name, "", place, true});
    code.Line("/// C#: " + place + ".");
    code.Open("class " + model.QualifiedName(one) + " final : public ScriptableRenderPass");
    code.Label("public:");
    if (!one.Derives("ScriptableRenderPass"))
    {
        code.Line("// TODO " + place + ": what '" + one.bases.front() + "' has goes in here, too");
    }
    WriteTypes(code, NestedIn(one));
    PortScope scope;
    for (const CSharpField& field : one.fields)
    {
        WriteField(code, one, field, scope);
    }
    WriteUsing(code, one);
    std::set<std::string> signatures;
    for (const CSharpMethod& method : one.methods)
    {
        code.Line();
        const auto signature = SignatureOf(model, one, method);
        if (signature && !signatures.insert(signature->name + signature->parameters).second)
        {
            code.TodoBody(method.name + ", a second one of these parameters", one, method);
            continue;
        }
        method.isConstructor() && !method.isStatic ? WriteConstructor(code, one, method)
                                                   : WriteMethod(code, one, method);
    }
    if (!HasWork(model, one))
    {
        code.Line();
        code.Open("void Execute(ScriptableRenderContext&, RenderingData&) override");
        code.Line("// TODO " + place + ": the work; limn draws no pass without one of its own");
        code.Close();
    }
    code.Close("};");
    code.Line();
}

} // namespace limn
