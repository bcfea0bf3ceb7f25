#include <cmath>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/ScriptableRenderContext.h>

#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "core/ThrownMessage.h"
#include "core/scene/TestScene.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

using TexturePtr = std::shared_ptr<const Texture>;
using Float4 = std::array<float, 4>;
constexpr GraphicsFormat k_R8 = GraphicsFormat::R8_UNorm;

/// Draws a shader of `_Map` over one texel, from the material to the picture, and returns what the
/// fragment function gave.
class MapDraw
{
public:
    /// @param declarations  of _Map and its sampler, in HLSL
    /// @param result        the fragment function's float4; it may use `_At`
    MapDraw(const std::string& declarations, const std::string& result,
            const std::string& properties = "")
        : m_Material(std::make_shared<Material>(
              ShaderWithProgram(properties, declarations + "\nfloat4 _At;", result, "Cull Off"),
              "Paint"))
    {
    }

    void Set(TexturePtr map) { m_Material->SetTexture(ShaderPropertyId("_Map"), std::move(map)); }

    Float4 At(const glm::vec4& coordinate)
    {
        m_Material->SetVector(ShaderPropertyId("_At"), coordinate);
        const RTHandle target(MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat));
        CommandBuffer cmd;
        cmd.SetRenderTarget(target);
        cmd.ClearRenderTarget(ClearFlag::Color, {-1, -1, -1, -1});
        cmd.DrawMesh(MakeQuad(), glm::mat4(1.0f), m_Material);
        RenderReport report;
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        const std::vector<std::shared_ptr<const RenderTexture>> outputs = {target.rt()};
        SharedDevice().Execute(CompileFrame(context.TakeCommands(), {}, outputs));
        return TexelFloat(ReadRows(*target.rt()), 0, 0);
    }

    /// The first channel in 255ths, as it stands in an R8_UNorm texture.
    int ByteAt(const glm::vec4& coordinate)
    {
        return static_cast<int>(std::lround(255.0f * At(coordinate)[0]));
    }

private:
    std::shared_ptr<Material> m_Material;
};

SamplerState PointClamp()
{
    using enum TextureWrapMode;
    return {FilterMode::Point, Clamp, Clamp, Clamp, false};
}

SamplerState LinearClamp()
{
    using enum TextureWrapMode;
    return {FilterMode::Bilinear, Clamp, Clamp, Clamp, false};
}

