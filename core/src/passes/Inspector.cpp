#include <limn/core/Inspector.h>

namespace limn
{

std::span<const EnumEntry> RenderPassEventEntries()
{
    static constexpr EnumEntry k_Entries[] = {
        {"BeforeRendering", 0},
        {"BeforeRenderingShadows", 50},
        {"AfterRenderingShadows", 100},
        {"BeforeRenderingPrePasses", 150},
        {"AfterRenderingPrePasses", 200},
        {"BeforeRenderingGbuffer", 210},
        {"AfterRenderingGbuffer", 220},
        {"BeforeRenderingDeferredLights", 230},
        {"AfterRenderingDeferredLights", 240},
        {"BeforeRenderingOpaques", 250},
        {"AfterRenderingOpaques", 300},
        {"BeforeRenderingSkybox", 350},
        {"AfterRenderingSkybox", 400},
        {"BeforeRenderingTransparents", 450},
        {"AfterRenderingTransparents", 500},
        {"BeforeRenderingPostProcessing", 550},
        {"AfterRenderingPostProcessing", 600},
        {"AfterRendering", 1000},
    };
    return k_Entries;
}

std::span<const EnumEntry> CompareFunctionEntries()
{
    static constexpr EnumEntry k_Entries[] = {{"Disabled", 0}, {"Never", 1},        {"Less", 2},
                                              {"Equal", 3},    {"LessEqual", 4},    {"Greater", 5},
                                              {"NotEqual", 6}, {"GreaterEqual", 7}, {"Always", 8}};
    return k_Entries;
}

std::span<const EnumEntry> StencilOpEntries()
{
    static constexpr EnumEntry k_Entries[] = {{"Keep", 0},
                                              {"Zero", 1},
                                              {"Replace", 2},
                                              {"IncrementSaturate", 3},
                                              {"DecrementSaturate", 4},
                                              {"Invert", 5},
                                              {"IncrementWrap", 6},
                                              {"DecrementWrap", 7}};
    return k_Entries;
}

std::span<const EnumEntry> CameraTypeEntries()
{
    static constexpr EnumEntry k_Entries[] = {
        {"Game", 1}, {"SceneView", 2}, {"Preview", 4}, {"Reflection", 16}, {"Everything", -1}};
    return k_Entries;
}

std::span<const EnumEntry> FilterModeEntries()
{
    static constexpr EnumEntry k_Entries[] = {{"Point", 0}, {"Bilinear", 1}, {"Trilinear", 2}};
    return k_Entries;
}

std::span<const EnumEntry> TextureWrapModeEntries()
{
    static constexpr EnumEntry k_Entries[] = {
        {"Repeat", 0}, {"Clamp", 1}, {"Mirror", 2}, {"MirrorOnce", 3}};
    return k_Entries;
}

std::span<const EnumEntry> RenderTextureFormatEntries()
{
    static constexpr EnumEntry k_Entries[] = {
        {"ARGB32", 0},          {"Depth", 1},   {"ARGBHalf", 2},
        {"Shadowmap", 3},       {"RGB565", 4},  {"ARGB4444", 5},
        {"ARGB1555", 6},        {"Default", 7}, {"ARGB2101010", 8},
        {"DefaultHDR", 9},      {"ARGB64", 10}, {"ARGBFloat", 11},
        {"RGFloat", 12},        {"RGHalf", 13}, {"RFloat", 14},
        {"RHalf", 15},          {"R8", 16},     {"ARGBInt", 17},
        {"RGInt", 18},          {"RInt", 19},   {"BGRA32", 20},
        {"RGB111110Float", 22}, {"RG32", 23},   {"RGBAUShort", 24},
        {"RG16", 25},           {"R16", 28}};
    return k_Entries;
}

std::span<const EnumEntry> CullModeEntries()
{
    static constexpr EnumEntry k_Entries[] = {{"Off", 0}, {"Front", 1}, {"Back", 2}};
    return k_Entries;
}

std::span<const EnumEntry> BlendModeEntries()
{
    static constexpr EnumEntry k_Entries[] = {{"Zero", 0},
                                              {"One", 1},
                                              {"DstColor", 2},
                                              {"SrcColor", 3},
                                              {"OneMinusDstColor", 4},
                                              {"SrcAlpha", 5},
                                              {"OneMinusSrcColor", 6},
                                              {"DstAlpha", 7},
                                              {"OneMinusDstAlpha", 8},
                                              {"SrcAlphaSaturate", 9},
                                              {"OneMinusSrcAlpha", 10}};
    return k_Entries;
}

} // namespace limn
