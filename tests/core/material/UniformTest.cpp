#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "record/RecordedCommands.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

using testing::ElementsAre;
using testing::FloatEq;

const ShaderPropertyId _Value("_Value");
const ShaderPropertyId _Color("_Color");
const ShaderPropertyId _Glow("_Glow");
const ShaderPropertyId _Count("_Count");
const ShaderPropertyId _Matrix("_Matrix");
const ShaderPropertyId _Points("_Points");
const ShaderPropertyId _Map("_Map");

/// What reaches a shader's uniforms.
class Uniforms : public testing::Test
{
protected:
    /// A material of a shader with these properties and uniforms, all of them in use.
    static std::shared_ptr<Material> MaterialOf(const std::string& properties,
                                                const std::string& declarations,
                                                const std::string& result)
    {
        return std::make_shared<Material>(test::ShaderWithProgram(properties, declarations, result),
                                          "Paint");
    }

    test::OneDraw m_Draw;
};

TEST_F(Uniforms, AreZeroWhereNobodySetThem)
{
    m_Draw.Resolve(MaterialOf("", "float4 _Value;", "_Value"));
    EXPECT_THAT(m_Draw.Floats("_Value", 4), ElementsAre(0, 0, 0, 0));
}

//   block  >  material  >  globals
TEST_F(Uniforms, TakeTheBlocksValueThenTheMaterialsThenTheGlobal)
{
    const auto material = MaterialOf("", "float4 _Value;", "_Value");
    m_Draw.before.SetGlobalVector(_Value, {1, 1, 1, 1});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Value", 4), ElementsAre(1, 1, 1, 1));
    material->SetVector(_Value, {2, 2, 2, 2});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Value", 4), ElementsAre(2, 2, 2, 2));
    m_Draw.block.SetVector(_Value, {3, 3, 3, 3});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Value", 4), ElementsAre(3, 3, 3, 3));
}

TEST_F(Uniforms, TakeThePropertysDefaultBeforeTheGlobal)
{
    m_Draw.before.SetGlobalFloat(_Value, 9.0f);
    m_Draw.Resolve(MaterialOf("_Value (\"Value\", Float) = 0.25", "float _Value;", "_Value"));
    EXPECT_THAT(m_Draw.Floats("_Value", 1), ElementsAre(0.25f));
}

