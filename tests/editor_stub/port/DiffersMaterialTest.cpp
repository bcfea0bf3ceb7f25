#include "port/Differs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

void ExpectFunctionsOfAMaterial()
{
    Material material(DiffersShader(), "Named");
    EXPECT_EQ(material.name(), "Named");
    EXPECT_EQ(material.shader(), DiffersShader());
    EXPECT_EQ(material.passCount(), 1);
    EXPECT_EQ(material.rawRenderQueue(), -1);
    EXPECT_EQ(material.renderQueue(), 3000) << "the shader's Transparent";
    material.SetRenderQueue(2100);
    EXPECT_EQ(material.renderQueue(), 2100);
    EXPECT_EQ(material.rawRenderQueue(), 2100);
    EXPECT_THAT(material.shaderKeywords(), IsEmpty());
    material.EnableKeyword("WET");
    EXPECT_THAT(material.shaderKeywords(), ElementsAre("WET"));
}

void ExpectTheMainColourAndTexture()
{
    Material material(DiffersShader());
    EXPECT_EQ(material.color(), (Color{1, 0, 0, 1}));
    material.SetColor(Color{0, 1, 0, 1});
    EXPECT_EQ(material.GetColor("_Color"), (Color{0, 1, 0, 1}));
    const auto texture = DefaultTexture("black");
    material.SetMainTexture(texture);
    EXPECT_EQ(material.mainTexture(), texture);
    EXPECT_EQ(material.GetTexture("_MainTex"), texture);
    material.SetMainTextureScale({2, 3});
    material.SetMainTextureOffset({4, 5});
    EXPECT_EQ(material.GetTextureScale("_MainTex"), glm::vec2(2, 3));
    EXPECT_EQ(material.mainTextureScale(), glm::vec2(2, 3));
    EXPECT_EQ(material.mainTextureOffset(), glm::vec2(4, 5));
}

void ExpectAThrowForAPropertyThatIsNone()
{
    const Material material(DiffersShader());
    EXPECT_EQ(material.GetFloat("_Width"), 2.0f);
    EXPECT_THROW(material.GetFloat("_None"), ContractError);
    EXPECT_THROW(material.GetInt("_None"), ContractError);
    EXPECT_THROW(material.GetInteger("_None"), ContractError);
    EXPECT_THROW(material.GetVector("_None"), ContractError);
    EXPECT_THROW(material.GetColor("_None"), ContractError);
    EXPECT_THROW(material.GetMatrix("_None"), ContractError);
}

void ExpectWhatWasSetOfWhatNoPropertiesBlockHas()
{
    Material material(DiffersShader());
    EXPECT_FALSE(material.HasBuffer("_B"));
    EXPECT_FALSE(material.HasConstantBuffer("_C"));
    EXPECT_FALSE(material.HasMatrix("_M"));
    EXPECT_EQ(material.GetBuffer("_B"), nullptr);
    EXPECT_EQ(material.GetConstantBuffer("_C"), nullptr);
    using Target = GraphicsBuffer::Target;
    const auto buffer = std::make_shared<GraphicsBuffer>(Target::Structured, 4, 4);
    const auto constants = std::make_shared<GraphicsBuffer>(Target::Constant, 1, 16);
    material.SetBuffer("_B", buffer);
    material.SetConstantBuffer("_C", constants, 0, 16);
    material.SetMatrix("_M", glm::mat4(2.0f));
    EXPECT_TRUE(material.HasBuffer("_B"));
    EXPECT_TRUE(material.HasConstantBuffer("_C"));
    EXPECT_TRUE(material.HasMatrix("_M"));
    EXPECT_EQ(material.GetBuffer("_B"), buffer);
    EXPECT_EQ(material.GetConstantBuffer("_C"), constants);
}

void ExpectAHandleAroundAnIdentifierRefused()
{
    const RTHandle handle = RTHandles::Alloc(RenderTargetIdentifier("_SomeTexture"));
    Material material(DiffersShader());
    EXPECT_THROW(material.SetTexture("_MainTex", handle), ContractError);
    MaterialPropertyBlock block;
    EXPECT_THROW(block.SetTexture("_MainTex", handle), ContractError);
}

void ExpectABlockToSayWhetherItIsEmpty()
{
    MaterialPropertyBlock block;
    EXPECT_TRUE(block.isEmpty());
    block.SetFloat("_Width", 1.0f);
    EXPECT_FALSE(block.isEmpty());
}

void ExpectAKeywordOfTheShader()
{
    EXPECT_EQ(LocalKeyword(*DiffersShader(), "WET").name(), "WET");
    EXPECT_THROW(LocalKeyword(*DiffersShader(), "DRY"), ContractError);
}

void ExpectAnArrayOfBlendStates()
{
    BlendState state;
    EXPECT_EQ(state.blendStates.size(), 8u);
    state.blendStates[7].writeMask = {};
    EXPECT_EQ(BlendState::defaultValue.blendStates[0], state.blendStates[0]);
    EXPECT_NE(BlendState::defaultValue.blendStates[7], state.blendStates[7]);
}

void ExpectStencilFacesAndFunctionsForBoth()
{
    StencilState state;
    state.front.compare = CompareFunction::Less;
    state.back.pass = StencilOp::Zero;
    EXPECT_NE(state.front, state.back);
    state.SetCompareFunction(CompareFunction::Equal);
    state.SetPassOperation(StencilOp::Replace);
    state.SetFailOperation(StencilOp::Invert);
    state.SetZFailOperation(StencilOp::IncrementWrap);
    EXPECT_EQ(state.front.compare, CompareFunction::Equal);
    EXPECT_EQ(state.front.pass, StencilOp::Replace);
    EXPECT_EQ(state.front.fail, StencilOp::Invert);
    EXPECT_EQ(state.front.zFail, StencilOp::IncrementWrap);
    EXPECT_EQ(state.front, state.back);
}

} // namespace

DiffersChecks MaterialDiffers()
{
    return {{Members("Material", {"name", "shader", "passCount", "renderQueue", "rawRenderQueue",
                                  "shaderKeywords"}),
             ExpectFunctionsOfAMaterial},
            {Members("Material", {"color", "mainTexture", "mainTextureScale", "mainTextureOffset"}),
             ExpectTheMainColourAndTexture},
            {Members("Material",
                     {"GetFloat", "GetInt", "GetInteger", "GetVector", "GetColor", "GetMatrix"}),
             ExpectAThrowForAPropertyThatIsNone},
            {Members("Material", {"HasBuffer", "HasConstantBuffer", "HasMatrix", "GetBuffer",
                                  "GetConstantBuffer"}),
             ExpectWhatWasSetOfWhatNoPropertiesBlockHas},
            {{"Material.SetTexture", "MaterialPropertyBlock.SetTexture"},
             ExpectAHandleAroundAnIdentifierRefused},
            {{"MaterialPropertyBlock.isEmpty"}, ExpectABlockToSayWhetherItIsEmpty},
            {{"LocalKeyword.name"}, ExpectAKeywordOfTheShader},
            {Members("BlendState", {"blendState0", "blendState1", "blendState2", "blendState3",
                                    "blendState4", "blendState5", "blendState6", "blendState7"}),
             ExpectAnArrayOfBlendStates},
            {Members("StencilState",
                     {"compareFunctionFront", "compareFunctionBack", "passOperationFront",
                      "passOperationBack", "failOperationFront", "failOperationBack",
                      "zFailOperationFront", "zFailOperationBack"}),
             ExpectStencilFacesAndFunctionsForBoth}};
}

} // namespace limn::test
