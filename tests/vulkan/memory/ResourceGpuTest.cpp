#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

namespace limn::test
{

namespace
{

/// Draws over a 1x1 float target and returns what is there.
std::array<float, 4> DrawTexel(CompiledFrame frame, const DrawCommand& draw)
{
    const TargetPtr target = MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat);
    frame.passes = {ClearPass(target)};
    frame.finalBarriers = {{target, TextureUsage::ColorAttachment, TextureUsage::CopySource}};
    frame.passes[0].commands.emplace_back(draw);
    SharedDevice().Execute(frame);
    return TexelFloat(ReadRows(*target), 0, 0);
}

/// Returns an attribute of a mesh as the fragment function gets it.
std::array<float, 4> ReadAttribute(const std::string& type, const std::string& semantic,
                                   const std::string& asFloat4, const MeshPtr& mesh)
{
    const PassPtr pass = CompilePass(R"(
        struct Input { float3 position : POSITION; )" +
                                     type + " value : " + semantic + R"(; };
        struct Between { float4 position : SV_POSITION; float4 value : TEXCOORD0; };
        Between vert(Input input)
        {
            )" + type + R"( v = input.value;
            Between output;
            output.position = float4(input.position, 1);
            output.value = )" + asFloat4 +
                                     R"(;
            return output;
        }
        float4 frag(Between input) : SV_Target { return input.value; })");
    CompiledFrame frame;
    const DrawCommand draw = MakeDraw(frame, pass, mesh);
    return DrawTexel(std::move(frame), draw);
}

/// A full quad whose four vertices all have the same attributes.
MeshPtr FullMesh()
{
    MeshData data = MakeQuad()->data();
    data.normals.assign(4, {0.0f, 1.0f, 0.0f});
    data.tangents.assign(4, {0.0f, 0.0f, 1.0f, -1.0f});
    data.colors.assign(4, {0.25f, 0.5f, 0.75f, 1.0f});
    data.uv.assign(4, {0.125f, 0.375f});
    data.uv2.assign(4, {1, 2, 3, 4});
    data.uv7.assign(4, {5, 6, 7, 8});
    return std::make_shared<Mesh>("full", std::move(data));
}

using Float4 = std::array<float, 4>;

/// 2x2: red, green / blue, white.
std::shared_ptr<const Texture2D> FourColors(SamplerState sampler = {})
{
    return std::make_shared<Texture2D>(
        "four colours", 2, 2, GraphicsFormat::R8G8B8A8_UNorm,
        Bytes({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}), sampler);
}

/// Samples at `_Uv` through a texture and a sampler of its own.
PassPtr SamplePass()
{
    static const PassPtr pass = CompilePass(R"(
        cbuffer Material { float4 _Uv; };
        Texture2D _MainTex;
        SamplerState sampler_MainTex;
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag() : SV_Target { return _MainTex.SampleLevel(sampler_MainTex, _Uv.xy, 0); })");
    return pass;
}

Float4 SampleAt(float u, float v, const std::shared_ptr<const Texture>& texture,
                SamplerState sampler)
{
    CompiledFrame frame;
    const PropertyLayout& layout = SamplePass()->layout;
    DrawBindings bindings;
    bindings.uniforms = {AddUniform(frame, layout.buffers.at(0).binding, Float4{u, v, 0, 0})};
    bindings.textures = {{layout.textures.at(0).binding, texture, std::nullopt}};
    bindings.samplers = {{layout.samplers.at(0).binding, sampler}};
    const DrawCommand draw = MakeDraw(frame, SamplePass(), MakeQuad(), PlainState(), bindings);
    return DrawTexel(std::move(frame), draw);
}

SamplerState Point(TextureWrapMode wrap)
{
    return {FilterMode::Point, wrap, wrap, wrap, false};
}

constexpr Float4 k_RedTexel = {1, 0, 0, 1};
constexpr Float4 k_GreenTexel = {0, 1, 0, 1};
constexpr Float4 k_BlueTexel = {0, 0, 1, 1};
constexpr Float4 k_WhiteTexel = {1, 1, 1, 1};

} // namespace

using Resources = GpuTest;

TEST_F(Resources, GiveUniformsToEachDraw)
{
    const TargetPtr target = MakeTarget(2, 1, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(-1, -1, 0, 1), {1.5f, 2.0f, 3.0f, 4.0f}));
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(0, -1, 1, 1), {5.0f, 6.0f, 7.0f, 8.0f}));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    EXPECT_EQ((Float4{1.5f, 2.0f, 3.0f, 4.0f}), TexelFloat(image, 0, 0));
    EXPECT_EQ((Float4{5.0f, 6.0f, 7.0f, 8.0f}), TexelFloat(image, 1, 0));
}