/// sRGB to linear as IEC 61966-2-1 has it, in double.
double Linear(double s)
{
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

TEST_F(Uniforms, HoldColorsAsLinear)
{
    const auto material =
        MaterialOf("_Color (\"Color\", Color) = (1, 1, 1, 1)", "float4 _Color;", "_Color");
    for (int i = 0; i <= 255; ++i)
    {
        const double s = i / 255.0;
        material->SetColor(_Color, {static_cast<float>(s), 0.0f, 1.0f, static_cast<float>(s)});
        m_Draw.Resolve(material);
        const std::vector<float> color = m_Draw.Floats("_Color", 4);
        EXPECT_NEAR(color[0], Linear(s), 1e-6) << "sRGB " << i;
        EXPECT_EQ(color[1], 0.0f);
        EXPECT_EQ(color[2], 1.0f);
        EXPECT_EQ(color[3], static_cast<float>(s)) << "alpha is no colour";
    }
}

TEST_F(Uniforms, HoldBrightColorsAsAPowerOf2Point2)
{
    const auto material = MaterialOf("", "float4 _Color;", "_Color");
    material->SetColor(_Color, {2.0f, 4.0f, 0.0f, 1.0f});
    m_Draw.Resolve(material);
    EXPECT_NEAR(m_Draw.Floats("_Color", 1)[0], std::pow(2.0, 2.2), 1e-5);
    EXPECT_NEAR(m_Draw.Floats("_Color", 1, 4)[0], std::pow(4.0, 2.2), 1e-4);
}

TEST_F(Uniforms, HoldHdrColorsAndVectorsAsTheyAre)
{
    const auto material = MaterialOf("[HDR] _Glow (\"Glow\", Color) = (0.5, 2, 0, 1)\n"
                                     "_Value (\"Value\", Vector) = (0.5, 0.5, 0.5, 0.5)",
                                     "float4 _Glow; float4 _Value;", "_Glow + _Value");
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Glow", 4), ElementsAre(0.5f, 2, 0, 1));
    EXPECT_THAT(m_Draw.Floats("_Value", 4), ElementsAre(0.5f, 0.5f, 0.5f, 0.5f));
    material->SetColor(_Glow, {0.25f, 8, 0, 1});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Glow", 4), ElementsAre(0.25f, 8, 0, 1));
}

TEST_F(Uniforms, DescribeTheTexelsOfTheTextureOfTheirName)
{
    const auto material = MaterialOf("", "float4 _Map_TexelSize;", "_Map_TexelSize");
    material->SetTexture(_Map, test::Target("map", 40, 8));
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Map_TexelSize", 4), ElementsAre(0.025f, 0.125f, 40, 8));
}

TEST_F(Uniforms, DescribeTheTexelsOfTheBlocksTexture)
{
    const auto material = MaterialOf("", "float4 _Map_TexelSize;", "_Map_TexelSize");
    material->SetTexture(_Map, test::Target("map", 40, 8));
    m_Draw.block.SetTexture(_Map, test::Target("other", 2, 4));
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Map_TexelSize", 4), ElementsAre(0.5f, 0.25f, 2, 4));
}

TEST_F(Uniforms, DescribeOneTexelWhereNoTextureIsSet)
{
    m_Draw.Resolve(MaterialOf("_Map (\"Map\", 2D) = \"white\" {}", "float4 _Map_TexelSize;",
                              "_Map_TexelSize"));
    EXPECT_THAT(m_Draw.Floats("_Map_TexelSize", 4), ElementsAre(1, 1, 1, 1));
}

TEST_F(Uniforms, LeaveTextureCoordinatesAloneUnlessTold)
{
    const auto material = MaterialOf("", "float4 _Map_ST;", "_Map_ST");
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Map_ST", 4), ElementsAre(1, 1, 0, 0));
    material->SetVector(ShaderPropertyId("_Map_ST"), {2, 3, 4, 5});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Map_ST", 4), ElementsAre(2, 3, 4, 5));
}

TEST_F(Uniforms, HoldIntegersAsTheShaderDeclaresThem)
{
    const auto material =
        MaterialOf("_Count (\"Count\", Integer) = -7\n_Value (\"V\", Float) = 2.6",
                   "int _Count; int _Value;", "_Count + _Value");
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Ints("_Count", 1), ElementsAre(-7));
    EXPECT_THAT(m_Draw.Ints("_Value", 1), ElementsAre(2));
    const auto asFloat = MaterialOf("", "float _Count;", "_Count");
    asFloat->SetInt(_Count, -7);
    m_Draw.Resolve(asFloat);
    EXPECT_THAT(m_Draw.Floats("_Count", 1), ElementsAre(-7.0f));
}

TEST_F(Uniforms, HoldMatricesColumnByColumn)
{
    const auto material = MaterialOf("", "float4x4 _Matrix;", "mul(_Matrix, float4(1, 2, 3, 4))");
    glm::mat4 matrix(0.0f);
    for (int i = 0; i < 16; ++i)
    {
        matrix[i / 4][i % 4] = static_cast<float>(i);
    }
    material->SetMatrix(_Matrix, matrix);
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Matrix", 16),
                ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
}

TEST_F(Uniforms, HoldAsManyArrayElementsAsThereAre)
{
    const auto material =
        MaterialOf("", "float4 _Points[3];", "_Points[0] + _Points[1] + _Points[2]");
    m_Draw.block.SetVectorArray(_Points, {{1, 2, 3, 4}, {5, 6, 7, 8}});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Points", 12), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 0, 0));
    m_Draw.block.SetVectorArray(_Points, std::vector<glm::vec4>(10, glm::vec4(9)));
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Points", 12), ElementsAre(9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9));
}

TEST_F(Uniforms, HoldTheFirstComponentOfEachElementOfAFloatArray)
{
    const auto material = MaterialOf("", "float _Points[2];", "_Points[0] + _Points[1]");
    m_Draw.block.SetVectorArray(_Points, {{1, 2, 3, 4}, {5, 6, 7, 8}});
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.Floats("_Points", 1)[0], 1.0f);
    EXPECT_EQ(m_Draw.Floats("_Points", 1, 16)[0], 5.0f);
}

