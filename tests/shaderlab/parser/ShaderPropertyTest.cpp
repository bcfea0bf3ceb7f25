#include "ShaderTestSupport.h"

namespace limn
{
namespace
{

ShaderProperty Property(const std::string& text)
{
    const ShaderLabDocument document =
        test::ParseGood("Shader \"x\" { Properties { " + text + " } }");
    EXPECT_EQ(document.properties.size(), 1u);
    return document.properties.at(0);
}

using Vector = std::array<float, 4>;

TEST(ShaderProperty, HoldsANumberAndItsNames)
{
    const ShaderProperty property = Property("_OutlineWidth (\"Outline Width\", Float) = -1.5");
    EXPECT_EQ(property.name, "_OutlineWidth");
    EXPECT_EQ(property.displayName, "Outline Width");
    EXPECT_EQ(property.type, ShaderPropertyType::Float);
    EXPECT_EQ(property.defaultValue, (Vector{-1.5f, 0, 0, 0}));
    EXPECT_EQ(property.location, (SourceLocation{1, 27}));
}

TEST(ShaderProperty, HoldsTheLimitsOfARange)
{
    const ShaderProperty property = Property("_W (\"w\", Range(-.5, 10.)) = 5");
    EXPECT_EQ(property.type, ShaderPropertyType::Range);
    EXPECT_EQ(property.rangeMin, -0.5f);
    EXPECT_EQ(property.rangeMax, 10.0f);
    EXPECT_EQ(property.defaultValue[0], 5.0f);
}

TEST(ShaderProperty, TellsTheTwoIntegerTypesApart)
{
    EXPECT_EQ(Property("_I (\"i\", Int) = 3").type, ShaderPropertyType::Int);
    EXPECT_EQ(Property("_I (\"i\", Integer) = 3").type, ShaderPropertyType::Integer);
}

TEST(ShaderProperty, FillsAColorOfThreeNumbersWithFullAlphaAndAVectorWithZero)
{
    EXPECT_EQ(Property("_C (\"c\", Color) = (0, 1, .5)").defaultValue, (Vector{0, 1, 0.5f, 1}));
    EXPECT_EQ(Property("_C (\"c\", Color) = (0, 1, 1, 0.25)").defaultValue,
              (Vector{0, 1, 1, 0.25f}));
    EXPECT_EQ(Property("_V (\"v\", Vector) = (1, 2, 3)").defaultValue, (Vector{1, 2, 3, 0}));
}

TEST(ShaderProperty, OfOneNumberTakesTheFirstOfAList)
{
    const ShaderLabParseResult result = ParseShaderLab(
        "Shader \"x\" { Properties { _W (\"w\", Float) = (2, 3, 4, 5) } }", "t.shader");
    EXPECT_EQ(
        test::Messages(result.diagnostics),
        std::vector<std::string>{
            "1:45: warning: _W: a list has more numbers than the property; write one number"});
    EXPECT_EQ(result.document.properties.at(0).defaultValue, (Vector{2, 0, 0, 0}));
}

struct DimensionCase
{
    const char* keyword;
    TextureDimension dimension;
};

class TextureProperty : public testing::TestWithParam<DimensionCase>
{
};

TEST_P(TextureProperty, HasTheDimensionOfItsKeyword)
{
    const ShaderProperty property =
        Property("_T (\"t\", " + std::string(GetParam().keyword) + ") = \"white\" {}");
    EXPECT_EQ(property.type, ShaderPropertyType::Texture);
    EXPECT_EQ(property.dimension, GetParam().dimension);
    EXPECT_EQ(property.defaultTexture, "white");
}

INSTANTIATE_TEST_SUITE_P(Keywords, TextureProperty,
                         testing::Values(DimensionCase{"2D", TextureDimension::Tex2D},
                                         DimensionCase{"2DArray", TextureDimension::Tex2DArray},
                                         DimensionCase{"3d", TextureDimension::Tex3D},
                                         DimensionCase{"Cube", TextureDimension::Cube},
                                         DimensionCase{"CubeArray", TextureDimension::CubeArray},
                                         DimensionCase{"Rect", TextureDimension::Tex2D},
                                         DimensionCase{"Any", TextureDimension::Tex2D}));

TEST(ShaderProperty, TakesATextureDefaultWithoutBracesAndWithLegacyModesInThem)
{
    EXPECT_EQ(Property("_T (\"t\", 2D) = \"\"").defaultTexture, "");
    EXPECT_EQ(Property("_T (\"t\", Cube) = \"black\" { TexGen CubeReflect }").defaultTexture,
              "black");
}

TEST(ShaderProperty, KeepsItsAttributesAsText)
{
    const ShaderProperty property = Property(
        "[HideInInspector] [HDR][Enum(UnityEngine.Rendering.BlendMode)]\n[Header(Detail (A))] "
        "_C (\"c\", Int) = 5");
    ASSERT_EQ(property.attributes.size(), 4u);
    EXPECT_EQ(property.attributes[2].text, "Enum(UnityEngine.Rendering.BlendMode)");
    EXPECT_EQ(property.attributes[3].text, "Header(Detail (A))");
    EXPECT_TRUE(property.HasAttribute("HDR"));
    EXPECT_TRUE(property.HasAttribute("Enum"));
    EXPECT_FALSE(property.HasAttribute("MainTexture"));
}

TEST(ShaderProperty, EndsAnAttributeAtTheFirstClosingBracket)
{
    const ShaderProperty property = Property("[Enum(OFF, 0, ON, 1,] _E (\"e\", Float) = 0");
    EXPECT_EQ(property.attributes.at(0).text, "Enum(OFF, 0, ON, 1,");
}

TEST(ShaderProperty, MayBeCalledLikeAKeywordAndHaveADisplayNameOfSeveralLines)
{
    const ShaderProperty property = Property("Color (\"a\n{ 'b': [1] }\", Color) = (1,1,1,1)");
    EXPECT_EQ(property.name, "Color");
    EXPECT_EQ(property.displayName, "a\n{ 'b': [1] }");
}

TEST(ShaderProperty, NeedsNoDefault)
{
    EXPECT_EQ(Property("_A (\"a\", Vector)").defaultValue, (Vector{0, 0, 0, 0}));
}

} // namespace
} // namespace limn
