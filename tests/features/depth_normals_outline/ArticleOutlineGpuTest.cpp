#include "features/OutlineScene.h"
#include "features/depth_normals_outline/DepthNormalsRun.h"

#include <glm/geometric.hpp>

namespace limn::test
{
namespace
{

struct ArticleLook
{
    double thickness = 2.0;
    double depthSensitivity = 0.2;
    double normalsSensitivity = 1.0;
    double alpha = 1.0; ///< of the colour, which is red
};

/// The two textures that the article reads.
struct ArticleTextures
{
    Field depth;
    Field normals; ///< 0...1

    double Depth(int x, int y) const
    {
        return depth.At(std::clamp(x, 0, depth.width - 1), std::clamp(y, 0, depth.height - 1));
    }
    /// Stereographic projection from the pole behind the object, scaled by 1.7777.
    glm::dvec3 Normal(int x, int y) const
    {
        const int column = std::clamp(x, 0, normals.width - 1);
        const int row = std::clamp(y, 0, normals.height - 1);
        const glm::dvec2 plane =
            (glm::dvec2(normals.At(column, row, 0), normals.At(column, row, 1)) - 0.5) * 2.0 *
            1.7777;
        const double g = 2.0 / (glm::dot(plane, plane) + 1.0);
        return {plane * g, g - 1.0};
    }
};

ArticleTextures TexturesOf(const Scene& scene, const Camera& camera, int width, int height)
{
    ArticleTextures textures{ProbedDepth(scene, camera, width, height),
                             Probed(scene, camera, width, height,
                                    "return SAMPLE_TEXTURE2D_X_LOD(_CameraDepthNormalsTexture, "
                                    "sampler_CameraDepthNormalsTexture, uv, 0);")};
    for (double& value : textures.normals.values)
    {
        value = std::round(value * 255.0) / 255.0; // half floats are near to that
    }
    return textures;
}

/// The article's formula, its pow(x, 2) as a square.
bool IsArticleEdge(const ArticleTextures& textures, const ArticleLook& look, int x, int y)
{
    const int low = static_cast<int>(std::floor(look.thickness * 0.5));
    const int high = static_cast<int>(std::ceil(look.thickness * 0.5));
    const int xs[] = {x - low, x + high, x + high, x - low};
    const int ys[] = {y + low, y - high, y + low, y - high}; // v rises where y falls
    double d[4];
    glm::dvec3 n[4];
    for (int i = 0; i < 4; ++i)
    {
        d[i] = textures.Depth(xs[i], ys[i]);
        n[i] = textures.Normal(xs[i], ys[i]);
    }
    const double edgeDepth = std::hypot(d[1] - d[0], d[3] - d[2]) * 100.0;
    const double edgeNormal =
        std::sqrt(glm::dot(n[1] - n[0], n[1] - n[0]) + glm::dot(n[3] - n[2], n[3] - n[2]));
    return (look.depthSensitivity > 0.0 && edgeDepth > d[0] / look.depthSensitivity) ||
           (look.normalsSensitivity > 0.0 && edgeNormal > 1.0 / look.normalsSensitivity);
}

const glm::vec3 k_Selected{0.2f, 0.5f, 0.3f};

/// Torus and cube of one colour, on which lines are drawn, and a white sphere before them.
class ArticleOutlineGpu : public GpuTest
{
protected:
    ArticleOutlineGpu()
    {
        for (const auto& object : m_Content.scene.objects())
        {
            object->renderer->sharedMaterials = {
                Plain(IsSelected(*object) ? k_Selected : glm::vec3(1.0f))};
        }
        m_Settings.m_LayerMask = LayerMask::FromIndex(k_FurnitureLayer);
        m_Settings.m_RenderingLayerMask = k_SelectedLayer;
    }

    static bool IsSelected(const GameObject& object)
    {
        return object.renderer->renderingLayerMask.Intersects(
            RenderingLayerMask::FromIndex(k_SelectedLayer));
    }

