#include "port/PortMember.h"
#include "port/PortOperator.h"

#include <limn/base/WordList.h>

namespace limn
{

namespace
{

using Result = std::optional<PortValue>;

/// Returns the mask of rendering layers or of layers that a number is, or nothing.
Result AsMask(const PortValue& value, const std::string& wanted)
{
    if (value.type != "int" && value.type != "uint")
    {
        return std::nullopt;
    }
    if (!value.isLiteral)
    {
        const std::string bits =
            value.type == "uint" ? value.cpp : "static_cast<std::uint32_t>(" + value.cpp + ")";
        return PortValue{wanted + "(" + bits + ")", wanted};
    }
    const bool isAll = IsIn(value.cpp, {"-1", "~0", "0xFFFFFFFFu", "4294967295u"});
    const bool isNone = value.cpp == "0" || value.cpp == "0u";
    if (isAll || isNone)
    {
        return PortValue{wanted + (isAll ? "::Everything()" : "::Nothing()"), wanted};
    }
    if (value.cpp[0] == '-' || value.cpp[0] == '~')
    {
        return std::nullopt;
    }
    return PortValue{wanted + "(" + value.cpp + (value.type == "int" ? "u)" : ")"), wanted};
}

/// Returns the value with another type that it turns into in C#, or nothing.
Result AsOther(const PortValue& value, const std::string& wanted)
{
    const auto is = [&](std::string_view from, std::string_view to)
    {
        return value.type == from && wanted == to;
    };
    std::string cpp;
    if (is("RenderTextureFormat", "GraphicsFormat"))
    {
        cpp = "ToGraphicsFormat(" + value.cpp + ", true)";
    }
    else if (is("LayerMask", "int") || is("RenderingLayerMask", "uint"))
    {
        cpp = wanted == "int" ? "static_cast<int>(" + value.Text(90) + ".bits)"
                              : value.Text(90) + ".bits";
    }
    else if (is("Color", "Vector4"))
    {
        cpp = value.Text(90) + ".vector()";
    }
    else if (is("Vector3", "Vector4"))
    {
        cpp = "Vector4(" + value.cpp + ", 0.0f)";
    }
    else if (is("Vector2", "Vector4"))
    {
        cpp = "Vector4(" + value.cpp + ", 0.0f, 0.0f)";
    }
    else if (is("Vector4", "Vector3") || is("Vector3", "Vector2") || is("Vector4", "Vector2"))
    {
        cpp = wanted + "(" + value.cpp + ")";
    }
    else if (is("TextureHandle", "RenderTargetIdentifier"))
    {
        cpp = "RTHandle(" + value.cpp + ")";
    }
    else if (value.type == "RTHandle" && wanted == "RenderTexture")
    {
        cpp = value.Text(90) + ".rt()";
    }
    else if (wanted == "RenderTargetIdentifier" &&
             IsIn(value.type, {"Texture", "Texture2D", "RenderTexture"}))
    {
        cpp = wanted + "(" + value.cpp + ")";
    }
    else if ((wanted == "RenderTargetIdentifier" &&
              IsIn(value.type,
                   {"RTHandle", "ShaderPropertyId", "BuiltinRenderTextureType", "string"})) ||
             (wanted == "Texture" &&
              IsIn(value.type, {"Texture2D", "Texture3D", "Cubemap", "RenderTexture"})) ||
             is("TextureHandle", "RTHandle") || is("float", "double") || is("int", "double"))
    {
        cpp = value.cpp;
    }
    return cpp.empty() ? std::nullopt : Result(PortValue{cpp, wanted});
}

} // namespace

std::string BaseTypeOf(PortRole role)
{
    return role == PortRole::Pass        ? "ScriptableRenderPass"
           : role == PortRole::Feature   ? "ScriptableRendererFeature"
           : role == PortRole::Component ? "VolumeComponent"
                                         : "";
}

std::string ElementTypeOf(const std::string& type)
{
    return type.ends_with("[]")                               ? type.substr(0, type.size() - 2)
           : type.starts_with("List<") && type.ends_with(">") ? type.substr(5, type.size() - 6)
                                                              : "";
}

bool IsSharedType(const PortModel& model, const std::string& type)
{
    const auto cpp = model.Find(type) ? std::nullopt : model.CppType(type);
    return cpp && cpp->starts_with("Shared<");
}

bool IsReferenceType(const PortModel& model, const std::string& type)
{
    static const WordList types(
        "Camera CameraData CommandBuffer ComputeCommandBuffer ComputeGraphContext ContextContainer "
        "CullingResults IComputeRenderGraphBuilder IRasterRenderGraphBuilder "
        "IUnsafeRenderGraphBuilder LightData RasterCommandBuffer RasterGraphContext RenderGraph "
        "RenderingData ScriptableRenderContext ScriptableRenderer ShadowData UniversalCameraData "
        "UniversalRenderer "
        "UniversalLightData UniversalRenderingData UniversalResourceData UnsafeCommandBuffer "
        "UniversalShadowData UnsafeGraphContext VolumeManager VolumeStack Transform Light");
    const CSharpClass* own = model.Find(type);
    return own ? own->keyword == "class" : types.Has(type);
}

std::string ParameterValueType(const std::string& parameter)
{
    if (parameter.find("Texture") != std::string::npos)
    {
        return "Texture";
    }
    for (const auto& [part, value] :
         {std::pair("Int", "int"), std::pair("Bool", "bool"), std::pair("Float", "float"),
          std::pair("Color", "Color"), std::pair("Vector2", "Vector2"),
          std::pair("Vector3", "Vector3"), std::pair("Vector4", "Vector4"),
          std::pair("RenderingLayerMask", "RenderingLayerMask"),
          std::pair("LayerMask", "LayerMask"), std::pair("FloatRange", "Vector2")})
    {
        if (parameter.ends_with(std::string(part) + "Parameter"))
        {
            return value;
        }
    }
    return "";
}

std::optional<PortValue> CastNumber(const PortModel& model, const PortValue& value,
                                    const std::string& type)
{
    const CSharpClass* own = model.Find(type);
    const bool isEnum = own && model.RoleOf(*own) == PortRole::Enum;
    const CSharpClass* from = model.Find(value.type);
    const auto cpp = model.CppType(type);
    static const WordList enums("AccessFlags BlendMode CameraType ClearFlag ColorWriteMask "
                                "CompareFunction CullMode FilterMode GraphicsFormat "
                                "RenderPassEvent RenderQueueType RenderStateMask "
                                "RenderTextureFormat ScriptableRenderPassInput "
                                "SortingCriteria StencilOp TextureWrapMode");
    const bool isFromEnum =
        from ? model.RoleOf(*from) == PortRole::Enum
             : enums.Has(value.type) ||
                   (!value.type.empty() && value.cpp.starts_with(value.type + "::"));
    if (cpp &&
        ((enums.Has(type) && value.type == "int") ||
         (IsNumber(type) && (IsNumber(value.type) || isFromEnum || value.type == "double")) ||
         (isEnum && IsNumber(value.type))))
    {
        return PortValue{"static_cast<" + *cpp + ">(" + value.cpp + ")", type};
    }
    return std::nullopt;
}

std::optional<PortValue> Converted(const PortModel& model, PortValue value,
                                   const std::string& wanted)
{
    const CSharpClass* own = wanted.empty() ? nullptr : model.Find(wanted);
    if (wanted.empty())
    {
        return value;
    }
    if (value.type == "ScriptableRenderer" && wanted == "UniversalRenderer")
    {
        value.type = wanted; // limn has one kind
    }
    if (value.type == wanted || value.type.empty() || (own && own == model.Find(value.type)))
    {
        value.cpp = value.isPointer ? "*" + value.Text(90) : value.cpp;
        value.strength = value.isPointer ? 90 : value.strength;
        value.isPointer = false;
        return value;
    }
    if (wanted == k_PropertyIdType && value.type == "int" && IsIn(value.cpp, {"0", "-1"}))
    {
        return PortValue{"{}", wanted}; // no property yet
    }
    const bool isHex = value.cpp.find_first_of("xX~") != std::string::npos;
    if (wanted == "float" && (value.type == "int" || value.type == "uint"))
    {
        return value.isLiteral && !isHex && value.type == "int"
                   ? PortValue{value.cpp + ".0f", "float", true}
                   : PortValue{"static_cast<float>(" + value.cpp + ")", "float"};
    }
    if (wanted == "uint" && value.type == "int" && value.isLiteral && value.cpp[0] != '-')
    {
        return PortValue{value.cpp + "u", "uint", true};
    }
    if (!own && (wanted == "LayerMask" || wanted.ends_with("RenderingLayerMask")))
    {
        return AsMask(value, wanted);
    }
    if (wanted == "bool" && (value.isPointer || IsSharedType(model, value.type)))
    {
        return PortValue{value.cpp + " != nullptr", "bool", false, false, false, false, false, 5};
    }
    if (value.type == "null" && wanted != "ProfilingSampler")
    {
        return PortValue{PortModel::CppDefault(model.CppType(wanted).value_or("")), wanted};
    }
    return AsOther(value, wanted);
}

} // namespace limn
