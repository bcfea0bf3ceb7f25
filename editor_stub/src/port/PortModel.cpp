#include "port/PortModel.h"

#include "port/csharp/CSharpWords.h"

#include <algorithm>
#include <filesystem>

namespace limn
{

namespace
{

/// Of types that are no classes of the files: C#'s and C++'s name.
const std::map<std::string, std::string, std::less<>>& KnownTypes()
{
    static const std::map<std::string, std::string, std::less<>> types = {
        {"int", "int"},
        {"uint", "std::uint32_t"},
        {"float", "float"},
        {"double", "double"},
        {"bool", "bool"},
        {"string", "std::string"},
        {"Color", "Color"},
        {"Matrix4x4", "glm::mat4"},
        {"LayerMask", "LayerMask"},
        {"Material", "std::shared_ptr<Material>"},
        {"Shader", "std::shared_ptr<const Shader>"},
        {"Texture", "std::shared_ptr<const Texture>"},
        {"Texture2D", "std::shared_ptr<const Texture>"},
        {"Texture3D", "std::shared_ptr<const Texture>"},
        {"Cubemap", "std::shared_ptr<const Texture>"},
        {"RenderTexture", "std::shared_ptr<const RenderTexture>"},
        {"Mesh", "std::shared_ptr<const Mesh>"},
        {"ComputeShader", "std::shared_ptr<ComputeShader>"},
        {"GraphicsBuffer", "std::shared_ptr<GraphicsBuffer>"},
        {"ComputeBuffer", "std::shared_ptr<ComputeBuffer>"},
        {"ProfilingSampler", "ProfilingSampler"}};
    return types;
}

/// Types that are called the same.
bool IsSameType(std::string_view type)
{
    static const std::set<std::string_view> types = {"RenderPassEvent",
                                                     "Vector2",
                                                     "Vector3",
                                                     "Vector4",
                                                     "Vector2Int",
                                                     "Vector3Int",
                                                     "RendererList",
                                                     "BufferHandle",
                                                     "TextureDesc",
                                                     "SortingSettings",
                                                     "DepthState",
                                                     "BlendState",
                                                     "RasterState",
                                                     "BlendMode",
                                                     "CullMode",
                                                     "RTHandle",
                                                     "RenderTargetIdentifier",
                                                     "RenderTargetHandle",
                                                     "FilteringSettings",
                                                     "RenderTextureDescriptor",
                                                     "DrawingSettings",
                                                     "SortingCriteria",
                                                     "RenderStateBlock",
                                                     "StencilState",
                                                     "ShaderTagId",
                                                     "FilterMode",
                                                     "TextureWrapMode",
                                                     "GraphicsFormat",
                                                     "RenderTextureFormat",
                                                     "CompareFunction",
                                                     "ColorWriteMask",
                                                     "RenderStateMask",
                                                     "AccessFlags",
                                                     "StencilOp",
                                                     "ClearFlag",
                                                     "MaterialPropertyBlock",
                                                     "TextureHandle",
                                                     "RendererListHandle",
                                                     "ScriptableRenderPassInput",
                                                     "RenderQueueRange",
                                                     "CameraType",
                                                     "RenderingLayerMask",
                                                     "ShaderPropertyId"};
    return types.contains(type);
}

bool IsCppWord(std::string_view word)
{
    // clang-format off
    static const std::set<std::string_view> words = {
        "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "catch",
        "char", "char8_t", "char16_t", "char32_t", "class", "compl", "concept", "consteval",
        "constexpr", "constinit", "const_cast", "co_await", "co_return", "co_yield", "decltype",
        "default", "delete", "double", "dynamic_cast", "enum", "explicit", "export", "extern",
        "float", "friend", "inline", "int", "long", "mutable", "namespace", "new", "noexcept",
        "not", "not_eq", "nullptr", "operator", "or", "or_eq", "private", "protected", "public",
        "register", "reinterpret_cast", "requires", "short", "signed", "sizeof", "static",
        "static_assert", "static_cast", "struct", "switch", "template", "this", "thread_local",
        "throw", "try", "typedef", "typeid", "typename", "union", "unsigned", "using", "virtual",
        "void", "volatile", "wchar_t", "while", "xor", "xor_eq", "linux", "unix", "NULL", "EOF",
        "errno", "assert", "stdin", "stdout", "stderr", "major", "minor", "std", "glm", "limn",
        "Header", "Describe", "const", "break", "case", "continue", "do", "else", "false", "for",
        "goto", "if", "return", "true", "INFINITY", "NAN", "HUGE_VAL", "OVERFLOW", "UNDERFLOW",
        "DOMAIN", "BUFSIZ", "RAND_MAX", "TRUE", "FALSE"};
    // clang-format on
    return words.contains(word);
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

} // namespace

PortModel::PortModel(const CSharpFiles& files, const PortingTable& table)
    : m_Files(files),
      m_Table(table),
      m_Index(files, [&table](std::string_view type) { return table.HasType(type); })
{
    for (const auto& file : files)
    {
        for (const CSharpClass& one : file->classes)
        {
            Place(*file, one);
        }
    }
    auto features = Of(PortRole::Feature);
    std::erase_if(features, [&](const CSharpClass* one) { return OuterOf(*one) != nullptr; });
    if (features.empty())
    {
        std::string found;
        for (const CSharpClass* one : m_Index.all())
        {
            found += (found.empty() ? "" : ", ") + one->name;
        }
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

void PortModel::Place(const CSharpFile& file, const CSharpClass& one)
{
    const PortContext context(*this, one);
    const bool isAgain = !m_PlacedNames.emplace(OuterOf(one), one.name).second;
    m_Places[&one] = {&file, isAgain ? PortRole::Other : ChooseRole(one)};
    for (const CSharpClass& nested : one.classes)
    {
        Place(file, nested);
    }
}

PortRole PortModel::ChooseRole(const CSharpClass& one, int depth) const
{
    if (one.keyword == "enum")
    {
        return PortRole::Enum;
    }
    if (one.keyword == "interface" || one.isGeneric || depth > 20)
    {
        return PortRole::Other;
    }
    if (one.isStatic)
    {
        return PortRole::Data;
    }
    PortRole role = PortRole::Data;
    for (const std::string& base : one.bases)
    {
        const std::string_view plain = PlainTypeName(base);
        const CSharpClass* own = Find(base);
        if (plain == "ScriptableRendererFeature")
        {
            return PortRole::Feature;
        }
        if (plain == "ScriptableRenderPass")
        {
            return PortRole::Pass;
        }
        if (plain == "ContextItem")
        {
            return PortRole::Context;
        }
        if (plain == "VolumeComponent")
        {
            return PortRole::Component;
        }
        if (plain == "VolumeParameter")
        {
            return PortRole::Parameter;
        }
        if (own && own != &one)
        {
            role = ChooseRole(*own, depth + 1);
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

bool PortModel::isLeftOut(const CSharpClass& one) const
{
    const CSharpClass* outer = OuterOf(one);
    const bool isHomeless =
        RoleOf(one) == PortRole::Pass && outer && RoleOf(*outer) != PortRole::Feature;
    return RoleOf(one) == PortRole::Other || isHomeless || (outer && isLeftOut(*outer));
}

std::string PortModel::ClassName(const CSharpClass& one)
{
    return IsCppWord(one.name) ? one.name + "_" : one.name;
}

std::string PortModel::QualifiedName(const CSharpClass& one) const
{
    const CSharpClass* outer = OuterOf(one);
    return outer ? QualifiedName(*outer) + "::" + ClassName(one) : ClassName(one);
}

std::string PortModel::Place(const CSharpClass& one, const SourceLocation& location) const
{
    return std::filesystem::path(FileOf(one).path).filename().string() + ":" +
           std::to_string(location.line);
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
    const auto known = KnownTypes().find(type);
    if (known != KnownTypes().end())
    {
        return known->second;
    }
    return IsSameType(type) ? std::optional(type) : std::nullopt;
}

std::optional<std::string> PortModel::CppPointed(const std::string& type) const
{
    const CSharpClass* own = Find(type);
    return own && RoleOf(*own) == PortRole::Component ? "const " + ClassName(*own) : CppType(type);
}

std::string PortModel::CppDefault(const std::string& cppType)
{
    return cppType == "RenderQueueRange"   ? "{0, 0}"
           : cppType == "ProfilingSampler" ? "{\"\"}"
                                           : "{}";
}

std::optional<std::string> PortModel::CppParameter(const std::string& type) const
{
    static const std::map<std::string, std::string, std::less<>> references = {
        {"CommandBuffer", "CommandBuffer&"},
        {"RasterCommandBuffer", "RasterCommandBuffer&"},
        {"UnsafeCommandBuffer", "UnsafeCommandBuffer&"},
        {"RasterGraphContext", "RasterGraphContext&"},
        {"UnsafeGraphContext", "UnsafeGraphContext&"},
        {"ComputeCommandBuffer", "ComputeCommandBuffer&"},
        {"ComputeGraphContext", "ComputeGraphContext&"},
        {"ScriptableRenderContext", "ScriptableRenderContext&"},
        {"RenderingData", "RenderingData&"},
        {"CameraData", "CameraData&"},
        {"ScriptableRenderer", "ScriptableRenderer&"},
        {"RenderGraph", "RenderGraph&"},
        {"ContextContainer", "ContextContainer&"},
        {"UniversalResourceData", "UniversalResourceData&"},
        {"UniversalCameraData", "UniversalCameraData&"},
        {"UniversalRenderingData", "UniversalRenderingData&"},
        {"UniversalLightData", "UniversalLightData&"},
        {"CullingResults", "const CullingResults&"},
        {"VolumeStack", "const VolumeStack&"},
        {"MaterialPropertyBlock", "MaterialPropertyBlock&"},
        {"Camera", "const Camera&"}};
    const auto reference = references.find(type);
    if (reference != references.end())
    {
        return reference->second;
    }
    const CSharpClass* own = Find(type);
    if (own && RoleOf(*own) == PortRole::Context)
    {
        return isDeclared(*own) ? std::optional(QualifiedName(*own) + "&") : std::nullopt;
    }
    if (own && RoleOf(*own) == PortRole::Component && !OuterOf(*own))
    {
        return "const " + ClassName(*own) + "&";
    }
    if (own && RoleOf(*own) == PortRole::Data)
    {
        const auto cpp = CppType(type);
        // C# copies a struct and shares a class.
        return cpp ? std::optional(own->keyword == "class" ? *cpp + "&" : "const " + *cpp + "&")
                   : std::nullopt;
    }
    const auto cpp = CppType(type);
    const bool isSmall =
        cpp && (*cpp == "int" || *cpp == "float" || *cpp == "bool" || *cpp == "double" ||
                *cpp == "std::uint32_t" || *cpp == "ShaderPropertyId" || own ||
                *cpp == "RenderPassEvent" || *cpp == "LayerMask");
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
    const CSharpClass* own = Find(field.type);
    const bool isAlone = own && PlainTypeName(field.type).size() == field.type.size();
    if (isAlone && RoleOf(*own) == PortRole::Component)
    {
        const bool isNull = field.value.empty() || field.value.front().Is("null");
        return !OuterOf(*own) && isDeclared(*own) && !field.isStatic && isNull;
    }
    const bool isOne = isAlone && RoleOf(*own) == PortRole::Data && own->keyword == "class";
    const CSharpClass* pass = &one;
    while (pass && RoleOf(*pass) != PortRole::Pass)
    {
        pass = OuterOf(*pass);
    }
    const bool isMade = !field.value.empty() && field.value.front().Is("new");
    return isOne && pass && !field.isStatic && (!isMade || isAssigned(*pass, field.name));
}

bool PortModel::isAssigned(const CSharpClass& one, std::string_view field)
{
    return std::ranges::any_of(one.methods,
                               [&](const CSharpMethod& method)
                               {
                                   const CSharpWords body = method.body;
                                   for (std::size_t i = 0; i + 1 < body.size(); ++i)
                                   {
                                       if (body[i].Is(field) && body[i + 1].Is("="))
                                       {
                                           return true;
                                       }
                                   }
                                   return false;
                               });
}

bool PortModel::isSetting(const std::string& type) const
{
    static const std::set<std::string_view> types = {"int",
                                                     "uint",
                                                     "float",
                                                     "bool",
                                                     "string",
                                                     "string[]",
                                                     "List<string>",
                                                     "Color",
                                                     "Vector4",
                                                     "LayerMask",
                                                     "RenderingLayerMask",
                                                     "RenderPassEvent",
                                                     "Shader",
                                                     "Material",
                                                     "CompareFunction",
                                                     "StencilOp"};
    const CSharpClass* own = Find(type);
    return own ? CppType(type).has_value() && !type.ends_with("]") && !type.starts_with("List<")
               : types.contains(type);
}

bool PortModel::isSerialized(const CSharpField& field) const
{
    return ((field.isPublic && !field.isProperty) || field.Find("SerializeField")) &&
           !field.isStatic && !field.isReadonly && !field.Find("NonSerialized");
}

std::string PortModel::CppName(const std::string& name) const
{
    const bool isType = IsSameType(name) || KnownTypes().contains(name) || Find(name);
    return isType || IsCppWord(name) ? name + "_" : name;
}

} // namespace limn
