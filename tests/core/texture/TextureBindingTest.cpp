#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limn/core/BuiltinShaders.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

using testing::ElementsAre;
using testing::IsEmpty;

const ShaderPropertyId _Map("_Map");

/// A shader that samples `_Map` with a sampler of this name.
std::shared_ptr<Material> Sampling(const std::string& properties,
                                   const std::string& sampler = "sampler_Map")
{
    return std::make_shared<Material>(
        test::ShaderWithProgram(properties, "Texture2D _Map; SamplerState " + sampler + ";",
                                "_Map.Sample(" + sampler + ", float2(0.5, 0.5))"),
        "Paint");
}

std::shared_ptr<const Texture> TextureWith(SamplerState sampler)
{
    return std::make_shared<const RenderTexture>(
        "map", RenderTextureDescriptor(4, 4, GraphicsFormat::R8G8B8A8_UNorm), sampler);
}

class TextureBindings : public testing::Test
{
protected:
    std::string DefaultFor(const std::string& property)
    {
        m_Draw.Resolve(Sampling(property));
        return m_Draw.TextureNamed("_Map")->name();
    }

    test::OneDraw m_Draw;
};

TEST_F(TextureBindings, DefaultToTheTextureThatThePropertyNames)
{
    EXPECT_EQ(DefaultFor("_Map (\"Map\", 2D) = \"white\" {}"), "white");
    EXPECT_EQ(DefaultFor("_Map (\"Map\", 2D) = \"black\" {}"), "black");
    EXPECT_EQ(DefaultFor("_Map (\"Map\", 2D) = \"Bump\" {}"), "bump");
    EXPECT_EQ(DefaultFor("_Map (\"Map\", 2D) = \"red\" {}"), "red");
}

TEST_F(TextureBindings, DefaultToGrayWithoutAKnownName)
{
    EXPECT_EQ(DefaultFor("_Map (\"Map\", 2D) = \"\" {}"), "gray");
    EXPECT_EQ(DefaultFor("_Map (\"Map\", 2D) = \"mauve\" {}"), "gray");
    EXPECT_EQ(DefaultFor(""), "gray");
}

TEST_F(TextureBindings, SayThatNothingGivesTheTextureAValue)
{
    m_Draw.Resolve(Sampling(""));
    EXPECT_THAT(m_Draw.report.notes, ElementsAre(Mentions("'Test/Program'", "'_Map' is gray",
                                                          "no property", "'Paint'", "global")));
}

TEST_F(TextureBindings, SayItOnceForAShader)
{
    RenderReport report;
    ScriptableRenderContext context(report);
    CommandBuffer cmd;
    const auto material = Sampling("");
    const auto other = std::make_shared<Material>(material->shader(), "Other");
    cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
    cmd.DrawProcedural(glm::mat4(1.0f), other, 0, 3);
    context.ExecuteCommandBuffer(cmd);
    EXPECT_EQ(report.notes.size(), 1u);
}

TEST_F(TextureBindings, SayNothingWhereAPropertyOrAGlobalGivesTheValue)
{
    m_Draw.Resolve(Sampling("_Map (\"Map\", 2D) = \"\" {}"));
    EXPECT_THAT(m_Draw.report.notes, IsEmpty());
    m_Draw.before.SetGlobalTexture(_Map, test::Target("global"));
    m_Draw.Resolve(Sampling(""));
    EXPECT_THAT(m_Draw.report.notes, IsEmpty());
}

TEST_F(TextureBindings, TakeTheBlocksTextureThenTheMaterialsThenTheGlobal)
{
    const auto material = Sampling("_Map (\"Map\", 2D) = \"white\" {}");
    const RTHandle global(test::Target("global"));
    m_Draw.before.SetGlobalTexture(_Map, global);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.TextureNamed("_Map"), global.rt());
    const auto own = test::Target("own");
    material->SetTexture(_Map, own);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.TextureNamed("_Map"), own);
    const auto block = test::Target("block");
    m_Draw.block.SetTexture(_Map, block);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.TextureNamed("_Map"), block);
}

