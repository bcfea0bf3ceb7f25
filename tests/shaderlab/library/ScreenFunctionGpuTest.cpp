#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <vulkan/GpuTestDevice.h>

// What passes over the whole screen work out of textures: NormalReconstruction.hlsl and
// PostProcessing/Common.hlsl.

namespace limn::test
{

namespace
{

using glm::dvec3;
using glm::dvec4;
using TexturePtr = std::shared_ptr<const Texture2D>;

constexpr int k_Size = 8;

/// A camera at (3, -1, 2) that looks along +z, with 8x8 pixels and reversed depth from 1 to 20, and
/// two walls before it: the left half of the pixels sees the first.
struct Walls
{
    dvec3 camera{3, -1, 2};
    dvec3 normals[2] = {glm::normalize(dvec3(0.4, 0.3, -1)), glm::normalize(dvec3(-0.2, 0.5, -1))};
    double distances[2] = {4.0, 9.0}; ///< from the camera, along the normal
    glm::dmat4 viewProjection;

    Walls()
    {
        const double n = 1.0;
        const double f = 20.0;
        glm::dmat4 projection(0.0);
        projection[0][0] = 1.5;
        projection[1][1] = 2.0;
        projection[2][2] = n / (f - n);
        projection[2][3] = -1.0;
        projection[3][2] = f * n / (f - n);
        viewProjection = projection * glm::scale(glm::dmat4(1.0), dvec3(1, 1, -1)) *
                         glm::translate(glm::dmat4(1.0), -camera);
    }

    /// What the middle of a pixel sees; row 0 is the top.
    dvec3 FromCamera(int x, int y, int wall) const
    {
        const dvec3 ray(((x + 0.5) / k_Size * 2.0 - 1.0) / 1.5,
                        (1.0 - (y + 0.5) / k_Size * 2.0) / 2.0, 1.0);
        return ray * (-distances[wall] / glm::dot(ray, normals[wall]));
    }
    double Depth(const dvec3& fromCamera) const
    {
        const dvec4 clip = viewProjection * dvec4(camera + fromCamera, 1.0);
        return clip.z / clip.w;
    }

