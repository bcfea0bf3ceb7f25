#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "resolve/DrawResolver.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::Mentions;

/// A material of a shader whose only pass has this fixed state.
class ResolvedState : public testing::Test
{
protected:
    void Make(const std::string& state, const std::string& properties = "")
    {
        m_Material = std::make_shared<Material>(
            test::ShaderOf("Shader \"Test/State\" { Properties { " + properties +
                           " } SubShader { Pass { " + state + " } } }"),
            "Glass");
    }
    PipelineState Resolve() const
    {
        return ResolveState(m_Material->shader()->passState(0), *m_Material, m_Globals);
    }
    /// What is wrong, without where.
    std::string Error() const
    {
        const std::string message = FullError();
        return message.substr(0, message.rfind("; the pass is at "));
    }
    std::string FullError() const
    {
        return test::ThrownMessage<ContractError>([&] { static_cast<void>(Resolve()); });
    }

    std::shared_ptr<Material> m_Material;
    FrameGlobals m_Globals;
};

TEST_F(ResolvedState, IsShaderLabsDefaultWithoutCommands)
{
    Make("");
    const PipelineState state = Resolve();
    EXPECT_EQ(state.cull, CullMode::Back);
    EXPECT_EQ(state.zTest, CompareFunction::LessEqual);
    EXPECT_TRUE(state.zWrite);
    EXPECT_EQ(state.targets[0], RenderTargetBlendState());
    EXPECT_EQ(state.targets[0].writeMask, 15);
    EXPECT_FALSE(state.stencilEnabled);
    EXPECT_FALSE(state.frontFaceFlipped);
}

TEST_F(ResolvedState, HoldsWhatTheCommandsSay)
{
    Make("Cull Off ZTest Always ZWrite Off Offset -1, -2 Blend SrcAlpha OneMinusSrcAlpha\n"
         "ColorMask RG Stencil { Ref 2 ReadMask 3 WriteMask 4 Comp NotEqual Pass Replace }");
    const PipelineState state = Resolve();
    EXPECT_EQ(state.cull, CullMode::Off);
    EXPECT_EQ(state.zTest, CompareFunction::Always);
    EXPECT_FALSE(state.zWrite);
    EXPECT_EQ(state.offsetFactor, -1.0f);
    EXPECT_EQ(state.offsetUnits, -2.0f);
    EXPECT_EQ(state.targets[0].sourceColorBlendMode, BlendMode::SrcAlpha);
    EXPECT_EQ(state.targets[0].destinationAlphaBlendMode, BlendMode::OneMinusSrcAlpha);
    EXPECT_EQ(state.targets[7].writeMask, 12);
    EXPECT_TRUE(state.stencilEnabled);
    EXPECT_EQ(state.stencilReference, 2);
    EXPECT_EQ(state.stencilReadMask, 3);
    EXPECT_EQ(state.stencilWriteMask, 4);
    EXPECT_EQ(state.stencilFront.compare, CompareFunction::NotEqual);
    EXPECT_EQ(state.stencilBack.pass, StencilOp::Replace);
}

TEST_F(ResolvedState, TakesReferencesFromTheMaterial)
{
    Make("Cull [_Cull] ZTest [_ZTest] ZWrite [_ZWrite] Blend [_Src] [_Dst] ColorMask [_Mask]\n"
         "Stencil { Ref [_Ref] Comp [_Comp] Pass [_Pass] }",
         "_Cull (\"\", Float) = 1\n_ZTest (\"\", Float) = 8\n_ZWrite (\"\", Float) = 0\n"
         "_Src (\"\", Float) = 5\n_Dst (\"\", Float) = 10\n_Mask (\"\", Integer) = 8\n"
         "_Ref (\"\", Integer) = 255\n_Comp (\"\", Float) = 6\n_Pass (\"\", Float) = 2");
    PipelineState state = Resolve();
    EXPECT_EQ(state.cull, CullMode::Front);
    EXPECT_EQ(state.zTest, CompareFunction::Always);
    EXPECT_FALSE(state.zWrite);
    EXPECT_EQ(state.targets[0].sourceColorBlendMode, BlendMode::SrcAlpha);
    EXPECT_EQ(state.targets[0].destinationColorBlendMode, BlendMode::OneMinusSrcAlpha);
    EXPECT_EQ(state.targets[0].writeMask, ColorWriteMask::Red);
    EXPECT_EQ(state.stencilReference, 255);
    EXPECT_EQ(state.stencilFront.compare, CompareFunction::NotEqual);
    EXPECT_EQ(state.stencilFront.pass, StencilOp::Replace);
    m_Material->SetFloat(ShaderPropertyId("_Cull"), 0.0f);
    EXPECT_EQ(Resolve().cull, CullMode::Off);
}

