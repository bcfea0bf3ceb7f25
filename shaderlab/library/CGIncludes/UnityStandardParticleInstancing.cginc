// Particles that one draw multiplies out of a buffer. limn draws no particles: as in Unity where
// procedural instancing is off, each vertex is what the mesh says.
#pragma once
#ifndef UNITY_STANDARD_PARTICLE_INSTANCING_INCLUDED
#define UNITY_STANDARD_PARTICLE_INSTANCING_INCLUDED
#include "UnityCG.cginc"

void vertInstancingSetup() {}
void vertInstancingColor(inout fixed4 color) {}
void vertInstancingUVs(in float2 uv, out float2 texcoord) { texcoord = uv; }
void vertInstancingUVs(in float2 uv, out float2 texcoord, out float3 texcoord2AndBlend)
{
    texcoord = uv;
    texcoord2AndBlend = float3(0, 0, 0);
}
#endif