TEST_F(Uniforms, HoldArraysOfFloats)
{
    m_Draw.before.SetGlobalFloatArray("_Points", {1, 2});
    const auto material =
        MaterialOf("", "float _Points[3];", "_Points[0] + _Points[1] + _Points[2]");
    const auto elements = [&]
    {
        m_Draw.Resolve(material);
        return std::vector{m_Draw.Floats("_Points", 1)[0], m_Draw.Floats("_Points", 1, 16)[0],
                           m_Draw.Floats("_Points", 1, 32)[0]};
    };
    EXPECT_THAT(elements(), ElementsAre(1, 2, 0));
    material->SetFloatArray("_Points", {3, 4, 5, 6});
    EXPECT_THAT(elements(), ElementsAre(3, 4, 5));
    m_Draw.block.SetFloatArray("_Points", {7});
    EXPECT_THAT(elements(), ElementsAre(7, 0, 0));
}

TEST_F(Uniforms, HoldArraysOfMatrices)
{
    m_Draw.before.SetGlobalMatrixArray("_Matrix", {glm::mat4(1), glm::mat4(2), glm::mat4(3)});
    const auto material = MaterialOf("", "float4x4 _Matrix[2];",
                                     "_Matrix[0][0] + mul(_Matrix[1], float4(1, 2, 3, 4))");
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Matrix", 16),
                ElementsAre(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
    EXPECT_THAT(m_Draw.Floats("_Matrix", 16, 64),
                ElementsAre(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2));
    material->SetMatrixArray("_Matrix", {glm::mat4(4)});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Matrix", 1), ElementsAre(4));
    EXPECT_THAT(m_Draw.Floats("_Matrix", 1, 64), ElementsAre(0));
    m_Draw.block.SetMatrixArray("_Matrix", {glm::mat4(5), glm::mat4(6)});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Matrix", 1, 64), ElementsAre(6));
}

TEST_F(Uniforms, HoldAGlobalArrayOfVectors)
{
    m_Draw.before.SetGlobalVectorArray("_Points", {{1, 2, 3, 4}, {5, 6, 7, 8}});
    const auto material = MaterialOf("", "float4 _Points[2];", "_Points[0] + _Points[1]");
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Points", 8), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
    material->SetVectorArray("_Points", {{9, 9, 9, 9}});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Points", 8), ElementsAre(9, 9, 9, 9, 0, 0, 0, 0));
}

// The number of a name is that of Shader.PropertyToID: both ways of calling it meet.
TEST_F(Uniforms, AreSetByName)
{
    const auto texture = test::Target("map", 40, 8);
    const auto material =
        MaterialOf("",
                   "float _Value; int _Count; float4 _Color; float4 _Glow; float4x4 _Matrix; "
                   "float4 _Map_TexelSize;",
                   "_Value + _Count + _Color + _Glow + _Matrix[0] + _Map_TexelSize");
    const auto expectAll = [&]
    {
        m_Draw.Resolve(material);
        EXPECT_THAT(m_Draw.Floats("_Value", 1), ElementsAre(0.5f));
        EXPECT_THAT(m_Draw.Ints("_Count", 1), ElementsAre(16777217)) << "no float is that";
        EXPECT_THAT(m_Draw.Floats("_Color", 4), ElementsAre(1, 0, 1, 0.5f));
        EXPECT_THAT(m_Draw.Floats("_Glow", 4), ElementsAre(1, 2, 3, 4));
        EXPECT_THAT(m_Draw.Floats("_Matrix", 1), ElementsAre(3));
        EXPECT_THAT(m_Draw.Floats("_Map_TexelSize", 4), ElementsAre(0.025f, 0.125f, 40, 8));
    };
    const std::string value = "_Value";
    CommandBuffer& cmd = m_Draw.before;
    cmd.SetGlobalFloat(value, 0.5f);
    cmd.SetGlobalInteger("_Count", 16777217);
    cmd.SetGlobalColor("_Color", {1, 0, 1, 0.5f});
    cmd.SetGlobalVector("_Glow", {1, 2, 3, 4});
    cmd.SetGlobalMatrix("_Matrix", glm::mat4(3));
    cmd.SetGlobalTexture("_Map", texture);
    expectAll();
    cmd.Clear();
    const auto setAll = [&](auto& target)
    {
        target.SetFloat(std::string_view(value), 0.5f);
        target.SetInteger("_Count", 16777217);
        target.SetColor("_Color", {1, 0, 1, 0.5f});
        target.SetVector("_Glow", {1, 2, 3, 4});
        target.SetMatrix("_Matrix", glm::mat4(3));
        target.SetTexture("_Map", texture);
    };
    setAll(m_Draw.block);
    expectAll();
    EXPECT_NE(m_Draw.block.Find(_Map), nullptr);
    m_Draw.block.Clear();
    setAll(*material);
    expectAll();
}

TEST_F(Uniforms, DoNotOverflowTheirPlace)
{
    const auto material = MaterialOf("", "float2 _Value; float2 _Glow;", "float4(_Value, _Glow)");
    material->SetVector(_Value, {1, 2, 3, 4});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Floats("_Value", 2), ElementsAre(1, 2));
    EXPECT_THAT(m_Draw.Floats("_Glow", 2), ElementsAre(0, 0));
}