TEST_F(ResolvedState, RoundsReferencesToTheNearestMember)
{
    Make("Cull [_Cull]", "_Cull (\"\", Float) = 1.6");
    EXPECT_EQ(Resolve().cull, CullMode::Back);
}

TEST_F(ResolvedState, TakesAReferenceThatTheMaterialLacksFromTheGlobals)
{
    Make("ZTest [_GlobalTest]");
    m_Globals.Set(ShaderPropertyId("_GlobalTest"), 3);
    EXPECT_EQ(Resolve().zTest, CompareFunction::Equal);
}

// In Unity, a state that refers to a property has 0 until something gives it the property's value.
TEST_F(ResolvedState, IsZeroForAReferenceThatNobodySetsAndTellsSo)
{
    Make("Cull [_Missing] ZTest [_Lost] Blend One One");
    std::vector<std::string> unset;
    const PipelineState state =
        ResolveState(m_Material->shader()->passState(0), *m_Material, m_Globals, nullptr, &unset);
    EXPECT_EQ(state.cull, CullMode::Off);
    EXPECT_EQ(state.zTest, CompareFunction::Disabled);
    EXPECT_EQ(state.targets[0].sourceColorBlendMode, BlendMode::One);
    EXPECT_THAT(unset, testing::ElementsAre("Cull [_Missing]", "ZTest [_Lost]"));
}

TEST_F(ResolvedState, RefusesANumberThatIsNoMemberOfTheEnum)
{
    Make("Blend [_Src] Zero", "_Src (\"\", Float) = 11");
    EXPECT_THAT(Error(), Mentions("'Glass'", "'Test/State'", "Blend [_Src]", "11", "0...10"));
    Make("Cull [_Cull]", "_Cull (\"\", Float) = -1");
    EXPECT_THAT(Error(), Mentions("'Glass'", "'Test/State'", "Cull [_Cull]", "-1", "0...2"));
    Make("Stencil { Ref [_Ref] }", "_Ref (\"\", Float) = 256");
    EXPECT_THAT(Error(), Mentions("'Glass'", "'Test/State'", "Ref [_Ref]", "256", "0...255"));
}

TEST_F(ResolvedState, SaysWhichPassIsMeant)
{
    Make("\n Cull [_P]", "_P (\"\", Float) = 3");
    EXPECT_EQ(FullError(),
              Error() + "; the pass is at " + m_Material->shader()->document().file + ":1:69");
}

TEST_F(ResolvedState, NamesTheRangeOfEveryCommand)
{
    struct Case
    {
        const char* state;
        const char* command;
        int highest;
    };
    for (const Case& one :
         {Case{"Cull [_P]", "Cull", 2}, Case{"ZTest [_P]", "ZTest", 8},
          Case{"Blend [_P] Zero", "Blend", 10}, Case{"Blend One [_P]", "Blend", 10},
          Case{"Blend One Zero, [_P] Zero", "Blend", 10},
          Case{"Blend One Zero, One [_P]", "Blend", 10}, Case{"BlendOp [_P]", "BlendOp", 35},
          Case{"BlendOp Add, [_P]", "BlendOp", 35}, Case{"ColorMask [_P]", "ColorMask", 15},
          Case{"Stencil { Ref [_P] }", "Ref", 255},
          Case{"Stencil { ReadMask [_P] }", "ReadMask", 255},
          Case{"Stencil { WriteMask [_P] }", "WriteMask", 255},
          Case{"Stencil { Comp [_P] }", "Comp", 8}, Case{"Stencil { Pass [_P] }", "Pass", 7},
          Case{"Stencil { Fail [_P] }", "Fail", 7}, Case{"Stencil { ZFail [_P] }", "ZFail", 7},
          Case{"Stencil { CompBack [_P] }", "Comp", 8},
          Case{"Stencil { ZFailFront [_P] }", "ZFail", 7}})
    {
        Make(one.state, "_P (\"\", Float) = " + std::to_string(one.highest));
        EXPECT_NO_THROW(static_cast<void>(Resolve())) << one.state;
        for (const int outside : {-1, one.highest + 1})
        {
            Make(one.state, "_P (\"\", Float) = " + std::to_string(outside));
            EXPECT_THAT(Error(),
                        Mentions("'Glass'", "'Test/State'", std::string(one.command) + " [_P]",
                                 std::to_string(outside), "0..." + std::to_string(one.highest)));
        }
    }
}

TEST_F(ResolvedState, RefusesValuesThatAreNoNumber)
{
    Make("Cull [_Cull]", "_Cull (\"\", Vector) = (1, 1, 1, 1)");
    EXPECT_THAT(Error(), Mentions("'Glass'", "'Test/State'", "Cull [_Cull]", "no number"));
}

} // namespace
} // namespace limn
