// Depth, and world-space normals, bent by the normal map, in a colour target.
#pragma once

#define LIMN_NORMAL_SCALE _BumpScale
#include "limn/DepthNormalsPass.hlsl"