std::string ErrorOf(const std::shared_ptr<const Material>& material)
{
    return test::ThrownMessage<ContractError>([&] { test::OneDraw().Resolve(material); });
}

TEST_F(Uniforms, RefuseAValueOfAnotherKind)
{
    const auto matrix = MaterialOf("", "float4x4 _Matrix;", "_Matrix[0]");
    matrix->SetFloat(_Matrix, 1.0f);
    EXPECT_THAT(ErrorOf(matrix), Mentions("'Paint'", "'_Matrix'", "a number", "declares a matrix"));
    const auto number = MaterialOf("", "float4 _Value;", "_Value");
    number->SetMatrix(_Value, glm::mat4(1.0f));
    EXPECT_THAT(ErrorOf(number), Mentions("'Paint'", "'_Value'", "a matrix", "number or vector"));
    number->SetMatrixArray(_Value, {glm::mat4(1.0f)});
    EXPECT_THAT(ErrorOf(number),
                Mentions("'Paint'", "'_Value'", "array of matrices", "number or vector"));
    matrix->SetFloatArray(_Matrix, {1.0f});
    EXPECT_THAT(ErrorOf(matrix),
                Mentions("'Paint'", "'_Matrix'", "array of floats", "declares a matrix"));
    number->SetTexture(_Value, test::Target("map"));
    EXPECT_THAT(ErrorOf(number), Mentions("'Paint'", "'_Value'", "a texture", "number or vector"));
}

// HLSL's cast from float to int, in which Unity's older Int property ends: the fraction goes.
TEST_F(Uniforms, CutTheFractionOffWhereTheShaderDeclaresAnInteger)
{
    const auto material = MaterialOf("", "int4 _Value;", "_Value");
    material->SetVector(_Value, {0.9f, -0.9f, 2.6f, -2.6f});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Ints("_Value", 4), ElementsAre(0, 0, 2, -2));
}

TEST_F(Uniforms, TakeTheNearestIntegerThereIsForOneTooLarge)
{
    const auto material = MaterialOf("", "int4 _Value;", "_Value");
    material->SetVector(_Value, {1e20f, -1e20f, 2147483648.0f, 3e9f});
    m_Draw.Resolve(material);
    EXPECT_THAT(m_Draw.Ints("_Value", 4),
                ElementsAre(2147483647, -2147483647 - 1, 2147483647, 2147483647));
    const auto bits = MaterialOf("", "uint4 _Value;", "_Value");
    bits->SetVector(_Value, {3e9f, 1e20f, -1.0f, 7.5f});
    m_Draw.Resolve(bits);
    EXPECT_THAT(m_Draw.Ints("_Value", 4),
                ElementsAre(static_cast<std::int32_t>(3000000000u), -1, -1, 7));
}

TEST_F(Uniforms, HoldAGlobalColorAsItIs)
{
    m_Draw.before.SetGlobalColor(_Color, {1.0f, 0.5f, 0.25f, 0.75f});
    m_Draw.Resolve(MaterialOf("", "float4 _Color;", "_Color"));
    EXPECT_THAT(m_Draw.Floats("_Color", 4), ElementsAre(1.0f, 0.5f, 0.25f, 0.75f));
}

constexpr float k_Nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_Infinity = std::numeric_limits<float>::infinity();

/// Sets a value of each kind that holds `bad` somewhere.
/// @param set  called as set(value); each call must throw
template <typename Message, typename Set>
void ExpectAllRefused(float bad, const Message& message, Set&& set)
{
    glm::mat4 matrix(1.0f);
    matrix[3][1] = bad;
    const ShaderPropertyValue values[] = {bad,
                                          glm::vec4(0, 1, 2, bad),
                                          Color{bad, 0, 0, 1},
                                          matrix,
                                          std::vector<float>{0, bad},
                                          std::vector<glm::vec4>{{0, 0, 0, 0}, {0, bad, 0, 0}},
                                          std::vector<glm::mat4>{glm::mat4(1.0f), matrix}};
    for (const ShaderPropertyValue& value : values)
    {
        EXPECT_THAT(test::ThrownMessage<ContractError>([&] { set(value); }), message)
            << bad << ", kind " << value.index();
    }
}