/// A face of a cube as somebody in its centre sees it, axes left-handed: looking along `forward`.
struct Face
{
    const char* name;
    glm::vec3 forward;
    glm::vec3 up;
    glm::vec3 right;
};
constexpr Face k_Faces[] = {
    {"+X", {1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {"-X", {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {"+Y", {0, 1, 0}, {0, 0, -1}, {1, 0, 0}}, {"-Y", {0, -1, 0}, {0, 0, 1}, {1, 0, 0}},
    {"+Z", {0, 0, 1}, {0, 1, 0}, {1, 0, 0}},  {"-Z", {0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
};

/// 2x2 texels a face: 40 * face + 10 * (0 top left, 1 top right, 2 bottom left, 3 bottom right),
/// and `plus`.
CubemapFaces NumberedFaces(int plus = 0)
{
    CubemapFaces faces;
    for (int i = 0; i < 6; ++i)
    {
        const int first = 40 * i + plus;
        faces[static_cast<std::size_t>(i)] = Bytes({first, first + 10, first + 20, first + 30});
    }
    return faces;
}

/// Looks at the middle of each quarter of each face. @param w  goes along as the fourth coordinate
void ExpectNumberedFaces(MapDraw& draw, float w, int plus)
{
    int expected = plus;
    for (const Face& face : k_Faces)
    {
        for (const glm::vec2 quarter :
             {glm::vec2(-0.5f, 0.5f), {0.5f, 0.5f}, {-0.5f, -0.5f}, {0.5f, -0.5f}})
        {
            const glm::vec3 direction = face.forward + quarter.x * face.right + quarter.y * face.up;
            EXPECT_EQ(expected, draw.ByteAt(glm::vec4(direction, w)))
                << face.name << " " << quarter.x << " " << quarter.y;
            expected += 10;
        }
    }
}

} // namespace

using TextureDimensions = GpuTest;

TEST_F(TextureDimensions, ShowACubesFaceWhereOneLooks)
{
    MapDraw draw("TextureCube _Map; SamplerState sampler_Map;",
                 "_Map.SampleLevel(sampler_Map, _At.xyz, 0)");
    draw.Set(std::make_shared<Cubemap>("sky", 2, k_R8, NumberedFaces(), PointClamp()));
    ExpectNumberedFaces(draw, 0.0f, 0);
}

TEST_F(TextureDimensions, ShowACubesFacesThroughTheOldSampler)
{
    MapDraw draw("samplerCUBE _Map;", "texCUBElod(_Map, float4(_At.xyz, 0))");
    draw.Set(std::make_shared<Cubemap>("sky", 2, k_R8, NumberedFaces(), PointClamp()));
    ExpectNumberedFaces(draw, 0.0f, 0);
}

TEST_F(TextureDimensions, FilterACubeAcrossItsEdges)
{
    MapDraw draw("TextureCube _Map; SamplerState sampler_Map;",
                 "_Map.SampleLevel(sampler_Map, _At.xyz, 0)");
    draw.Set(std::make_shared<Cubemap>(
        "sky", 1, k_R8,
        CubemapFaces{Bytes({40}), Bytes({0}), Bytes({0}), Bytes({0}), Bytes({200}), Bytes({0})},
        LinearClamp()));
    EXPECT_EQ(40, draw.ByteAt({1, 0, 0, 0}));
    EXPECT_EQ(200, draw.ByteAt({0, 0, 1, 0}));
    EXPECT_NEAR(120, draw.ByteAt({1, 0, 1, 0}), 1) << "half of +X and half of +Z";
}

TEST_F(TextureDimensions, ChooseACubeOfAnArrayByNumber)
{
    MapDraw draw("TextureCubeArray _Map; SamplerState sampler_Map;",
                 "_Map.SampleLevel(sampler_Map, _At, 0)");
    draw.Set(std::make_shared<CubemapArray>(
        "skies", 2, k_R8, std::vector{NumberedFaces(1), NumberedFaces(2), NumberedFaces(3)},
        PointClamp()));
    ExpectNumberedFaces(draw, 0.0f, 1);
    ExpectNumberedFaces(draw, 1.0f, 2);
    ExpectNumberedFaces(draw, 2.0f, 3);
}

TEST_F(TextureDimensions, ChooseAnElementOfAnArrayByNumber)
{
    MapDraw draw("Texture2DArray _Map; SamplerState sampler_Map;",
                 "_Map.SampleLevel(sampler_Map, _At.xyz, 0)");
    // Rows of three bytes: nothing is a multiple of four.
    draw.Set(std::make_shared<Texture2DArray>("sheets", 3, 2, k_R8,
                                              std::vector{Bytes({1, 2, 3, 4, 5, 6}),
                                                          Bytes({11, 12, 13, 14, 15, 16}),
                                                          Bytes({21, 22, 23, 24, 25, 26})},
                                              PointClamp()));
    for (int element = 0; element < 3; ++element)
    {
        const auto z = static_cast<float>(element);
        EXPECT_EQ(10 * element + 1, draw.ByteAt({0.1f, 0.25f, z, 0})) << "row 0 is at v = 0";
        EXPECT_EQ(10 * element + 3, draw.ByteAt({0.9f, 0.25f, z, 0}));
        EXPECT_EQ(10 * element + 5, draw.ByteAt({0.5f, 0.75f, z, 0}));
    }
    EXPECT_EQ(15, draw.ByteAt({0.5f, 0.75f, 1.4f, 0})) << "the nearest number counts";
    EXPECT_EQ(25, draw.ByteAt({0.5f, 0.75f, 9.0f, 0})) << "behind the last is the last";
    EXPECT_EQ(5, draw.ByteAt({0.5f, 0.75f, -3.0f, 0}));
}

namespace
{

/// 2x2x2 texels: 20 * x + 40 * y + 80 * z.
std::vector<std::byte> NumberedVolume()
{
    return Bytes({0, 20, 40, 60, 80, 100, 120, 140});
}

} // namespace

TEST_F(TextureDimensions, PutTheTexelsOfAVolumeInItsCorners)
{
    MapDraw draw("Texture3D _Map; SamplerState sampler_Map;",
                 "_Map.SampleLevel(sampler_Map, _At.xyz, 0)");
    draw.Set(std::make_shared<Texture3D>("fog", 2, 2, 2, k_R8, NumberedVolume(), LinearClamp()));
    for (int i = 0; i < 8; ++i)
    {
        const glm::vec3 corner(i & 1, (i >> 1) & 1, i >> 2);
        EXPECT_EQ(20 * i, draw.ByteAt(glm::vec4(corner, 0))) << i;
    }
}

TEST_F(TextureDimensions, AreReadByEveryOldFunction)
{
    const auto sky = std::make_shared<Cubemap>("sky", 2, k_R8, NumberedFaces(), PointClamp());
    for (const char* read :
         {"texCUBE(_Map, _At.xyz)", "texCUBE(_Map, _At.xyz, 0, 0)",
          "texCUBEgrad(_Map, _At.xyz, 0, 0)", "texCUBElod(_Map, float4(_At.xyz, 0))",
          "texCUBEbias(_Map, float4(_At.xyz, 0))"})
    {
        SCOPED_TRACE(read);
        MapDraw draw("samplerCUBE _Map;", read);
        draw.Set(sky);
        for (int i = 0; i < 6; ++i)
        {
            const Face& face = k_Faces[i];
            const glm::vec3 topRight = face.forward + 0.5f * face.right + 0.5f * face.up;
            EXPECT_EQ(40 * i + 10, draw.ByteAt(glm::vec4(topRight, 0))) << face.name;
        }
    }
    const auto fog =
        std::make_shared<Texture3D>("fog", 2, 2, 2, k_R8, NumberedVolume(), PointClamp());
    for (const char* read :
         {"tex3D(_Map, _At.xyz)", "tex3D(_Map, _At.xyz, 0, 0)", "tex3Dgrad(_Map, _At.xyz, 0, 0)",
          "tex3Dlod(_Map, float4(_At.xyz, 0))", "tex3Dbias(_Map, float4(_At.xyz, 0))",
          "tex3Dproj(_Map, float4(_At.xyz * 4, 4))"})
    {
        SCOPED_TRACE(read);
        MapDraw draw("sampler3D _Map;", read);
        draw.Set(fog);
        EXPECT_EQ(20, draw.ByteAt({0.75f, 0.25f, 0.25f, 0}));
        EXPECT_EQ(40, draw.ByteAt({0.25f, 0.75f, 0.25f, 0}));
        EXPECT_EQ(80, draw.ByteAt({0.25f, 0.25f, 0.75f, 0}));
    }
}

TEST_F(TextureDimensions, InterpolateInAVolumeAlongEachAxis)
{
    MapDraw draw("sampler3D _Map;", "tex3Dlod(_Map, float4(_At.xyz, 0))");
    draw.Set(std::make_shared<Texture3D>("fog", 2, 2, 2, k_R8, NumberedVolume(), LinearClamp()));
    // The middles of the texels are at 1/4 and 3/4: in between, the value is linear in each axis.
    const auto expect = [&](float x, float y, float z)
    {
        const float expected = 40.0f * (x - 0.25f) + 80.0f * (y - 0.25f) + 160.0f * (z - 0.25f);
        EXPECT_NEAR(expected, 255.0f * draw.At({x, y, z, 0})[0], 0.75f)
            << x << " " << y << " " << z;
    };
    expect(0.5f, 0.5f, 0.5f); // 70, the average of all
    expect(0.5f, 0.25f, 0.25f);
    expect(0.25f, 0.5f, 0.25f);
    expect(0.25f, 0.25f, 0.5f);
    expect(0.375f, 0.625f, 0.6875f);
}

TEST_F(TextureDimensions, WrapAVolumeAlongEachAxisByItsOwnMode)
{
    using enum TextureWrapMode;
    struct Case
    {
        TextureWrapMode wrap;
        int at025; ///< which of the two texels is a quarter before the border
        int at075;
        int at175;
    };
    MapDraw draw("Texture3D _Map; SamplerState sampler_Map;",
                 "_Map.SampleLevel(sampler_Map, _At.xyz, 0)");
    for (const Case& expected : {Case{Repeat, 1, 0, 0}, Case{Clamp, 0, 0, 0}, Case{Mirror, 0, 1, 0},
                                 Case{MirrorOnce, 0, 1, 1}})
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            SCOPED_TRACE("mode " + std::to_string(static_cast<int>(expected.wrap)) + ", axis " +
                         std::to_string(axis));
            SamplerState sampler = PointClamp();
            (axis == 0   ? sampler.wrapModeU
             : axis == 1 ? sampler.wrapModeV
                         : sampler.wrapModeW) = expected.wrap;
            draw.Set(std::make_shared<Texture3D>("fog", 2, 2, 2, k_R8, NumberedVolume(), sampler));
            const int weight = 20 << axis;
            glm::vec4 at(0.25f);
            at[axis] = -0.25f;
            EXPECT_EQ(weight * expected.at025, draw.ByteAt(at));
            at[axis] = -0.75f;
            EXPECT_EQ(weight * expected.at075, draw.ByteAt(at));
            at[axis] = -1.75f;
            EXPECT_EQ(weight * expected.at175, draw.ByteAt(at));
        }
    }
}

TEST_F(TextureDimensions, HaveTheDefaultThatThePropertyNames)
{
    struct Case
    {
        const char* property;
        const char* type;
        const char* coordinate;
    };
    struct Default
    {
        const char* name;
        Float4 rgba;
        float allowed = 1e-5f;
    };
    constexpr float half = 128.0f / 255.0f;
    const auto linear = [](float encoded)
    {
        return std::pow((encoded + 0.055f) / 1.055f, 2.4f);
    };
    const float gray = linear(half); // it is sRGB, which devices decode within half a step
    const float halfStep = linear(half + 0.5f / 255.0f) - gray;
    for (const Case& c :
         {Case{"2D", "Texture2D", "_At.xy"}, Case{"3D", "Texture3D", "_At.xyz"},
          Case{"Cube", "TextureCube", "_At.xyz"}, Case{"2DArray", "Texture2DArray", "_At.xyz"},
          Case{"CubeArray", "TextureCubeArray", "_At"}})
    {
        for (const Default& expected :
             {Default{"white", {1, 1, 1, 1}}, Default{"black", {0, 0, 0, 1}},
              Default{"bump", {half, half, 1, 1}}, Default{"", {gray, gray, gray, half}, halfStep},
              Default{"linearGray", {half, half, half, half}}})
        {
            MapDraw draw(std::string(c.type) + " _Map; SamplerState sampler_Map;",
                         std::string("_Map.SampleLevel(sampler_Map, ") + c.coordinate + ", 0)",
                         std::string("_Map (\"Map\", ") + c.property + ") = \"" + expected.name +
                             "\" {}");
            const Float4 texel = draw.At({0.3f, -0.9f, 0.2f, 0});
            for (std::size_t i = 0; i < 4; ++i)
            {
                EXPECT_NEAR(expected.rgba[i], texel[i], expected.allowed)
                    << c.property << " " << expected.name;
            }
        }
    }
}

TEST_F(TextureDimensions, NameATextureOfMoreSlicesThanTheDeviceMakes)
{
    constexpr int tooMany = 1 << 17; // no device comes near that
    MapDraw array("Texture2DArray _Map;", "_Map.Load(int4(0, 0, 0, 0))");
    array.Set(std::make_shared<Texture2DArray>(
        "stack", 1, 1, k_R8, std::vector<std::vector<std::byte>>(tooMany, Bytes({0}))));
    EXPECT_THAT(
        ThrownMessage<DrawError>([&] { array.At({}); }),
        testing::MatchesRegex(".*'stack'.* 1x1x131072 2DArray.* at most [0-9]+x[0-9]+x[0-9]+ .*"));
    MapDraw volume("Texture3D _Map;", "_Map.Load(int4(0, 0, 0, 0))");
    volume.Set(
        std::make_shared<Texture3D>("tower", 1, 1, tooMany, k_R8, std::vector<std::byte>(tooMany)));
    EXPECT_THAT(
        ThrownMessage<DrawError>([&] { volume.At({}); }),
        testing::MatchesRegex(".*'tower'.* 1x1x131072 3D.* at most [0-9]+x[0-9]+x[0-9]+ .*"));
}

} // namespace limn::test
