#include "shader_graph/GraphTarget.h"

#include "shader_graph/GraphValue.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

// The names by Unity's numbers.
constexpr const char* k_Faces[] = {"Off", "Front", "Back"};
constexpr const char* k_Tests[] = {"Always",  "Never",    "Less",   "Equal", "LEqual",
                                   "Greater", "NotEqual", "GEqual", "Always"};
constexpr const char* k_Blends[] = {"SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha",
                                    "One OneMinusSrcAlpha, One OneMinusSrcAlpha",
                                    "SrcAlpha One, One One", "DstColor Zero"};
constexpr const char* k_Factors[] = {"Zero",
                                     "One",
                                     "DstColor",
                                     "SrcColor",
                                     "OneMinusDstColor",
                                     "SrcAlpha",
                                     "OneMinusSrcColor",
                                     "DstAlpha",
                                     "OneMinusDstAlpha",
                                     "SrcAlphaSaturate",
                                     "OneMinusSrcAlpha"};
constexpr const char* k_BlendOps[] = {"Add", "Sub", "RevSub", "Min", "Max"};
constexpr const char* k_StencilOps[] = {"Keep",    "Zero",   "Replace",  "IncrSat",
                                        "DecrSat", "Invert", "IncrWrap", "DecrWrap"};
constexpr const char* k_DepthModes[] = {"EYE", "LINEAR01", "RAW"};

template <std::size_t Count>
std::string NameOf(const char* const (&names)[Count], int index)
{
    return names[static_cast<std::size_t>(std::clamp(index, 0, static_cast<int>(Count) - 1))];
}

} // namespace

GraphTarget::GraphTarget(const GraphFile& file)
{
    const std::string name = file.path().generic_string();
    for (const Json* target : file.FindAll(PartOf(file.graph(), "m_ActiveTargets")))
    {
        m_Target = GraphTypeOf(*target) == "UniversalTarget" ? target : m_Target;
    }
    if (m_Target == nullptr)
    {
        throw AssetError(name, {}, "the graph has no target for URP");
    }
    m_SubTarget = file.Find(PartOf(*m_Target, "m_ActiveSubTarget"));
    m_Kind = m_SubTarget != nullptr ? GraphTypeOf(*m_SubTarget) : "";
    m_Screen = file.FindOfType("FullscreenData");
    if (!IsLit() && !IsSprite() && !IsScreen() && m_Kind != "UniversalUnlitSubTarget")
    {
        throw AssetError(name, {},
                         "the graph's target is " + m_Kind +
                             ", which limn does not translate; it translates Lit, Unlit, Sprite "
                             "and Fullscreen");
    }
}

int GraphTarget::Setting(const char* name, int otherwise) const
{
    return m_Target->contains(name) ? IntIn(*m_Target, name) : otherwise;
}

int GraphTarget::ScreenSetting(const char* name) const
{
    return m_Screen != nullptr ? IntIn(*m_Screen, name) : 0;
}

int GraphTarget::RenderFace() const
{
    return Setting("m_RenderFace", Setting("m_TwoSided", 0) != 0 ? 0 : 2);
}

bool GraphTarget::WritesDepth() const
{
    const int control = Setting("m_ZWriteControl", 0); // automatic, always or never
    return !IsSprite() && (control == 1 || (control == 0 && !IsTransparent()));
}

std::string GraphTarget::TagsText() const
{
    const std::string pipeline = "        Tags { \"RenderPipeline\" = \"UniversalPipeline\"";
    if (IsScreen())
    {
        return pipeline + " }\n";
    }
    const char* queue = IsTransparent()                  ? "Transparent"
                        : Setting("m_AlphaClip", 0) != 0 ? "AlphaTest"
                                                         : "Geometry";
    return pipeline + " \"RenderType\" = \"" + (IsTransparent() ? "Transparent" : "Opaque") +
           "\" \"Queue\" = \"" + queue + "\" }\n";
}

std::string GraphTarget::CullText() const
{
    return GraphLine("Cull " + (IsSprite() || IsScreen() ? "Off"
                                : IsOverridden()         ? "[_Cull]"
                                                         : NameOf(k_Faces, RenderFace())));
}

std::string GraphTarget::StateText() const
{
    if (IsScreen())
    {
        return GraphLine("Blend " + ScreenBlendText()) +
               GraphLine("ZTest " + NameOf(k_Tests, ScreenSetting("m_DepthTestMode"))) +
               GraphLine(ScreenSetting("m_DepthWrite") != 0 ? "ZWrite On" : "ZWrite Off") +
               StencilText();
    }
    return GraphLine("Blend " + BlendText()) +
           GraphLine("ZTest " +
                     (IsOverridden() ? "[_ZTest]" : NameOf(k_Tests, Setting("m_ZTestMode", 4)))) +
           GraphLine(IsOverridden()  ? "ZWrite [_ZWrite]"
                     : WritesDepth() ? "ZWrite On"
                                     : "ZWrite Off");
}