TEST(PropertyValues, OfAMaterialAreRefusedUnlessTheyAreFinite)
{
    Material material(test::ShaderWithModes({"A"}), "Paint");
    const std::uint64_t version = material.version();
    const auto set = [&](const ShaderPropertyValue& value)
    {
        if (const auto* number = std::get_if<float>(&value))
        {
            material.SetFloat(_Value, *number);
        }
        else if (const auto* color = std::get_if<Color>(&value))
        {
            material.SetColor(_Value, *color);
        }
        else if (const auto* matrix = std::get_if<glm::mat4>(&value))
        {
            material.SetMatrix(_Value, *matrix);
        }
        else
        {
            const auto* vector = std::get_if<glm::vec4>(&value);
            material.SetVector(_Value, vector != nullptr ? *vector : glm::vec4(k_Nan));
        }
    };
    for (const float bad : {k_Nan, k_Infinity, -k_Infinity})
    {
        ExpectAllRefused(bad, Mentions("'Paint'", "'_Value'", "not finite"), set);
    }
    EXPECT_THROW(material.SetTextureOffset(_Map, {0.0f, k_Nan}), ContractError);
    EXPECT_EQ(material.Find(_Value), nullptr);
    EXPECT_EQ(material.version(), version);
}

TEST(PropertyValues, ThatAreArraysAreRefusedWithoutElements)
{
    Material material(test::ShaderWithModes({"A"}), "Paint");
    MaterialPropertyBlock block;
    CommandBuffer cmd;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { material.SetFloatArray("_Value", {}); }),
                Mentions("'Paint'", "'_Value'", "without elements"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { block.SetVectorArray("_Value", {}); }),
                Mentions("'_Value'", "without elements"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { cmd.SetGlobalMatrixArray("_Value", {}); }),
                Mentions("global", "'_Value'", "without elements"));
    EXPECT_EQ(material.Find("_Value"), nullptr);
    EXPECT_TRUE(block.isEmpty());
    EXPECT_TRUE(cmd.commands().empty());
}

TEST(PropertyValues, OfABlockAreRefusedUnlessTheyAreFinite)
{
    MaterialPropertyBlock block;
    for (const float bad : {k_Nan, k_Infinity, -k_Infinity})
    {
        ExpectAllRefused(bad, Mentions("'_Value'", "not finite"),
                         [&](const ShaderPropertyValue& value) { block.Set(_Value, value); });
    }
    EXPECT_TRUE(block.isEmpty());
}

TEST(PropertyValues, ThatAreGlobalAreRefusedUnlessTheyAreFinite)
{
    CommandBuffer cmd;
    const auto message = Mentions("global", "'_Value'", "not finite");
    for (const float bad : {k_Nan, k_Infinity, -k_Infinity})
    {
        const auto error = [&](auto&& set)
        {
            return test::ThrownMessage<ContractError>(set);
        };
        EXPECT_THAT(error([&] { cmd.SetGlobalFloat(_Value, bad); }), message);
        EXPECT_THAT(error([&] { cmd.SetGlobalVector(_Value, glm::vec4(bad)); }), message);
        EXPECT_THAT(error([&] { cmd.SetGlobalColor(_Value, {0, 0, 0, bad}); }), message);
        EXPECT_THAT(error([&] { cmd.SetGlobalMatrix(_Value, glm::mat4(bad)); }), message);
    }
    EXPECT_TRUE(cmd.commands().empty());
}

TEST_F(Uniforms, BeginAtOffsetsThatAnyDeviceAccepts)
{
    const auto material = MaterialOf("", "cbuffer A { float4 _Value; } cbuffer B { float4 _Glow; }",
                                     "_Value + _Glow");
    m_Draw.Resolve(material);
    ASSERT_EQ(m_Draw.draw().bindings->uniforms.size(), 2u);
    for (const UniformSlice& slice : m_Draw.draw().bindings->uniforms)
    {
        EXPECT_EQ(slice.offset % 256, 0u);
        EXPECT_LE(slice.offset + slice.size, m_Draw.frame().uniformData.size());
    }
}

} // namespace
} // namespace limn
