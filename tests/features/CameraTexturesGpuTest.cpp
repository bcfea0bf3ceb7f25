#include "features/OutlineGpuReference.h"
#include "precision/DevicePrecision.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <gmock/gmock.h>
#include <limits>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <numbers>
#include <optional>

#include "core/scene/TestScene.h"

namespace limn::test
{
namespace
{

constexpr int k_PictureWidth = 64;
constexpr int k_PictureHeight = 48;
constexpr auto k_LibraryPath = "Packages/com.unity.render-pipelines.universal/ShaderLibrary/";
/// Half floats hold the picture: the eye depth in sixteenths of a metre, and what is left of it.
constexpr auto k_ShowDepth = R"(
    float depth = LinearEyeDepth(SampleSceneDepth(input.texcoord), _ZBufferParams);
    float coarse = floor(depth * 16.0) / 16.0;
    return float4(coarse, depth - coarse, 0, 1);)";
constexpr auto k_ShowNormals = "return float4(SampleSceneNormals(input.texcoord), 1);";

std::string Include(const std::string& file)
{
    return "#include \"" + (k_LibraryPath + file) + "\"\n";
}

/// A full-screen shader with this fragment function.
std::shared_ptr<Material> FullScreen(const std::string& body)
{
    return std::make_shared<Material>(ShaderOf(
        "Shader \"Test/FullScreen\" { SubShader { Pass { ZTest Always ZWrite Off Cull Off\n"
        "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n" +
        Include("Core.hlsl") + Include("DeclareDepthTexture.hlsl") +
        Include("DeclareNormalsTexture.hlsl") + Include("DeclareOpaqueTexture.hlsl") +
        "#include \"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl\"\n"
        "float4 Frag(Varyings input) : SV_Target {" +
        body + "}\nENDHLSL\n} } }"));
}

/// What a ray through a pixel meets.
struct Hit
{
    double depth = 0.0; ///< along the camera's axis, metres
    glm::dvec3 normal{0.0};
    int object = -1;
};

/// A ray that begins outside, in the space of an object.
struct Ray
{
    glm::dvec3 origin;
    glm::dvec3 direction;

    glm::dvec3 At(double t) const { return origin + t * direction; }
};

using Shape = std::optional<Hit> (*)(const Ray& ray);

std::optional<Hit> HitCube(const Ray& ray)
{
    double enter = -1e9;
    double leave = 1e9;
    glm::dvec3 normal(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
        const double side = ray.direction[axis] > 0.0 ? 1.0 : -1.0;
        const double in = (-0.5 * side - ray.origin[axis]) / ray.direction[axis];
        leave = std::min(leave, (0.5 * side - ray.origin[axis]) / ray.direction[axis]);
        if (in > enter)
        {
            enter = in;
            normal = glm::dvec3(0.0);
            normal[axis] = -side;
        }
    }
    return enter < leave ? std::optional(Hit{enter, normal}) : std::nullopt;
}

std::optional<Hit> HitSphere(const Ray& ray)
{
    const double a = glm::dot(ray.direction, ray.direction);
    const double b = glm::dot(ray.origin, ray.direction);
    const double root = b * b - a * (glm::dot(ray.origin, ray.origin) - 0.25);
    if (root < 0.0)
    {
        return std::nullopt;
    }
    const double t = (-b - std::sqrt(root)) / a;
    return Hit{t, ray.At(t)};
}

/// 10 x 10, seen from above.
std::optional<Hit> HitPlane(const Ray& ray)
{
    const double t = -ray.origin.y / ray.direction.y;
    const glm::dvec3 place = ray.At(t);
    const bool isInside = t > 0.0 && std::abs(place.x) < 5.0 && std::abs(place.z) < 5.0;
    return isInside ? std::optional(Hit{t, {0, 1, 0}}) : std::nullopt;
}

/// A tilted plane, a turned cube, a stretched sphere before a camera that looks along +z.
class CameraTexturesGpu : public GpuTest
{
protected:
    CameraTexturesGpu()
    {
        m_Camera.transform.localPosition = {0.0f, 0.3f, -4.0f};
        m_Camera.fieldOfView = 50.0f;
        Add(PrimitiveType::Plane, HitPlane, {0, -1, 1.5f}, {-8, 20, 5}, {0.5f, 1.0f, 0.4f});
        Add(PrimitiveType::Cube, HitCube, {0.9f, 0.1f, 0.2f}, {20, 35, 10}, {1, 1, 1});
        Add(PrimitiveType::Sphere, HitSphere, {-0.8f, 0.3f, 0.5f}, {0, 0, 30}, {1.4f, 1.0f, 1.2f});
        m_Request.scene = &m_Scene;
        m_Request.camera = &m_Camera;
        m_Request.width = k_PictureWidth;
        m_Request.height = k_PictureHeight;
    }

