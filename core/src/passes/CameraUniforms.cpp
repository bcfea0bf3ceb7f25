#include "passes/CameraUniforms.h"
#include "record/MatrixIds.h"

#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>

namespace limn
{

namespace
{

const ShaderPropertyId unity_WorldToCamera{"unity_WorldToCamera"};
const ShaderPropertyId unity_CameraToWorld{"unity_CameraToWorld"};
const ShaderPropertyId unity_CameraProjection{"unity_CameraProjection"};
const ShaderPropertyId unity_CameraInvProjection{"unity_CameraInvProjection"};
const ShaderPropertyId limn_CameraPos{"limn_CameraPos"};
const ShaderPropertyId _WorldSpaceCameraPos{"_WorldSpaceCameraPos"};
const ShaderPropertyId _ProjectionParams{"_ProjectionParams"};
const ShaderPropertyId _ScreenParams{"_ScreenParams"};
const ShaderPropertyId _ScaledScreenParams{"_ScaledScreenParams"};
const ShaderPropertyId _ScreenSize{"_ScreenSize"};
const ShaderPropertyId _ZBufferParams{"_ZBufferParams"};
const ShaderPropertyId unity_OrthoParams{"unity_OrthoParams"};
const ShaderPropertyId _ScaleBiasRt{"_ScaleBiasRt"};
const ShaderPropertyId _GlobalMipBias{"_GlobalMipBias"};
const ShaderPropertyId _Time{"_Time"};
const ShaderPropertyId _SinTime{"_SinTime"};
const ShaderPropertyId _CosTime{"_CosTime"};
const ShaderPropertyId _TimeParameters{"_TimeParameters"};
const ShaderPropertyId unity_DeltaTime{"unity_DeltaTime"};
const ShaderPropertyId _MainLightPosition{"_MainLightPosition"};
const ShaderPropertyId k_HarmonicIds[] = {
    ShaderPropertyId("unity_SHAr"), ShaderPropertyId("unity_SHAg"), ShaderPropertyId("unity_SHAb"),
    ShaderPropertyId("unity_SHBr"), ShaderPropertyId("unity_SHBg"), ShaderPropertyId("unity_SHBb"),
    ShaderPropertyId("unity_SHC")};
const ShaderPropertyId unity_SpecCube0{"unity_SpecCube0"};
const ShaderPropertyId unity_SpecCube1{"unity_SpecCube1"};
const ShaderPropertyId unity_SpecCube0_HDR{"unity_SpecCube0_HDR"};
const ShaderPropertyId _GlossyEnvironmentColor{"_GlossyEnvironmentColor"};
const ShaderPropertyId _GlossyEnvironmentCubeMap{"_GlossyEnvironmentCubeMap"};
const ShaderPropertyId _GlossyEnvironmentCubeMap_HDR{"_GlossyEnvironmentCubeMap_HDR"};
const ShaderPropertyId unity_FogParams{"unity_FogParams"};
const ShaderPropertyId unity_FogColor{"unity_FogColor"};
const ShaderPropertyId _MainLightColor{"_MainLightColor"};
const ShaderPropertyId _LightColor0{"_LightColor0"};
const ShaderPropertyId unity_AmbientSky{"unity_AmbientSky"};
const ShaderPropertyId unity_AmbientEquator{"unity_AmbientEquator"};
const ShaderPropertyId unity_AmbientGround{"unity_AmbientGround"};
const ShaderPropertyId _MainLightLayerMask{"_MainLightLayerMask"};

glm::mat4 Inverse(const glm::dmat4& matrix)
{
    return glm::mat4(glm::inverse(matrix));
}

/// 0 for 0: an orthographic camera may have a plane there, and nothing that it draws asks how deep
/// a perspective camera would see it.
double Reciprocal(double x)
{
    return x == 0.0 ? 0.0 : 1.0 / x;
}

/// Returns the constants of Linear01Depth and LinearEyeDepth (urp.md §5.4).
glm::vec4 ZBufferParams(double n, double f, bool usesReversedZBuffer)
{
    if (!usesReversedZBuffer)
    {
        return glm::vec4(1.0 - f * Reciprocal(n), f * Reciprocal(n), Reciprocal(f) - Reciprocal(n),
                         Reciprocal(n));
    }
    return glm::vec4(f * Reciprocal(n) - 1.0, 1.0, Reciprocal(n) - Reciprocal(f), Reciprocal(f));
}

void SetMatrices(CommandBuffer& cmd, const CameraData& data)
{
    RenderingUtils::SetViewAndProjectionMatrices(cmd, data.viewMatrix, data.gpuProjectionMatrix,
                                                 true);
    glm::dmat4 worldToCamera(1.0);
    worldToCamera[2][2] = -1.0;
    worldToCamera *= data.viewMatrix;
    cmd.SetGlobalMatrix(unity_WorldToCamera, glm::mat4(worldToCamera));
    cmd.SetGlobalMatrix(unity_CameraToWorld, Inverse(worldToCamera));
    // OpenGL's, whatever the target is, as scripts see it.
    const glm::dmat4 projection = data.GetProjectionMatrix();
    cmd.SetGlobalMatrix(unity_CameraProjection, glm::mat4(projection));
    cmd.SetGlobalMatrix(unity_CameraInvProjection, Inverse(projection));
    SetOriginUniforms(cmd, data);
}

} // namespace

void SetOriginUniforms(CommandBuffer& cmd, const CameraData& data)
{
    const glm::dvec3& origin = data.renderOrigin;
    cmd.SetGlobalVector(limn_Origin, glm::vec4(origin, origin == glm::dvec3(0.0) ? 0.0f : 1.0f));
    const glm::dvec3 position(data.camera->transform.worldMatrix()[3]);
    cmd.SetGlobalVector(limn_CameraPos, glm::vec4(position - origin, 0.0f));
}

void SetCameraUniforms(CommandBuffer& cmd, const CameraData& data)
{
    const Camera& camera = *data.camera;
    const double n = camera.nearClipPlane;
    const double f = camera.farClipPlane;
    const auto w = static_cast<float>(data.cameraTargetDescriptor.width);
    const auto h = static_cast<float>(data.cameraTargetDescriptor.height);
    const auto pictureWidth = static_cast<float>(data.pixelWidth);
    const auto pictureHeight = static_cast<float>(data.pixelHeight);
    SetMatrices(cmd, data);
    cmd.SetGlobalVector(_WorldSpaceCameraPos, glm::vec4(camera.transform.position(), 0.0f));
    const bool isFlipped = data.IsCameraProjectionMatrixFlipped();
    cmd.SetGlobalVector(_ProjectionParams,
                        glm::vec4(ProjectionSign(isFlipped), n, f, Reciprocal(f)));
    cmd.SetGlobalVector(_ScreenParams, {pictureWidth, pictureHeight, 1.0f + 1.0f / pictureWidth,
                                        1.0f + 1.0f / pictureHeight});
    cmd.SetGlobalVector(_ScaledScreenParams, {w, h, 1.0f + 1.0f / w, 1.0f + 1.0f / h});
    cmd.SetGlobalVector(_ScreenSize, {w, h, 1.0f / w, 1.0f / h});
    cmd.SetGlobalVector(_ZBufferParams, ZBufferParams(n, f, data.usesReversedZBuffer));
    cmd.SetGlobalVector(unity_OrthoParams,
                        {camera.orthographicSize * data.aspectRatio, camera.orthographicSize, 0.0f,
                         camera.orthographic ? 1.0f : 0.0f});
    cmd.SetGlobalVector(_ScaleBiasRt, ScaleBiasRt(isFlipped));
    cmd.SetGlobalVector(_GlobalMipBias, {0.0f, 1.0f, 0.0f, 0.0f});
}

void SetTimeUniforms(CommandBuffer& cmd, double t, double dt)
{
    const auto sines = [t](double (*function)(double))
    {
        return glm::vec4(function(t / 8), function(t / 4), function(t / 2), function(t));
    };
    cmd.SetGlobalVector(_Time, glm::vec4(t / 20, t, t * 2, t * 3));
    cmd.SetGlobalVector(_SinTime, sines([](double x) { return std::sin(x); }));
    cmd.SetGlobalVector(_CosTime, sines([](double x) { return std::cos(x); }));
    cmd.SetGlobalVector(_TimeParameters, glm::vec4(t, std::sin(t), std::cos(t), 0.0));
    const double rate = dt > 1e-30 ? 1.0 / dt : 0.0; // a float's
    cmd.SetGlobalVector(unity_DeltaTime, glm::vec4(dt, rate, dt, rate));
}

void SetLightUniforms(CommandBuffer& cmd, const Scene& scene)
{
    const DirectionalLight& light = scene.mainLight;
    cmd.SetGlobalVector(_MainLightPosition, glm::vec4(-light.direction, 0.0f));
    const glm::vec4 color(
        glm::vec3(CoreUtils::ConvertSRGBToActiveColorSpace(light.color).vector()) * light.intensity,
        1.0f);
    // The second name is the built-in pipeline's, which its shaders may declare by themselves.
    for (const ShaderPropertyId name : {_MainLightColor, _LightColor0})
    {
        cmd.SetGlobalVector(name, color);
    }
    cmd.SetGlobalInt(_MainLightLayerMask, static_cast<int>(light.renderingLayerMask.bits));
}

void SetAmbientUniforms(CommandBuffer& cmd, const RenderSettings& settings)
{
    const SphericalHarmonicsL2 ambient = settings.AmbientLight();
    const std::array<glm::vec4, std::size(k_HarmonicIds)> harmonics = ambient.shaderConstants();
    for (std::size_t i = 0; i < harmonics.size(); ++i)
    {
        cmd.SetGlobalVector(k_HarmonicIds[i], harmonics[i]);
    }
    const bool isFlat = settings.ambientMode == AmbientMode::Flat;
    const auto side = [&](const Color& color)
    {
        return CoreUtils::ConvertSRGBToActiveColorSpace(isFlat ? settings.ambientLight : color)
            .vector();
    };
    cmd.SetGlobalVector(unity_AmbientSky, side(settings.ambientSkyColor));
    cmd.SetGlobalVector(unity_AmbientEquator, side(settings.ambientEquatorColor));
    cmd.SetGlobalVector(unity_AmbientGround, side(settings.ambientGroundColor));

    const float intensity = settings.reflectionIntensity;
    const Color around(ambient(0, 0), ambient(1, 0), ambient(2, 0));
    cmd.SetGlobalVector(_GlossyEnvironmentColor,
                        CoreUtils::ConvertLinearToActiveColorSpace(around * intensity).vector());
    const std::shared_ptr<const Texture>& reflection = settings.ReflectionTexture();
    const std::shared_ptr<const Texture> black = DefaultTexture("black", TextureDimension::Cube);
    // Shaders multiply texels, which are linear and may be above 1, by this; all 0 tells them that
    // there is no reflection.
    const glm::vec4 decode = reflection ? glm::vec4(intensity, 1.0f, 0.0f, 0.0f) : glm::vec4(0.0f);
    cmd.SetGlobalTexture(unity_SpecCube0, reflection ? reflection : black);
    cmd.SetGlobalVector(unity_SpecCube0_HDR, decode);
    cmd.SetGlobalTexture(_GlossyEnvironmentCubeMap, reflection ? reflection : black);
    cmd.SetGlobalVector(_GlossyEnvironmentCubeMap_HDR, decode);
    cmd.SetGlobalTexture(unity_SpecCube1, black); // there are no probes to blend with
}

void SetFogUniforms(CommandBuffer& cmd, const RenderSettings& settings)
{
    static const GlobalKeyword linear("FOG_LINEAR");
    static const GlobalKeyword exponential("FOG_EXP");
    static const GlobalKeyword squared("FOG_EXP2");
    if (!settings.fog)
    {
        return;
    }
    const FogMode mode = settings.fogMode;
    cmd.EnableKeyword(mode == FogMode::Linear        ? linear
                      : mode == FogMode::Exponential ? exponential
                                                     : squared);
    const double ln2 = std::log(2.0);
    const double density = settings.fogDensity;
    const double end = settings.fogEndDistance;
    double depth = end - static_cast<double>(settings.fogStartDistance);
    constexpr double k_Step = 1e-4; // metres; fog that begins and ends at once is a wall
    depth = std::abs(depth) < k_Step ? std::copysign(k_Step, depth) : depth;
    cmd.SetGlobalVector(unity_FogParams, glm::vec4(density / std::sqrt(ln2), density / ln2,
                                                   -1.0 / depth, end / depth));
    cmd.SetGlobalVector(unity_FogColor,
                        CoreUtils::ConvertSRGBToActiveColorSpace(settings.fogColor).vector());
}

} // namespace limn
