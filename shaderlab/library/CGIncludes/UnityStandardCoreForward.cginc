#pragma once
#ifndef UNITY_STANDARD_CORE_FORWARD_INCLUDED
#define UNITY_STANDARD_CORE_FORWARD_INCLUDED
#include "UnityStandardConfig.cginc"

#if UNITY_STANDARD_SIMPLE
#include "UnityStandardCoreForwardSimple.cginc"
VertexOutputBaseSimple vertBase(VertexInput v) { return vertForwardBaseSimple(v); }
half4 fragBase(VertexOutputBaseSimple i) : SV_Target { return fragForwardBaseSimpleInternal(i); }
VertexOutputForwardAddSimple vertAdd(VertexInput v) { return vertForwardAddSimple(v); }
half4 fragAdd(VertexOutputForwardAddSimple i) : SV_Target
{
    return fragForwardAddSimpleInternal(i);
}
#else
#include "UnityStandardCore.cginc"
VertexOutputForwardBase vertBase(VertexInput v) { return vertForwardBase(v); }
half4 fragBase(VertexOutputForwardBase i) : SV_Target { return fragForwardBaseInternal(i); }
VertexOutputForwardBase vertAdd(VertexInput v) { return vertForwardAdd(v); }
half4 fragAdd(VertexOutputForwardBase i) : SV_Target { return fragForwardAddInternal(i); }
#endif
#endif
