// Copies depth, of the farthest sample where there are several.
#pragma once
#ifndef UNIVERSAL_COPY_DEPTH_PASS_INCLUDED
#define UNIVERSAL_COPY_DEPTH_PASS_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

#if defined(_DEPTH_MSAA_2)
#define MSAA_SAMPLES 2
#elif defined(_DEPTH_MSAA_4)
#define MSAA_SAMPLES 4
#elif defined(_DEPTH_MSAA_8)
#define MSAA_SAMPLES 8
#else
#define MSAA_SAMPLES 1
#endif

#if MSAA_SAMPLES == 1
TEXTURE2D_FLOAT(_CameraDepthAttachment);
float SampleDepth(float2 pixelCoords)
{
    return LOAD_TEXTURE2D(_CameraDepthAttachment, uint2(pixelCoords)).r;
}
#else
Texture2DMS<float, MSAA_SAMPLES> _CameraDepthAttachment;
float SampleDepth(float2 pixelCoords)
{
    float depth = _CameraDepthAttachment.Load(int2(pixelCoords), 0);
    for (int i = 1; i < MSAA_SAMPLES; ++i)
    {
#if defined(UNITY_REVERSED_Z)
        depth = min(depth, _CameraDepthAttachment.Load(int2(pixelCoords), i));
#else
        depth = max(depth, _CameraDepthAttachment.Load(int2(pixelCoords), i));
#endif
    }
    return depth;
}
#endif

#if defined(_OUTPUT_DEPTH)
float frag(Varyings input) : SV_Depth { return SampleDepth(input.positionCS.xy); }
#else
float frag(Varyings input) : SV_Target { return SampleDepth(input.positionCS.xy); }
#endif
#endif
