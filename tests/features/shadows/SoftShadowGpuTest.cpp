#include "features/shadows/ShadowScene.h"

#include <cstring>
#include <random>

namespace limn::test
{
namespace
{

constexpr int k_MapSide = 48;
constexpr int k_Texels = 12;

/// How much of [a, b] a tent over [-w, w] of area 1 covers.
double UnderTent(double a, double b, double w)
{
    const auto upTo = [w](double x)
    {
        x = std::clamp(x, -w, w);
        return (w * x - x * std::abs(x) / 2.0) / (w * w);
    };
    return upTo(b) - upTo(a);
}

/// A wall that shows a made-up shadow map through the library's filter.
class SoftShadowGpu : public GpuTest
{
protected:
    SoftShadowGpu() : m_Wall(k_MapSide, k_MapSide)
    {
        std::mt19937 random(3);
        for (float& depth : m_Depths)
        {
            depth = static_cast<float>(random() % 2) * 0.8f;
        }
        std::vector<std::byte> texels(sizeof m_Depths);
        std::memcpy(texels.data(), m_Depths.data(), texels.size());
        m_Map = std::make_shared<const Texture2D>("depths", k_Texels, k_Texels,
                                                  GraphicsFormat::R32_SFloat, std::move(texels));
        const auto shader = ShaderOf(
            "Shader \"Test/Filter\" { SubShader { Pass { Tags { \"LightMode\" = "
            "\"UniversalForward\" }\nHLSLPROGRAM\n"
            "#pragma vertex Vert\n#pragma fragment Frag\n"
            "#pragma multi_compile_local _MAIN_LIGHT_SHADOWS\n"
            "#pragma multi_compile_local _ _SHADOWS_SOFT\n"
            "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl\""
            "\nfloat4 Vert(float4 p : POSITION) : SV_POSITION\n"
            "{ return TransformObjectToHClip(p.xyz); }\n"
            "float4 Frag(float4 p : SV_POSITION) : SV_Target {\n"
            "float2 uv = 0.3 + 0.4 * p.xy / 48.0;\n"
            "return float4(MainLightRealtimeShadow(float4(uv, 0.5, 0)).xxx, 1); }\n"
            "ENDHLSL\n} } }");
        m_Material = std::make_shared<Material>(shader);
        m_Material->EnableKeyword("_MAIN_LIGHT_SHADOWS");
        m_Material->SetTexture(ShaderPropertyId("_MainLightShadowmapTexture"), m_Map);
        const float half = 0.5f / k_Texels;
        m_Material->SetVector(ShaderPropertyId("_MainLightShadowOffset0"),
                              {-half, -half, half, -half});
        m_Material->SetVector(ShaderPropertyId("_MainLightShadowOffset1"),
                              {-half, half, half, half});
        m_Wall.Add({0, 0}, {k_MapSide, k_MapSide}, 5, m_Material);
    }

    /// @param softness  as _MainLightShadowParams.y has it
    Field Draw(float softness)
    {
        m_Material->SetVector(ShaderPropertyId("_MainLightShadowParams"),
                              {1.0f, softness, 0.0f, 0.0f});
        softness > 0.0f ? m_Material->EnableKeyword("_SHADOWS_SOFT")
                        : m_Material->DisableKeyword("_SHADOWS_SOFT");
        PictureRun run(m_Wall.scene, m_Wall.camera, k_MapSide, k_MapSide);
        return run.Color(nullptr);
    }

    /// 1 where 0.5 is as near as the texel or nearer, with 1 near.
    double Lit(int x, int y) const
    {
        return m_Depths[static_cast<std::size_t>(y * k_Texels + x)] <= 0.5f ? 1.0 : 0.0;
    }
    /// @param weight  of a texel whose borders are that far from the place
    double Filtered(double x, double y, double (*weight)(double, double)) const
    {
        double sum = 0.0;
        for (int row = 0; row < k_Texels; ++row)
        {
            for (int column = 0; column < k_Texels; ++column)
            {
                sum += Lit(column, row) * weight(column - x, column + 1 - x) *
                       weight(row - y, row + 1 - y);
            }
        }
        return sum;
    }
    void ExpectFiltered(float softness, double (*weight)(double, double))
    {
        const Field picture = Draw(softness);
        double least = 1.0;
        double most = 0.0;
        for (int y = 0; y < k_MapSide; ++y)
        {
            for (int x = 0; x < k_MapSide; ++x)
            {
                const double u = (0.3 + 0.4 * (x + 0.5) / k_MapSide) * k_Texels;
                const double v = (0.3 + 0.4 * (y + 0.5) / k_MapSide) * k_Texels;
                const double wanted = Filtered(u, v, weight);
                ASSERT_NEAR(picture.At(x, k_MapSide - 1 - y, 0), wanted, 1e-3)
                    << x << ", " << y << " from the bottom";
                least = std::min(least, wanted);
                most = std::max(most, wanted);
            }
        }
        EXPECT_GT(most - least, 0.1) << "nothing to filter";
    }

    FlatScene m_Wall;
    std::array<float, k_Texels * k_Texels> m_Depths;
    std::shared_ptr<const Texture2D> m_Map;
    std::shared_ptr<Material> m_Material;
};

/// A box of one texel around the place: what bilinear weights are.
double Box(double a, double b)
{
    return std::max(std::min(b, 0.5) - std::max(a, -0.5), 0.0);
}

TEST_F(SoftShadowGpu, WeighsTexelsBilinearlyWhereItIsHard)
{
    ExpectFiltered(0.0f, Box);
}

TEST_F(SoftShadowGpu, OfLowQualityIsTheMeanOfFourPlacesHalfATexelAway)
{
    ExpectFiltered(1.0f, [](double a, double b)
                   { return (Box(a - 0.5, b - 0.5) + Box(a + 0.5, b + 0.5)) / 2.0; });
}

TEST_F(SoftShadowGpu, OfMediumQualityIsATentOverFiveTexels)
{
    ExpectFiltered(2.0f, [](double a, double b) { return UnderTent(a, b, 2.5); });
}

TEST_F(SoftShadowGpu, OfHighQualityIsATentOverSevenTexels)
{
    ExpectFiltered(3.0f, [](double a, double b) { return UnderTent(a, b, 3.5); });
}

} // namespace
} // namespace limn::test