std::string GraphTarget::BlendText() const
{
    return IsOverridden()     ? "[_SrcBlend] [_DstBlend]"
           : !IsTransparent() ? "Off"
                              : NameOf(k_Blends, Setting("m_AlphaMode", 0));
}

std::string GraphTarget::ScreenBlendText() const
{
    const int mode = ScreenSetting("m_BlendMode");
    if (mode < 5)
    {
        return mode == 0 ? "Off" : NameOf(k_Blends, mode - 1);
    }
    const auto factor = [&](const char* key)
    {
        return NameOf(k_Factors, ScreenSetting(key));
    };
    const auto operation = [&](const char* key)
    {
        return NameOf(k_BlendOps, ScreenSetting(key));
    };
    return factor("m_SrcColorBlendMode") + " " + factor("m_DstColorBlendMode") + ", " +
           factor("m_SrcAlphaBlendMode") + " " + factor("m_DstAlphaBlendMode") +
           "\n            BlendOp " + operation("m_ColorBlendOperation") + ", " +
           operation("m_AlphaBlendOperation");
}

std::string GraphTarget::StencilText() const
{
    if (ScreenSetting("m_EnableStencil") == 0)
    {
        return "";
    }
    const auto number = [&](const char* key)
    {
        return std::to_string(ScreenSetting(key));
    };
    const auto operation = [&](const char* key)
    {
        return NameOf(k_StencilOps, ScreenSetting(key));
    };
    return GraphLine("Stencil") + GraphLine("{") +
           GraphLine("    Ref " + number("m_StencilReference")) +
           GraphLine("    ReadMask " + number("m_StencilReadMask")) +
           GraphLine("    WriteMask " + number("m_StencilWriteMask")) +
           GraphLine("    Comp " + NameOf(k_Tests, ScreenSetting("m_StencilCompareFunction"))) +
           GraphLine("    Pass " + operation("m_StencilPassOperation")) +
           GraphLine("    Fail " + operation("m_StencilFailOperation")) +
           GraphLine("    ZFail " + operation("m_StencilDepthFailOperation")) + GraphLine("}");
}

std::string GraphTarget::DefinesText() const
{
    std::string text;
    const auto add = [&](bool isSet, const std::string& line)
    {
        text += isSet ? GraphLine("#" + line) : "";
    };
    if (IsScreen())
    {
        add(ScreenSetting("m_DepthWrite") != 0, "define DEPTH_WRITE 1");
        add(ScreenSetting("m_DepthWrite") != 0,
            "define DEPTH_WRITE_MODE_" + NameOf(k_DepthModes, ScreenSetting("m_depthWriteMode")));
        return text;
    }
    if (IsOverridden())
    {
        for (const char* keyword :
             {"_SURFACE_TYPE_TRANSPARENT", "_ALPHATEST_ON", "_ALPHAPREMULTIPLY_ON",
              "_ALPHAMODULATE_ON", "_RECEIVE_SHADOWS_OFF"})
        {
            add(true, std::string("pragma shader_feature_local_fragment _ ") + keyword);
        }
    }
    else
    {
        const int mode = Setting("m_AlphaMode", 0);
        const bool isCut = Setting("m_AlphaClip", 0) != 0;
        add(IsTransparent(), "define _SURFACE_TYPE_TRANSPARENT 1");
        add(IsTransparent() && mode == 1, "define _ALPHAPREMULTIPLY_ON 1");
        add(IsTransparent() && mode == 3, "define _ALPHAMODULATE_ON 1");
        add(isCut, "define _ALPHATEST_ON 1");
        add(isCut && IsSprite(), "define ALPHA_CLIP_THRESHOLD 1");
        add(Setting("m_ReceiveShadows", 1) == 0, "define _RECEIVE_SHADOWS_OFF 1");
    }
    add(IsLit() && NumberIn(*m_SubTarget, "m_WorkflowMode") == 0, "define _SPECULAR_SETUP 1");
    add(IsLit() && NumberIn(*m_SubTarget, "m_ClearCoat") != 0, "define _CLEARCOAT 1");
    return text;
}

std::string GraphTarget::PropertiesText() const
{
    if (!IsOverridden())
    {
        return "";
    }
    const std::pair<const char*, int> values[] = {
        {"_Surface", IsTransparent() ? 1 : 0},     {"_Blend", Setting("m_AlphaMode", 0)},
        {"_AlphaClip", Setting("m_AlphaClip", 0)}, {"_SrcBlend", IsTransparent() ? 5 : 1},
        {"_DstBlend", IsTransparent() ? 10 : 0},   {"_ZWrite", WritesDepth() ? 1 : 0},
        {"_ZTest", Setting("m_ZTestMode", 4)},     {"_Cull", RenderFace()}};
    std::string text;
    for (const auto& [name, value] : values)
    {
        text += std::string("        [HideInInspector] ") + name + "(\"" + name +
                "\", Float) = " + std::to_string(value) + "\n";
    }
    return text;
}

} // namespace limn