    void SetUp(FunctionGrid& grid) const
    {
        const glm::mat4 inverse(glm::inverse(viewProjection));
        const float* first = glm::value_ptr(inverse);
        grid.SetGlobal("unity_MatrixInvVP", {first, first + 16});
        grid.SetGlobal("_WorldSpaceCameraPos", {3, -1, 2});
        grid.SetGlobal("_ScreenSize", {k_Size, k_Size, 1.0f / k_Size, 1.0f / k_Size});
        grid.SetTexture("_CameraDepthTexture",
                        MakeTexture(k_Size, k_Size,
                                    [this](int x, int y)
                                    {
                                        const int wall = x < k_Size / 2 ? 0 : 1;
                                        return glm::vec4(dvec4(Depth(FromCamera(x, y, wall))));
                                    }));
    }
};

/// SV_Position of pixels of some columns, all rows that have two neighbours above and below.
std::vector<GridInput> Pixels(const std::vector<int>& columns)
{
    std::vector<GridInput> inputs;
    for (const int x : columns)
    {
        for (int y = 2; y < k_Size - 2; ++y)
        {
            inputs.push_back({{x + 0.5, y + 0.5, 0, 0}});
        }
    }
    return inputs;
}

dvec3 Each(const dvec3& v, const std::function<double(double)>& f)
{
    return {f(v.x), f(v.y), f(v.z)};
}

constexpr int k_Lut = 4;

/// A strip of 4 slices of 4x4 that gives the channels of a colour in the order b, r, g, halved.
TexturePtr LutStrip()
{
    return MakeTexture(k_Lut * k_Lut, k_Lut,
                       [](int x, int y)
                       {
                           const glm::vec3 color(x % k_Lut, y, x / k_Lut);
                           return glm::vec4(color.b, color.r, color.g, 6.0f) / 6.0f;
                       });
}

const std::string k_ColorGrading =
    "#include "
    "\"Packages/com.unity.render-pipelines.universal/Shaders/PostProcessing/Common.hlsl\"\n"
    "TEXTURE2D(_Lut); SAMPLER(sampler_Lut); TEXTURE2D(_UserLut); SAMPLER(sampler_UserLut);\n"
    "TEXTURE2D(_Noise); SAMPLER(sampler_Noise);\n"
    "float3 Grade(float3 color, float exposure, float userContribution)\n"
    "{\n"
    "    float3 params = float3(1.0 / 16, 1.0 / 4, 3);\n"
    "    return ApplyColorGrading(color, exposure, TEXTURE2D_ARGS(_Lut, sampler_Lut), params,\n"
    "        TEXTURE2D_ARGS(_UserLut, sampler_UserLut), params, userContribution);\n"
    "}\n";

} // namespace

using ScreenFunctions = GpuTest;

TEST_F(ScreenFunctions, FindNormalsOutOfDepth)
{
    FunctionGrid grid("#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/"
                      "NormalReconstruction.hlsl\"\n");
    const Walls walls;
    walls.SetUp(grid);
    const Tolerance tolerance{0, 2e-4}; // depth has 24 bits, and steps between pixels are small
    const auto wall = [&walls](auto& a, auto&, auto&)
    {
        return walls.normals[a.x < 4.0 ? 0 : 1];
    };
    grid.Add("ViewSpacePosAtPixelPosition(a.xy)", Pixels({0, 3, 4, 7}),
             [&walls](auto& a, auto&, auto&) {
                 return walls.FromCamera(static_cast<int>(a.x), static_cast<int>(a.y),
                                         a.x < 4.0 ? 0 : 1);
             },
             {2e-5, 1e-5});
    grid.Add("ReconstructNormalTap3(a.xy)", Pixels({1, 2, 4, 6}), wall, tolerance);
    grid.Add("ReconstructNormalTap4(a.xy)", Pixels({1, 2, 5, 6}), wall, tolerance);
    // These two also beside the edge, where the others mix both walls.
    grid.Add("ReconstructNormalTap5(a.xy)", Pixels({2, 3, 4, 5}), wall, tolerance);
    grid.Add("ReconstructNormalTap9(a.xy)", Pixels({2, 3, 4, 5}), wall, tolerance);
    // By the pixel itself: row 5 of the grid; pixels in blocks of two.
    grid.Add("ReconstructNormalDerivative(limn_Position.xy)",
             {{{0, 0, 0, 0}}, {{1, 0, 0, 0}}, {{2, 0, 0, 0}}, {{3, 0, 0, 0}}, {{4, 0, 0, 0}}}, wall,
             tolerance);
    grid.Run();
}

TEST_F(ScreenFunctions, GradeColors)
{
    FunctionGrid grid(k_ColorGrading);
    grid.SetTexture("_Lut", LutStrip());
    grid.SetTexture("_UserLut",
                    MakeTexture(k_Lut * k_Lut, k_Lut,
                                [](int x, int y)
                                {
                                    const float third = 1.0f / 3.0f;
                                    return glm::vec4(1.0f - third * static_cast<float>(y),
                                                     third * static_cast<float>(x % k_Lut), 0.25f,
                                                     1.0f);
                                }));
    const auto colors = CombineVectors({{0, 1, 2}, {1, 1, 0}, {2, 0, 1}, {3, 2, 9}});
    // Thirds are texels of the strip.
    grid.Add("Grade(a.rgb / 6, 2, 0)", colors,
             [](auto& a, auto&, auto&)
             { return dvec3(std::min(a.z, 3.0), std::min(a.x, 3.0), std::min(a.y, 3.0)) / 6.0; },
             {1e-5, 1e-5});
    // The author's strip comes first, over sRGB values: (1 - g, r, 1/4), mixed in by half.
    grid.Add("Grade(GetSRGBToLinear(a.rgb / 3), 1, 0.5).gbr * 2", colors,
             [](auto& a, auto&, auto&)
             {
                 const dvec3 encoded = glm::min(dvec3(a) / 3.0, dvec3(1.0));
                 const dvec3 graded(1.0 - encoded.y, encoded.x, 0.25);
                 const dvec3 linear = Each((encoded + graded) * 0.5, SrgbToLinear);
                 return linear;
             },
             {2e-3, 2e-3}); // a device may round where it reads between texels to 1/256 of the way
    grid.Add("GetLuminance(a.rgb)", colors,
             [](auto& a, auto&, auto&)
             { return 0.2126729 * a.x + 0.7151522 * a.y + 0.0721750 * a.z; });
    grid.Add("GetLinearToSRGB(a.rgb / 3)", colors,
             [](auto& a, auto&, auto&) { return Each(dvec3(a) / 3.0, LinearToSrgb); },
             {1e-5, 1e-6});
    grid.Add("ApplyTonemap(a.rgb / 2)", colors,
             [](auto& a, auto&, auto&) { return glm::min(dvec3(a) / 2.0, dvec3(1.0)); });
    grid.Run();
}

TEST_F(ScreenFunctions, GradeWithAStripOverLogarithms)
{
    FunctionGrid grid("#define _HDR_GRADING 1\n" + k_ColorGrading);
    grid.SetTexture("_Lut", LutStrip());
    // Values that ARRI's LogC curve brings to thirds, less the exposure.
    std::vector<GridInput> inputs;
    const std::vector<dvec3> thirds = {{1, 1, 2}, {2, 3, 1}, {1, 2, 3}};
    for (const dvec3& t : thirds)
    {
        const dvec3 linear =
            Each(t / 3.0, [](double y)
                 { return (std::pow(10.0, (y - 0.386036) / 0.244161) - 0.047996) / 5.555556; });
        inputs.push_back({dvec4(linear / 4.0, 0), dvec4(t, 0)});
    }
    grid.Add("Grade(a.rgb, 4, 0)", inputs,
             [](auto&, auto& b, auto&) { return dvec3(b.z, b.x, b.y) / 6.0; }, {2e-4, 1e-4});
    grid.Run();
}

TEST_F(ScreenFunctions, DarkenCornersAndAddNoise)
{
    FunctionGrid grid(k_ColorGrading);
    // Alpha is 0.25 everywhere: grain of -0.5.
    grid.SetTexture("_Noise",
                    MakeTexture(1, 1, [](int, int) { return glm::vec4(0, 0, 0, 0.25f); }));
    const std::vector<GridInput> places =
        CombineVectors({{0.5, 0.25, 0}, {0.1, 0.9, 0}, {1, 1, 0}}, {{0.8, 0.4, 0.2}, {0.05, 3, 0}});
    grid.Add("ApplyVignette(b.rgb, a.xy, float2(0.5, 0.25), 1.5, 0.75, 2.5, float3(0.1, 0, 0.3))",
             places,
             [](auto& a, auto& b, auto&)
             {
                 const double x = std::abs(a.x - 0.5) * 1.5 * 0.75;
                 const double y = std::abs(a.y - 0.25) * 1.5;
                 const double kept = std::pow(std::max(1.0 - x * x - y * y, 0.0), 2.5);
                 return dvec3(b.x * (0.1 + 0.9 * kept), b.y * kept, b.z * (0.3 + 0.7 * kept));
             },
             {1e-5, 1e-6});
    grid.Add(
        "ApplyGrain(b.rgb, a.xy, TEXTURE2D_ARGS(_Noise, sampler_Noise), 0.6, 0.8, float2(3, 2), "
        "float2(0.1, 0.2))",
        places,
        [](auto&, auto& b, auto&)
        {
            const double luminance = 0.2126729 * b.x + 0.7151522 * b.y + 0.0721750 * b.z;
            const double strength = 0.2 + 0.8 * (1.0 - std::sqrt(luminance));
            return dvec3(b) * (1.0 - 0.5 * 0.6 * strength);
        },
        {1e-5, 1e-6});
    // Even noise of -0.5 is -(1 - sqrt(0.5)) of the triangle.
    grid.Add("ApplyDithering(b.rgb, a.xy, TEXTURE2D_ARGS(_Noise, sampler_Noise), float2(3, 2), "
             "float2(0.1, 0.2))",
             CombineVectors({{0.5, 0.25, 0}}, {{0.8, 0.4, 0.2}, {0.05, 0.01, 1}}),
             [](auto&, auto& b, auto&)
             {
                 return Each(dvec3(b), [](double c)
                             { return SrgbToLinear(LinearToSrgb(c) - 0.292893219 / 255.0); });
             },
             {1e-5, 1e-6});
    grid.Run();
}

TEST_F(ScreenFunctions, InputAttachmentsAreReadAtThePixelsOwnPlace)
{
    FunctionGrid grid(CoreInclude("Common") +
                      "FRAMEBUFFER_INPUT_X_HALF(0);\nFRAMEBUFFER_INPUT_X_FLOAT(3);\n");
    grid.SetTexture("_UnityFBInput0",
                    MakeTexture(k_Size, 1, [](int x, int) { return glm::vec4(x, 1, 0, 1); }));
    grid.SetTexture("_UnityFBInput3",
                    MakeTexture(k_Size, 1, [](int x, int) { return glm::vec4(-2 * x, 0, 3, 1); }));
    std::vector<GridInput> pixels;
    for (int x = 0; x < k_Size; ++x)
    {
        pixels.push_back({{x + 0.5, 0.5, 0, 0}});
    }
    grid.Add("LOAD_FRAMEBUFFER_INPUT_X(0, a.xy)", pixels,
             [](const dvec4& a, auto&, auto&) { return dvec4(a.x - 0.5, 1, 0, 1); });
    grid.Add("LOAD_FRAMEBUFFER_INPUT(3, a)", pixels,
             [](const dvec4& a, auto&, auto&) { return dvec4(1 - 2 * a.x, 0, 3, 1); });
    grid.Run();
}

TEST_F(ScreenFunctions, CoordinatesStayWhereAFilterDoesNotReachAcrossTheEdge)
{
    FunctionGrid grid(CoreInclude("Common") + "float4 _ScreenSize;\n" +
                      CoreInclude("DynamicScalingClamping"));
    grid.SetGlobal("_ScreenSize", {4, 10, 0.25f, 0.1f});
    const std::vector<GridInput> places =
        CombineVectors({{-0.5, 0.2, 0}, {0.5, 0.999, 0}, {1.0, 2.0, 0}});
    const auto within = [](double x, double y, double scale = 1.0)
    {
        return [=](const dvec4& a, auto&, auto&)
        {
            return glm::dvec2(std::min(a.x, x), std::min(a.y, y)) * scale;
        };
    };
    grid.Add("ClampUVForBilinear(a.xy, float2(0.5, 0.125))", places, within(0.75, 0.9375));
    grid.Add("ClampAndScaleUVForBilinear(a.xy)", places, within(0.875, 0.95));
    grid.Add("ClampUV(a.xy, float2(0.5, 0.125), 2)", places, within(0.0, 0.75));
    grid.Add("ClampAndScaleUV(a.xy, float2(0.5, 0.125), 1, float2(0.5, 0.5))", places,
             within(0.5, 0.875, 0.5));
    grid.Add("ClampAndScaleUVForPoint(a.xy)", places, within(1.0, 1.0));
    grid.Run();
}

} // namespace limn::test
