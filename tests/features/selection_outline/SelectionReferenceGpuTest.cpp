#include "features/selection_outline/SelectionReference.h"
#include "features/selection_outline/SelectionRun.h"
#include "precision/DevicePrecision.h"

#include <cmath>
#include <cstdlib>

using namespace limn;
using namespace limn::test;

namespace
{

class SelectionAtSizeGpu : public GpuTest, public testing::WithParamInterface<std::pair<int, int>>
{
};

TEST_P(SelectionAtSizeGpu, AgreesWithTheArticleInDoublePrecision)
{
    const auto [width, height] = GetParam();
    OutlineScene content;
    SelectionRun run(width, height, content.scene, content.camera);
    run.feature().SetStartTime(*content.scene.Find("Cube"), 0.4);
    run.Enable(false);
    run.RenderForReading(1.3);
    const Field base = run.CameraColor();
    run.Enable(true);
    run.RenderForReading(1.3);

    const Field stencil = run.Stencil();
    const Field low = BlurredReference(stencil, 2.0, 3, -1);
    const Field high = BlurredReference(stencil, 2.0, 3, 1);
    EXPECT_EQ(CompareBetween(run.Blur(), low, high).largest, 0.0);
    const Outside all =
        CompareBetween(run.CameraColor(), CompositeReference(base, stencil, low, 3.0),
                       CompositeReference(base, stencil, high, 3.0));
    EXPECT_LE(all.largest, 2.0);
    EXPECT_GE(all.shareWithinTwo, 0.999);
    // Ties of seven blurs leave some room; those of the last one, and of none, leave less.
    const Difference composite =
        Compare(run.CameraColor(), CompositeReference(base, stencil, run.Blur(), 3.0));
    EXPECT_LE(composite.largest, 1.0);
    EXPECT_GT(Compare(run.CameraColor(), base).largest, 100.0) << "something is drawn";
    ExpectNoValidationMessages();
}

// lavapipe filters 8-bit textures with 8-bit numbers: a tap between texels is off by up to 1/255
// and a little more, and seven blurs add that up.
TEST_P(SelectionAtSizeGpu, BlursAsTheArticleDoesForOtherOffsets)
{
    const auto [width, height] = GetParam();
    OutlineScene content;
    SelectionRun run(width, height, content.scene, content.camera);
    for (const float offset : {0.75f, 1.5f, 3.0f})
    {
        run.component().offsetScale.Override(offset);
        run.RenderForReading(0.9);
        const Difference blur =
            Compare(run.Blur(), QuantiseToR8(BlurReference(run.BlurBefore(), offset)));
        EXPECT_LE(blur.largest, 2.0) << offset;
    }
    ExpectNoValidationMessages();
}

INSTANTIATE_TEST_SUITE_P(Sizes, SelectionAtSizeGpu,
                         testing::Values(std::pair(96, 54), std::pair(97, 61), std::pair(33, 47)),
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" +
                                    std::to_string(size.param.second);
                         });

class SelectionShadersGpu : public GpuTest
{
};

/// The article's arithmetic, spelled as shaders of the built-in pipeline are.
/// Its any(inner.rgb) takes a pixel for an object's by any blend with one, though the texture is
/// sampled at texels' centres: interpolated coordinates are rounded, and Vulkan does not limit the
/// bits of a weight upwards, so that a neighbour may count by a trifle. Half a step of 8 bits is
/// none.
constexpr const char* k_OldStencil = R"(Shader "Old/Stencil" { SubShader { Pass {
    CGPROGRAM
    #pragma vertex vert
    #pragma fragment frag
    #include "UnityCG.cginc"
    float _StartTime;
    float4 vert(float4 vertex : POSITION) : SV_POSITION { return UnityObjectToClipPos(vertex); }
    fixed4 frag() : SV_Target
    {
        float angle = _Time.z - _StartTime;
        return float4(1 + sin(angle), 1 + cos(angle), 1 - sin(angle), 1 - cos(angle));
    }
    ENDCG } } })";