    void Add(PrimitiveType type, Shape shape, const glm::vec3& position, const glm::vec3& angles,
             const glm::vec3& scale)
    {
        GameObject& object = m_Scene.Add("object");
        object.transform.localPosition = position;
        object.transform.localRotation = EulerToRotation(angles);
        object.transform.localScale = scale;
        object.renderer = MeshRenderer{CreatePrimitive(type), {m_Material}};
        m_Shapes.emplace_back(object.transform.localToWorldMatrix(), shape);
    }

    void AddFullScreen(const char* body, ScriptableRenderPassInput requirements)
    {
        auto feature = std::make_unique<FullScreenPassRendererFeature>();
        feature->passMaterial = FullScreen(body);
        feature->requirements = requirements;
        feature->fetchColorBuffer = false;
        m_Renderer.AddFeature(std::move(feature));
    }

    /// The camera's linear colour.
    Field Draw()
    {
        // The camera's textures are known after a frame only; the next one keeps them readable.
        m_Request.alsoReadBack.clear();
        m_Request.compile.leavesOut = false;
        const RenderResult first = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        m_Request.compile.leavesOut = true;
        for (const CompiledRenderPass& pass : first.frame->passes)
        {
            if (!pass.colors.empty() &&
                pass.colors.front().texture->name() == "_CameraColorAttachmentA")
            {
                m_Request.alsoReadBack = {RTHandle(pass.colors.front().texture)};
            }
        }
        m_Result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        return ToField(SharedDevice().ReadBack(*m_Request.alsoReadBack.at(0).rt()));
    }

    /// What is seen through a place in a pixel; nothing is nearer than what was met first.
    Hit Reference(int x, int y) const { return ReferenceAt(glm::dvec2(x, y) + m_PlaceInPixel); }
    Hit ReferenceAt(const glm::dvec2& place) const
    {
        const double half = std::tan(m_Camera.fieldOfView * std::numbers::pi / 360.0);
        const double aspect = static_cast<double>(k_PictureWidth) / k_PictureHeight;
        const glm::dvec4 origin(glm::dvec3(m_Camera.transform.localPosition), 1.0);
        const glm::dvec2 at = place / glm::dvec2(k_PictureWidth, k_PictureHeight) * 2.0 - 1.0;
        const glm::dvec4 direction(at.x * half * aspect, -at.y * half, 1.0, 0.0);
        Hit nearest{m_Camera.farClipPlane};
        for (std::size_t i = 0; i < m_Shapes.size(); ++i)
        {
            const auto& [matrix, shape] = m_Shapes[i];
            const glm::dmat4 inverse = glm::inverse(matrix);
            const auto hit = shape({glm::dvec3(inverse * origin), glm::dvec3(inverse * direction)});
            if (hit && hit->depth < nearest.depth)
            {
                nearest = *hit;
                nearest.normal = glm::normalize(glm::transpose(glm::dmat3(inverse)) * hit->normal);
                nearest.object = static_cast<int>(i);
            }
        }
        return nearest;
    }

