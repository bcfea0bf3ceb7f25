// There are no debug views: these names do nothing.
#pragma once
#ifndef UNIVERSAL_DEBUGGING3D_INCLUDED
#define UNIVERSAL_DEBUGGING3D_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Debug/DebuggingCommon.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/BRDF.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

bool CanDebugOverrideOutputColor(InputData inputData, SurfaceData surfaceData,
                                 inout float4 debugColor)
{
    return false;
}
bool CanDebugOverrideOutputColor(InputData inputData, SurfaceData surfaceData, BRDFData brdfData,
                                 inout float4 debugColor)
{
    return false;
}
#endif