constexpr const char* k_OldComposite = R"(Shader "Old/Composite" { SubShader { Pass {
    ZTest Always Cull Off ZWrite Off
    CGPROGRAM
    #pragma vertex vert_img
    #pragma fragment frag
    #include "UnityCG.cginc"
    sampler2D _MainTex, _StencilTex, _BlurTex;
    float _OutlineStrength;
    fixed4 frag(v2f_img i) : COLOR
    {
        fixed4 picture = tex2D(_MainTex, i.uv);
        fixed4 inner = tex2D(_StencilTex, i.uv);
        fixed4 outer = tex2D(_BlurTex, i.uv);
        fixed part = any(inner.rgb > 0.5 / 255) ? 0 : saturate(outer.a - inner.a);
        return fixed4(lerp(picture.rgb, outer.rgb * _OutlineStrength, part), picture.a);
    }
    ENDCG } } })";

int LargestDifference(const Image& a, const Image& b)
{
    int largest = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
    {
        largest = std::max(largest, std::abs(std::to_integer<int>(a.texels[i]) -
                                             std::to_integer<int>(b.texels.at(i))));
    }
    return largest;
}

/// Compares a few moments with those of limn's own shaders.
/// @return by how much the output may differ, and did not
void ExpectSamePictures(const SelectionOutlineSettings& settings)
{
    OutlineScene content;
    SelectionRun ours(97, 61, content.scene, content.camera);
    SelectionRun theirs(97, 61, content.scene, content.camera, settings);
    for (SelectionRun* run : {&ours, &theirs})
    {
        run->feature().SetStartTime(*content.scene.Find("Cube"), 0.4);
    }
    for (const double time : {0.3, 1.1, 2.7})
    {
        ours.RenderForReading(time);
        theirs.RenderForReading(time);
        EXPECT_EQ(ours.Stencil().values, theirs.Stencil().values) << time;
        EXPECT_EQ(ours.Blur().values, theirs.Blur().values) << time;
        // Blending rounds the picture's half floats where a shader's lerp does not.
        EXPECT_LE(LargestDifference(ours.Output(time), theirs.Output(time)), 1) << time;
    }
}

TEST_F(SelectionShadersGpu, AreReplacedByOnesOfTheBuiltInPipeline)
{
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    settings.m_StencilShader = Shader::FromText(k_OldStencil, "stencil.shader", Compiler());
    settings.m_CompositeShader = Shader::FromText(k_OldComposite, "composite.shader", Compiler());
    ExpectSamePictures(settings);
    ExpectNoValidationMessages();
}

TEST_F(SelectionShadersGpu, GiveTheSamePixelsAsTheArticlesOwn)
{
    const char* corpus = std::getenv("LIMN_CORPUS_DIR");
    const std::filesystem::path folder = corpus != nullptr ? corpus : "";
    if (!std::filesystem::exists(folder / "s2_Stencil.shader"))
    {
        GTEST_SKIP() << "LIMN_CORPUS_DIR names no folder with s2_Stencil.shader";
    }
    if (HasCoarseCorners())
    {
        // The article's programs blend a pixel with its neighbours where its place is a little off,
        // and its composite takes any trace of a neighbour for the object itself.
        GTEST_SKIP() << "the device reports fewer than 8 subPixelPrecisionBits";
    }
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    settings.m_StencilShader = Shader::Load(folder / "s2_Stencil.shader", Compiler());
    settings.m_BlurShader = Shader::Load(folder / "s2_Blur.shader", Compiler());
    settings.m_CompositeShader = Shader::Load(folder / "s2_Composite.shader", Compiler());
    ExpectSamePictures(settings);
    ExpectNoValidationMessages();
}

