// Depth, and world-space normals in a colour target.
#pragma once

#include "limn/DepthNormalsPass.hlsl"
