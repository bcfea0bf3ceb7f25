// Objects change their level of detail at once.
#pragma once
#ifndef UNIVERSAL_PIPELINE_LODCROSSFADE_INCLUDED
#define UNIVERSAL_PIPELINE_LODCROSSFADE_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

void LODFadeCrossFade(float4 positionCS)
{
#ifdef LOD_FADE_CROSSFADE
    LODDitheringTransition((uint2)positionCS.xy, unity_LODFade.x);
#endif
}
#endif
