#pragma once
#ifndef SHAPE_LIGHT_VARIABLES
#define SHAPE_LIGHT_VARIABLES
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

#define _HDREmulationScale 1.0 // targets hold what is brighter than white
#endif
