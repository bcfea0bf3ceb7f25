// There are no debug views: these names do nothing.
#pragma once
#ifndef UNIVERSAL_DEBUGGING_COMMON_INCLUDED
#define UNIVERSAL_DEBUGGING_COMMON_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Debug/DebugViewEnums.cs.hlsl"
#include "limn/ProjectVersion.hlsl"

bool IsLightingFeatureEnabled(uint bitMask) { return true; }
bool IsOnlyAOLightingFeatureEnabled() { return false; }

// From URP 17 on the coordinates bring their texture along.
#if limn_UNIVERSAL_VERSION >= 17
#define SETUP_DEBUG_TEXTURE_DATA(inputData, uv)
#else
#define SETUP_DEBUG_TEXTURE_DATA(inputData, uv, texture)
#endif
#define SETUP_DEBUG_TEXTURE_DATA_FOR_TEX(inputData, uv, texture)
#define SETUP_DEBUG_TEXTURE_DATA_TERRAIN(inputData, uv)
#define SETUP_DEBUG_TEXTURE_DATA_NO_UV(inputData)
#endif
