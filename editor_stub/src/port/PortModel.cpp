#include "port/PortModel.h"

#include "console/Texts.h"
#include "port/PortMember.h"

#include <algorithm>
#include <limn/base/WordList.h>

namespace limn
{

namespace
{

/// C++'s name of a type that is no class of the files; "" for one that is not known.
std::string KnownType(const std::string& type)
{
    static const WordList same(
        "AccessFlags BlendMode BlendState BufferHandle CameraType ClearFlag ColorWriteMask "
        "CompareFunction CullMode DepthState DrawingSettings FilterMode FilteringSettings "
        "GraphicsFormat MaterialPropertyBlock RTHandle RasterState RenderPassEvent "
        "RenderQueueRange RenderQueueType RenderStateBlock RenderStateMask RenderTargetHandle "
        "RenderTargetIdentifier RenderTextureDescriptor RenderTextureFormat RendererList "
        "RendererListHandle RenderingLayerMask ScriptableRenderPassInput ShaderPropertyId "
        "ShaderTagId SortingCriteria SortingSettings StencilOp StencilState StencilStateData "
        "TextureDesc TextureHandle TextureWrapMode Vector2 Vector2Int Vector3 Vector3Int Vector4 "
        "int float double bool Color LayerMask ProfilingSampler");
    static const WordList made("Material ComputeShader GraphicsBuffer ComputeBuffer");
    static const WordList loaded("Shader Texture RenderTexture Mesh");
    return same.Has(type)                                      ? type
           : type == "uint"                                    ? "std::uint32_t"
           : type == "string"                                  ? "std::string"
           : type == "Matrix4x4"                               ? "glm::mat4"
           : type == "Quaternion"                              ? "glm::quat"
           : made.Has(type)                                    ? "Shared<" + type + ">"
           : loaded.Has(type)                                  ? "Shared<const " + type + ">"
           : IsIn(type, {"Texture2D", "Texture3D", "Cubemap"}) ? "Shared<const Texture>"
                                                               : "";
}

bool IsCppWord(std::string_view word)
{
    static const WordList words(
        "alignas alignof and and_eq asm auto bitand bitor bool catch char char8_t char16_t "
        "char32_t class compl concept consteval constexpr constinit const_cast co_await co_return "
        "co_yield decltype default delete double dynamic_cast enum explicit export extern float "
        "friend inline int long mutable namespace new noexcept not not_eq nullptr operator or "
        "or_eq private protected public register reinterpret_cast requires short signed sizeof "
        "static static_assert static_cast struct switch template this thread_local throw try "
        "typedef typeid typename union unsigned using virtual void volatile wchar_t while xor "
        "xor_eq linux unix NULL EOF errno assert stdin stdout stderr major minor std glm limn "
        "Header Describe const break case continue do else false for goto if return true INFINITY "
        "NAN HUGE_VAL OVERFLOW UNDERFLOW DOMAIN BUFSIZ RAND_MAX TRUE FALSE");
    return words.Has(word);
}

/// A name that CMake takes for a target: of letters, digits and _, and none of its own.
std::string TargetName(const std::string& name)
{
    std::string plain;
    for (const char c : name)
    {
        constexpr const char* k_Digits = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        plain += byte < 0x80 ? std::string(1, c)
                             : std::string("x") + k_Digits[byte / 16] + k_Digits[byte % 16];
    }
    const bool isTaken =
        IsIn(plain, {"all", "clean", "test", "install", "package", "help", "edit_cache",
                     "rebuild_cache", "package_source", "list_install_components"});
    return isTaken ? plain + "_" : plain;
}

bool IsInterfaceName(std::string_view name)
{
    return name.size() > 1 && name[0] == 'I' && name[1] >= 'A' && name[1] <= 'Z';
}

/// Returns whether a body has `field = `.
bool Assigns(CSharpWords body, std::string_view field)
{
    return std::ranges::adjacent_find(body, [&](const CSharpToken& word, const CSharpToken& next)
                                      { return word.Is(field) && next.Is("="); }) != body.end();
}

} // namespace

PortModel::PortModel(const CSharpFiles& files, const PortingTable& table)
    : m_Files(files),
      m_Table(table),
      m_Index(files, [&table](std::string_view type) { return table.HasType(type); })
{
    std::set<std::pair<const CSharpClass*, std::string_view>> names; // each in its outer class
    for (const CSharpClass* one : m_Index.all())
    {
        const PortContext context(*this, *one);
        const bool isAgain = !names.emplace(one->outer, one->name).second;
        m_Roles[one] = isAgain ? PortRole::Other : ChooseRole(*one);
    }
    const auto features = TopLevel(PortRole::Feature);
    if (features.empty())
    {
        const std::string found = Joined(m_Index.all(), ", ", &CSharpClass::name);
        throw AssetError(files.front()->path, {},
                         "no class derives from ScriptableRendererFeature; " +
                             (found.empty()
                                  ? "there is no class at all"
                                  : "there are only " + found + ": name the feature's file, too"));
    }
    m_Name = features.front()->name;
    for (const std::string_view suffix : {"RendererFeature", "RenderFeature", "Feature"})
    {
        if (m_Name.size() > suffix.size() && m_Name.ends_with(suffix))
        {
            m_Name.resize(m_Name.size() - suffix.size());
            break;
        }
    }
    m_Name = TargetName(m_Name);
}

PortRole PortModel::ChooseRole(const CSharpClass& one, int depth) const
{
    if (one.keyword == "enum")
    {
        return PortRole::Enum;
    }
    if (one.keyword == "interface" || (one.isGeneric && depth == 0) || depth > 20)
    {
        return PortRole::Other;
    }
    if (one.isStatic)
    {
        return PortRole::Data;
    }
    static const std::map<std::string_view, PortRole> roles = {
        {"ScriptableRendererFeature", PortRole::Feature},
        {"ScriptableRenderPass", PortRole::Pass},
        {"ContextItem", PortRole::Context},
        {"VolumeComponent", PortRole::Component},
        {"VolumeParameter", PortRole::Parameter}};
    PortRole role = PortRole::Data;
    for (const std::string& base : one.bases)
    {
        const std::string_view plain = PlainTypeName(base);
        const CSharpClass* own = Find(base);
        if (const auto known = roles.find(plain); known != roles.end())
        {
            return known->second;
        }
        if (own && own != &one)
        {
            role = ChooseRole(*own, depth + 1);
            // A pass says what its base has to give it; other classes would lack it without a word.
            role = own->isGeneric && role != PortRole::Pass ? PortRole::Other : role;
        }
        else if (!IsInterfaceName(plain))
        {
            role = PortRole::Other;
        }
    }
    return role;
}

std::vector<const CSharpClass*> PortModel::Of(PortRole role) const
{
    std::vector<const CSharpClass*> result;
    std::ranges::copy_if(m_Index.all(), std::back_inserter(result),
                         [&](const CSharpClass* one) { return RoleOf(*one) == role; });
    return result;
}

std::vector<const CSharpClass*> PortModel::TopLevel(PortRole role) const
{
    std::vector<const CSharpClass*> classes = Of(role);
    std::erase_if(classes, [&](const CSharpClass* one) { return one->outer != nullptr; });
    return classes;
}

bool PortModel::isLeftOut(const CSharpClass& one) const
{
    const bool isHomeless =
        RoleOf(one) == PortRole::Pass && one.outer && RoleOf(*one.outer) != PortRole::Feature;
    return RoleOf(one) == PortRole::Other || isHomeless || (one.outer && isLeftOut(*one.outer));
}

std::string PortModel::ClassName(const CSharpClass& one)
{
    return IsCppWord(one.name) ? one.name + "_" : one.name;
}

std::string PortModel::QualifiedName(const CSharpClass& one) const
{
    return (one.outer ? QualifiedName(*one.outer) + "::" : "") + ClassName(one);
}

std::string PortModel::Place(const CSharpClass& one, const SourceLocation& location) const
{
    return one.file->name() + ":" + std::to_string(location.line);
}

std::optional<std::string> PortModel::CppType(const std::string& type) const
{
    const bool isArray = type.ends_with("[]");
    if (isArray || (type.starts_with("List<") && type.ends_with(">")))
    {
        const auto element =
            CppType(isArray ? type.substr(0, type.size() - 2) : type.substr(5, type.size() - 6));
        return element ? std::optional("std::vector<" + *element + ">") : std::nullopt;
    }
    if (const CSharpClass* own = Find(type))
    {
        const PortRole role = RoleOf(*own);
        const bool isValue = role == PortRole::Enum || role == PortRole::Data;
        return isValue && !isLeftOut(*own) && isDeclared(*own) ? std::optional(QualifiedName(*own))
                                                               : std::nullopt;
    }
    const std::string known = KnownType(type);
    return known.empty() ? std::nullopt : std::optional(known);
}

std::optional<std::string> PortModel::CppPointed(const std::string& type) const
{
    const CSharpClass* own = Find(type);
    return own && RoleOf(*own) == PortRole::Component ? "const " + ClassName(*own)
           : own                                      ? CppType(type)
           : type == "Camera"                         ? "const Camera"
           : type == "UniversalRenderer"              ? "ScriptableRenderer"
                                                      : std::optional(type);
}

std::string PortModel::CppDefault(const std::string& cppType)
{
    return cppType == "RenderQueueRange"   ? "{0, 0}"
           : cppType == "ProfilingSampler" ? "{\"\"}"
                                           : "{}";
}

std::optional<std::string> PortModel::CppParameter(const std::string& type) const
{
    if (type == "UniversalRenderer")
    {
        return "ScriptableRenderer&";
    }
    static const WordList references(
        "CommandBuffer RasterCommandBuffer UnsafeCommandBuffer RasterGraphContext "
        "UnsafeGraphContext ComputeCommandBuffer ComputeGraphContext ScriptableRenderContext "
        "RenderingData CameraData ScriptableRenderer RenderGraph ContextContainer "
        "UniversalResourceData UniversalCameraData UniversalRenderingData UniversalLightData "
        "MaterialPropertyBlock");
    if (references.Has(type))
    {
        return type + "&";
    }
    if (IsIn(type, {"CullingResults", "VolumeStack", "Camera"}))
    {
        return "const " + type + "&";
    }
    const CSharpClass* own = Find(type);
    if (own && RoleOf(*own) == PortRole::Context)
    {
        return isDeclared(*own) ? std::optional(QualifiedName(*own) + "&") : std::nullopt;
    }
    if (own && RoleOf(*own) == PortRole::Component && !own->outer)
    {
        return isDeclared(*own) ? std::optional("const " + ClassName(*own) + "&") : std::nullopt;
    }
    if (own && RoleOf(*own) == PortRole::Data)
    {
        const auto cpp = CppType(type);
        // C# copies a struct and shares a class.
        return cpp ? std::optional(own->keyword == "class" ? *cpp + "&" : "const " + *cpp + "&")
                   : std::nullopt;
    }
    const auto cpp = CppType(type);
    const bool isSmall = own || IsIn(type, {"int", "float", "bool", "double", "uint",
                                            "ShaderPropertyId", "RenderPassEvent", "LayerMask"});
    return !cpp || isSmall ? cpp : std::optional("const " + *cpp + "&");
}

std::optional<std::string> PortModel::CppParameter(const CSharpParameter& parameter) const
{
    auto type = CppParameter(parameter.type);
    if (!type || !parameter.isReference)
    {
        return type;
    }
    const auto value = CppType(parameter.type);
    return value ? std::optional(*value + "&") : type;
}

bool PortModel::isShared(const CSharpClass& one, const CSharpField& field) const
{
    const CSharpClass* own = FindPlain(field.type);
    static const WordList shared(
        "Camera ScriptableRenderer UniversalRenderer UniversalCameraData UniversalLightData "
        "UniversalRenderingData UniversalResourceData");
    if (!own && shared.Has(field.type))
    {
        return !field.isStatic;
    }
    if (own && RoleOf(*own) == PortRole::Component)
    {
        const bool isNull = field.value.empty() || field.value.front().Is("null");
        return !own->outer && isDeclared(*own) && !field.isStatic && isNull;
    }
    const bool isOne = own && RoleOf(*own) == PortRole::Data && own->keyword == "class";
    const CSharpClass* pass = &one;
    while (pass && RoleOf(*pass) != PortRole::Pass)
    {
        pass = pass->outer;
    }
    const bool isMade = !field.value.empty() && field.value.front().Is("new");
    return isOne && pass && !field.isStatic &&
           (!isMade || std::ranges::any_of(pass->methods, [&](const CSharpMethod& method)
                                           { return Assigns(method.body, field.name); }));
}

bool PortModel::hasOwn(const CSharpClass& one, const CSharpField& field) const
{
    const CSharpClass* own = FindPlain(field.type);
    const auto makes = [&](const CSharpMethod& method)
    {
        const CSharpWords body = method.body;
        for (std::size_t i = 0; i + 2 < body.size(); ++i)
        {
            if (body[i].Is(field.name) && body[i + 1].Is("=") && body[i + 2].Is("new"))
            {
                return true;
            }
        }
        return false;
    };
    const bool isMade = !field.value.empty() && field.value.front().Is("new");
    return own && RoleOf(*own) == PortRole::Data && isShared(one, field) && CppType(field.type) &&
           (isMade || std::ranges::any_of(one.methods, makes));
}

std::string PortModel::HeldType(const std::string& type) const
{
    const CSharpClass* own = Find(type);
    const std::string& base = own && !own->bases.empty() ? own->bases.front() : type;
    const std::size_t open = base.find('<');
    return open == std::string::npos ? "" : base.substr(open + 1, base.size() - open - 2);
}

bool PortModel::hasEntries(std::string_view type)
{
    static const WordList types("BlendMode CameraType CompareFunction CullMode FilterMode "
                                "RenderQueueType RenderTextureFormat StencilOp TextureWrapMode");
    return types.Has(type);
}

bool PortModel::isSetting(const std::string& type) const
{
    static const WordList types(
        "int uint float bool string string[] List<string> Color Vector2 Vector3 Vector4 LayerMask "
        "RenderingLayerMask RenderPassEvent Shader Material Texture Texture2D Texture3D Cubemap "
        "RenderTexture ComputeShader StencilStateData");
    const CSharpClass* own = Find(type);
    return own ? CppType(type).has_value() && !type.ends_with("]") && !type.starts_with("List<")
               : types.Has(type) || hasEntries(type);
}

bool PortModel::isSerialized(const CSharpField& field) const
{
    static const WordList unknown( // to Unity's serializer
        "BufferHandle CullingResults DrawingSettings FilteringSettings MaterialPropertyBlock "
        "ProfilingSampler RTHandle RenderQueueRange RenderStateBlock RenderTargetHandle "
        "RenderTargetIdentifier RenderTextureDescriptor RendererList RendererListHandle "
        "ScriptableRenderer ShaderTagId SortingSettings StencilState TextureDesc TextureHandle");
    const std::string element = ElementTypeOf(field.type);
    const std::string& type = element.empty() ? field.type : element;
    if (unknown.Has(type) && !Find(type))
    {
        return false;
    }
    return ((field.isPublic && !field.isProperty) || field.Find("SerializeField")) &&
           !field.isStatic && !field.isReadonly && !field.Find("NonSerialized");
}

std::string PortModel::CppName(const std::string& name) const
{
    return !KnownType(name).empty() || Find(name) || IsCppWord(name) ? name + "_" : name;
}

} // namespace limn
