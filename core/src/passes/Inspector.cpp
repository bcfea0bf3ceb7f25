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

} // namespace limn
