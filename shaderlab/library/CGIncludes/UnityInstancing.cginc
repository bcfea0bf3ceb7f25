// The macros themselves are in limn/Platform.hlsl: instances are told apart by limn_DrawIndex.
#pragma once
#ifndef UNITY_INSTANCING_INCLUDED
#define UNITY_INSTANCING_INCLUDED
#include "UnityShaderVariables.cginc"

#define DEFAULT_UNITY_VERTEX_INPUT_INSTANCE_ID
#define DEFAULT_UNITY_SETUP_INSTANCE_ID(input)
#define DEFAULT_UNITY_TRANSFER_INSTANCE_ID(input, output)
#define UNITY_INSTANCING_CBUFFER_START(name) cbuffer UnityInstancing_##name {
#define UNITY_INSTANCING_CBUFFER_END };
#endif
