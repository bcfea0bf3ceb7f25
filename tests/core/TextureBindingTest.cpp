#include <gtest/gtest.h>

#include "DrawHarness.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

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
    EXPECT_EQ(
        test::ThrownMessage<ContractError>([&] { m_Draw.Resolve(material); }),
        "material 'Paint': property '_Map' is a texture in the shader but is set to a number");
}

TEST_F(TextureBindings, RefuseOtherKindsThan2D)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "TextureCube _Sky; SamplerState sampler_Sky;",
                                "_Sky.Sample(sampler_Sky, float3(0, 0, 1))"),
        "Paint");
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { m_Draw.Resolve(material); }),
              "material 'Paint': '_Sky' is no plain 2D texture; other kinds cannot be bound yet");
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
                  (SamplerState{expected.filterMode, expected.wrapMode, expected.wrapMode, false}))
            << expected.name;
    }
}

TEST_F(TextureBindings, CompareWhereTheShaderDeclaresAComparisonSampler)
{
    const auto material = std::make_shared<Material>(test::ShaderWithProgram(
        "", "Texture2D _Map; SamplerComparisonState sampler_LinearClampCompare;",
        "_Map.SampleCmpLevelZero(sampler_LinearClampCompare, float2(0.5, 0.5), 0.5)"));
    m_Draw.Resolve(material);
    EXPECT_EQ(
        m_Draw.SamplerNamed("sampler_LinearClampCompare"),
        (SamplerState{FilterMode::Bilinear, TextureWrapMode::Clamp, TextureWrapMode::Clamp, true}));
}

TEST_F(TextureBindings, FilterAndWrapAsTheTextureThatTheSamplerIsNamedAfter)
{
    const SamplerState sampler{FilterMode::Point, TextureWrapMode::Mirror, TextureWrapMode::Clamp,
                               false};
    const auto material = Sampling("");
    material->SetTexture(_Map, TextureWith(sampler));
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.SamplerNamed("sampler_Map"), sampler);
}

TEST_F(TextureBindings, TakeTheSamplerOfAnotherTexture)
{
    const SamplerState sampler{FilterMode::Point, TextureWrapMode::Clamp, TextureWrapMode::Clamp,
                               false};
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
                               false};
    const auto texture = TextureWith(sampler);
    material->SetTexture(_Map, texture);
    m_Draw.Resolve(material);
    ASSERT_EQ(m_Draw.draw().bindings->textures.size(), 1u);
    EXPECT_EQ(m_Draw.draw().bindings->textures[0].texture, texture);
    EXPECT_EQ(m_Draw.draw().bindings->textures[0].sampler, sampler);
}

TEST_F(TextureBindings, RefuseAStructuredBufferThatIsNotThePerDrawOne)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "StructuredBuffer<float4> _Points;", "_Points[0]"), "Paint");
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { m_Draw.Resolve(material); }),
              "material 'Paint': structured buffer '_Points' cannot be bound yet");
}

} // namespace
} // namespace limn