TEST_F(Resources, GiveMeshAttributesToTheVertexFunction)
{
    EXPECT_EQ((Float4{0, 1, 0, 9}), ReadAttribute("float3", "NORMAL", "float4(v, 9)", FullMesh()));
    EXPECT_EQ((Float4{0, 0, 1, -1}), ReadAttribute("float4", "TANGENT", "v", FullMesh()));
    EXPECT_EQ((Float4{0.25f, 0.5f, 0.75f, 1}), ReadAttribute("float4", "COLOR", "v", FullMesh()));
    EXPECT_EQ((Float4{0.125f, 0.375f, 8, 9}),
              ReadAttribute("float2", "TEXCOORD0", "float4(v, 8, 9)", FullMesh()));
    EXPECT_EQ((Float4{1, 2, 3, 4}), ReadAttribute("float4", "TEXCOORD1", "v", FullMesh()));
    EXPECT_EQ((Float4{5, 6, 0, 0}),
              ReadAttribute("float2", "TEXCOORD6", "float4(v, 0, 0)", FullMesh()));
}

TEST_F(Resources, FillComponentsThatTheMeshLacks)
{
    EXPECT_EQ((Float4{0.125f, 0.375f, 0, 1}),
              ReadAttribute("float4", "TEXCOORD0", "v", FullMesh()));
}

TEST_F(Resources, ReplaceMissingAttributesByConstants)
{
    EXPECT_EQ((Float4{0, 0, 1, 9}), ReadAttribute("float3", "NORMAL", "float4(v, 9)", MakeQuad()));
    EXPECT_EQ((Float4{1, 0, 0, 1}), ReadAttribute("float4", "TANGENT", "v", MakeQuad()));
    EXPECT_EQ((Float4{1, 1, 1, 1}), ReadAttribute("float4", "COLOR", "v", MakeQuad()));
    EXPECT_EQ((Float4{0, 0, 8, 9}),
              ReadAttribute("float2", "TEXCOORD0", "float4(v, 8, 9)", MakeQuad()));
    EXPECT_EQ((Float4{0, 0, 0, 0}), ReadAttribute("float4", "TEXCOORD3", "v", FullMesh()));
}

TEST_F(Resources, PutTheFirstRowAtVZero)
{
    const SamplerState point = Point(TextureWrapMode::Clamp);
    EXPECT_EQ(k_RedTexel, SampleAt(0.25f, 0.25f, FourColors(), point));
    EXPECT_EQ(k_GreenTexel, SampleAt(0.75f, 0.25f, FourColors(), point));
    EXPECT_EQ(k_BlueTexel, SampleAt(0.25f, 0.75f, FourColors(), point));
    EXPECT_EQ(k_WhiteTexel, SampleAt(0.75f, 0.75f, FourColors(), point));
}

TEST_F(Resources, WrapAsTheSamplerSays)
{
    // The first row is red, green. Places left of it, in picture widths from its left border:
    struct Case
    {
        TextureWrapMode wrap;
        Float4 at025;
        Float4 at075;
        Float4 at175;
    };
    const Case cases[] = {{TextureWrapMode::Repeat, k_GreenTexel, k_RedTexel, k_RedTexel},
                          {TextureWrapMode::Clamp, k_RedTexel, k_RedTexel, k_RedTexel},
                          {TextureWrapMode::Mirror, k_RedTexel, k_GreenTexel, k_RedTexel},
                          {TextureWrapMode::MirrorOnce, k_RedTexel, k_GreenTexel, k_GreenTexel}};
    for (const Case& expected : cases)
    {
        SCOPED_TRACE(static_cast<int>(expected.wrap));
        const SamplerState sampler = Point(expected.wrap);
        EXPECT_EQ(expected.at025, SampleAt(-0.25f, 0.25f, FourColors(), sampler));
        EXPECT_EQ(expected.at075, SampleAt(-0.75f, 0.25f, FourColors(), sampler));
        EXPECT_EQ(expected.at175, SampleAt(-1.75f, 0.25f, FourColors(), sampler));
    }
}