TEST_F(TextureBindings, GoBackToTheDefaultWhenTheTextureIsTakenAway)
{
    const auto material = Sampling("_Map (\"Map\", 2D) = \"red\" {}");
    material->SetTexture(_Map, test::Target("own"));
    material->SetTexture(_Map, nullptr);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.TextureNamed("_Map")->name(), "red");
}

TEST_F(TextureBindings, RefuseANumber)
{
    const auto material = Sampling("");
    material->SetFloat(_Map, 1.0f);
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Draw.Resolve(material); }),
                Mentions("'Paint'", "'_Map'", "a texture", "a number"));
}

/// How HLSL declares and samples a dimension.
struct DimensionCase
{
    TextureDimension dimension;
    const char* property; ///< in ShaderLab
    const char* type;     ///< in HLSL
    const char* coordinate;
    const char* name; ///< of the test
};

std::shared_ptr<Material> SamplingDimension(const DimensionCase& c, const std::string& properties)
{
    return std::make_shared<Material>(
        test::ShaderWithProgram(properties,
                                std::string(c.type) + " _Map; SamplerState sampler_Map; "
                                                      "float4 _Map_TexelSize; float4 _Map_HDR;",
                                std::string("_Map.Sample(sampler_Map, ") + c.coordinate +
                                    ") * _Map_TexelSize * _Map_HDR"),
        "Paint");
}

class DimensionBindings : public testing::TestWithParam<DimensionCase>
{
protected:
    std::shared_ptr<const Texture> DefaultFor(const std::string& name)
    {
        m_Draw.Resolve(SamplingDimension(GetParam(), std::string("_Map (\"Map\", ") +
                                                         GetParam().property + ") = \"" + name +
                                                         "\" {}"));
        return m_Draw.TextureNamed("_Map");
    }

    test::OneDraw m_Draw;
};

INSTANTIATE_TEST_SUITE_P(
    Each, DimensionBindings,
    testing::Values(
        DimensionCase{TextureDimension::Tex2D, "2D", "Texture2D", "float2(0, 0)", "Flat"},
        DimensionCase{TextureDimension::Tex3D, "3D", "Texture3D", "float3(0, 0, 0)", "Volume"},
        DimensionCase{TextureDimension::Cube, "Cube", "TextureCube", "float3(0, 0, 1)", "Cube"},
        DimensionCase{TextureDimension::Tex2DArray, "2DArray", "Texture2DArray", "float3(0, 0, 0)",
                      "Array"},
        DimensionCase{TextureDimension::CubeArray, "CubeArray", "TextureCubeArray",
                      "float4(0, 0, 1, 0)", "CubeArray"}),
    [](const auto& c) { return c.param.name; });

TEST_P(DimensionBindings, DefaultToTheNamedColourInTheDimensionThatTheShaderDeclares)
{
    struct Default
    {
        const char* written;
        const char* name;
        std::vector<int> rgba;
    };
    for (const Default& expected :
         {Default{"white", "white", {255, 255, 255, 255}},
          Default{"black", "black", {0, 0, 0, 255}}, Default{"gray", "gray", {128, 128, 128, 128}},
          Default{"grey", "gray", {128, 128, 128, 128}},
          Default{"linearGrey", "linearGray", {128, 128, 128, 128}},
          Default{"linearGray", "linearGray", {128, 128, 128, 128}},
          Default{"bump", "bump", {128, 128, 255, 255}}, Default{"red", "red", {255, 0, 0, 255}},
          Default{"", "gray", {128, 128, 128, 128}}})
    {
        SCOPED_TRACE(expected.written);
        const auto texture =
            std::dynamic_pointer_cast<const TexelTexture>(DefaultFor(expected.written));
        ASSERT_NE(texture, nullptr);
        EXPECT_EQ(texture->dimension(), GetParam().dimension);
        EXPECT_EQ(texture->name(), expected.name);
        EXPECT_EQ(IsSRGBFormat(texture->graphicsFormat()), std::string(expected.name) == "gray");
        std::vector<int> firstTexel;
        for (std::size_t i = 0; i < 4; ++i)
        {
            firstTexel.push_back(std::to_integer<int>(texture->texels().at(i)));
        }
        EXPECT_EQ(firstTexel, expected.rgba);
    }
}