    /// Calls `use` for pixels that are not at an edge of what is seen.
    template <typename Use>
    void ForEachInside(const Use& use) const
    {
        int seen[4] = {};
        for (int y = 1; y < k_PictureHeight - 1; ++y)
        {
            for (int x = 1; x < k_PictureWidth - 1; ++x)
            {
                const Hit hit = Reference(x, y);
                bool isInside = true;
                for (int n = 0; n < 9; ++n)
                {
                    const Hit near = Reference(x + n % 3 - 1, y + n / 3 - 1);
                    isInside = isInside && near.object == hit.object &&
                               (hit.object == 2 || glm::distance(near.normal, hit.normal) < 1e-9);
                }
                if (isInside)
                {
                    ++seen[hit.object + 1];
                    use(x, y, hit);
                }
            }
        }
        EXPECT_THAT(seen, testing::Each(testing::Gt(60))) << "background, plane, cube, sphere";
    }

    /// How far a depth is from those that the device may take for a pixel's.
    double DepthError(int x, int y, double depth) const
    {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const glm::dvec2& place : MovedPlaces(glm::dvec2(x, y) + m_PlaceInPixel))
        {
            const double seen = ReferenceAt(place).depth;
            low = std::min(low, seen);
            high = std::max(high, seen);
        }
        return std::max({low - depth, depth - high, 0.0});
    }

    /// @return the largest error of each: background, plane, cube, sphere; metres
    std::array<double, 4> DepthErrors(const Field& picture) const
    {
        std::array<double, 4> largest{};
        ForEachInside(
            [&](int x, int y, const Hit& hit)
            {
                const double depth = picture.At(x, y, 0) + picture.At(x, y, 1);
                double& error = largest[static_cast<std::size_t>(hit.object + 1)];
                error = std::max(error, DepthError(x, y, depth));
            });
        return largest;
    }

    /// @return the largest error of a component, likewise
    std::array<double, 4> NormalErrors(const Field& picture) const
    {
        std::array<double, 4> largest{};
        ForEachInside(
            [&](int x, int y, const Hit& hit)
            {
                for (int channel = 0; channel < 3; ++channel)
                {
                    double& error = largest[static_cast<std::size_t>(hit.object + 1)];
                    error =
                        std::max(error, std::abs(picture.At(x, y, channel) - hit.normal[channel]));
                }
            });
        return largest;
    }

    std::vector<std::string> Ran() const
    {
        std::vector<std::string> names;
        for (const ExecutedPassReport& pass : m_Result.report.passes)
        {
            names.push_back(pass.name.name());
        }
        return names;
    }

    const std::shared_ptr<Material> m_Material =
        std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()));
    std::vector<std::pair<glm::dmat4, Shape>> m_Shapes;
    Scene m_Scene;
    Camera m_Camera;
    UniversalRenderer m_Renderer{Compiler()};
    RenderRequest m_Request;
    RenderResult m_Result; ///< of the last Draw
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
    glm::dvec2 m_PlaceInPixel{0.5}; ///< from its left top
};

/// Where the first of four samples is, as Vulkan and D3D have it: they count from the first row,
/// which is the picture's bottom.
/// SwiftShader draws the samples there, but takes their depth from the other side of the pixel.
glm::dvec2 FirstSample()
{
    const bool isMirrored = SharedDevice().deviceName().starts_with("SwiftShader");
    return {isMirrored ? 0.625 : 0.375, 0.875};
}

/// Half floats have steps of 0.5 below 1000 m, of 3e-5 below a sixteenth of a metre. The sphere has
/// facets.
void ExpectDepths(const std::array<double, 4>& errors)
{
    EXPECT_LT(errors[0], 0.5);
    EXPECT_LT(errors[1], 5e-5);
    EXPECT_LT(errors[2], 5e-5);
    EXPECT_LT(errors[3], 0.02);
}

/// The texture holds n/127; half a step, and what half floats round.
void ExpectNormals(const std::array<double, 4>& errors)
{
    EXPECT_EQ(errors[0], 0.0);
    EXPECT_LT(errors[1], 0.0045);
    EXPECT_LT(errors[2], 0.0045);
    EXPECT_LT(errors[3], 0.05);
}

