#include "port/PortedBody.h"

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
    const std::size_t begin = code.text.size();
    code.Open((isConversion ? "explicit " : "") + signature->Text());
    PortedBody(code, one, method).Write();
    code.Close();
    code.TrimUnused(begin);
}

void WriteMethod(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    const auto signature = SignatureOf(code.model(), one, method);
    if (IsCompatibilityMethod(one, method))
    {
        code.Comment("Only Unity 6's compatibility mode runs '" + method.name + "' of " +
                     code.model().Place(one, method.location) + ".");
        return;
    }
    if (!signature && method.isOverride && method.body.empty())
    {
        return; // there is nothing in it
    }
    if (!signature)
    {
        code.TodoBody(method.name, one, method);
        NoteGraphPasses(code, one, method);
        return;
    }
    const std::size_t begin = code.text.size();
    code.Open((method.isStatic ? "static " : "") + signature->Text());
    PortedBody(code, one, method).Write();
    code.Close();
    code.TrimUnused(begin);
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

} // namespace

bool IsChanged(CSharpWords body, std::string_view name, bool isField)
{
    for (std::size_t i = 0; i + 1 < body.size(); ++i)
    {
        const bool isOfThis = isField && i > 1 && body[i - 1].Is(".") && body[i - 2].Is("this");
        const bool isIt = body[i].Is(name) && (i == 0 || isOfThis || !body[i - 1].Is("."));
        std::size_t behind = i + 1;
        while (isIt && behind + 2 < body.size() &&
               ((body[behind].Is(".") && body[behind + 1].isName()) || body[behind].Is("[")))
        {
            behind += body[behind].Is(".") ? 2 : static_cast<std::size_t>(body[behind].match) + 1;
        }
        behind = std::min(behind, body.size() - 1);
        if (isIt && body[behind].Is("(") && IsIn(body[behind - 1].text, {"SetRow", "SetColumn"}))
        {
            return true;
        }
        if (isIt && i > 1 && body[i - 1].Is("(") && body[i - 2].Is("Destroy"))
        {
            return true; // CoreUtils::Destroy makes it null
        }
        if (isIt && IsIn(body[behind].text, {"=", "+=", "-=", "*=", "/=", "|=", "&=", "++", "--"}))
        {
            return true;
        }
    }
    return false;
}

const PassMember* FindPassMember(std::string_view name)
{
    static const PassMember members[] = {
        {"renderPassEvent", "RenderPassEvent", "event"},
        {"profilingSampler", "ProfilingSampler", "name of a pass"}};
    const auto* found = std::ranges::find(members, name, &PassMember::name);
    return found == std::end(members) ? nullptr : found;
}

bool IsCallable(const PortModel& model, const CSharpClass& one, const CSharpMethod& method)
{
    const bool isBehind = model.context() == &one || model.isDeclared(method) ||
                          (model.isDeclared(one) && model.RoleOf(one) == PortRole::Pass);
    return isBehind && !method.isConstructor() && SignatureOf(model, one, method) &&
           !(model.RoleOf(one) == PortRole::Pass && IsCompatibilityMethod(one, method));
}

std::string LocalName(const PortModel& model, const CSharpClass& one, const std::string& name)
{
    const std::string base = BaseTypeOf(model.RoleOf(one));
    bool isHiding = FindPassMember(name) || name == "name" ||
                    (!base.empty() && !model.table().OwnerOf(base, name, true).empty());
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

bool IsCopied(const std::string& cppType, const CSharpMethod& method, const std::string& parameter)
{
    return method.isOverride && cppType == "const RenderTextureDescriptor&" &&
           IsChanged(method.body, parameter);
}

std::optional<PortedSignature> SignatureOf(const PortModel& model, const CSharpClass& one,
                                           const CSharpMethod& method)
{
    const PortContext context(model, one);
    const bool isTaken =
        method.isSetter && std::ranges::count(one.methods, method.name, &CSharpMethod::name) > 1;
    if (one.FindField(method.name) || isTaken)
    {
        return std::nullopt; // no C#, or another SetX
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
        if (method.isUnread || !result || isKnown) // which it would hide
        {
            return std::nullopt;
        }
        signature.result = *result;
        signature.name = method.isConstructor() ? model.ClassName(one) : signature.name;
        for (const CSharpParameter& parameter : method.parameters)
        {
            auto type = model.CppParameter(parameter);
            const bool isRead = IsIn(parameter.type, {"CameraData", "RenderingData"}) &&
                                !IsChanged(method.body, parameter.name);
            if (type && isRead && !method.isConstructor())
            {
                type = "const " + *type;
            }
            if (!type)
            {
                return std::nullopt;
            }
            const auto value = model.CppType(parameter.type);
            const bool isCopy =
                value && *type == "const " + *value + "&" && IsChanged(method.body, parameter.name);
            const bool isList = isCopy && value->starts_with("std::vector<");
            types.push_back(isCopy ? *value + (isList ? "&" : "") : *type);
        }
    }
    for (std::size_t i = 0; i < types.size(); ++i)
    {
        const std::string name = method.parameters[i].name;
        signature.parameters += (i == 0 ? "[[maybe_unused]] " : ", [[maybe_unused]] ") + types[i] +
                                " " + LocalName(model, one, name) +
                                (IsCopied(types[i], method, name) ? "Given" : "");
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
    code.model().Declare(one);
    code.Line();
}

} // namespace limn
