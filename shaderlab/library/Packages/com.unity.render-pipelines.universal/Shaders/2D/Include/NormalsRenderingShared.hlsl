// The pass that draws sprites' normals for 2D lights, from -1...1 to 0...1.
#pragma once
#ifndef NORMALS_RENDERING_PASS
#define NORMALS_RENDERING_PASS
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/Core2D.hlsl"

half4 NormalsRenderingShared(half4 color, half3 normalTS, half3 tangent, half3 bitangent,
                             half3 normal)
{
    float3 normalWS = TransformTangentToWorld(normalTS, half3x3(tangent, bitangent, normal));
    return half4(normalWS * 0.5 + 0.5, color.a);
}
#endif
