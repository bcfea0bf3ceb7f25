// Instancing needs nothing from the author here; the macros are in limn/Platform.hlsl.
#pragma once
#ifndef UNITY_INSTANCING_INCLUDED
#define UNITY_INSTANCING_INCLUDED
#include "limn/Platform.hlsl"
#endif
