#include "ShaderTestSupport.h"

namespace limn
{
namespace
{

RenderState State(const std::string& commands)
{
    return test::ParsePass(commands).state;
}

template <typename T>
struct ValueCase
{
    const char* text;
    T value;
};

TEST(RenderState, HasShaderLabsDefaultsWithoutCommands)
{
    const RenderState state = State("");
    EXPECT_EQ(state.cull.value, CullMode::Back);
    EXPECT_EQ(state.zTest.value, CompareFunction::LessEqual);
    EXPECT_TRUE(state.zWrite.value);
    EXPECT_TRUE(state.zClip.value);
    EXPECT_FALSE(state.alphaToMask.value);
    EXPECT_FALSE(state.conservative.value);
    EXPECT_EQ(state.offsetFactor.value, 0.0f);
    EXPECT_FALSE(state.targets[0].enabled);
    EXPECT_EQ(state.targets[7].writeMask.value, 15);
    EXPECT_FALSE(state.separateBlend);
    EXPECT_FALSE(state.stencil.enabled);
}

TEST(RenderState, TakesEveryValueOfCull)
{
    for (const auto& [text, value] : {ValueCase<CullMode>{"Back", CullMode::Back},
                                      {"Front", CullMode::Front},
                                      {"Off", CullMode::Off},
                                      {"False", CullMode::Off}})
    {
        EXPECT_EQ(State("Cull " + std::string(text)).cull, value) << text;
    }
}

TEST(RenderState, TakesEveryValueOfZTest)
{
    using enum CompareFunction;
    for (const auto& [text, value] : {ValueCase<CompareFunction>{"Never", Never},
                                      {"Less", Less},
                                      {"Equal", Equal},
                                      {"LEqual", LessEqual},
                                      {"Greater", Greater},
                                      {"NotEqual", NotEqual},
                                      {"NEqual", NotEqual},
                                      {"GEqual", GreaterEqual},
                                      {"Always", Always},
                                      {"Off", Disabled},
                                      {"False", Disabled},
                                      {"Disabled", Disabled},
                                      {"On", LessEqual},
                                      {"True", LessEqual}})
    {
        EXPECT_EQ(State("ZTest Never ZTest " + std::string(text)).zTest, value) << text;
    }
}

TEST(RenderState, TakesEveryValueOfASwitch)
{
    for (const auto& [text, value] :
         {ValueCase<bool>{"On", true}, {"Off", false}, {"True", true}, {"false", false}})
    {
        const std::string word = text;
        EXPECT_EQ(State("ZWrite " + word).zWrite, value) << text;
        EXPECT_EQ(State("ZClip " + word).zClip, value) << text;
        EXPECT_EQ(State("AlphaToMask " + word).alphaToMask, value) << text;
        EXPECT_EQ(State("Conservative " + word).conservative, value) << text;
    }
}

TEST(RenderState, TakesFactorAndUnitsOfOffset)
{
    const RenderState state = State("Offset -.5, [_Units]");
    EXPECT_EQ(state.offsetFactor.value, -0.5f);
    EXPECT_EQ(state.offsetUnits.property, "_Units");
}

TEST(RenderState, TakesEveryBlendFactor)
{
    using enum BlendMode;
    for (const auto& [text, value] : {ValueCase<BlendMode>{"Zero", Zero},
                                      {"One", One},
                                      {"DstColor", DstColor},
                                      {"SrcColor", SrcColor},
                                      {"OneMinusDstColor", OneMinusDstColor},
                                      {"SrcAlpha", SrcAlpha},
                                      {"OneMinusSrcColor", OneMinusSrcColor},
                                      {"DstAlpha", DstAlpha},
                                      {"OneMinusDstAlpha", OneMinusDstAlpha},
                                      {"SrcAlphaSaturate", SrcAlphaSaturate},
                                      {"OneMinusSrcAlpha", OneMinusSrcAlpha}})
    {
        const PassBlendState target = State("Blend " + std::string(text) + " DstColor").targets[0];
        EXPECT_TRUE(target.enabled);
        EXPECT_EQ(target.sourceColorBlendMode, value) << text;
        EXPECT_EQ(target.destinationColorBlendMode, DstColor);
        EXPECT_EQ(target.sourceAlphaBlendMode, value) << text;
        EXPECT_EQ(target.destinationAlphaBlendMode, DstColor);
    }
}

TEST(RenderState, BlendsAlphaByFactorsOfItsOwn)
{
    const RenderState state = State("Blend One SrcAlpha, Zero One");
    for (const PassBlendState& target : state.targets)
    {
        EXPECT_EQ(target.sourceColorBlendMode, BlendMode::One);
        EXPECT_EQ(target.destinationColorBlendMode, BlendMode::SrcAlpha);
        EXPECT_EQ(target.sourceAlphaBlendMode, BlendMode::Zero);
        EXPECT_EQ(target.destinationAlphaBlendMode, BlendMode::One);
    }
    EXPECT_FALSE(state.separateBlend);
}

TEST(RenderState, BlendsOneTargetDifferently)
{
    const RenderState state = State("Blend One One Blend 2 SrcAlpha Zero Blend 3 Off");
    EXPECT_TRUE(state.separateBlend);
    EXPECT_EQ(state.targets[0].sourceColorBlendMode, BlendMode::One);
    EXPECT_EQ(state.targets[2].sourceColorBlendMode, BlendMode::SrcAlpha);
    EXPECT_TRUE(state.targets[2].enabled);
    EXPECT_FALSE(state.targets[3].enabled);
    EXPECT_TRUE(state.targets[4].enabled);
}

TEST(RenderState, TurnsBlendingOffAgain)
{
    EXPECT_FALSE(State("Blend One One Blend Off").targets[0].enabled);
}

TEST(RenderState, TakesEveryBlendOperation)
{
    using enum BlendOp;
    for (const auto& [text, value] : {ValueCase<BlendOp>{"Add", Add},
                                      {"Sub", Subtract},
                                      {"RevSub", ReverseSubtract},
                                      {"Min", Min},
                                      {"Max", Max},
                                      {"LogicalClear", LogicalClear},
                                      {"LogicalEquiv", LogicalEquivalence},
                                      {"logicalorinverted", LogicalOrInverted},
                                      {"Multiply", Multiply},
                                      {"HSLLuminosity", HSLLuminosity}})
    {
        const PassBlendState target = State("BlendOp " + std::string(text)).targets[7];
        EXPECT_EQ(target.colorBlendOperation, value) << text;
        EXPECT_EQ(target.alphaBlendOperation, value) << text;
    }
}

TEST(RenderState, TakesABlendOperationForAlphaAndForOneTarget)
{
    const RenderState state = State("BlendOp Min, Max BlendOp 1 Sub");
    EXPECT_EQ(state.targets[0].colorBlendOperation, BlendOp::Min);
    EXPECT_EQ(state.targets[0].alphaBlendOperation, BlendOp::Max);
    EXPECT_EQ(state.targets[1].colorBlendOperation, BlendOp::Subtract);
    EXPECT_TRUE(state.separateBlend);
}

TEST(RenderState, TakesColorMasksOfLettersInAnyOrder)
{
    for (const auto& [text, value] : {ValueCase<int>{"RGBA", 15},
                                      {"ARGB", 15},
                                      {"RGB", 14},
                                      {"r", 8},
                                      {"G", 4},
                                      {"b", 2},
                                      {"A", 1},
                                      {"RA", 9},
                                      {"0", 0},
                                      {"Off", 0}})
    {
        EXPECT_EQ(State("ColorMask " + std::string(text)).targets[5].writeMask, value) << text;
    }
}

TEST(RenderState, TakesTheTargetOfAColorMaskFromBehindIt)
{
    const RenderState state = State("ColorMask [_Mask] 4 ColorMask 0 1");
    EXPECT_EQ(state.targets[4].writeMask.property, "_Mask");
    EXPECT_EQ(state.targets[1].writeMask, 0);
    EXPECT_EQ(state.targets[0].writeMask, 15);
    EXPECT_TRUE(state.separateBlend);
}

TEST(RenderState, TakesPropertiesInThePlaceOfValues)
{
    const RenderState state =
        State("Cull [_Cull] ZTest [ _ZTest ] ZWrite [_ZWrite] ZClip [_ZClip] Offset [_F], [_U] "
              "Blend [_Src] [_Dst], One [_DstA] BlendOp [_Op] ColorMask [_Mask]");
    EXPECT_EQ(state.cull.property, "_Cull");
    EXPECT_EQ(state.zTest.property, "_ZTest");
    EXPECT_EQ(state.zWrite.property, "_ZWrite");
    EXPECT_EQ(state.zClip.property, "_ZClip");
    EXPECT_EQ(state.offsetFactor.property, "_F");
    EXPECT_EQ(state.offsetUnits.property, "_U");
    EXPECT_EQ(state.targets[0].sourceColorBlendMode.property, "_Src");
    EXPECT_EQ(state.targets[0].destinationColorBlendMode.property, "_Dst");
    EXPECT_EQ(state.targets[0].sourceAlphaBlendMode, BlendMode::One);
    EXPECT_EQ(state.targets[0].destinationAlphaBlendMode.property, "_DstA");
    EXPECT_EQ(state.targets[0].colorBlendOperation.property, "_Op");
    EXPECT_EQ(state.targets[0].writeMask.property, "_Mask");
}

TEST(PassStencilState, HasItsDefaultsInAnEmptyBlock)
{
    const PassStencilState stencil = State("Stencil { }").stencil;
    EXPECT_TRUE(stencil.enabled);
    EXPECT_EQ(stencil.reference, 0);
    EXPECT_EQ(stencil.readMask, 255);
    EXPECT_EQ(stencil.writeMask, 255);
    EXPECT_EQ(stencil.front, StencilFaceState{});
    EXPECT_EQ(stencil.front.compare, CompareFunction::Always);
}

TEST(PassStencilState, TakesEveryOperation)
{
    using enum StencilOp;
    for (const auto& [text, value] : {ValueCase<StencilOp>{"Keep", Keep},
                                      {"Zero", Zero},
                                      {"Replace", Replace},
                                      {"IncrSat", IncrementSaturate},
                                      {"DecrSat", DecrementSaturate},
                                      {"Invert", Invert},
                                      {"IncrWrap", IncrementWrap},
                                      {"DecrWrap", DecrementWrap}})
    {
        const PassStencilState stencil =
            State("Stencil { Pass " + std::string(text) + " }").stencil;
        EXPECT_EQ(stencil.front.pass, value) << text;
        EXPECT_EQ(stencil.back.pass, value) << text;
    }
}

TEST(PassStencilState, SetsBothFacesOrOneAndTheLaterLineWins)
{
    const PassStencilState stencil =
        State("Stencil { Ref 7 ReadMask 15 WriteMask [_W] Comp Equal CompBack Less "
              "PassFront Replace Pass Zero PassBack Invert FailFront IncrSat ZFailBack DecrWrap }")
            .stencil;
    EXPECT_EQ(stencil.reference, 7);
    EXPECT_EQ(stencil.readMask, 15);
    EXPECT_EQ(stencil.writeMask.property, "_W");
    EXPECT_EQ(stencil.front.compare, CompareFunction::Equal);
    EXPECT_EQ(stencil.back.compare, CompareFunction::Less);
    EXPECT_EQ(stencil.front.pass, StencilOp::Zero);
    EXPECT_EQ(stencil.back.pass, StencilOp::Invert);
    EXPECT_EQ(stencil.front.fail, StencilOp::IncrementSaturate);
    EXPECT_EQ(stencil.back.fail, StencilOp::Keep);
    EXPECT_EQ(stencil.front.zFail, StencilOp::Keep);
    EXPECT_EQ(stencil.back.zFail, StencilOp::DecrementWrap);
}

} // namespace
} // namespace limn