class SelectionTimeGpu : public GpuTest
{
protected:
    /// The stencil's colour at several moments against double precision.
    static void ExpectColors(const SelectionOutlineSettings& settings)
    {
        SquareScene content(9);
        SelectionRun run(9, 9, content.scene, content.camera, settings);
        for (const double time : {0.0, 3600.0, 7.0 * 24 * 3600, 1e7})
        {
            for (const double since : {0.0, 0.9, 2500.0})
            {
                run.feature().SetStartTime(content.large, time - since);
                run.feature().SetStartTime(content.small, time - since);
                run.RenderForReading(time);
                const auto expected = StencilColorReference(time, time - since);
                for (int channel = 0; channel < 4; ++channel)
                {
                    EXPECT_NEAR(run.Stencil().At(4, 4, channel) * 255.0,
                                expected[static_cast<std::size_t>(channel)] * 255.0, 1.0)
                        << time << " s, selected " << since << " s before, channel " << channel;
                }
            }
        }
    }
};

TEST_F(SelectionTimeGpu, ChangesTheColourByLessThanOne255thInWeeks)
{
    ExpectColors(SelectionRun::MakeSettings());
    ExpectNoValidationMessages();
}

TEST_F(SelectionTimeGpu, ChangesThatOfOlderShadersByNoMore)
{
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    settings.m_StencilShader = Shader::FromText(k_OldStencil, "stencil.shader", Compiler());
    ExpectColors(settings);
    const char* corpus = std::getenv("LIMN_CORPUS_DIR");
    const std::filesystem::path path =
        std::filesystem::path(corpus != nullptr ? corpus : "") / "s2_Stencil.shader";
    if (std::filesystem::exists(path))
    {
        settings.m_StencilShader = Shader::Load(path, Compiler());
        ExpectColors(settings);
    }
    ExpectNoValidationMessages();
}

TEST_F(SelectionTimeGpu, CountsFromTheStartOfTheWholeOrElseStepByStep)
{
    SquareScene content(9);
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    settings.m_PhaseStep = 0.3f;
    SelectionRun run(9, 9, content.scene, content.camera, settings);
    const auto expectStart = [&](double start)
    {
        run.RenderForReading(2.0);
        const auto expected = StencilColorReference(2.0, start);
        for (int channel = 0; channel < 4; ++channel)
        {
            EXPECT_NEAR(run.Stencil().At(4, 4, channel),
                        expected[static_cast<std::size_t>(channel)], 1.01 / 255.0)
                << start;
        }
    };
    expectStart(0.3); // the small one is the second object and drawn last
    content.small.transform.parent = &content.large.transform;
    content.small.transform.localScale = glm::vec3(0.5f);
    content.small.transform.localPosition = {0.0f, 0.0f, -0.1f};
    run.feature().SetStartTime(content.large, 1.7);
    expectStart(1.7);
    run.feature().SetStartTime(content.small, 0.9);
    expectStart(0.9);
    run.feature().ClearStartTimes();
    expectStart(0.3);
}

// Why the pass hands shaders a time of its own: as a material of the scene the same shader is off.
TEST_F(SelectionTimeGpu, OfTheFrameIsTooCoarseAfterMonths)
{
    SquareScene content(9);
    const auto material =
        std::make_shared<Material>(Shader::FromText(k_OldStencil, "stencil.shader", Compiler()));
    content.small.renderer->sharedMaterials = {material};
    content.large.activeSelf = false;
    SelectionRun run(9, 9, content.scene, content.camera);
    run.Enable(false);
    const double time = 1e7 + 0.3;
    material->SetFloat(ShaderPropertyId("_StartTime"), static_cast<float>(2.0 * (time - 0.9)));
    run.RenderForReading(time);
    const auto expected = StencilColorReference(time, time - 0.9);
    double largest = 0.0;
    for (int channel = 0; channel < 3; ++channel)
    {
        const double drawn = std::clamp(run.CameraColor().At(4, 4, channel), 0.0, 1.0);
        largest = std::max(largest,
                           std::abs(drawn - expected[static_cast<std::size_t>(channel)]) * 255.0);
    }
    EXPECT_GT(largest, 10.0);
}

} // namespace
