#include "state/StateTable.h"

namespace limn::test
{
namespace
{

constexpr VkBlendFactor k_Factors[] = {
    VK_BLEND_FACTOR_ZERO,
    VK_BLEND_FACTOR_ONE,
    VK_BLEND_FACTOR_DST_COLOR,
    VK_BLEND_FACTOR_SRC_COLOR,
    VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR,
    VK_BLEND_FACTOR_SRC_ALPHA,
    VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR,
    VK_BLEND_FACTOR_DST_ALPHA,
    VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA,
    VK_BLEND_FACTOR_SRC_ALPHA_SATURATE,
    VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
};
constexpr const char* k_FactorNames[] = {
    "Zero",
    "One",
    "DstColor",
    "SrcColor",
    "OneMinusDstColor",
    "SrcAlpha",
    "OneMinusSrcColor",
    "DstAlpha",
    "OneMinusDstAlpha",
    "SrcAlphaSaturate",
    "OneMinusSrcAlpha",
};

TEST(StateTable, HasTheDefaultsWithoutCommands)
{
    EXPECT_EQ("", Mistakes({}, StateOf(PassWith(""))));
}

TEST(StateTable, TranslatesCull)
{
    ExpectTable({{"Cull Back", {}},
                 {"Cull Front", {{"cullMode", VK_CULL_MODE_FRONT_BIT}}},
                 {"Cull Off", {{"cullMode", VK_CULL_MODE_NONE}}},
                 {"Cull False", {{"cullMode", VK_CULL_MODE_NONE}}}});
    ExpectNumbers("Cull [_P]", {{{"cullMode", VK_CULL_MODE_NONE}},
                                {{"cullMode", VK_CULL_MODE_FRONT_BIT}},
                                {{"cullMode", VK_CULL_MODE_BACK_BIT}}});
}

TEST(StateTable, TranslatesZTestForReversedDepth)
{
    const VulkanValues disabled = {
        {"depthTest", 0}, {"depthWrite", 0}, {"depthCompare", VK_COMPARE_OP_ALWAYS}};
    ExpectTable({{"ZTest Never", {{"depthCompare", VK_COMPARE_OP_NEVER}}},
                 {"ZTest Less", {{"depthCompare", VK_COMPARE_OP_GREATER}}},
                 {"ZTest Equal", {{"depthCompare", VK_COMPARE_OP_EQUAL}}},
                 {"ZTest LEqual", {}},
                 {"ZTest Greater", {{"depthCompare", VK_COMPARE_OP_LESS}}},
                 {"ZTest NotEqual", {{"depthCompare", VK_COMPARE_OP_NOT_EQUAL}}},
                 {"ZTest NEqual", {{"depthCompare", VK_COMPARE_OP_NOT_EQUAL}}},
                 {"ZTest GEqual", {{"depthCompare", VK_COMPARE_OP_LESS_OR_EQUAL}}},
                 {"ZTest Always", {{"depthCompare", VK_COMPARE_OP_ALWAYS}}},
                 {"ZTest Disabled", disabled},
                 {"ZTest Off", disabled},
                 {"ZTest False", disabled},
                 {"ZTest On", {}},
                 {"ZTest True", {}}});
    ExpectNumbers("ZTest [_P]", {disabled,
                                 {{"depthCompare", VK_COMPARE_OP_NEVER}},
                                 {{"depthCompare", VK_COMPARE_OP_GREATER}},
                                 {{"depthCompare", VK_COMPARE_OP_EQUAL}},
                                 {{"depthCompare", VK_COMPARE_OP_GREATER_OR_EQUAL}},
                                 {{"depthCompare", VK_COMPARE_OP_LESS}},
                                 {{"depthCompare", VK_COMPARE_OP_NOT_EQUAL}},
                                 {{"depthCompare", VK_COMPARE_OP_LESS_OR_EQUAL}},
                                 {{"depthCompare", VK_COMPARE_OP_ALWAYS}}});
}

TEST(StateTable, TranslatesTheSwitches)
{
    ExpectTable({{"ZWrite On", {}},
                 {"ZWrite True", {}},
                 {"ZWrite Off", {{"depthWrite", 0}}},
                 {"ZWrite False", {{"depthWrite", 0}}},
                 {"ZClip On", {}},
                 {"ZClip True", {}},
                 {"ZClip Off", {{"depthClamp", 1}}},
                 {"ZClip False", {{"depthClamp", 1}}},
                 {"AlphaToMask Off", {}},
                 {"AlphaToMask False", {}},
                 {"AlphaToMask On", {{"alphaToCoverage", 1}}},
                 {"AlphaToMask True", {{"alphaToCoverage", 1}}}});
    ExpectNumbers("ZWrite [_P]", {{{"depthWrite", 0}}, {}, {}});
    ExpectNumbers("ZClip [_P]", {{{"depthClamp", 1}}, {}, {}});
    ExpectNumbers("AlphaToMask [_P]", {{}, {{"alphaToCoverage", 1}}, {{"alphaToCoverage", 1}}});
}

TEST(StateTable, TranslatesOffsetForReversedDepth)
{
    ExpectTable(
        {{"Offset 0, 0", {}},
         {"Offset 1, 2", {{"depthBias", 1}, {"depthBiasSlope", -1.0}, {"depthBiasConstant", -2.0}}},
         {"Offset -.5, 0", {{"depthBias", 1}, {"depthBiasSlope", 0.5}}},
         {"Offset 0, -1", {{"depthBias", 1}, {"depthBiasConstant", 1.0}}}});
    EXPECT_EQ("", Mistakes({{"depthBias", 1}, {"depthBiasSlope", -0.75}},
                           StateOf(PassWith("Offset [_P], 0"), 0.75f)));
    EXPECT_EQ("", Mistakes({{"depthBias", 1}, {"depthBiasConstant", 3.0}},
                           StateOf(PassWith("Offset 0, [_P]"), -3.0f)));
}

TEST(StateTable, TranslatesEveryBlendFactorInEveryPlace)
{
    for (std::size_t i = 0; i < std::size(k_Factors); ++i)
    {
        const std::string name = k_FactorNames[i];
        const double factor = k_Factors[i];
        const VulkanValues source = EveryTarget({{"blendEnable", 1},
                                                 {"srcColor", factor},
                                                 {"srcAlpha", factor},
                                                 {"dstColor", VK_BLEND_FACTOR_ONE},
                                                 {"dstAlpha", VK_BLEND_FACTOR_ONE}});
        const VulkanValues alpha = EveryTarget({{"blendEnable", i > 0}, {"dstAlpha", factor}});
        ExpectTable({{"Blend " + name + " One", source}, {"Blend One Zero, One " + name, alpha}});
        const float number = static_cast<float>(i);
        EXPECT_EQ("", Mistakes(source, StateOf(PassWith("Blend [_P] One"), number))) << name;
        EXPECT_EQ("", Mistakes(alpha, StateOf(PassWith("Blend One Zero, One [_P]"), number)))
            << name;
    }
    ExpectTable({{"Blend Off", {}}, {"Blend False", {}}, {"Blend One One Blend Off", {}}});
    ExpectTable({{"Blend One Zero", {}}}); // which is what happens without
}

TEST(StateTable, TranslatesBlendOp)
{
    constexpr VkBlendOp ops[] = {VK_BLEND_OP_ADD, VK_BLEND_OP_SUBTRACT,
                                 VK_BLEND_OP_REVERSE_SUBTRACT, VK_BLEND_OP_MIN, VK_BLEND_OP_MAX};
    constexpr const char* names[] = {"Add", "Sub", "RevSub", "Min", "Max"};
    for (std::size_t i = 0; i < std::size(ops); ++i)
    {
        const std::string name = names[i];
        const double op = ops[i];
        const double enabled = i > 0; // Blend One Zero with Add is none
        const VulkanValues both =
            EveryTarget({{"blendEnable", enabled}, {"colorOp", op}, {"alphaOp", op}});
        const VulkanValues alpha = EveryTarget({{"blendEnable", enabled}, {"alphaOp", op}});
        ExpectTable({{"Blend One Zero BlendOp " + name, both},
                     {"Blend One Zero BlendOp Add, " + name, alpha},
                     {"BlendOp " + name, {}}}); // no Blend, no effect
        EXPECT_EQ("", Mistakes(both, StateOf(PassWith("Blend One Zero BlendOp [_P]"),
                                             static_cast<float>(i))))
            << name;
    }
}

TEST(StateTable, TranslatesLogicalBlendOps)
{
    constexpr std::pair<const char*, VkLogicOp> k_Ops[] = {
        {"LogicalClear", VK_LOGIC_OP_CLEAR},
        {"LogicalSet", VK_LOGIC_OP_SET},
        {"LogicalCopy", VK_LOGIC_OP_COPY},
        {"LogicalCopyInverted", VK_LOGIC_OP_COPY_INVERTED},
        {"LogicalNoop", VK_LOGIC_OP_NO_OP},
        {"LogicalInvert", VK_LOGIC_OP_INVERT},
        {"LogicalAnd", VK_LOGIC_OP_AND},
        {"LogicalNand", VK_LOGIC_OP_NAND},
        {"LogicalOr", VK_LOGIC_OP_OR},
        {"LogicalNor", VK_LOGIC_OP_NOR},
        {"LogicalXor", VK_LOGIC_OP_XOR},
        {"LogicalEquiv", VK_LOGIC_OP_EQUIVALENT},
        {"LogicalAndReverse", VK_LOGIC_OP_AND_REVERSE},
        {"LogicalAndInverted", VK_LOGIC_OP_AND_INVERTED},
        {"LogicalOrReverse", VK_LOGIC_OP_OR_REVERSE},
        {"LogicalOrInverted", VK_LOGIC_OP_OR_INVERTED}};
    float number = 5.0f; // Unity's for the first
    for (const auto& [name, op] : k_Ops)
    {
        const VulkanValues expected = {{"logicOp", op}};
        ExpectTable({{"Blend One Zero BlendOp " + std::string(name), expected},
                     {"BlendOp " + std::string(name), {}}}); // no Blend, no effect
        EXPECT_EQ("", Mistakes(expected, StateOf(PassWith("Blend One Zero BlendOp [_P]"), number)))
            << name;
        number += 1.0f;
    }
}

TEST(StateTable, TranslatesAdvancedBlendOps)
{
    constexpr std::pair<const char*, VkBlendOp> k_Ops[] = {
        {"Multiply", VK_BLEND_OP_MULTIPLY_EXT},
        {"Screen", VK_BLEND_OP_SCREEN_EXT},
        {"Overlay", VK_BLEND_OP_OVERLAY_EXT},
        {"Darken", VK_BLEND_OP_DARKEN_EXT},
        {"Lighten", VK_BLEND_OP_LIGHTEN_EXT},
        {"ColorDodge", VK_BLEND_OP_COLORDODGE_EXT},
        {"ColorBurn", VK_BLEND_OP_COLORBURN_EXT},
        {"HardLight", VK_BLEND_OP_HARDLIGHT_EXT},
        {"SoftLight", VK_BLEND_OP_SOFTLIGHT_EXT},
        {"Difference", VK_BLEND_OP_DIFFERENCE_EXT},
        {"Exclusion", VK_BLEND_OP_EXCLUSION_EXT},
        {"HSLHue", VK_BLEND_OP_HSL_HUE_EXT},
        {"HSLSaturation", VK_BLEND_OP_HSL_SATURATION_EXT},
        {"HSLColor", VK_BLEND_OP_HSL_COLOR_EXT},
        {"HSLLuminosity", VK_BLEND_OP_HSL_LUMINOSITY_EXT}};
    float number = 21.0f; // Unity's for the first
    for (const auto& [name, op] : k_Ops)
    {
        const double value = op;
        const VulkanValues expected =
            EveryTarget({{"blendEnable", 1}, {"colorOp", value}, {"alphaOp", value}});
        ExpectTable({{"Blend One Zero BlendOp " + std::string(name), expected},
                     {"BlendOp " + std::string(name), {}}});
        EXPECT_EQ("", Mistakes(expected, StateOf(PassWith("Blend One Zero BlendOp [_P]"), number)))
            << name;
        number += 1.0f;
    }
}

TEST(StateTable, TranslatesConservative)
{
    const VulkanValues on = {{"conservative", VK_CONSERVATIVE_RASTERIZATION_MODE_OVERESTIMATE_EXT}};
    ExpectTable({{"Conservative True", on}, {"Conservative On", on}, {"Conservative False", {}}});
    ExpectNumbers("Conservative [_P]", {{}, on, on});
}

TEST(StateTable, TranslatesColorMask)
{
    constexpr int r = VK_COLOR_COMPONENT_R_BIT;
    constexpr int g = VK_COLOR_COMPONENT_G_BIT;
    constexpr int b = VK_COLOR_COMPONENT_B_BIT;
    constexpr int a = VK_COLOR_COMPONENT_A_BIT;
    // Unity's numbers: alpha is 1, blue 2, green 4, red 8.
    constexpr int masks[] = {0, a,     b,     b | a,     g,     g | a,     g | b,     g | b | a,
                             r, r | a, r | b, r | b | a, r | g, r | g | a, r | g | b, 0xF};
    constexpr const char* letters[] = {"0", "A",  "B",  "BA",  "G",  "GA",  "GB",  "GBA",
                                       "R", "RA", "RB", "RBA", "RG", "RGA", "RGB", "RGBA"};
    for (std::size_t i = 0; i < std::size(masks); ++i)
    {
        const VulkanValues expected = EveryTarget({{"writeMask", masks[i]}});
        ExpectTable({{"ColorMask " + std::string(letters[i]), expected}});
        EXPECT_EQ("",
                  Mistakes(expected, StateOf(PassWith("ColorMask [_P]"), static_cast<float>(i))))
            << i;
    }
    ExpectTable({{"ColorMask Off", EveryTarget({{"writeMask", 0}})}, {"ColorMask bgra", {}}});
}

TEST(StateTable, TranslatesCommandsForOneTarget)
{
    ExpectTable(
        {{"Blend 1 SrcAlpha One, Zero One",
          {{"1.blendEnable", 1},
           {"1.srcColor", VK_BLEND_FACTOR_SRC_ALPHA},
           {"1.dstColor", VK_BLEND_FACTOR_ONE},
           {"1.srcAlpha", VK_BLEND_FACTOR_ZERO},
           {"1.dstAlpha", VK_BLEND_FACTOR_ONE}}},
         {"Blend 7 One Zero BlendOp 7 Max, Min",
          {{"7.blendEnable", 1}, {"7.colorOp", VK_BLEND_OP_MAX}, {"7.alphaOp", VK_BLEND_OP_MIN}}},
         {"ColorMask RG 3", {{"3.writeMask", VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT}}},
         {"ColorMask 0 0", {{"0.writeMask", 0}}},
         {"Blend 2 One One Blend 2 Off", {}}});
}

TEST(StateTable, InheritsFromCategoryAndSubShaderUpToThePass)
{
    const std::string text = "Category { Cull Off ZWrite Off Stencil { Ref 1 }\n"
                             "SubShader { ZTest Always Pass { ZWrite On } Cull Front\n"
                             "Pass { Stencil { Comp Equal } } } }";
    EXPECT_EQ("", Mistakes({{"cullMode", VK_CULL_MODE_NONE},
                            {"depthCompare", VK_COMPARE_OP_ALWAYS},
                            {"stencilTest", 1},
                            {"front.reference", 1},
                            {"back.reference", 1}},
                           StateOf(text, 0.0f, 0)));
    EXPECT_EQ("", Mistakes({{"cullMode", VK_CULL_MODE_FRONT_BIT},
                            {"depthCompare", VK_COMPARE_OP_ALWAYS},
                            {"depthWrite", 0},
                            {"stencilTest", 1},
                            {"front.compareOp", VK_COMPARE_OP_EQUAL},
                            {"back.compareOp", VK_COMPARE_OP_EQUAL}},
                           StateOf(text, 0.0f, 1)));
}

TEST(StateTable, TakesTheLastOfEqualCommands)
{
    ExpectTable({{"Cull Off Cull Front", {{"cullMode", VK_CULL_MODE_FRONT_BIT}}},
                 {"Cull [_P] Cull Back", {}},
                 {"ZTest Never ZTest LEqual", {}},
                 {"ZWrite Off ZWrite On", {}},
                 {"Blend One One Blend Off", {}},
                 {"BlendOp Max BlendOp Add", {}},
                 {"ColorMask 0 ColorMask RGBA", {}},
                 {"Offset 1, 1 Offset 0, 0", {}},
                 {"Stencil { Ref 1 Ref 2 CompFront Less Comp Equal }",
                  BothFaces({{"reference", 2}, {"compareOp", VK_COMPARE_OP_EQUAL}})}});
}

TEST(StateTable, RoundsNumbersOfPropertiesToTheNearestMember)
{
    EXPECT_EQ(
        "", Mistakes({{"cullMode", VK_CULL_MODE_FRONT_BIT}}, StateOf(PassWith("Cull [_P]"), 0.6f)));
    EXPECT_EQ("", Mistakes({{"depthWrite", 0}}, StateOf(PassWith("ZWrite [_P]"), 0.0f)));
}

TEST(StateTable, TestsNothingThatTheTargetsLack)
{
    vulkan::TargetFormats colorOnly = AllTargets();
    colorOnly.depth = VK_FORMAT_UNDEFINED;
    colorOnly.stencil = VK_FORMAT_UNDEFINED;
    EXPECT_EQ("", Mistakes({{"depthTest", 0}, {"depthWrite", 0}},
                           StateOf(PassWith("Stencil { }"), 0.0f, 0, colorOnly)));
}

} // namespace
} // namespace limn::test