TEST_F(Resources, InterpolateBetweenTexels)
{
    SamplerState bilinear;
    bilinear.wrapModeU = TextureWrapMode::Clamp;
    bilinear.wrapModeV = TextureWrapMode::Clamp;
    const Float4 texel = SampleAt(0.5f, 0.25f, FourColors(), bilinear);
    EXPECT_NEAR(0.5f, texel[0], 0.01f);
    EXPECT_NEAR(0.5f, texel[1], 0.01f);
    EXPECT_NEAR(0.0f, texel[2], 0.01f);
}

TEST_F(Resources, DecodeSrgbTexels)
{
    const auto grey = std::make_shared<Texture2D>("grey", 1, 1, GraphicsFormat::R8G8B8A8_SRGB,
                                                  Bytes({188, 255, 0, 128}));
    // sRGB 188/255 is ((0.7373 + 0.055) / 1.055)^2.4 = 0.503 linear.
    const Float4 texel = SampleAt(0.5f, 0.5f, grey, {});
    EXPECT_NEAR(0.503f, texel[0], 0.003f);
    EXPECT_NEAR(1.0f, texel[1], 0.001f);
    EXPECT_NEAR(0.502f, texel[3], 0.003f) << "alpha is stored as it is";
}

TEST_F(Resources, UseTheTexturesOwnSamplerWhereTheSlotHasNone)
{
    const PassPtr pass = CompilePass(R"(
        sampler2D _MainTex;
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag() : SV_Target { return tex2Dlod(_MainTex, float4(-0.25, 0.25, 0, 0)); })");
    ASSERT_TRUE(pass->layout.textures.at(0).combinedSampler);
    const std::uint32_t binding = pass->layout.textures.at(0).binding;
    DrawBindings bindings;
    bindings.textures = {{binding, FourColors(Point(TextureWrapMode::Repeat)), std::nullopt}};
    CompiledFrame frame;
    const DrawCommand own = MakeDraw(frame, pass, MakeQuad(), PlainState(), bindings);
    EXPECT_EQ(k_GreenTexel, DrawTexel(frame, own));
    bindings.textures[0].sampler = Point(TextureWrapMode::Clamp);
    const DrawCommand slots = MakeDraw(frame, pass, MakeQuad(), PlainState(), bindings);
    EXPECT_EQ(k_RedTexel, DrawTexel(frame, slots));
}

TEST_F(Resources, IndexPerDrawDataFromTheFirstInstance)
{
    const PassPtr pass = CompilePass(R"(
        #include "limn/PerDraw.hlsl"
        struct Between { float4 position : SV_POSITION; };
        Between vert(float3 position : POSITION)
        {
            Between output;
            output.position = mul(unity_ObjectToWorld, float4(position, 1));
            return output;
        }
        float4 frag(Between input) : SV_Target
        {
            return float4(asuint(unity_RenderingLayer.x), 0, 0, 1);
        })");
    const auto& buffers = pass->layout.storageBuffers;
    const auto perDraw = std::ranges::find(buffers, "limn_PerDraw", &StorageBufferBinding::name);
    ASSERT_NE(buffers.end(), perDraw);
    const TargetPtr target = MakeTarget(4, 1, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    for (int i = 0; i < 5; ++i)
    {
        PerDrawData data{};
        data.objectToWorld[0] = data.objectToWorld[5] = data.objectToWorld[10] =
            data.objectToWorld[15] = 1.0f;
        data.objectToWorld[12] = 0.5f * static_cast<float>(i - 1); // element 1 stays in place
        data.renderingLayer[0] = 10u + static_cast<std::uint32_t>(i);
        frame.perDraw.push_back(data);
    }
    DrawBindings bindings;
    bindings.perDrawBinding = perDraw->binding;
    DrawCommand draw = MakeDraw(frame, pass, MakeQuad(-1, -1, -0.5f, 1), PlainState(), bindings);
    draw.firstInstance = 2; // the quad over column 0 is moved to columns 1 and 2
    draw.instanceCount = 2;
    frame.passes[0].commands.emplace_back(draw);
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    EXPECT_EQ(0.0f, TexelFloat(image, 0, 0)[0]);
    // The fragment function sees the element of the draw's first instance.
    EXPECT_EQ(12.0f, TexelFloat(image, 1, 0)[0]);
    EXPECT_EQ(12.0f, TexelFloat(image, 2, 0)[0]);
    EXPECT_EQ(0.0f, TexelFloat(image, 3, 0)[0]);
}

} // namespace limn::test