TEST_P(DimensionBindings, DefaultToGrayWithoutAPropertiesEntry)
{
    m_Draw.Resolve(SamplingDimension(GetParam(), ""));
    EXPECT_EQ(m_Draw.TextureNamed("_Map")->dimension(), GetParam().dimension);
    EXPECT_EQ(m_Draw.TextureNamed("_Map")->name(), "gray");
}

TEST_P(DimensionBindings, TakeOnlyATextureOfTheDimensionThatTheShaderDeclares)
{
    const DimensionCase& c = GetParam();
    for (const TextureDimension other :
         {TextureDimension::Tex2D, TextureDimension::Tex3D, TextureDimension::Cube,
          TextureDimension::Tex2DArray, TextureDimension::CubeArray})
    {
        const auto material = SamplingDimension(c, "");
        const std::shared_ptr<const Texture> texture = DefaultTexture("red", other);
        material->SetTexture(_Map, texture);
        if (other == c.dimension)
        {
            m_Draw.Resolve(material);
            EXPECT_EQ(m_Draw.TextureNamed("_Map"), texture);
            continue;
        }
        const std::string error =
            test::ThrownMessage<ContractError>([&] { m_Draw.Resolve(material); });
        EXPECT_THAT(error, Mentions("'Paint'", "'_Map'", std::string(c.property) + " texture",
                                    ToString(other) + std::string(" texture 'red'")));
    }
}

TEST_P(DimensionBindings, TellTheSizeOfTheTopLevelAndThatNothingIsEncoded)
{
    m_Draw.Resolve(SamplingDimension(GetParam(), ""));
    EXPECT_EQ(m_Draw.Floats("_Map_TexelSize", 4), (std::vector{1.0f, 1.0f, 1.0f, 1.0f}));
    EXPECT_EQ(m_Draw.Floats("_Map_HDR", 4), (std::vector{1.0f, 1.0f, 0.0f, 0.0f}));
}

TEST_F(TextureBindings, SayWhichDimensionsDoNotFit)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("_Sky (\"Sky\", Cube) = \"\" {}",
                                "TextureCube _Sky; SamplerState sampler_Sky;",
                                "_Sky.Sample(sampler_Sky, float3(0, 0, 1))"),
        "Paint");
    material->SetTexture(ShaderPropertyId("_Sky"), test::Target("map"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Draw.Resolve(material); }),
                Mentions("'Paint'", "'_Sky'", "Cube texture", "2D texture 'map'"));
}

TEST_F(TextureBindings, TellWidthAndHeightOfAVolume)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "Texture3D _Fog; float4 _Fog_TexelSize;",
                                "_Fog.Load(int4(0, 0, 0, 0)) * _Fog_TexelSize"));
    material->SetTexture(ShaderPropertyId("_Fog"),
                         std::make_shared<const Texture3D>("fog", 8, 4, 2, GraphicsFormat::R8_UNorm,
                                                           std::vector<std::byte>(64)));
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.Floats("_Fog_TexelSize", 4), (std::vector{0.125f, 0.25f, 8.0f, 4.0f}));
}

TEST_F(TextureBindings, RefuseTexturesOfSeveralSamples)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "Texture2DMS<float4> _Map;", "_Map.Load(int2(0, 0), 0)"),
        "Paint");
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Draw.Resolve(material); }),
                Mentions("'Paint'", "'_Map'", "several samples", "cannot bind"));
}

