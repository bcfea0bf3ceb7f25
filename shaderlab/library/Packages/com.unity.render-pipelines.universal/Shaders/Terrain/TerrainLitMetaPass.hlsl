// The pass of URP's terrain that bakes light.
#pragma once
#ifndef UNIVERSAL_TERRAIN_LIT_META_PASS_INCLUDED
#define UNIVERSAL_TERRAIN_LIT_META_PASS_INCLUDED

#define _BaseMap_ST _MainTex_ST // a terrain has no other
#include "Packages/com.unity.render-pipelines.universal/Shaders/LitMetaPass.hlsl"

Varyings TerrainVertexMeta(Attributes input) { return UniversalVertexMeta(input); }
float4 TerrainFragmentMeta(Varyings input) : SV_Target { return UniversalFragmentMetaLit(input); }
#endif