    const VolumeStack& With(const ArticleLook& look)
    {
        return m_Volumes.With(
            [&](DepthNormalsOutline& outline)
            {
                outline.m_Technique.Override(DepthNormalsTechnique::Article);
                outline.m_OutlineColor.Override(Color{1, 0, 0, static_cast<float>(look.alpha)});
                outline.m_OutlineWidth.Override(static_cast<float>(look.thickness));
                outline.m_DepthSensitivity.Override(static_cast<float>(look.depthSensitivity));
                outline.m_NormalsSensitivity.Override(static_cast<float>(look.normalsSensitivity));
            });
    }

    /// What every sample of a selected object turns to.
    Field Reference(const Field& base, const Field& coverage, const ArticleTextures& textures,
                    const ArticleLook& look) const
    {
        Field result = base;
        const std::array<double, 3> red{1.0, 0.0, 0.0};
        for (int y = 0; y < base.height; ++y)
        {
            for (int x = 0; x < base.width; ++x)
            {
                const double share =
                    IsArticleEdge(textures, look, x, y) ? coverage.At(x, y) * look.alpha : 0.0;
                for (int channel = 0; channel < 3; ++channel)
                {
                    const double own = static_cast<double>(k_Selected[channel]);
                    result.At(x, y, channel) +=
                        share * (red[static_cast<std::size_t>(channel)] - own);
                }
            }
        }
        return result;
    }

