#pragma once
#define UNITY_STANDARD_CORE_FORWARD_INCLUDED
#include "UnityStandardConfig.cginc"
#include "UnityStandardCore.cginc"

VertexOutputForwardBase vertBase(VertexInput v) { return vertForwardBase(v); }
VertexOutputForwardBase vertAdd(VertexInput v) { return vertForwardAdd(v); }
half4 fragBase(VertexOutputForwardBase i) : SV_Target { return fragForwardBaseInternal(i); }
half4 fragAdd(VertexOutputForwardBase i) : SV_Target { return fragForwardAddInternal(i); }
