// Instancing needs nothing from the author here; the macros are in limn/Platform.hlsl.
#pragma once
#include "limn/Platform.hlsl"