    OutlineScene m_Content;
    DepthNormalsOutlineSettings m_Settings;
    BlendedComponent<DepthNormalsOutline> m_Volumes;
};

struct PictureSize
{
    int width;
    int height;
    int samples;
};

class ArticleOutlineAtSizeGpu : public ArticleOutlineGpu,
                                public testing::WithParamInterface<PictureSize>
{
};

TEST_P(ArticleOutlineAtSizeGpu, AgreesWithTheArticlesFormulaInDouble)
{
    const auto [width, height, samples] = GetParam();
    PictureRun run(m_Content.scene, m_Content.camera, width, height);
    run.SetSamples(samples);
    run.Add(std::make_unique<DepthNormalsOutlineRendererFeature>(m_Settings));
    const Field base = run.Color(nullptr);
    const Field coverage =
        Coverage(m_Content.scene, m_Content.camera, width, height, samples, IsSelected);
    const ArticleTextures textures = TexturesOf(m_Content.scene, m_Content.camera, width, height);
    const ArticleLook looks[] = {{1.0, 0.2, 0.0, 1.0}, {2.0, 0.2, 0.0, 0.5},
                                 {2.0, 0.0, 1.0, 1.0}, {3.0, 0.2, 0.7, 0.75},
                                 {5.0, 1.0, 0.5, 1.0}, {2.6, 0.05, 1.0, 1.0}};
    for (const ArticleLook& look : looks)
    {
        const Field picture = run.Color(&With(look));
        EXPECT_GE(ShareWithinTwo(picture, Reference(base, coverage, textures, look)), 0.999)
            << look.thickness << ", " << look.depthSensitivity << ", " << look.normalsSensitivity;
        EXPECT_GT(CountDifferent(picture, base), 20);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ArticleOutlineAtSizeGpu,
                         testing::Values(PictureSize{96, 64, 1}, PictureSize{61, 37, 1},
                                         PictureSize{33, 65, 1}, PictureSize{96, 64, 4},
                                         PictureSize{61, 37, 4}, PictureSize{33, 65, 4}),
                         [](const auto& of)
                         {
                             return std::to_string(of.param.width) + "x" +
                                    std::to_string(of.param.height) + "x" +
                                    std::to_string(of.param.samples);
                         });

TEST_F(ArticleOutlineGpu, HasNoLinesWithoutSensitivity)
{
    LinedRun run(m_Content.scene, m_Content.camera, 48, 32, m_Settings);
    const Field base = run.Color(nullptr);
    EXPECT_EQ(CountDifferent(run.Color(&With({2.0, 0.0, 0.0, 1.0})), base), 0);
}

// A porter's material: Lerp(colour, outline colour, edge) in the object's own pass.
TEST_F(ArticleOutlineGpu, IsTheSameInAnObjectsOwnMaterial)
{
    PictureRun feature(m_Content.scene, m_Content.camera, 61, 37);
    feature.Add(std::make_unique<DepthNormalsOutlineRendererFeature>(m_Settings));
    const Field expected = feature.Color(&With({3.0, 0.2, 0.7, 1.0}));

    const auto material = std::make_shared<Material>(ShaderOf(
        "Shader \"Test/Own\" { SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n"
        "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "#include \"limn/outline/OutlineObject.hlsl\"\n"
        "float4 Vert(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }\n"
        "float4 Frag(float4 p : SV_POSITION) : SV_Target { float edge;\n"
        "OutlineObject_float(p.xy / _ScreenParams.xy, 3, 0.2, 0.7, edge);\n"
        "return lerp(float4(0.2, 0.5, 0.3, 1), float4(1, 0, 0, 1), edge); }\nENDHLSL\n}\n"
        "Pass { Tags { \"LightMode\" = \"DepthNormalsOnly\" }\n"
        "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "struct V { float4 p : SV_POSITION; float3 n : TEXCOORD0; };\n"
        "V Vert(float4 p : POSITION, float3 n : NORMAL) { V v;\n"
        "v.p = TransformObjectToHClip(p.xyz); v.n = TransformObjectToWorldNormal(n); return v; }\n"
        "float4 Frag(V v) : SV_Target { return float4(normalize(v.n), 0); }\nENDHLSL\n} } }"));
    for (const auto& object : m_Content.scene.objects())
    {
        if (IsSelected(*object))
        {
            object->renderer->sharedMaterials = {material};
        }
    }
    PictureRun own(m_Content.scene, m_Content.camera, 61, 37);
    EXPECT_GE(ShareWithinTwo(own.Color(nullptr), expected), 0.999);
}

// The texture that the article reads, against the one of which it is made.
TEST_F(ArticleOutlineGpu, ReadsNormalsOfViewSpaceAndTheDepthOverTheFarPlane)
{
    const Scene& scene = m_Content.scene;
    Camera& camera = m_Content.camera;
    camera.farClipPlane = 20.0f;
    for (const bool isOrthographic : {false, true})
    {
        camera.orthographic = isOrthographic;
        camera.orthographicSize = 1.5f;
        const Field normals =
            Probed(scene, camera, 48, 32, "return float4(SampleSceneNormals(uv), 1);");
        const Field decoded =
            Probed(scene, camera, 48, 32, "return float4(limn_ViewNormal(uv), 1);");
        const Field eye = Probed(scene, camera, 48, 32,
                                 "float depth; float3 normal; DecodeDepthNormal("
                                 "SAMPLE_TEXTURE2D_X_LOD(_CameraDepthNormalsTexture, "
                                 "sampler_CameraDepthNormalsTexture, uv, 0), depth, normal);"
                                 "return float4(depth * 20, limn_EyeDepth(limn_Depth(uv)), 0, 1);");
        int seen = 0;
        for (int y = 0; y < 32; ++y)
        {
            for (int x = 0; x < 48; ++x)
            {
                const glm::dvec3 world(normals.At(x, y, 0), normals.At(x, y, 1),
                                       normals.At(x, y, 2));
                const bool isSeen = glm::length(world) > 0.5;
                // The camera looks along +z; view space looks along -z.
                const glm::dvec3 view =
                    isSeen ? glm::normalize(world) * glm::dvec3(1, 1, -1) : glm::dvec3(0, 0, 1);
                seen += isSeen ? 1 : 0;
                for (int i = 0; i < 3 && view.z > -0.3; ++i)
                {
                    ASSERT_NEAR(decoded.At(x, y, i), view[i], 0.03) << x << ", " << y;
                }
                ASSERT_NEAR(eye.At(x, y, 0), isSeen ? eye.At(x, y, 1) : 20.0, 0.08)
                    << x << ", " << y;
            }
        }
        EXPECT_GT(seen, 200);
    }
}

} // namespace
} // namespace limn::test