TEST_F(CameraTexturesGpu, HaveTheDepthThatAReferenceSaysCopied)
{
    AddFullScreen(k_ShowDepth, ScriptableRenderPassInput::Depth);
    ExpectDepths(DepthErrors(Draw()));
    EXPECT_THAT(Ran(), testing::Contains("CopyDepth"));
}

TEST_F(CameraTexturesGpu, HaveTheDepthThatAReferenceSaysFromAPrepass)
{
    AddFullScreen(k_ShowDepth, ScriptableRenderPassInput::Normal);
    ExpectDepths(DepthErrors(Draw()));
    EXPECT_THAT(Ran(), testing::Contains("DepthNormalPrepass"));
}

TEST_F(CameraTexturesGpu, HaveTheSameDepthOfUnlitObjects)
{
    const auto unlit = std::make_shared<Material>(
        FindBuiltinShader("Universal Render Pipeline/Unlit", Compiler()));
    for (const auto& object : m_Scene.objects())
    {
        object->renderer->sharedMaterials = {unlit};
    }
    AddFullScreen(k_ShowDepth, ScriptableRenderPassInput::Normal);
    ExpectDepths(DepthErrors(Draw()));
}

TEST_F(CameraTexturesGpu, HaveTheNormalsThatANormalMapBends)
{
    const std::vector<std::byte> texel = {std::byte{200}, std::byte{80}, std::byte{230},
                                          std::byte{255}};
    const auto bumpy =
        std::make_shared<Material>(FindBuiltinShader("Universal Render Pipeline/Lit", Compiler()));
    bumpy->EnableKeyword("_NORMALMAP");
    bumpy->SetTexture(
        ShaderPropertyId("_BumpMap"),
        std::make_shared<const Texture2D>("bump", 1, 1, GraphicsFormat::R8G8B8A8_UNorm, texel));
    GameObject& plane = *m_Scene.objects()[0];
    plane.renderer->sharedMaterials = {bumpy};
    AddFullScreen(k_ShowNormals, ScriptableRenderPassInput::Normal);
    const Field picture = Draw();
    const MeshData& mesh = plane.renderer->mesh->data();
    const glm::dvec3 normal(mesh.normals[0]);
    const glm::dvec3 tangent(mesh.tangents[0]);
    const glm::dvec3 bitangent =
        glm::cross(normal, tangent) * static_cast<double>(mesh.tangents[0].w);
    const glm::dvec2 slope(200 / 127.5 - 1.0, 80 / 127.5 - 1.0);
    const glm::dvec3 bent = glm::dquat(plane.transform.localRotation) *
                            (tangent * slope.x + bitangent * slope.y +
                             normal * std::sqrt(1.0 - glm::dot(slope, slope)));
    double error = 0.0;
    ForEachInside(
        [&](int x, int y, const Hit& hit)
        {
            for (int channel = 0; channel < 3 && hit.object == 0; ++channel)
            {
                error = std::max(error, std::abs(picture.At(x, y, channel) - bent[channel]));
            }
        });
    EXPECT_LT(error, 0.0045);
}

TEST_F(CameraTexturesGpu, HaveTheNormalsThatAReferenceSays)
{
    AddFullScreen(k_ShowNormals, ScriptableRenderPassInput::Normal);
    ExpectNormals(NormalErrors(Draw()));
}

TEST_F(CameraTexturesGpu, HaveTheDepthOfTheFirstSampleCopied)
{
    m_Pipeline.msaaSampleCount = 4;
    m_PlaceInPixel = FirstSample();
    AddFullScreen(k_ShowDepth, ScriptableRenderPassInput::Depth);
    ExpectDepths(DepthErrors(Draw()));
    EXPECT_THAT(Ran(), testing::Contains("CopyDepth"));
}

