// Depth, and world-space normals, bent by the normal map, in a colour target.
#pragma once
#ifndef UNIVERSAL_FORWARD_LIT_DEPTH_NORMALS_PASS_INCLUDED
#define UNIVERSAL_FORWARD_LIT_DEPTH_NORMALS_PASS_INCLUDED

#define LIMN_NORMAL_SCALE _BumpScale
#include "limn/DepthNormalsPass.hlsl"
#endif
