#include "report/extremes/FormulaShader.h"

#include "report/measure/StudyPicture.h"
#include "report/measure/StudyScene.h"

#include <bit>
#include <cmath>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <sstream>

namespace limn::study
{

namespace
{

constexpr const char* k_Begin = R"(Shader "Hidden/Limn/Formulas" { SubShader { Pass
{
ZTest Always ZWrite Off Cull Off
HLSLPROGRAM
#pragma vertex Vert
#pragma fragment Frag
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
#include "limn/outline/OutlineObject.hlsl"
#include "limn/outline/Hull.hlsl"

// How far a normal so many degrees from the view axis is off behind 8 bits a channel.
float limn_AngleBetween(float3 n, float3 kept)
{
    return degrees(acos(clamp(dot(n, SafeNormalize(kept)), -1.0, 1.0)));
}
float3 limn_NormalAt(float angle)
{
    return float3(sin(radians(angle)), 0.0, cos(radians(angle)));
}
float limn_StereoError(float angle)
{
    float2 kept = round(saturate(EncodeViewNormalStereo(limn_NormalAt(angle))) * 255.0) / 255.0;
    return limn_AngleBetween(limn_NormalAt(angle), DecodeViewNormalStereo(float4(kept, 0.0, 0.0)));
}
float limn_ComponentError(float angle)
{
    return limn_AngleBetween(limn_NormalAt(angle), round(limn_NormalAt(angle) * 127.0) / 127.0);
}

// How far a vertex of a hull moves to the right in view space, for a camera at the origin.
float limn_Right(float4 positionCS, float depth)
{
    float4 before = mul(UNITY_MATRIX_VP, float4(0.2, 0.0, depth, 1.0));
    return (positionCS.x - before.x) / UNITY_MATRIX_P._m00;
}
float limn_ExtrudedInClipSpace(float depth)
{
    float4 positionCS = mul(UNITY_MATRIX_VP, float4(0.2, 0.0, depth, 1.0));
    float2 direction = normalize(mul((float3x3)UNITY_MATRIX_VP, float3(1.0, 0.0, 0.0)).xy);
    positionCS.xy += direction * (8.0 * 2.0 * positionCS.w) / _ScreenParams.xy;
    return limn_Right(positionCS, depth);
}
float limn_HullMoved(float depth)
{
    float3 right = float3(1.0, 0.0, 0.0);
    return limn_Right(HullPosition(float3(0.2, 0.0, depth), right, right, 8.0), depth);
}

// NaN for the number that its bits are.
float limn_Special(float x) { return x > 2.0e9 && x < 1e30 ? asfloat((uint)x) : x; }
// As ColorEdges.shader takes the picture.
float limn_Shown(float x) { return x > 0.0 ? min(x, 1.0) : 0.0; }

)";

constexpr const char* k_End = R"(
    uint bits = asuint(input.positionCS.y < 1.0 ? second : first);
    return float4(bits >> 22, bits >> 11 & 2047, bits & 2047, 1);
}
ENDHLSL
} } })";

std::string TextOf(std::span<const ShaderExpression> expressions)
{
    std::ostringstream text;
    text << k_Begin;
    for (std::size_t i = 0; i < expressions.size(); ++i)
    {
        text << "float4 _Input" << i << ";\n";
    }
    text << "float4 Frag(Varyings input) : SV_Target\n{\n    int cell = int(input.positionCS.x);\n"
            "    float first = 0.0;\n    float second = 0.0;\n";
    for (std::size_t i = 0; i < expressions.size(); ++i)
    {
        // Beyond 1e38 it is too large for a float by now.
        text << "    if (cell == " << i << ")\n    {\n        float4 v = _Input" << i
             << ";\n        v = abs(v) > 1e38 ? v * 100.0 : v;\n"
                "        float a = v.x, b = v.y, c = v.z, d = v.w;\n        first = "
             << expressions[i].first << ";\n        second = " << expressions[i].second
             << ";\n    }\n";
    }
    text << k_End;
    return text.str();
}

double NumberAt(const Coverage (&channels)[3], int x, int y)
{
    const auto part = [&](int channel)
    {
        return static_cast<std::uint32_t>(std::lround(channels[channel].At(x, y)));
    };
    return static_cast<double>(std::bit_cast<float>(part(0) << 22 | part(1) << 11 | part(2)));
}

} // namespace

std::vector<std::array<double, 2>> Evaluate(std::span<const ShaderExpression> expressions,
                                            AssetContext& assets, GraphicsDevice& device)
{
    const auto material = std::make_shared<Material>(
        Shader::FromText(TextOf(expressions), "formulas", assets.compiler()));
    for (std::size_t i = 0; i < expressions.size(); ++i)
    {
        material->SetVector(ShaderPropertyId("_Input" + std::to_string(i)), expressions[i].values);
    }
    auto feature = std::make_unique<FullScreenPassRendererFeature>();
    feature->name = "Formulas";
    feature->passMaterial = material;
    feature->requirements = ScriptableRenderPassInput::Depth | ScriptableRenderPassInput::Normal;
    feature->fetchColorBuffer = false;
    SceneAsset asset = EmptyPicture(static_cast<int>(expressions.size()), 2);
    asset.camera.orthographic = false;
    asset.camera.nearClipPlane = 0.1f;
    asset.camera.transform.localPosition = glm::vec3(0.0f);
    asset.renderer.features.push_back(std::move(feature));
    StudyPicture picture(std::move(asset), assets, device);
    const Image colors = picture.Colors();
    const Coverage channels[3] = {ChannelOf(colors, 0), ChannelOf(colors, 1), ChannelOf(colors, 2)};
    std::vector<std::array<double, 2>> values;
    for (int x = 0; x < colors.width; ++x)
    {
        values.push_back({NumberAt(channels, x, 0), NumberAt(channels, x, 1)});
    }
    return values;
}

} // namespace limn::study
