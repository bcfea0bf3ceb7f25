#pragma once

#include "features/shadows/ShadowScene.h"

#include <limn/features/ScreenSpaceAmbientOcclusion.h>

namespace limn::test
{

using SsaoSettings = ScreenSpaceAmbientOcclusionSettings;
using SsaoMethod = SsaoSettings::AOMethodOptions;
using SsaoSource = SsaoSettings::DepthSource;
using SsaoNormals = SsaoSettings::NormalQuality;
using SsaoSamples = SsaoSettings::AOSampleOption;
using SsaoBlur = SsaoSettings::BlurQualityOptions;

/// A material whose picture is what the library says of occlusion: of indirect light in red, of
/// direct light in green; and which has depth and normals.
inline std::shared_ptr<Material> OcclusionShown()
{
    const static std::string text =
        "Shader \"Test/Occlusion\" { Properties { _Cull (\"Culled\", Float) = 2 } SubShader {\n"
        "UsePass \"Universal Render Pipeline/Lit/DEPTHONLY\"\n"
        "UsePass \"Universal Render Pipeline/Lit/DEPTHNORMALS\"\n"
        "Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n"
        "HLSLPROGRAM\n"
        "#pragma vertex Vert\n#pragma fragment Frag\n"
        "#pragma multi_compile_fragment _ _SCREEN_SPACE_OCCLUSION\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl\"\n"
        "float4 Vert(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }\n"
        "float4 Frag(float4 p : SV_POSITION) : SV_Target {\n"
        "AmbientOcclusionFactor f = CreateAmbientOcclusionFactor(\n"
        "    GetNormalizedScreenSpaceUV(p), 1.0);\n"
        "return float4(f.indirectAmbientOcclusion, f.directAmbientOcclusion, 0, 1); }\n"
        "ENDHLSL\n} } }";
    // One shader for all scenes, as a driver compiles each anew.
    const static auto shader = std::make_shared<const Shader>(
        ParseShaderLab(text, "test.shader").document, Compiler(), &BuiltinShaders());
    return std::make_shared<Material>(shader);
}

/// Boxes on a floor, for a camera in the middle of it that looks along +z.
struct OcclusionScene : ShadowScene
{
    OcclusionScene(int pictureWidth, int pictureHeight, const glm::vec3& position, float pitch)
        : ShadowScene(pictureWidth, pictureHeight, OcclusionShown())
    {
        scene.mainLight.shadows = LightShadows::None;
        camera.transform.localPosition = position;
        camera.transform.localRotation = EulerToRotation({pitch, 0.0f, 0.0f});
        camera.nearClipPlane = 0.05f;
        camera.farClipPlane = 500.0f;
    }

    glm::dvec3 forward() const
    {
        return glm::dquat(camera.transform.localRotation) * glm::dvec3(0.0, 0.0, 1.0);
    }
    /// Metres along the camera's direction.
    double DepthOf(const glm::dvec3& place) const
    {
        return glm::dot(place - glm::dvec3(camera.transform.localPosition), forward());
    }
    /// The pixel's place in the picture; rows from the top.
    glm::dvec2 PixelOf(const glm::dvec3& place) const
    {
        const glm::dvec3 way = place - glm::dvec3(camera.transform.localPosition);
        const glm::dquat rotation(camera.transform.localRotation);
        const double right = glm::dot(way, rotation * glm::dvec3(1, 0, 0));
        const double up = glm::dot(way, rotation * glm::dvec3(0, 1, 0));
        const double half =
            camera.orthographic
                ? static_cast<double>(camera.orthographicSize)
                : std::tan(glm::radians(static_cast<double>(camera.fieldOfView) / 2)) *
                      DepthOf(place);
        return {0.5 * width + right / half * 0.5 * height, 0.5 * height - up / half * 0.5 * height};
    }
};

/// A run of a scene with the feature.
struct OcclusionRun : PictureRun
{
    OcclusionRun(const OcclusionScene& scene, const SsaoSettings& settings)
        : PictureRun(scene.scene, scene.camera, scene.width, scene.height)
    {
        Add(std::make_unique<ScreenSpaceAmbientOcclusion>(settings));
    }

    /// The share of light that is left of each pixel.
    Field Left()
    {
        Render(nullptr);
        return Texture("_ScreenSpaceOcclusionTexture");
    }
    /// What is hidden, before it is blurred.
    Field Hidden()
    {
        Render(nullptr);
        return Texture("_SSAO_OcclusionTexture0");
    }
};

inline double Least(const Field& field)
{
    return *std::ranges::min_element(field.values);
}

} // namespace limn::test
