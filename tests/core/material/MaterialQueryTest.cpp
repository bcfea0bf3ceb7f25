#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

/// A material with a property of each kind.
class MaterialQueries : public testing::Test
{
protected:
    template <typename Call>
    static std::string ErrorOf(Call&& call)
    {
        return test::ThrownMessage<ContractError>(call);
    }

    Material m_Material{
        test::ShaderOf("Shader \"Test/Queries\" { Properties {\n"
                       "_Width (\"\", Float) = 1.75\n_Cut (\"\", Range(0, 1)) = 0.25\n"
                       "_Old (\"\", Int) = 3\n_Count (\"\", Integer) = 4\n"
                       "_Tint (\"\", Color) = (0.5, 0.25, 1, 0.5)\n"
                       "[HDR] _Glow (\"\", Color) = (2, 3, 4, 1)\n"
                       "_Offset (\"\", Vector) = (1, 2, 3, 4)\n_Map (\"\", 2D) = \"white\" {}\n"
                       "} SubShader { Pass { Name \"First\" } Pass { Name \"Second\" } } }"),
        "Paint"};
};

/// sRGB to linear, in double.
double LinearOf(double s)
{
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

TEST_F(MaterialQueries, GiveDefaultsAndWhatWasSet)
{
    EXPECT_EQ(m_Material.GetFloat("_Width"), 1.75f);
    EXPECT_EQ(m_Material.GetFloat("_Cut"), 0.25f);
    EXPECT_EQ(m_Material.GetInt("_Old"), 3);
    EXPECT_EQ(m_Material.GetInteger("_Count"), 4);
    EXPECT_EQ(m_Material.GetVector("_Offset"), glm::vec4(1, 2, 3, 4));
    m_Material.SetFloat("_Width", -7.5f);
    m_Material.SetMatrix("_Matrix", glm::mat4(2.0f));
    m_Material.SetFloatArray("_Floats", {1, 2});
    m_Material.SetVectorArray("_Vectors", {glm::vec4(3)});
    m_Material.SetMatrixArray("_Matrices", {glm::mat4(4.0f)});
    EXPECT_EQ(m_Material.GetFloat("_Width"), -7.5f);
    EXPECT_EQ(m_Material.GetMatrix("_Matrix"), glm::mat4(2.0f));
    EXPECT_EQ(m_Material.GetFloatArray("_Floats"), (std::vector<float>{1, 2}));
    EXPECT_EQ(m_Material.GetVectorArray("_Vectors"), std::vector{glm::vec4(3)});
    EXPECT_EQ(m_Material.GetMatrixArray("_Matrices"), std::vector{glm::mat4(4.0f)});
    EXPECT_TRUE(m_Material.GetFloatArray("_Vectors").empty());
}

TEST_F(MaterialQueries, TakeNumbersForOneAnother)
{
    EXPECT_EQ(m_Material.GetFloat("_Count"), 4.0f);
    EXPECT_EQ(m_Material.GetInt("_Width"), 1);
    m_Material.SetFloat("_Width", -1.75f);
    EXPECT_EQ(m_Material.GetInt("_Width"), -1);
    m_Material.SetFloat("_Width", 1e30f);
    EXPECT_EQ(m_Material.GetInt("_Width"), std::numeric_limits<int>::max());
}

TEST_F(MaterialQueries, GiveColorsAsTheyAreSetAndVectorsAsShadersFindThem)
{
    EXPECT_EQ(m_Material.GetColor("_Tint"), (Color{0.5f, 0.25f, 1.0f, 0.5f}));
    const glm::vec4 linear = m_Material.GetVector("_Tint");
    EXPECT_NEAR(linear.x, LinearOf(0.5), 1e-6);
    EXPECT_NEAR(linear.y, LinearOf(0.25), 1e-6);
    EXPECT_EQ(linear.w, 0.5f);
    EXPECT_EQ(m_Material.GetColor("_Glow"), (Color{2, 3, 4, 1}));
    EXPECT_EQ(m_Material.GetVector("_Glow"), glm::vec4(2, 3, 4, 1));
    for (const float value : {0.0f, 0.002f, 0.04f, 0.3f, 1.0f, 5.0f})
    {
        m_Material.SetVector("_Tint", glm::vec4(Color{value, 0, 0, 1}.linear().vector()));
        EXPECT_NEAR(m_Material.GetColor("_Tint").r, value, 1e-5f * (1 + value));
    }
}

TEST_F(MaterialQueries, GiveTexturesWithScaleAndOffset)
{
    EXPECT_EQ(m_Material.GetTexture("_Map"), nullptr);
    EXPECT_EQ(m_Material.GetTextureScale("_Map"), glm::vec2(1, 1));
    EXPECT_EQ(m_Material.GetTextureOffset("_Map"), glm::vec2(0, 0));
    const RTHandle target(test::Target("Map"));
    m_Material.SetTexture("_Map", target);
    m_Material.SetTextureScale("_Map", {2, 3});
    m_Material.SetTextureOffset("_Map", {4, 5});
    EXPECT_EQ(m_Material.GetTexture("_Map"), target.rt());
    EXPECT_EQ(m_Material.GetTextureScale("_Map"), glm::vec2(2, 3));
    EXPECT_EQ(m_Material.GetTextureOffset("_Map"), glm::vec2(4, 5));
    m_Material.SetTexture("_Map", RTHandle());
    EXPECT_EQ(m_Material.GetTexture("_Map"), nullptr);
}

TEST_F(MaterialQueries, SayWhatIsMissing)
{
    EXPECT_THAT(ErrorOf([&] { m_Material.GetFloat("_Nothing"); }),
                Mentions("'Paint'", "'_Nothing'", "not set", "number"));
    EXPECT_THAT(ErrorOf([&] { m_Material.GetInt("_Tint"); }),
                Mentions("'Paint'", "'_Tint'", "not a number"));
    EXPECT_THAT(ErrorOf([&] { m_Material.GetVector("_Width"); }),
                Mentions("'Paint'", "'_Width'", "not a vector"));
    EXPECT_THAT(ErrorOf([&] { m_Material.GetColor("_Width"); }),
                Mentions("'Paint'", "'_Width'", "not a colour"));
    EXPECT_THAT(ErrorOf([&] { m_Material.GetMatrix("_Offset"); }),
                Mentions("'Paint'", "'_Offset'", "not a matrix"));
    EXPECT_THAT(ErrorOf([&] { m_Material.SetTexture("_Map", RTHandles::Alloc("_Name")); }),
                Mentions("'Paint'", "'_Map'", "identifier", "SetGlobalTexture"));
    MaterialPropertyBlock block;
    EXPECT_THAT(ErrorOf([&] { block.SetTexture("_Map", RTHandles::Alloc("_Name")); }),
                Mentions("'_Map'", "identifier", "SetGlobalTexture"));
}

TEST_F(MaterialQueries, KnowWhatTheShaderDeclares)
{
    m_Material.SetFloat("_Later", 1.0f);
    for (const char* name : {"_Width", "_Cut", "_Old"})
    {
        EXPECT_TRUE(m_Material.HasFloat(name) && m_Material.HasInt(name)) << name;
        EXPECT_FALSE(m_Material.HasInteger(name)) << name;
    }
    EXPECT_TRUE(m_Material.HasInteger("_Count"));
    EXPECT_FALSE(m_Material.HasInt("_Count"));
    EXPECT_TRUE(m_Material.HasColor("_Tint") && m_Material.HasColor("_Glow"));
    EXPECT_FALSE(m_Material.HasVector("_Tint") || m_Material.HasTexture("_Tint"));
    EXPECT_TRUE(m_Material.HasVector("_Offset"));
    EXPECT_TRUE(m_Material.HasTexture("_Map"));
    EXPECT_TRUE(m_Material.HasProperty("_Map") && m_Material.HasProperty("_Width"));
    EXPECT_FALSE(m_Material.HasProperty("_Later") || m_Material.HasFloat("_Later"));
}

TEST_F(MaterialQueries, NamePasses)
{
    EXPECT_EQ(m_Material.passCount(), 2);
    EXPECT_EQ(m_Material.GetPassName(1), "Second");
    EXPECT_EQ(m_Material.FindPass("Second"), 1);
    EXPECT_EQ(m_Material.FindPass("Third"), -1);
    EXPECT_THROW(m_Material.GetPassName(2), ContractError);
}

TEST_F(MaterialQueries, CopyPropertiesButNotTheShader)
{
    Material other(test::ShaderWithProgram("_Width (\"\", Float) = 9"), "Other");
    other.SetColor("_Tint", Color::red);
    other.EnableKeyword("_FAST");
    other.SetRenderQueue(2450);
    const auto shader = m_Material.shader();
    const std::uint64_t version = m_Material.version();
    m_Material.EnableKeyword("_SLOW");
    m_Material.CopyPropertiesFromMaterial(other);
    EXPECT_EQ(m_Material.GetFloat("_Width"), 9.0f);
    EXPECT_EQ(m_Material.GetColor("_Tint"), Color::red);
    EXPECT_TRUE(m_Material.IsKeywordEnabled("_FAST"));
    EXPECT_FALSE(m_Material.IsKeywordEnabled("_SLOW"));
    EXPECT_EQ(m_Material.renderQueue(), 2450);
    EXPECT_EQ(m_Material.shader(), shader);
    EXPECT_EQ(m_Material.name(), "Paint");
    EXPECT_GT(m_Material.version(), version);
}

TEST(MaterialColorArray, ReachesShadersLinear)
{
    const auto material =
        std::make_shared<Material>(test::ShaderWithProgram("", "float4 _Colors[2];", "_Colors[1]"));
    material->SetColorArray("_Colors", {Color::black, Color{0.5f, 0.02f, 1.0f, 0.25f}});
    test::OneDraw draw;
    draw.Resolve(material);
    const auto values = draw.Floats("_Colors", 4, 16);
    EXPECT_NEAR(values[0], LinearOf(0.5), 1e-6);
    EXPECT_NEAR(values[1], LinearOf(0.02), 1e-6);
    EXPECT_EQ(values[2], 1.0f);
    EXPECT_EQ(values[3], 0.25f);
}

TEST(MaterialMainProperties, AreThoseWithTheAttributesOrTheUsualNames)
{
    const auto make = [](const std::string& properties)
    {
        return Material(test::ShaderOf("Shader \"Test/Main\" { Properties {\n" + properties +
                                       "} SubShader { Tags { \"Queue\" = \"Overlay\" "
                                       "\"RenderType\" = \"Opaque\" } Pass { } } }"));
    };
    Material plain =
        make("_Color (\"\", Color) = (1, 0, 0, 1)\n_MainTex (\"\", 2D) = \"white\" {}\n");
    EXPECT_EQ(plain.color(), Color::red);
    plain.SetColor(Color::blue);
    EXPECT_EQ(plain.GetColor("_Color"), Color::blue);
    EXPECT_EQ(plain.mainTexture(), nullptr);
    plain.SetMainTextureScale({2, 3});
    EXPECT_EQ(plain.GetTextureScale("_MainTex"), glm::vec2(2, 3));
    EXPECT_EQ(plain.GetTag("renderType", false), "Opaque");
    EXPECT_EQ(plain.GetTag("Other", true, "none"), "none");
    Material named = make("_Color (\"\", Color) = (1, 0, 0, 1)\n"
                          "[MainColor] _BaseColor (\"\", Color) = (0, 1, 0, 1)\n"
                          "[MainTexture] _BaseMap (\"\", 2D) = \"white\" {}\n");
    EXPECT_EQ(named.color(), Color::green);
    named.SetMainTextureOffset({0.5f, 0.25f});
    EXPECT_EQ(named.GetTextureOffset("_BaseMap"), glm::vec2(0.5f, 0.25f));
}

TEST_F(MaterialQueries, ListTheNamesOfAKind)
{
    using Names = std::vector<std::string>;
    using enum MaterialPropertyType;
    EXPECT_EQ(m_Material.GetPropertyNames(Float), (Names{"_Width", "_Cut", "_Old"}));
    EXPECT_EQ(m_Material.GetPropertyNames(Int), Names{"_Count"});
    EXPECT_EQ(m_Material.GetPropertyNames(Vector), (Names{"_Tint", "_Glow", "_Offset"}));
    EXPECT_EQ(m_Material.GetTexturePropertyNames(), Names{"_Map"});
    EXPECT_EQ(m_Material.GetTexturePropertyNameIDs(), std::vector{ShaderPropertyId("_Map")});
    EXPECT_EQ(m_Material.GetPropertyNames(Matrix), Names());
}

TEST_F(MaterialQueries, OverrideTagsOfTheShader)
{
    Material material{test::ShaderOf("Shader \"Test/Tags\" { SubShader { Tags { \"RenderType\" = "
                                     "\"Opaque\" } Pass { } } }")};
    material.SetOverrideTag("RENDERTYPE", "Cutout");
    EXPECT_EQ(material.GetTag("RenderType", true), "Cutout");
    material.SetOverrideTag("Other", "Value");
    EXPECT_EQ(material.GetTag("other", false, "none"), "Value");
    material.SetOverrideTag("RenderType", "");
    EXPECT_EQ(material.GetTag("RenderType", true), "Opaque");
}

TEST_F(MaterialQueries, CopyOnlyWhatBothShadersHave)
{
    Material other{test::ShaderOf("Shader \"Test/Other\" { Properties { _Width (\"\", Float) = 9\n"
                                  "_Else (\"\", Float) = 8\n_Map (\"\", 2D) = \"white\" {} } "
                                  "SubShader { Pass { } } }")};
    other.SetTextureScale("_Map", {2.0f, 3.0f});
    other.SetFloat("_Cut", 0.5f); // no property of its shader
    other.EnableKeyword("_ON");
    other.SetRenderQueue(3000);
    m_Material.CopyMatchingPropertiesFromMaterial(other);
    EXPECT_EQ(m_Material.GetFloat("_Width"), 9.0f);
    EXPECT_EQ(m_Material.GetFloat("_Cut"), 0.25f);
    EXPECT_EQ(m_Material.GetTextureScale("_Map"), glm::vec2(2.0f, 3.0f));
    EXPECT_EQ(m_Material.Find(ShaderPropertyId("_Else")), nullptr);
    EXPECT_FALSE(m_Material.IsKeywordEnabled("_ON"));
    EXPECT_EQ(m_Material.rawRenderQueue(), -1);
    EXPECT_EQ(other.rawRenderQueue(), 3000);
}

TEST_F(MaterialQueries, LerpNumbersVectorsAndColours)
{
    Material start = m_Material;
    Material end = m_Material;
    start.SetFloat("_Width", 1.0f);
    end.SetFloat("_Width", 3.0f);
    start.SetVector("_Offset", glm::vec4(0.0f));
    end.SetVector("_Offset", glm::vec4(4.0f));
    start.SetColor("_Tint", Color(0.0f, 0.0f, 0.0f, 0.0f));
    end.SetColor("_Tint", Color(1.0f, 0.5f, 0.0f, 1.0f));
    end.SetInteger("_Count", 44);
    m_Material.Lerp(start, end, 0.25f);
    EXPECT_EQ(m_Material.GetFloat("_Width"), 1.5f);
    EXPECT_EQ(m_Material.GetVector("_Offset"), glm::vec4(1.0f));
    EXPECT_EQ(m_Material.GetColor("_Tint"), Color(0.25f, 0.125f, 0.0f, 0.25f));
    EXPECT_EQ(m_Material.GetInteger("_Count"), 4) << "there is nothing between whole numbers";
    m_Material.Lerp(start, end, 7.0f);
    EXPECT_EQ(m_Material.GetFloat("_Width"), 3.0f);
}

TEST_F(MaterialQueries, GiveColoursOfAnArrayAsTheyWereSet)
{
    const Color color(0.5f, 0.25f, 1.0f, 0.5f);
    m_Material.SetColorArray("_Colors", {color});
    const std::vector<Color> seen = m_Material.GetColorArray("_Colors");
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_NEAR(seen[0].r, color.r, 1e-6);
    EXPECT_NEAR(seen[0].g, color.g, 1e-6);
    EXPECT_EQ(seen[0].a, color.a);
    EXPECT_TRUE(m_Material.GetColorArray("_Width").empty());
}

} // namespace
} // namespace limn