struct NamedSampler
{
    const char* name;
    FilterMode filterMode;
    TextureWrapMode wrapMode;
};

TEST_F(TextureBindings, FilterAndWrapAsTheSamplersNameSays)
{
    using enum FilterMode;
    using enum TextureWrapMode;
    for (const NamedSampler& expected :
         {NamedSampler{"sampler_LinearClamp", Bilinear, Clamp},
          NamedSampler{"sampler_PointClamp", Point, Clamp},
          NamedSampler{"sampler_LinearRepeat", Bilinear, Repeat},
          NamedSampler{"my_point_repeat_sampler", Point, Repeat},
          NamedSampler{"sampler_trilinear_mirror", Trilinear, Mirror},
          NamedSampler{"sampler_MirrorOnce_Linear", Bilinear, MirrorOnce}})
    {
        m_Draw.Resolve(Sampling("", expected.name));
        EXPECT_EQ(m_Draw.SamplerNamed(expected.name),
                  (SamplerState{expected.filterMode, expected.wrapMode, expected.wrapMode,
                                expected.wrapMode, false}))
            << expected.name;
    }
}

TEST_F(TextureBindings, CompareWhereTheShaderDeclaresAComparisonSampler)
{
    const auto material = std::make_shared<Material>(test::ShaderWithProgram(
        "", "Texture2D _Map; SamplerComparisonState sampler_LinearClampCompare;",
        "_Map.SampleCmpLevelZero(sampler_LinearClampCompare, float2(0.5, 0.5), 0.5)"));
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.SamplerNamed("sampler_LinearClampCompare"),
              (SamplerState{FilterMode::Bilinear, TextureWrapMode::Clamp, TextureWrapMode::Clamp,
                            TextureWrapMode::Clamp, true}));
}

TEST_F(TextureBindings, FilterAndWrapAsTheTextureThatTheSamplerIsNamedAfter)
{
    const SamplerState sampler{FilterMode::Point, TextureWrapMode::Mirror, TextureWrapMode::Clamp,
                               TextureWrapMode::MirrorOnce, false};
    const auto material = Sampling("");
    material->SetTexture(_Map, TextureWith(sampler));
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.SamplerNamed("sampler_Map"), sampler);
}

TEST_F(TextureBindings, TakeTheSamplerOfAnotherTexture)
{
    const SamplerState sampler{FilterMode::Point, TextureWrapMode::Clamp, TextureWrapMode::Clamp,
                               TextureWrapMode::Clamp, false};
    const auto material = Sampling("", "sampler_MainTex");
    material->SetTexture(ShaderPropertyId("_MainTex"), TextureWith(sampler));
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.SamplerNamed("sampler_MainTex"), sampler);
}

TEST_F(TextureBindings, KeepTextureAndSamplerOfASampler2DTogether)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "sampler2D _Map;", "tex2D(_Map, float2(0.5, 0.5))"));
    const SamplerState sampler{FilterMode::Point, TextureWrapMode::Clamp, TextureWrapMode::Repeat,
                               TextureWrapMode::Repeat, false};
    const auto texture = TextureWith(sampler);
    material->SetTexture(_Map, texture);
    m_Draw.Resolve(material);
    ASSERT_EQ(m_Draw.draw().bindings->textures.size(), 1u);
    EXPECT_EQ(m_Draw.draw().bindings->textures[0].texture, texture);
    EXPECT_EQ(m_Draw.draw().bindings->textures[0].sampler, sampler);
}

TEST_F(TextureBindings, RefuseAStructuredBufferThatIsNotSet)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "StructuredBuffer<float4> _Points;", "_Points[0]"), "Paint");
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Draw.Resolve(material); }),
                Mentions("'Paint'", "buffer '_Points'", "not set", "global"));
}

} // namespace
} // namespace limn