TEST_F(CameraTexturesGpu, HaveTheDepthOfOneSampleFromAPrepass)
{
    m_Pipeline.msaaSampleCount = 4;
    AddFullScreen(k_ShowDepth, ScriptableRenderPassInput::Normal);
    ExpectDepths(DepthErrors(Draw()));
    EXPECT_THAT(Ran(), testing::Contains("DepthNormalPrepass"));
}

TEST_F(CameraTexturesGpu, HaveTheNormalsOfOneSample)
{
    m_Pipeline.msaaSampleCount = 4;
    AddFullScreen(k_ShowNormals, ScriptableRenderPassInput::Normal);
    ExpectNormals(NormalErrors(Draw()));
}

TEST_F(CameraTexturesGpu, HaveTheAverageOfTheOpaqueSamples)
{
    const Field plain = Draw();
    m_Pipeline.msaaSampleCount = 4;
    const Field opaque = Draw();
    AddFullScreen("return float4(SampleSceneColor(input.texcoord).bgr, 1);",
                  ScriptableRenderPassInput::Color);
    const Field picture = Draw();
    int smoothed = 0;
    for (int y = 0; y < k_PictureHeight; ++y)
    {
        for (int x = 0; x < k_PictureWidth; ++x)
        {
            for (int channel = 0; channel < 3; ++channel)
            {
                ASSERT_EQ(picture.At(x, y, channel), opaque.At(x, y, 2 - channel))
                    << x << ", " << y;
            }
            smoothed += std::abs(opaque.At(x, y, 0) - plain.At(x, y, 0)) > 0.05 ? 1 : 0;
        }
    }
    EXPECT_GT(smoothed, 50) << "pixels at edges";
    EXPECT_THAT(Ran(), testing::Contains("CopyColor"));
}

TEST_F(CameraTexturesGpu, ShowTransparentObjectsTheOpaquePicture)
{
    const Field opaque = Draw();
    const auto transparent = [&](const std::string& include, const std::string& result, int queue)
    {
        const auto material = std::make_shared<Material>(
            ShaderOf("Shader \"Test/Glass\" { SubShader { Pass { Tags { \"LightMode\" = "
                     "\"UniversalForward\" } ZWrite Off\nHLSLPROGRAM\n#pragma vertex Vert\n"
                     "#pragma fragment Frag\n" +
                     Include("Core.hlsl") + include +
                     "float4 Vert(float4 p : POSITION) : SV_POSITION "
                     "{ return TransformObjectToHClip(p.xyz); }\n"
                     "float4 Frag(float4 p : SV_POSITION) : SV_Target { return " +
                     result + "; }\nENDHLSL\n} } }"));
        material->SetRenderQueue(queue);
        AddCube(m_Scene, "glass", {0.1f, 0.2f, -1.5f}, {material});
    };
    transparent("", "float4(1, 0, 0, 1)", 3000);
    transparent(Include("DeclareOpaqueTexture.hlsl"), "float4(LoadSceneColor(uint2(p.xy)).bgr, 1)",
                3001);
    const Field picture = Draw();
    int swapped = 0;
    for (int y = 0; y < k_PictureHeight; ++y)
    {
        for (int x = 0; x < k_PictureWidth; ++x)
        {
            const bool isGlass = picture.At(x, y, 0) == opaque.At(x, y, 2) &&
                                 picture.At(x, y, 2) == opaque.At(x, y, 0);
            const bool isOpaque = picture.At(x, y, 0) == opaque.At(x, y, 0) &&
                                  picture.At(x, y, 2) == opaque.At(x, y, 2);
            EXPECT_TRUE(isGlass || isOpaque) << x << ", " << y;
            EXPECT_EQ(picture.At(x, y, 1), opaque.At(x, y, 1)) << x << ", " << y;
            swapped += isGlass && !isOpaque ? 1 : 0;
        }
    }
    EXPECT_GT(swapped, 150);
    EXPECT_THAT(Ran(), testing::ElementsAre("Draw Opaque Objects", "CopyColor",
                                            "Draw Transparent Objects", "Final Blit"));
}

} // namespace
} // namespace limn::test
