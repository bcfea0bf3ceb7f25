#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <algorithm>
#include <cmath>
#include <limn/core/CommandBuffer.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/ScriptableRenderContext.h>
#include <random>

namespace limn::test
{

namespace
{

/// A picture of one channel in double.
struct Level
{
    int width = 0;
    int height = 0;
    std::vector<double> texels;

    double At(int x, int y) const
    {
        return texels[static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width +
                                               std::clamp(x, 0, width - 1))];
    }
    /// Between texels, at a place in texels.
    double Bilinear(double x, double y) const
    {
        const double left = std::floor(x - 0.5);
        const double top = std::floor(y - 0.5);
        const int i = static_cast<int>(left);
        const int j = static_cast<int>(top);
        const double u = x - 0.5 - left;
        const double v = y - 0.5 - top;
        return std::lerp(std::lerp(At(i, j), At(i + 1, j), u),
                         std::lerp(At(i, j + 1), At(i + 1, j + 1), u), v);
    }
};

/// Half as large; each texel what a linear filter sees in the middle of its place.
Level NextLevel(const Level& from)
{
    Level next{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    for (int y = 0; y < next.height; ++y)
    {
        for (int x = 0; x < next.width; ++x)
        {
            next.texels.push_back(from.Bilinear((x + 0.5) * from.width / next.width,
                                                (y + 0.5) * from.height / next.height));
        }
    }
    return next;
}

std::shared_ptr<const Texture2D> FloatTexture(const Level& level, SamplerState sampler = {},
                                              bool mipChain = true)
{
    std::vector<std::byte> bytes(level.texels.size() * sizeof(float));
    for (std::size_t i = 0; i < level.texels.size(); ++i)
    {
        const auto value = static_cast<float>(level.texels[i]);
        std::memcpy(bytes.data() + i * sizeof(float), &value, sizeof(float));
    }
    return std::make_shared<const Texture2D>("floats", level.width, level.height,
                                             GraphicsFormat::R32_SFloat, std::move(bytes), sampler,
                                             mipChain);
}

SamplerState Sampler(FilterMode filter)
{
    return {filter, TextureWrapMode::Clamp, TextureWrapMode::Clamp, TextureWrapMode::Clamp};
}

std::shared_ptr<const Material> MipMaterial(const std::string& declarations,
                                            const std::string& result)
{
    static const auto compiler = std::make_shared<ShaderCompiler>();
    return std::make_shared<const Material>(Shader::FromText(
        "Shader \"Test/Mips\" { SubShader { Pass { Cull Off ZTest Always ZWrite Off\n"
        "HLSLPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n" +
            declarations + R"(
        SamplerState sampler_Tex;
        float4 vert(uint id : SV_VertexID) : SV_POSITION
        {
            return float4(id == 1 ? 3 : -1, id == 2 ? 3 : -1, 0.5, 1);
        }
        float4 frag(float4 p : SV_POSITION) : SV_Target { return )" +
            result + "; }\nENDHLSL } } }",
        "mips.shader", compiler));
}

class MipMapGpu : public GpuTest
{
protected:
    /// Draws over a float target of this size.
    Image Draw(int width, int height, const std::shared_ptr<const Material>& material,
               const std::shared_ptr<const Texture>& texture)
    {
        const RTHandle target(MakeTarget(width, height, GraphicsFormat::R32G32B32A32_SFloat));
        cmd.SetGlobalTexture("_Tex", texture);
        cmd.SetRenderTarget(target);
        cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
        const Image image = Execute(target);
        ExpectNoValidationMessages();
        return image;
    }
    Image Execute(const RTHandle& output)
    {
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        cmd.Clear();
        const auto texture = output.rt();
        frame = CompileFrame(context.TakeCommands(), SharedDevice().textureStates(),
                             std::span(&texture, 1));
        SharedDevice().Execute(frame);
        return ReadRows(*texture);
    }
    static Level Noise(int width, int height)
    {
        Level level{width, height, {}};
        std::mt19937 random(7);
        for (int i = 0; i < width * height; ++i)
        {
            level.texels.push_back(static_cast<double>(random() % 1024) / 1024.0);
        }
        return level;
    }
    static Level Checkers(int size)
    {
        Level level{size, size, {}};
        for (int i = 0; i < size * size; ++i)
        {
            level.texels.push_back((i + i / size) % 2);
        }
        return level;
    }

    CommandBuffer cmd;
    RenderReport report;
    CompiledFrame frame;
};

} // namespace

TEST_F(MipMapGpu, MakesEachLevelByALinearFilterOfTheOneBefore)
{
    for (const auto& [width, height] : {std::pair(8, 4), std::pair(5, 3), std::pair(1, 7)})
    {
        Level level = Noise(width, height);
        const auto texture = FloatTexture(level);
        const int count = texture->mipmapCount();
        EXPECT_EQ(count, 1 + static_cast<int>(std::log2(std::max(width, height))));
        const bool isEven = width == 8;
        for (int mip = 0; mip < count; ++mip)
        {
            const Image image =
                Draw(level.width, level.height,
                     MipMaterial("Texture2D _Tex;",
                                 "_Tex.Load(int3(p.xy, " + std::to_string(mip) + ")).rrrr"),
                     texture);
            for (int y = 0; y < level.height; ++y)
            {
                for (int x = 0; x < level.width; ++x)
                {
                    // Vulkan lets filters place texels to 1/256.
                    EXPECT_NEAR(TexelFloat(image, x, y)[0], level.At(x, y),
                                isEven ? 1e-6 : mip * 2.0 / 256.0)
                        << width << "x" << height << " level " << mip;
                }
            }
            level = NextLevel(level);
        }
    }
}

TEST_F(MipMapGpu, AveragesLightNotItsEncoding)
{
    const std::vector<std::byte> bytes = {std::byte{0},   std::byte{0},   std::byte{0},
                                          std::byte{255}, std::byte{255}, std::byte{255},
                                          std::byte{255}, std::byte{255}};
    const auto texture = std::make_shared<const Texture2D>(
        "sRGB", 2, 1, GraphicsFormat::R8G8B8A8_SRGB, bytes, SamplerState(), true);
    const Image image =
        Draw(1, 1, MipMaterial("Texture2D _Tex;", "_Tex.Load(int3(0, 0, 1))"), texture);
    const auto encoded = [](double linear)
    {
        return 255.0 * (1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
    };
    // Devices may round what they encode by 0.6 of a step; the mean of the encodings is 127.5.
    EXPECT_NEAR(std::round(encoded(TexelFloat(image, 0, 0)[0])), encoded(0.5), 0.6);
}

TEST_F(MipMapGpu, GoesThroughSlicesOfVolumesAndKeepsThemApartElsewhere)
{
    std::vector<std::byte> ramp(8);
    for (std::size_t i = 0; i < 8; ++i)
    {
        ramp[i] = static_cast<std::byte>(i * 16);
    }
    const auto volume = std::make_shared<const Texture3D>(
        "volume", 2, 2, 2, GraphicsFormat::R8_UNorm, ramp, SamplerState(), true);
    EXPECT_EQ(volume->mipmapCount(), 2);
    Image image =
        Draw(1, 1, MipMaterial("Texture3D _Tex;", "_Tex.Load(int4(0, 0, 0, 1)).rrrr"), volume);
    EXPECT_NEAR(TexelFloat(image, 0, 0)[0], 56.0 / 255.0, 0.51 / 255.0);

    const std::vector<std::byte> dark(4, std::byte{40});
    const std::vector<std::byte> light(4, std::byte{200});
    const auto array = std::make_shared<const Texture2DArray>(
        "array", 2, 2, GraphicsFormat::R8_UNorm, std::vector<std::vector<std::byte>>{dark, light},
        SamplerState(), true);
    image = Draw(2, 1, MipMaterial("Texture2DArray _Tex;", "_Tex.Load(int4(0, 0, p.x, 1)).rrrr"),
                 array);
    EXPECT_NEAR(TexelFloat(image, 0, 0)[0], 40.0 / 255.0, 1e-6);
    EXPECT_NEAR(TexelFloat(image, 1, 0)[0], 200.0 / 255.0, 1e-6);

    const auto cube = std::make_shared<const Cubemap>(
        "cube", 2, GraphicsFormat::R8_UNorm, CubemapFaces{dark, light, dark, dark, dark, dark},
        SamplerState(), true);
    image = Draw(2, 1,
                 MipMaterial("TextureCube _Tex;",
                             "_Tex.SampleLevel(sampler_Tex, float3(p.x < 1 ? 1 : -1, 0, 0), 1).r"),
                 cube);
    EXPECT_NEAR(TexelFloat(image, 0, 0)[0], 40.0 / 255.0, 1e-6);
    EXPECT_NEAR(TexelFloat(image, 1, 0)[0], 200.0 / 255.0, 1e-6);
}

TEST_F(MipMapGpu, IsSampledByLevelAndBiasAsTheFilterSays)
{
    const Level checkers = Checkers(8); // every level but the first is 0.5
    const auto at = [&](FilterMode filter, const std::string& sample, float bias = 0.0f)
    {
        SamplerState sampler = Sampler(filter);
        sampler.mipMapBias = bias;
        const Image image =
            Draw(8, 8, MipMaterial("Texture2D _Tex;", sample), FloatTexture(checkers, sampler));
        return std::pair(TexelFloat(image, 2, 2)[0], TexelFloat(image, 3, 2)[0]);
    };
    using Pair = std::pair<float, float>;
    const std::string uv = "_Tex.Sample(sampler_Tex, p.xy / 8).rrrr";
    EXPECT_EQ(at(FilterMode::Point, uv), Pair(0, 1));
    EXPECT_EQ(at(FilterMode::Point, uv, 1.0f), Pair(0.5f, 0.5f)) << "the sampler's bias";
    EXPECT_EQ(at(FilterMode::Bilinear, "_Tex.SampleBias(sampler_Tex, p.xy / 8, 1).rrrr"),
              Pair(0.5f, 0.5f));
    EXPECT_EQ(at(FilterMode::Bilinear, "_Tex.SampleLevel(sampler_Tex, p.xy / 8, 0.4).rrrr"),
              Pair(0, 1))
        << "the nearest level";
    const auto [dark, light] =
        at(FilterMode::Trilinear, "_Tex.SampleLevel(sampler_Tex, p.xy / 8, 0.5).rrrr");
    EXPECT_NEAR(dark, 0.25, 1.0 / 256.0) << "between two levels";
    EXPECT_NEAR(light, 0.75, 1.0 / 256.0);
    EXPECT_EQ(at(FilterMode::Point, "_Tex.SampleLevel(sampler_Tex, p.xy / 8, 99).rrrr"),
              Pair(0.5f, 0.5f));
}

TEST_F(MipMapGpu, TakesSamplesAlongWhatIsSeenFlatWhereTheDeviceCan)
{
    Level stripes{64, 64, {}};
    for (int i = 0; i < 64 * 64; ++i)
    {
        stripes.texels.push_back(i / 64 % 2);
    }
    const std::string squeezed = "_Tex.Sample(sampler_Tex, p.xy * float2(8, 1) / 64).rrrr";
    const auto at = [&](int anisoLevel)
    {
        SamplerState sampler = Sampler(FilterMode::Bilinear);
        sampler.anisoLevel = anisoLevel;
        const Image image =
            Draw(8, 8, MipMaterial("Texture2D _Tex;", squeezed), FloatTexture(stripes, sampler));
        return std::pair(TexelFloat(image, 4, 2)[0], TexelFloat(image, 4, 3)[0]);
    };
    EXPECT_EQ(at(1), std::pair(0.5f, 0.5f)) << "the level of the greater step";
    const auto [dark, light] = at(16);
    const bool isTaken = light - dark > 0.1f; // by which weights is the device's affair
    EXPECT_TRUE(isTaken || std::pair(dark, light) == std::pair(0.5f, 0.5f))
        << dark << ", " << light;
    RecordProperty("anisotropic", isTaken ? "yes" : "no");
}

TEST_F(MipMapGpu, IsMadeOfWhatIsDrawn)
{
    RenderTextureDescriptor descriptor(8, 8, GraphicsFormat::R32_SFloat);
    descriptor.useMipMap = true;
    for (const bool automatic : {true, false})
    {
        descriptor.autoGenerateMips = automatic;
        const RTHandle drawn(std::make_shared<const RenderTexture>("drawn", descriptor));
        cmd.SetRenderTarget(drawn);
        cmd.DrawProcedural(glm::mat4(1.0f), MipMaterial("", "floor(p.x) + 10 * floor(p.y)"), 0, 3);
        if (!automatic)
        {
            cmd.GenerateMips(drawn);
        }
        const Image image =
            Draw(2, 2, MipMaterial("Texture2D _Tex;", "_Tex.Load(int3(p.xy, 2)).rrrr"), drawn.rt());
        EXPECT_EQ(frame.passes.at(0).colors.at(0).generatesMips, true);
        for (int y = 0; y < 2; ++y)
        {
            for (int x = 0; x < 2; ++x)
            {
                EXPECT_FLOAT_EQ(TexelFloat(image, x, y)[0],
                                1.5f + 4.0f * static_cast<float>(x) +
                                    10.0f * (1.5f + 4.0f * static_cast<float>(y)))
                    << "automatic " << automatic;
            }
        }
    }
    EXPECT_TRUE(report.notes.empty());
}

TEST_F(MipMapGpu, IsMadeOfResolvedSamples)
{
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R32_SFloat);
    descriptor.useMipMap = true;
    descriptor.msaaSamples = 4;
    const RTHandle drawn(std::make_shared<const RenderTexture>("samples", descriptor));
    cmd.SetRenderTarget(drawn);
    cmd.DrawProcedural(glm::mat4(1.0f), MipMaterial("", "floor(p.x)"), 0, 3);
    const Image image =
        Draw(1, 1, MipMaterial("Texture2D _Tex;", "_Tex.Load(int3(0, 0, 2)).rrrr"), drawn.rt());
    EXPECT_FLOAT_EQ(TexelFloat(image, 0, 0)[0], 1.5f);
}

} // namespace limn::test
