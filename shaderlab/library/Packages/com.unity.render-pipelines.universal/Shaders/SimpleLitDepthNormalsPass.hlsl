// Depth, and world-space normals, bent by the normal map, in a colour target.
#pragma once

#define LIMN_NORMAL_SCALE 1.0
#include "limn/DepthNormalsPass.hlsl"
