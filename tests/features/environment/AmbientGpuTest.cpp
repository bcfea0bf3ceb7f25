#include "features/color_edges/PictureRun.h"

#include <array>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace limn::test
{
namespace
{

/// Panels of a pixel each, whose material tells what a shader has for a direction.
class AmbientGpu : public GpuTest
{
protected:
    /// @param hlsl  a float3 of float3 `direction` and float `value`
    static std::shared_ptr<const Shader> Telling(const std::string& include,
                                                 const std::string& hlsl)
    {
        return ShaderOf(
            "Shader \"Test/Telling\" { Properties { _Direction (\"\", Vector) = (0, 1, 0, 0) }\n"
            "SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n"
            "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n#include \"" +
            include +
            "\"\nfloat4 _Direction;\n"
            "float4 Vert(float4 p : POSITION) : SV_POSITION\n"
            "{ return mul(UNITY_MATRIX_VP, mul(UNITY_MATRIX_M, float4(p.xyz, 1))); }\n"
            "float4 Frag() : SV_Target\n"
            "{ float3 direction = _Direction.xyz; float value = _Direction.w;\n"
            "return float4(" +
            hlsl + ", 1); }\nENDHLSL\n} } }");
    }
    static std::shared_ptr<const Shader> TellingUrp(const std::string& hlsl)
    {
        return Telling("Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl",
                       hlsl);
    }

    /// Draws with one panel for each; a panel's w is `value`.
    std::vector<glm::dvec3> Draw(const std::shared_ptr<const Shader>& shader,
                                 const std::vector<glm::vec4>& panels)
    {
        const int width = static_cast<int>(panels.size());
        FlatScene flat(width, 1);
        static_cast<RenderSettings&>(flat.scene) = m_Settings;
        for (std::size_t i = 0; i < panels.size(); ++i)
        {
            const auto material = std::make_shared<Material>(shader);
            material->SetVector(ShaderPropertyId("_Direction"), panels[i]);
            const auto left = static_cast<float>(i);
            flat.Add({left, 0}, {left + 1, 1}, 5, material);
        }
        const Field picture = PictureRun(flat.scene, flat.camera, width, 1).Color(nullptr);
        std::vector<glm::dvec3> colors;
        for (int x = 0; x < width; ++x)
        {
            colors.emplace_back(picture.At(x, 0, 0), picture.At(x, 0, 1), picture.At(x, 0, 2));
        }
        return colors;
    }

    RenderSettings m_Settings;
};

void ExpectNear(const glm::dvec3& wanted, const glm::dvec3& seen, const std::string& place)
{
    for (int channel = 0; channel < 3; ++channel)
    {
        EXPECT_NEAR(wanted[channel], seen[channel], 1e-3 * std::abs(wanted[channel]) + 1e-4)
            << place << ", channel " << channel;
    }
}

const std::vector<glm::vec4> k_Sides{{1, 0, 0, 1},        {-1, 0, 0, 1},          {0, 1, 0, 1},
                                     {0, -1, 0, 1},       {0, 0, 1, 1},           {0, 0, -1, 1},
                                     {0.6f, 0, -0.8f, 1}, {0.48f, 0.6f, 0.64f, 1}};

TEST_F(AmbientGpu, IsTheSumOfTheHarmonicsInEachLibrary)
{
    m_Settings.ambientMode = AmbientMode::Custom;
    for (int rgb = 0; rgb < 3; ++rgb)
    {
        for (int i = 0; i < 9; ++i)
        {
            m_Settings.ambientProbe(rgb, i) =
                i == 0 ? 2.5f : 0.3f * std::sin(static_cast<float>(9 * rgb + 2 * i));
        }
    }
    const std::vector<glm::dvec3> urp = Draw(TellingUrp("SampleSH(direction)"), k_Sides);
    const std::vector<glm::dvec3> builtin =
        Draw(Telling("UnityCG.cginc", "ShadeSH9(half4(direction, 1))"), k_Sides);
    for (std::size_t side = 0; side < k_Sides.size(); ++side)
    {
        const glm::dvec3 n(k_Sides[side]);
        const double functions[] = {1.0,
                                    n.y,
                                    n.z,
                                    n.x,
                                    n.x * n.y,
                                    n.y * n.z,
                                    3.0 * n.z * n.z - 1.0,
                                    n.x * n.z,
                                    n.x * n.x - n.y * n.y};
        glm::dvec3 sum(0.0);
        for (int i = 0; i < 9; ++i)
        {
            for (int rgb = 0; rgb < 3; ++rgb)
            {
                sum[rgb] += static_cast<double>(m_Settings.ambientProbe(rgb, i)) * functions[i];
            }
        }
        ExpectNear(sum, urp[side], "URP, side " + std::to_string(side));
        ExpectNear(sum, builtin[side], "built-in, side " + std::to_string(side));
    }
}

TEST_F(AmbientGpu, HasThreeColorsByHeightInModeTrilight)
{
    m_Settings.ambientMode = AmbientMode::Trilight;
    m_Settings.ambientSkyColor = {0.9f, 0.4f, 0.1f};
    m_Settings.ambientEquatorColor = {0.3f, 0.8f, 0.5f};
    m_Settings.ambientGroundColor = {0.7f, 0.2f, 0.6f};
    const auto linear = [](const Color& color)
    {
        return glm::dvec3(glm::vec3(color.linear().vector()));
    };
    const std::vector<glm::dvec3> light = Draw(TellingUrp("SampleSH(direction)"), k_Sides);
    for (const std::size_t side : std::to_array<std::size_t>({0, 1, 4, 5, 6}))
    {
        ExpectNear(linear({0.3f, 0.8f, 0.5f}), light[side], "side " + std::to_string(side));
    }
    ExpectNear(linear({0.9f, 0.4f, 0.1f}), light[2], "up");
    ExpectNear(linear({0.7f, 0.2f, 0.6f}), light[3], "down");
    const std::vector<glm::dvec3> named =
        Draw(TellingUrp("value < 1.5 ? unity_AmbientSky.rgb : value < 2.5 ? "
                        "unity_AmbientEquator.rgb : unity_AmbientGround.rgb"),
             {{0, 1, 0, 1}, {0, 1, 0, 2}, {0, 1, 0, 3}});
    ExpectNear(linear({0.9f, 0.4f, 0.1f}), named[0], "unity_AmbientSky");
    ExpectNear(linear({0.3f, 0.8f, 0.5f}), named[1], "unity_AmbientEquator");
    ExpectNear(linear({0.7f, 0.2f, 0.6f}), named[2], "unity_AmbientGround");
}

/// A cube of 64 texels whose color says face and level.
std::shared_ptr<const Cubemap> TellingCube()
{
    std::vector<CubemapFaces> levels(7);
    for (std::size_t level = 0; level < levels.size(); ++level)
    {
        for (std::size_t face = 0; face < 6; ++face)
        {
            const std::uint64_t texel = glm::packHalf4x16(
                {static_cast<float>(face) + 1.0f, static_cast<float>(level) + 1.0f, 16.0f, 1.0f});
            const std::size_t width = std::size_t{64} >> level;
            std::vector<std::byte>& texels = levels[level][face];
            texels.resize(8 * width * width);
            for (std::size_t i = 0; i < width * width; ++i)
            {
                std::memcpy(texels.data() + 8 * i, &texel, 8);
            }
        }
    }
    return std::make_shared<const Cubemap>("telling", 64, GraphicsFormat::R16G16B16A16_SFloat,
                                           std::move(levels), SamplerState{FilterMode::Trilinear});
}

TEST_F(AmbientGpu, MirrorsTheLevelOfTheRoughnessTimesTheIntensity)
{
    m_Settings.customReflectionTexture = TellingCube();
    m_Settings.reflectionIntensity = 0.5f;
    std::vector<glm::vec4> panels;
    for (std::size_t face = 0; face < 6; ++face)
    {
        for (int level = 0; level <= 6; ++level)
        {
            // Of level = 6 p (1.7 - 0.7 p).
            const double p = (1.7 - std::sqrt(1.7 * 1.7 - 2.8 * level / 6.0)) / 1.4;
            panels.emplace_back(glm::vec3(k_Sides[face]), p);
        }
    }
    for (const std::string cube : {"unity_SpecCube0", "_GlossyEnvironmentCubeMap"})
    {
        const std::vector<glm::dvec3> colors = Draw(
            TellingUrp("DecodeHDREnvironment(SAMPLE_TEXTURECUBE_LOD(" + cube + ", sampler" + cube +
                       ", direction, PerceptualRoughnessToMipmapLevel(value)), " + cube + "_HDR)"),
            panels);
        for (std::size_t i = 0; i < panels.size(); ++i)
        {
            const double face = static_cast<double>(i / 7) + 1.0;
            const double level = static_cast<double>(i % 7) + 1.0;
            // Levels are mixed by 8 bits of their number.
            EXPECT_NEAR(0.5 * face, colors[i].x, 1e-3 * face) << cube << i;
            EXPECT_NEAR(0.5 * level, colors[i].y, 4e-3) << cube << i;
            EXPECT_NEAR(8.0, colors[i].z, 8e-3) << cube << i;
        }
    }
}

TEST_F(AmbientGpu, MirrorsNothingToBeginWith)
{
    const auto shader = TellingUrp("SAMPLE_TEXTURECUBE_LOD(unity_SpecCube0, "
                                   "samplerunity_SpecCube0, direction, value).rgb");
    for (const glm::dvec3& color : Draw(shader, k_Sides))
    {
        EXPECT_EQ(glm::dvec3(0.0), color);
    }
}

TEST_F(AmbientGpu, TellsItsMeanToWhatMirrorsNothing)
{
    m_Settings.ambientMode = AmbientMode::Custom;
    m_Settings.ambientProbe.AddAmbientLight({0.25f, 0.5f, 1.0f});
    m_Settings.ambientProbe(1, 3) = 0.75f;
    m_Settings.reflectionIntensity = 0.5f;
    const auto colors = Draw(TellingUrp("_GlossyEnvironmentColor.rgb"), {{0, 1, 0, 0}});
    ExpectNear({0.125, 0.25, 0.5}, colors.front(), "color");
}

} // namespace
} // namespace limn::test
